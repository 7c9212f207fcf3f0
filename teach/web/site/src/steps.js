// SPDX-License-Identifier: MIT
// The steps of the handout that are shaders: code, verdict, cases and hints, where the step's text stands.
import { compareView } from "./compare_view.js";
import { afterPause, element, figure } from "./dom.js";
import { lineNumbersOf, surroundingsOf } from "./places.js";
import { Stopped } from "./session.js";
import { readState } from "./state.js";

const kPause = 250;  // milliseconds without a key before the text is tried
const kWords = { passed: "done", failed: "wrong", skipped: "waits", untouched: "to do", unchecked: "not checked" };

/** The editor shows a step's part without its last line's end: else an empty line would follow. */
const asShown = (text) => text.replace(/\n$/, "");
const asWritten = (text) => (text === "" || text.endsWith("\n") ? text : `${text}\n`);

/** One step's workbench. */
class Workbench {
  constructor(its) {
    Object.assign(this, its);  // place, step, look, session, work, showCase, showCompared, next, changed
    this.round = 0;
    this.editor = null;
    this.marked = [];  // problems at their lines, also of a text that came before the editor
    this.result = null;
    this.build();
  }

  build() {
    const button = (text, title, act) => {
      const made = element("button", { type: "button", title }, text);
      made.addEventListener("click", act);
      return made;
    };
    this.badge = element("span", { className: "badge" });
    this.code = element("div", { className: "code" });
    this.problem = element("pre", { className: "problem", role: "status", hidden: true });
    this.verdict = element("p", { className: "verdict", role: "status" });
    this.cause = element("p", { className: "cause", hidden: true });
    this.cases = element("ul", { className: "cases" });
    this.back = button("Start over", "Put the step's first text back; Ctrl+Z in the editor takes it back again", () => this.reset());
    this.hintList = element("ol", { className: "hints" });
    this.hintButton = button("", "", () => this.nextHint());
    this.shown = 0;
    this.place.replaceChildren(
      element("div", { className: "head" }, this.badge,
        button("See the step's look", "Draw the step's picture with your text", () => this.showCase(this.look)), this.back),
      this.code, this.problem, this.verdict, this.cause, this.cases,
      element("div", { className: "hinting" }, this.hintList, this.hintButton));
    this.showHints();
    this.show({ ...this.step, status: this.step.untouched ? "untouched" : "unchecked" }, false);
  }

  /** The text before the editor is loaded: of the same size. */
  async load() {
    this.read = await this.session.call("read", this.step.id);
    this.own = this.session.ownText(this.step.id) ?? this.read.text;  // on a solved page not the first one
    const file = await this.session.call("file", this.read.file);
    const around = surroundingsOf(file, this.step.id);
    this.numbers = lineNumbersOf(file, this.step.id);
    this.host = element("div", { className: "editor" }, element("pre", { className: "plain" }, asShown(this.kept())));
    this.code.replaceChildren(element("p", { className: "file" }, this.read.file), element("pre", { className: "context" }, around.before), this.host,
      element("pre", { className: "context" }, around.after));
  }

  /** What this browser keeps of the step, which another tab may have written. */
  kept() {
    return this.work.text(this.step.id) ?? this.own;
  }
  /** What stands there. */
  text() {
    return asWritten(this.editor ? this.editor.text() : this.host.textContent);
  }

  async mount() {
    if (this.editor || this.mounting) return;
    this.mounting = true;
    const { makeEditor } = await import("./editor.js");
    const text = asShown(this.text());
    this.host.replaceChildren();
    this.editor = makeEditor({
      host: this.host,
      text,
      numbers: this.numbers,
      label: `Code of step ${this.step.id}: ${this.step.title}. Escape and then Tab leaves the editor.`,
      changed: this.edited,
    });
    this.editor.mark(this.marked);
  }

  edited = (text) => {
    this.work.write(this.step.id, asWritten(text));
    this.soon();
  };
  /** Tries what stands there when no other text came for a moment. */
  soon() {
    ++this.round;
    this.badge.textContent = "…";
    this.tried();
  }
  tried = afterPause(kPause, () => this.try(this.text()).catch(this.complain));

  /** Writes the text, and judges it if it compiles. */
  async try(text) {
    const round = ++this.round;
    let problem = null;
    const report = await this.session.write(this.step.id, text).catch((error) => {
      if (error instanceof Stopped) throw error;
      problem = error;
    });
    if (round !== this.round) return;
    this.showProblem(problem ?? (report?.endless ? { message: report.endless } : null));
    if (problem) {
      this.show({ ...this.step, status: "failed" }, false);
      this.badge.textContent = "does not compile";
      return;
    }
    await this.check();
    if (round === this.round && !report?.endless) this.work.drewWell(this.step.id, text);
  }

  /** Judges what stands there; `show` has the result. */
  async check() {
    const round = this.round;
    this.badge.textContent = "checking";
    const { steps } = await this.session.judge("check", this.step.id);
    if (round === this.round) this.show(steps.find((step) => step.id === this.step.id), true);
  }

  complain = (error) => {
    if (!(error instanceof Stopped)) this.showProblem(error);
  };

  showProblem(error) {
    const mine = (error?.problems ?? []).filter((one) => one.file === this.read.file);
    this.marked = mine;
    this.editor?.mark(mine);
    this.problem.hidden = !error;
    this.problem.textContent = error ? (mine.length > 0 ? mine.map((one) => `line ${one.line}: ${one.message}`).join("\n") : error.message) : "";
  }

