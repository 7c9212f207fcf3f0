// SPDX-License-Identifier: MIT
// The engines of a page: one draws the picture, another judges and so never stops the picture. Both run in workers. One that
// loops for ever is ended, and a new one takes up the same lab, parameters and texts.
import { startEngine } from "../engine/client.mjs";

const kPatience = 8000;  // milliseconds without an answer: a slow machine compiles a large shader in two or three seconds

/** The engine does not run: it was ended, and starts again when the user says so. */
export class Stopped extends Error {
  constructor() {
    super("The picture has stopped.");
  }
}

export class Session {
  #engine = null;
  #judge = null;
  #judgeStarts = null;
  #stopped = false;
  #lastWritten = null;
  #lastLoss = 0;
  #gone = null;  // rejects when the engines are ended: their open calls never answer
  #end = null;

  /**
   * `lab`: number. `freshCanvas()`: an empty canvas in the picture's place. `work`: the texts (storage.js). `state()`: what to
   * show, {set, view, split, size}. `on`: stuck(step), lost(message, step), failed(error), restarted(), undone(step, text); `step` was written
   * last, or null.
   */
  constructor({ lab, freshCanvas, work, state, on }) {
    Object.assign(this, { lab, freshCanvas, work, state, on });
  }

  get isStopped() {
    return this.#stopped;
  }

  /** Starts the picture's engine and opens the lab; gives what `open` gives. */
  async start() {
    this.#stopped = false;
    this.#gone = new Promise((_, reject) => (this.#end = () => reject(new Stopped())));
    this.#gone.catch(() => {});
    const round = this.#gone;  // what an engine of an earlier round still says is of no interest
    const ofNow = (act) => (message) => round === this.#gone && act(message);
    this.#engine = await this.#within(startEngine({
      canvas: this.freshCanvas(),
      patience: kPatience,
      onStuck: ofNow(() => this.#stuck()),
      onLost: ofNow((message) => this.#lost(message)),
    }));
    return this.call("open", this.lab);
  }

  /**
   * Writes what the student has, and shows the state. The engine draws nothing before `resize`: one picture is drawn, at the
   * end. The first error is thrown then.
   */
  async resume() {
    let first = null;
    const tried = (promise) => promise.catch((error) => {
      if (error instanceof Stopped) throw error;
      first ??= error;
    });
    const { set, view, split, size } = this.state();
    if (Object.keys(set).length > 0) await tried(this.call("set", set));
    if (view !== "color") await tried(this.call("view", view));
    if (split) await tried(this.call("split", split.parameter, split.value, split.position));
    for (const step of this.work.steps()) {
      if (!(await this.#concerns(step))) continue;
      this.#lastWritten = step;
      await tried(this.call("write", step, this.work.text(step)));
    }
    await tried(this.call("resize", size.width, size.height));
    if (first) throw first;
  }

  /** A call of the picture's engine. */
  call(name, ...values) {
    if (this.#stopped || !this.#engine) return Promise.reject(new Stopped());
    return this.#within(this.#engine[name](...values));
  }

  /** A call of the judge's engine, which starts with the first one. */
  async judge(name, ...values) {
    if (this.#stopped) throw new Stopped();
    this.#judgeStarts ??= this.#startJudge();
    await this.#within(this.#judgeStarts);
    return this.#within(this.#judge[name](...values));
  }

  /** A text of a step: kept, drawn, and told to the judge. Gives the frame's report. Rejects where it does not compile; it is kept all the same. */
  async write(step, text) {
    this.work.write(step, text);
    this.#lastWritten = step;
    let problem = null;
    const report = await this.call("write", step, text).catch((error) => {
      if (error instanceof Stopped) throw error;
      problem = error;
    });
    if (this.#judgeStarts) {
      await this.#within(this.#judgeStarts);
      await this.#tell(step, text);
    }
    if (problem) throw problem;
    return report;
  }

  /** Takes the last change back and starts again. */
  async undoAndRestart() {
    const step = this.#lastWritten;
    if (step !== null) {
      const good = this.work.lastGood(step);
      if (good === undefined || good === this.work.text(step)) this.work.forget(step);
      else this.work.write(step, good);
    }
    await this.restart();
    if (step !== null) this.on.undone(step, this.work.text(step) ?? (await this.call("read", step)).text);
  }

  async restart() {
    this.#stop();
    await this.start();
    await this.resume();
    this.on.restarted();
  }

  /** Whether a step changes this lab's pictures: its own, and those in the library of all labs. */
  async #concerns(step) {
    if (step.startsWith(`${this.lab}.`)) return true;
    const { file } = await this.call("read", step).catch(() => ({ file: "" }));
    return file.startsWith("shaders/lib/");
  }

  async #startJudge() {
    const round = this.#gone;
    const ofNow = (act) => () => round === this.#gone && act();
    this.#judge = await startEngine({ patience: kPatience, onStuck: ofNow(() => this.#stuck()), onLost: ofNow(() => this.#forgetJudge()) });
    await this.#judge.open(this.lab);
    for (const step of this.work.steps()) await this.#tell(step, this.work.text(step));
  }

  /** What the judge does not compile, its check says. */
  async #tell(step, text) {
    await this.#within(this.#judge.write(step, text)).catch((error) => {
      if (error instanceof Stopped) throw error;
    });
  }

  #forgetJudge() {
    this.#judge?.end();
    this.#judge = this.#judgeStarts = null;
  }

  #within(promise) {
    return Promise.race([promise, this.#gone]);
  }

  #stop() {
    this.#end?.();
    this.#engine?.end();
    this.#engine = null;
    this.#forgetJudge();
  }

  #stuck() {
    if (this.#stopped) return;
    this.#stopped = true;
    this.#stop();
    this.on.stuck(this.#lastWritten);
  }

  /** A lost context comes back by itself, unless it is lost again at once. */
  #lost(message) {
    if (this.#stopped) return;
    const now = performance.now();
    const again = now - this.#lastLoss < 10_000 && this.#lastLoss > 0;
    this.#lastLoss = now;
    if (!again) {
      this.restart().catch((error) => this.on.failed(error));
      return;
    }
    this.#stopped = true;
    this.#stop();
    this.on.lost(message, this.#lastWritten);
  }
}
