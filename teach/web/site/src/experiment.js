// SPDX-License-Identifier: MIT
// The lab's own shader as a whole, in the editor of the steps, for experiments. It is drawn and never judged. The steps stay.
import matcap from "../experiments/matcap.frag";
import parallax from "../experiments/parallax.frag";
import triplanar from "../experiments/triplanar.frag";
import { afterPause, element } from "./dom.js";

const kPause = 250;  // milliseconds without a key before the text is drawn
const kStarts = { 4: { triplanar }, 5: { "parallax by steps": parallax }, 8: { matcap } };  // by lab
const kHash = "#experiment=";

/** A text in an address, and back. Rejects where it is none. */
export const toHash = async (text) => {
  const { strToU8, deflateSync } = await import("fflate");
  return kHash + btoa(String.fromCharCode(...deflateSync(strToU8(text), { level: 9 }))).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
};
export const fromHash = async (hash) => {
  const { strFromU8, inflateSync } = await import("fflate");
  const bytes = atob(hash.slice(kHash.length).replaceAll("-", "+").replaceAll("_", "/"));
  return strFromU8(inflateSync(Uint8Array.from(bytes, (c) => c.charCodeAt(0))));
};
const isShared = () => location.hash.startsWith(kHash);

/**
 * Fills `host`. `sign` is seen while an experiment is drawn. `path`: the shader's. `draw(promise)` shows what a frame says, as the page
 * does; `copy(text)` gives a text to the user. Gives `{close(), restarted()}`: a new engine has the lab's own shader.
 */
export async function buildExperiment({ host, sign, lab, path, session, work, draw, copy }) {
  const key = `experiment ${lab}`, starts = { "the lab's shader": null, ...kStarts[lab] };
  let editor = null, own = null, isOn = false;
  const button = (text, title, act) => {
    const made = element("button", { type: "button", title }, text);
    made.addEventListener("click", () => act().catch((error) => tell(error.message)));
    return made;
  };
  const start = element("select", { "aria-label": "Begin with" }, ...Object.keys(starts).map((name) => element("option", { value: name }, name)));
  const place = element("div", { className: "code" });
  const problem = element("pre", { className: "problem", role: "status", hidden: true });
  const begin = button("Begin", "Open the shader in an editor", () => open(work.note(key)));
  const other = button("Put it there", "Replace the text by this one; Ctrl+Z takes it back", () => take(textOf(start.value)));
  const link = button("Copy link", "An address with this shader and this look", async () => copy(new URL(await toHash(editor.text()), location.href).href));
  const end = button("End", "The picture is your steps' again; the text is kept", close);
  const inside = [start, other, link, end];
  host.querySelector(".bench").replaceChildren(element("div", { className: "head" }, begin, ...inside), place, problem);
  const show = (on) => {
    isOn = on;
    begin.hidden = on;
    for (const one of [...inside, place]) one.hidden = !on;
    sign.hidden = !on;
  };
  show(false);

  function tell(text) {
    problem.hidden = !text;
    problem.textContent = text ?? "";
  }
  const textOf = (name) => starts[name] ?? own;

  async function open(kept) {
    own ??= (await (await fetch(new URL("../engine/files.json", location.href))).json()).texts[path];
    const { makeEditor } = await import("./editor.js");
    start.value = Object.keys(starts).at(-1);
    const text = kept ?? textOf(start.value);
    show(true);
    place.replaceChildren(element("p", { className: "file" }, path));
    const inner = element("div", { className: "editor" });
    place.append(inner);
    editor = makeEditor({ host: inner, text, numbers: (all) => all.split("\n").map((_, i) => i + 1), label: `Experiment: ${path}`, changed: soon, wraps: true });
    await tried(text);
  }
  async function close() {
    show(false);
    tell(null);
    await draw(session.call("experiment", path, ""));
  }
  async function take(text) {
    editor.write(text);
    work.keep(key, text);
    await tried(text);
  }
  const soon = afterPause(kPause, (text) => {
    work.keep(key, text);
    tried(text).catch((error) => tell(error.message));
  });
  /** Draws with a text. What does not compile is marked, and the last good picture stays. */
  async function tried(text) {
    if (!isOn) return;
    let problems = [];
    const drawing = session.call("experiment", path, text).then((report) => {
      tell(report.endless);
      return report;
    }, (error) => {
      if (!error.problems?.length) throw error;
      problems = error.problems;
      tell(problems.map(({ file, line, message }) => `${file}:${line}: ${message}`).join("\n"));
      return null;
    });
    const report = await drawing;
    editor.mark(problems.filter(({ file }) => path.endsWith(file)));
    if (report) await draw(Promise.resolve(report));
  }

  if (isShared()) {
    await open(await fromHash(location.hash).catch(() => null));
    host.scrollIntoView();
  }
  return { close, restarted: () => isOn && tried(editor.text()).catch((error) => tell(error.message)) };
}
