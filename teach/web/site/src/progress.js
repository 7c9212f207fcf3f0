// SPDX-License-Identifier: MIT
// Above the steps: how far the student is, and the way of the work out of the browser and in again.
import { download, element } from "./dom.js";

/** Fills `host`. `labNumbers`: of all labs; `benches`: the workbenches of this one. Gives `{show()}`. */
export function buildProgress({ host, labNumbers, benches, session, work, checkAll }) {
  const count = element("b");
  const lasts = element("span");
  const said = element("p", { className: "quiet", role: "status" });
  const button = (text, title, act) => {
    const made = element("button", { type: "button", title }, text);
    made.addEventListener("click", () => act().catch((error) => (said.textContent = error.message)));
    return made;
  };
  const file = element("input", { type: "file", accept: ".zip,application/zip", hidden: true });
  file.addEventListener("change", async () => {
    try {
      if (file.files[0]) await bringIn(await file.files[0].arrayBuffer());
    } catch (error) {
      said.textContent = error.message;
    }
    file.value = "";
  });

  // The judge has the texts of all labs.
  async function shaderSteps() {
    const labs = await Promise.all(labNumbers.map((number) => session.judge("steps_of", number)));
    return labs.flat().filter((step) => step.kind === "shader");
  }
  async function takeOut() {
    const { packed } = await import("./archive.js");
    const texts = {}, steps = await shaderSteps();
    await session.tellJudge(steps.map((step) => step.id));  // another tab may have written since
    for (const { file: path } of steps) texts[path] ??= await session.judge("file", path);
    download("texel-labs.zip", await packed(texts));
    said.textContent = "Unpack it over your folder of the course: ./run check says the same there.";
  }
  async function bringIn(bytes) {
    const { unpacked } = await import("./archive.js");
    const steps = await shaderSteps();
    const texts = await unpacked(bytes, [...new Set(steps.map((step) => step.file))]);
    await session.tellJudge(steps.map((step) => step.id));
    const read = () => Promise.all(steps.map((step) => session.judge("read", step.id)));
    const before = await read();
    for (const [path, text] of Object.entries(texts))
      await session.judge("put", path, text).catch((error) => {
        if (!error.problems?.length) throw error;  // what does not compile is taken, and its step says so
      });
    const taken = [];
    for (const [i, { text }] of (await read()).entries()) {
      const { id } = steps[i];
      if (text === before[i].text) continue;
      taken.push(id);
      if (benches.has(id)) await benches.get(id).write(text);
      else work.write(id, text);
    }
    said.textContent = taken.length === 0 ? "The .zip has nothing new." : `Taken from the .zip: ${taken.join(", ")}.`;
  }

  const save = () => button("Save as .zip", "Your shader files of all labs, with the paths of the course's folder", takeOut);
  const refused = element("p", { className: "refused", role: "alert", hidden: true },
    "This browser does not keep your code: its storage is full or blocked. ", save());
  host.after(refused);
  host.replaceChildren(
    element("p", {}, count, lasts),
    element("div", { className: "buttons" }, button("Check all", "Check every step of this lab", checkAll),
      save(),
      button("Load a .zip", "Take your shader files from a .zip", async () => file.click()), file), said);
  host.hidden = benches.size === 0;

  const show = () => {
    const all = [...benches.values()];
    const done = all.filter((bench) => bench.result?.status === "passed");
    const unknown = all.filter((bench) => !bench.result && !bench.step.untouched);
    const points = (list) => list.reduce((sum, bench) => sum + bench.step.points, 0);
    const also = unknown.length === 0 ? "" : ` ${unknown.length} ${unknown.length === 1 ? "is" : "are"} not checked yet.`;
    count.textContent = unknown.length === all.length ? `${all.length} shader ${all.length === 1 ? "step" : "steps"}, not checked yet.`
      : `${done.length} of ${all.length} shader steps ${all.length === 1 ? "is" : "are"} right, ${points(done)} of ${points(all)} points.${also}`;
    lasts.textContent = work.lasts ? " Your code stays in this browser." : "";
    refused.hidden = work.lasts || host.hidden;
  };
  show();
  return { show };
}
