// SPDX-License-Identifier: MIT
// The engine as a page sees it; README.md has the calls.
export class EngineError extends Error {
  constructor({ message, ...rest }) {
    super(message);
    Object.assign(this, { kind: "internal", file: "", line: 0, column: 0, problems: [] }, rest);
  }
}

/// Calls that only pass their arguments on, with the names of these.
const calls = {
  parameters: [], values: [], reset: [], view: ["name"],
  split: ["parameter", "value", "position"], resize: ["width", "height"], samples: ["count"], drag: ["dx", "dy"],
  zoom: ["steps"], turn: ["degrees"], frame: [], pixel: ["x", "y"], steps: [], steps_of: ["lab"],
  read: ["step"], write: ["step", "text"], file: ["path"], put: ["path", "text"], experiment: ["path", "text"], check: ["step"],
  compare: ["name"], figures: [], presented: [], lose: [],
};
/// Of calls of this kind that wait, only their sum is drawn.
const sums = { drag: ["dx", "dy"], zoom: ["steps"], turn: ["degrees"] };

export class Engine {
  #worker; #waiting = []; #busy = null; #serial = 0; #timer = null; #options;
  #lab = null; #opened = null; #canvasSize = null; #written = new Map();

  constructor(options) {
    this.#options = { patience: 8000, onLost() {}, onStuck() {}, ...options };
    for (const [name, names] of Object.entries(calls))
      this[name] ??= (...values) => {
        const args = {};
        names.forEach((key, i) => { if (values[i] !== undefined) args[key] = values[i]; });
        return this.#call(name, args);
      };
  }

  async open(lab) {
    const opened = this.#opened;
    this.#opened = null;
    if (opened?.number !== lab) return this.#call("open", { lab });
    this.#lab = lab;  // the early worker has done it
    return opened;
  }
  set(values) { return this.#call("set", values); }
  draw(what = {}) { return this.#call("draw", what); }
  shown(what = {}) { return this.#call("draw", { ...what, colors: true }); }

  async start(canvas) {
    // A page may have started a worker for this canvas before this script was there: {worker, canvas, started}.
    const early = canvas && globalThis.texelEarly?.canvas === canvas ? globalThis.texelEarly : null;
    this.#worker = early?.worker ?? new Worker(new URL("./worker.mjs", import.meta.url), { type: "module" });
    this.#worker.onmessage = ({ data }) => this.#answered(data);
    this.#worker.onerror = (event) => this.#fail(new EngineError({ message: event.message || "the engine cannot be loaded" }));
    const offscreen = early ? null : canvas?.transferControlToOffscreen?.();
    const about = this.#call("start", { canvas: offscreen, timeOrigin: performance.timeOrigin }, offscreen ? [offscreen] : [], 120000, early);
    const { opened, ...rest } = await about;
    this.#opened = opened;
    Object.assign(this, rest);
    return this;
  }

  /// Ends the worker, whatever it does, and opens the same in a new one.
  async restart(canvas) {
    const { values, view } = this.#lastValues ?? {};
    this.#worker.terminate();
    this.#fail(new EngineError({ message: "the engine was started again", kind: "failed" }));
    await this.start(canvas);
    if (this.#lab === null) return;
    await this.open(this.#lab);
    for (const { call, args } of [...this.#written.values()]) await this.#call(call, args).catch(() => {});
    if (values) await this.set(values);
    if (view) await this.view(view);
    if (this.#split) await this.#call("split", this.#split);
    if (this.#canvasSize) await this.resize(...this.#canvasSize);
  }
  /// The aspect, width by height, for which the look that is shown was made: nothing of it is cut off.
  aspect(aspect) { return this.#call("aspect", { aspect }); }
  /// Leaves out a step's text at the next restart, as when it never ends.
  forget(step) { this.#written.delete(step); }

  #lastValues = null;
  #split = null;

  #call(call, args = {}, transfer = [], patience = this.#options.patience, early = null) {
    const last = this.#waiting.at(-1);
    if (last && last.call === call && sums[call]) {
      for (const key of sums[call]) last.args[key] += args[key];
      return last.promise;
    }
    if (last && last.call === call && (call === "set" || call === "resize" || call === "frame")) {
      Object.assign(last.args, args);
      return last.promise;
    }
    const one = { id: ++this.#serial, call, args, transfer, patience, early };
    one.promise = new Promise((resolve, reject) => Object.assign(one, { resolve, reject }));
    this.#waiting.push(one);
    this.#next();
    return one.promise;
  }

  #next() {
    if (this.#busy || this.#waiting.length === 0) return;
    const one = (this.#busy = this.#waiting.shift());
    if (one.early) one.early.started.then((data) => this.#answered({ ...data, id: one.id }));
    else this.#worker.postMessage({ id: one.id, call: one.call, args: one.args }, one.transfer);
    const slow = one.call === "check" || one.call === "open" ? 4 : 1;
    this.#timer = setTimeout(() => this.#options.onStuck(one.call), slow * one.patience);
  }

  #answered({ id, result, error, lost }) {
    if (lost) return this.#options.onLost(lost);
    const one = this.#busy;
    if (!one || one.id !== id) return;
    clearTimeout(this.#timer);
    this.#busy = null;
    // A text that does not compile is in the tree all the same.
    if (one.call === "write" || one.call === "put") this.#written.set(one.args.step ?? one.args.path, one);
    if (error) one.reject(new EngineError(error));
    else {
      this.#remember(one, result);
      one.resolve(result);
    }
    this.#next();
  }

  #remember({ call, args }, result) {
    if (call === "open") {
      if (this.#lab !== args.lab) this.#split = null;
      this.#lab = args.lab;
    }
    if (call === "split") this.#split = args.parameter === undefined ? null : args;
    if (call === "resize") this.#canvasSize = [args.width, args.height];
    if (call === "values") this.#lastValues = result;
  }

  #fail(error) {
    clearTimeout(this.#timer);
    const all = this.#busy ? [this.#busy, ...this.#waiting] : this.#waiting;
    this.#busy = null;
    this.#waiting = [];
    for (const one of all) { one.promise.catch(() => {}); one.reject(error); }
  }

  /// Ends the worker. Calls that wait are rejected.
  end() {
    this.#worker.terminate();
    this.#fail(new EngineError({ message: "the engine was ended", kind: "failed" }));
  }
}

/// `canvas` may be left out by a page that only asks for pictures and checks.
export function startEngine({ canvas, ...options } = {}) {
  return new Engine(options).start(canvas);
}
