// SPDX-License-Identifier: MIT
// What a student wrote, kept in this browser: it survives a reload. Each text has a key of its own, and is read when it is asked
// for: another tab may have written it meanwhile.

/** The texts of all labs' steps. `place` tells courses on the same host apart, such as the folder of the pages. */
export class Work {
  #place;
  #store;
  #unsaved = new Map();  // {key: text, or null for none}: what the browser refused so far
  #lasts;
  /** Called when `lasts` changes. */
  watch = () => {};

  /** `store()` gives the browser's storage, or throws where it is blocked. */
  constructor(place, store = () => window.localStorage) {
    this.#place = `texel-labs ${place}`;
    this.#store = store;
    this.#lasts = this.#tried((to) => {
      to.setItem("texel-labs", "1");
      to.removeItem("texel-labs");
      return true;
    }) ?? false;
  }

  /** Whether the browser kept all that it was given. It does not where its storage is full or blocked. */
  get lasts() {
    return this.#lasts;
  }
  /** Whether a text would be lost with the page. */
  get hasUnsaved() {
    return this.#refused().some((key) => this.#unsaved.get(key) !== null);
  }
  /** Steps that have a text. */
  steps() {
    const keys = this.#tried((store) => Object.keys(store)) ?? [];
    const known = [...keys, ...this.#unsaved.keys()].map((key) => this.stepOf(key));
    return [...new Set(known)].filter((step) => step !== null && this.text(step) !== undefined);
  }
  text(step) {
    return this.#read(this.#key(step));
  }
  /** The last text with which a picture was drawn; undefined: only the first text is known to draw. */
  lastGood(step) {
    return this.#read(`${this.#key(step)} good`);
  }
  write(step, text) {
    this.#put(this.#key(step), text);
    this.#put(this.#key("last"), step);
  }
  /** The step that was written last, if there is one. */
  lastStep() {
    return this.#read(this.#key("last"));
  }
  /** Whether the step was right when it was judged last. */
  isRight(step) {
    return this.#read(`${this.#key(step)} right`) !== undefined;
  }
  judged(step, right) {
    if (this.isRight(step) !== right) this.#put(`${this.#key(step)} right`, right ? "1" : null);
  }
  /** A text that is no step's, by a name of its own. */
  note(name) {
    return this.#read(this.#key(name));
  }
  keep(name, text) {
    this.#put(this.#key(name), text);
  }
  /** A picture was drawn with this text. */
  drewWell(step, text) {
    if (this.text(step) !== undefined && this.lastGood(step) !== text) this.#put(`${this.#key(step)} good`, text);
  }
  forget(step) {
    this.#put(`${this.#key(step)} good`, null);
    this.#put(this.#key(step), null);
  }
  /** The step whose text has this key; null for another key. */
  stepOf(key) {
    const name = key?.startsWith(`${this.#place} `) ? key.slice(this.#place.length + 1) : "";
    return /^\d+\.\d+$/.test(name) ? name : null;
  }
  /** Another tab wrote this key: the last one who wrote counts. */
  heard(key) {
    if (this.#unsaved.delete(key)) this.#flush();
    else this.save();
  }
  /** Tries again what the browser refused. */
  save() {
    if (this.#unsaved.size > 0) this.#flush();
  }

  #flush() {
    for (const [key, text] of this.#unsaved) {
      const isKept = this.#tried((store) => {
        if (text === null) store.removeItem(key);
        else store.setItem(key, text);
        return true;
      });
      if (isKept) this.#unsaved.delete(key);
    }
    const lasts = this.#refused().length === 0;
    if (lasts === this.#lasts) return;
    this.#lasts = lasts;
    this.watch();
  }

  /** Steps' texts alone: a page does without the rest. */
  #refused() {
    return [...this.#unsaved.keys()].filter((key) => this.stepOf(key) !== null);
  }
  #key(step) {
    return `${this.#place} ${step}`;
  }
  #read(key) {
    return (this.#unsaved.has(key) ? this.#unsaved.get(key) : this.#tried((store) => store.getItem(key))) ?? undefined;
  }
  #put(key, text) {
    this.#unsaved.set(key, text);
    this.#flush();
  }
  #tried(act) {
    try {
      return act(this.#store());
    } catch {
      return undefined;  // full, or blocked
    }
  }
}
