// SPDX-License-Identifier: MIT
// A stand-in for the engine, with the calls of teach/web/engine/README.md that the pages use. It draws stripes. A text with "for (;;)"
// loops for ever, one with "syntax error" does not compile, and one with "right" is right.
class EngineError extends Error {
  constructor(fields) {
    super(fields.message);
    Object.assign(this, fields);
  }
}

export async function startEngine({ canvas, onLost, onStuck, patience = 8000 }) {
  const early = canvas && globalThis.texelEarly?.canvas === canvas ? globalThis.texelEarly : null;
  const worker = early?.worker ?? new Worker(new URL("worker.mjs", import.meta.url), { type: "module" });
  const waiting = new Map();
  let last = 0, timer = 0;
  const limit = Math.min(patience, 4000);  // tests do not wait long
  const watch = () => {
    clearTimeout(timer);
    if (waiting.size > 0) timer = setTimeout(onStuck, limit);
  };
  worker.onerror = (event) => console.error(event.message, event.lineno);
  worker.onmessage = ({ data }) => {
    if (data.lost) return onLost(data.lost);
    if (!waiting.has(data.id)) return;  // the page's own start
    const { done, failed } = waiting.get(data.id);
    waiting.delete(data.id);
    watch();
    if (data.error) failed(new EngineError(data.error));
    else done(data.value);
  };
  const call = (name, values, transfer = []) => new Promise((done, failed) => {
    waiting.set(++last, { done, failed });
    worker.postMessage({ id: last, name, values }, transfer);
    watch();
  });
  if (early) await early.started;
  else {
    const surface = canvas?.transferControlToOffscreen();
    await call("start", [surface], surface ? [surface] : []);
  }
  const end = () => {
    clearTimeout(timer);
    worker.terminate();
  };
  return new Proxy({ end }, { get: (own, name) => own[name] ?? (name === "then" ? undefined : (...values) => call(name, values)) });
}
