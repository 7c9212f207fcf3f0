// SPDX-License-Identifier: MIT
// What scripts outside may call on a lab's page, as `texel` (docs/browser.md).

/** Bytes that the page itself loaded so far, as they came over the net. */
const ownBytes = () => [...performance.getEntriesByType("navigation"), ...performance.getEntriesByType("resource")]
  .reduce((sum, entry) => sum + (entry.encodedBodySize || 0), 0);

export function contract({ ready, session, now, check, write }) {
  let figures = null;
  const done = ready.then(async () => {
    figures = await session.call("figures");
  });
  done.catch(() => {});  // told on the page; who awaits `ready` gets it too
  return {
    ready: done,
    /** A picture beside the canvas: {width, height, channels, data}, bottom row first; parameters not in `set` are the defaults. */
    draw: ({ view = "color", size = "512x512", set = {} } = {}) => session.call("draw", { view, size, set }),
    /** What `--list-parameters --json` prints. */
    parameters: () => now.parameters.map(({ name, type, default: initial, min, max, choices, unit, help }) =>
      ({ name, type, default: initial, min, max, choices, unit, help })),
    /** Puts a text into a step's editor, and resolves when it is drawn and judged. */
    write,
    check,
    /** Takes the graphics context away, as a driver may. */
    lose: () => session.call("lose").catch(() => {}),  // the answer may be lost with it
    /** {first_picture_ms, frame_ms, bytes}: since navigation began, of the last frame, and loaded so far. */
    figures: () => ({
      first_picture_ms: figures?.first_picture_ms ?? null,
      frame_ms: now.report?.frame_ms ?? figures?.frame_ms ?? null,
      bytes: ownBytes() + (figures?.bytes ?? 0),
    }),
  };
}
