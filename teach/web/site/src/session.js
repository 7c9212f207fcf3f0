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
  #lastWritten = null;  // {step, text}
  #own = new Map();  // {step: the page's own text}, of steps that were written
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
   * end, and its report given. The first error is thrown then.
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
      if (!this.#concerns(step)) continue;
      const text = this.work.text(step);
      this.#lastWritten = { step, text };
      await tried(this.#put(this.#engine, step, text));
    }
    const report = await tried(this.call("resize", size.width, size.height));
    if (first) throw first;
    return report;
  }

  /** A call of the picture's engine. */
  call(name, ...values) {
    if (this.#stopped || !this.#engine) return Promise.reject(new Stopped());
    return this.#within(this.#engine[name](...values));
  }

  /** A call of the judge's engine, which starts with the first one. */
  async judge(name, ...values) {
    const judge = await this.#started();
    return this.#within(judge[name](...values));
  }

  /** A text of a step: drawn, and told to the judge. Gives the frame's report. Rejects where it does not compile. */
  async write(step, text) {
    this.#lastWritten = { step, text };
    let problem = null;
    const report = await this.#put(this.#engine, step, text).catch((error) => {
      if (error instanceof Stopped) throw error;
      problem = error;
    });
    if (this.#judgeStarts) await this.#tell(await this.#started(), step, text);
    if (problem) throw problem;
    return report;
  }

  /** The text of a step that another tab changed. */
  async follow(step) {
    if (this.#concerns(step)) await this.#bring(this.#engine, step);
    if (this.#judgeStarts) await this.#bring(await this.#started(), step);
  }

  /** Tells the judge what is kept of these steps. */
  async tellJudge(steps) {
    const judge = await this.#started();
    for (const step of steps) await this.#bring(judge, step);
  }

  /** The page's own text of a step; undefined where none was written over it. */
  ownText(step) {
    return this.#own.get(step);
  }

  /** Takes the last change back and starts again. What another tab wrote meanwhile stays. */
  async undoAndRestart() {
    const { step, text } = this.#lastWritten ?? {};
    if (step && this.work.text(step) === text) {
      const good = this.work.lastGood(step);
      if (good === undefined || good === text) this.work.forget(step);
      else this.work.write(step, good);
    }
    await this.restart();
    if (step) this.on.undone(step, this.work.text(step) ?? this.#own.get(step));
  }

  async restart() {
    this.#stop();
    await this.start();
    await this.resume();
    this.on.restarted();
  }

  /** Whether a step changes this lab's pictures. */
  #concerns(step) {
    return step.startsWith(`${this.lab}.`);
  }

  async #startJudge() {
    const round = this.#gone;
    const ofNow = (act) => () => round === this.#gone && act();
    this.#judge = await startEngine({ patience: kPatience, onStuck: ofNow(() => this.#stuck()), onLost: ofNow(() => this.#forgetJudge()) });
    await this.#judge.open(this.lab);
    for (const step of this.work.steps()) await this.#tell(this.#judge, step, this.work.text(step));
  }

  /** Writes into an engine. What it had before the first text is the page's own. */
  async #put(engine, step, text) {
    if (this.#stopped || !engine) throw new Stopped();
    if (!this.#own.has(step)) this.#own.set(step, (await this.#within(engine.read(step))).text);
    return this.#within(engine.write(step, text));
  }

  /** Writes what is kept of a step, where an engine has another text. */
  async #bring(engine, step) {
    const wanted = this.work.text(step) ?? this.#own.get(step);
    if (wanted !== undefined && (await this.#within(engine.read(step))).text !== wanted) await this.#tell(engine, step, wanted);
  }

  /** The judge's engine, which starts with the first call. */
  async #started() {
    if (this.#stopped) throw new Stopped();
    this.#judgeStarts ??= this.#startJudge();
    await this.#within(this.#judgeStarts);
    return this.#judge;
  }

  /** What does not compile, the step's check says. */
  async #tell(engine, step, text) {
    await this.#put(engine, step, text).catch((error) => {
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
    this.on.stuck(this.#lastWritten?.step ?? null);
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
    this.on.lost(message, this.#lastWritten?.step ?? null);
  }
}