  /** `result`: the step as `texel check --json` has it. */
  show(result, judged) {
    this.result = judged ? result : null;
    const good = result.status === "passed";
    // A step that is not begun is no wrong answer.
    const status = result.status === "failed" && result.cases.some((one) => one.status === "untouched") ? "untouched" : result.status;
    this.badge.className = `badge ${status}`;
    this.badge.textContent = kWords[status] ?? status;
    const next = judged && good ? this.next(this.step.id) : null;
    this.verdict.replaceChildren(...(next ? ["Right. Next: ", next] : [judged ? result.message || (good ? "Right." : "") : ""]));
    this.cause.hidden = !judged || !result.looks_like_says;
    this.cause.textContent = this.cause.hidden ? "" : `This looks like: ${result.looks_like_says}`;
    this.back.disabled = [undefined, this.read?.first].includes(this.work.text(this.step.id));
    this.cases.replaceChildren(...result.cases.map((one) => this.caseItem(one, judged)));
    const after = this.place.closest(".step").querySelector("details.after");
    if (after && judged) after.open = good;
    if (judged) this.work.judged(this.step.id, good), this.changed();
    if (this.open && judged) this.compare(this.open).catch(this.complain);
  }

  caseItem(one, judged) {
    const picture = one.view !== "mesh";
    const known = judged && one.status !== undefined;
    const sign = !known ? "·" : one.status === "passed" ? "✓" : "✗";
    const says = !known ? `limit ${figure(one.limit)} ${one.unit}`
      : one.error === null ? one.message : `${figure(one.error)} ${one.unit}, limit ${figure(one.limit)}`;
    const button = element("button", { type: "button", disabled: !picture, title: "Set this look, and show the expected picture beside yours", "aria-expanded": String(this.open === one.name) },
      element("span", { className: "sign", "aria-label": !known ? "not checked" : one.status === "passed" ? "right" : "wrong" }, sign), ` ${one.name.replaceAll("_", " ")} `, element("span", { className: "quiet" }, says));
    button.addEventListener("click", () => this.pick(one));
    return element("li", { className: known ? one.status : "" }, button);
  }

  async pick(one) {
    if (this.open === one.name) {
      this.close();
    } else {
      this.open = one.name;
      await this.showCase(one);
      await (this.result ? this.compare(one.name) : this.check()).catch(this.complain);
    }
    for (const button of this.cases.querySelectorAll("button")) button.setAttribute("aria-expanded", "false");
    if (this.open) [...this.cases.querySelectorAll("button")].find((b) => b.textContent.includes(` ${one.name.replaceAll("_", " ")} `))?.setAttribute("aria-expanded", "true");
  }

  async compare(name) {
    const pictures = await this.session.judge("compare", name);
    this.showCompared(pictures && compareView(pictures), () => this.close());
  }
  close() {
    this.open = null;
    this.showCompared(null);
    for (const button of this.cases.querySelectorAll("button")) button.setAttribute("aria-expanded", "false");
  }

  /** A text from elsewhere: a .zip, the test's hand, an undone change. */
  async write(text) {
    this.work.write(this.step.id, asWritten(text));
    await this.take(text);
  }

  /** Another tab may have changed the text. */
  follow() {
    const text = this.kept();
    if (asWritten(asShown(text)) === this.text()) return;
    this.put(text);
    this.soon();
  }

  put(text) {
    if (this.editor) this.editor.write(asShown(text));
    else this.host.firstChild.textContent = asShown(text);
  }

  /** Shows a text and tries it; what is kept stays as it is. */
  async take(text) {
    this.put(text);
    await this.try(asWritten(text)).catch((error) => {
      if (error instanceof Stopped) throw error;
      this.complain(error);
    });
  }

  async reset() {
    if (this.own === this.read.first) {
      this.work.forget(this.step.id);
      await this.take(this.own);
    } else await this.write(this.read.first);
  }

  nextHint() {
    this.hintList.append(element("li", {}, this.step.hints[this.shown++]));
    this.showHints();
  }
  showHints() {
    const all = this.step.hints.length;
    this.hintButton.hidden = this.shown >= all;
    this.hintButton.textContent = `Hint ${this.shown + 1} of ${all}`;
  }
}

/** The workbenches of a handout's shader steps. Editors are loaded when they come near the window. */
export async function buildSteps({ article, session, work, ...callbacks }) {
  const benches = new Map();
  const near = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries)
      if (isIntersecting) {
        near.unobserve(target);
        const bench = benches.get(target.dataset.step);
        bench.mount().catch(() => {});
        if (!bench.result && !bench.step.untouched && work.text(bench.step.id) === undefined) bench.check().catch(bench.complain);
      }
  }, { rootMargin: "300px" });
  for (const step of await session.call("steps")) {
    const section = article.querySelector(`[data-step="${step.id}"]`);
    const place = section?.querySelector(".workbench");
    if (!place || step.kind !== "shader") continue;
    const bench = new Workbench({ place, step, look: readState(section.dataset.look), session, work, ...callbacks });
    await bench.load();
    benches.set(step.id, bench);
    place.dataset.step = step.id;
    near.observe(place);
  }
  return benches;
}
