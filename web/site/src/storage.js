// SPDX-License-Identifier: MIT
// What a student wrote, kept in this browser: it survives a reload.

/** The texts of all labs' steps. `place` tells courses on the same host apart, such as the folder of the pages. */
export class Work {
  #key;
  #kept;
  #store;

  constructor(place, store = safeStore()) {
    this.#key = `texel-labs ${place}`;
    this.#store = store;
    this.#kept = parsed(store?.getItem(this.#key));
  }

  /** Whether the browser keeps anything: in some private windows it does not. */
  get lasts() {
    return this.#store !== null;
  }
  /** Steps that have a text. */
  steps() {
    return Object.keys(this.#kept);
  }
  text(step) {
    return this.#kept[step]?.text;
  }
  /** The last text with which a picture was drawn; undefined: only the first text is known to draw. */
  lastGood(step) {
    return this.#kept[step]?.good;
  }
  write(step, text) {
    this.#kept[step] = { ...this.#kept[step], text };
    this.#save();
  }
  drewWell(step) {
    const kept = this.#kept[step];
    if (!kept || kept.good === kept.text) return;
    kept.good = kept.text;
    this.#save();
  }
  forget(step) {
    delete this.#kept[step];
    this.#save();
  }
  #save() {
    try {
      this.#store?.setItem(this.#key, JSON.stringify(this.#kept));
    } catch {
      this.#store = null;  // full, or forbidden meanwhile
    }
  }
}

function safeStore() {
  try {
    const store = window.localStorage;
    store.setItem("texel-labs", "1");
    store.removeItem("texel-labs");
    return store;
  } catch {
    return null;
  }
}

function parsed(text) {
  try {
    const kept = JSON.parse(text ?? "{}");
    return Object.fromEntries(Object.entries(kept).filter(([, one]) => typeof one?.text === "string"));
  } catch {
    return {};
  }
}
