// SPDX-License-Identifier: MIT
// The picture's surface: pointer, wheel, fingers and keys become calls of `act`; its size follows the page.
import { element } from "./dom.js";

const kClick = 4;        // CSS pixels that a pointer may move and still have clicked
const kTurn = 12;        // CSS pixels of a drag that an arrow key stands for
const kMostPixels = 1600;  // of a side: a large screen's software renderer would be slow

/**
 * Makes `host` a picture that can be turned. `act` has drag(dx, dy), zoom(steps), pick(x, y) in device pixels from the lower
 * left, resize(width, height) and key(name). Gives `{canvas(), fresh(), size()}`: a canvas belongs to one worker, and
 * `fresh()` puts a new one in its place.
 */
export function makePicture(host, act) {
  let canvas = null;
  const pointers = new Map();
  let moved = 0, pinch = 0;

  const ratio = () => {
    const wanted = window.devicePixelRatio || 1;
    return Math.min(wanted, kMostPixels / Math.max(host.clientWidth, host.clientHeight, 1));
  };
  const size = () => ({
    width: Math.max(1, Math.round(host.clientWidth * ratio())),
    height: Math.max(1, Math.round(host.clientHeight * ratio())),
  });
  const fresh = () => {
    // The first one may have been given to a worker already.
    const early = canvas ? null : globalThis.texelEarly?.canvas;
    canvas?.remove();
    canvas = early ?? element("canvas", size());
    host.prepend(canvas);
    return canvas;
  };

  const spread = () => {
    const [a, b] = [...pointers.values()];
    return Math.hypot(a.x - b.x, a.y - b.y);
  };
  host.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    host.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (pointers.size === 1) moved = 0;
    if (pointers.size === 2) pinch = spread();
  });
  host.addEventListener("pointermove", (event) => {
    const at = pointers.get(event.pointerId);
    if (!at) return;
    const dx = event.clientX - at.x, dy = event.clientY - at.y;
    at.x = event.clientX;
    at.y = event.clientY;
    moved += Math.hypot(dx, dy);
    if (pointers.size === 1) return moved > kClick && act.drag(dx, dy);
    const now = spread();
    if (pinch > 0 && now > 0) act.zoom(4 * Math.log(now / pinch));
    pinch = now;
  });
  const release = (event) => {
    if (!pointers.delete(event.pointerId)) return;
    if (event.type === "pointerup" && pointers.size === 0 && moved <= kClick) pick(event.clientX, event.clientY);
    if (pointers.size > 0) moved = kClick + 1;  // after a pinch the finger that is left is no click
  };
  host.addEventListener("pointerup", release);
  host.addEventListener("pointercancel", release);
  host.addEventListener("wheel", (event) => {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY / 3 : event.deltaY / 100;
    act.zoom(-Math.min(Math.max(lines, -3), 3));
  }, { passive: false });

  function pick(clientX, clientY) {
    const box = host.getBoundingClientRect();
    const { width, height } = size();
    const x = Math.floor(((clientX - box.left) / box.width) * width), y = Math.floor(((box.bottom - clientY) / box.height) * height);
    act.pick(Math.min(Math.max(x, 0), width - 1), Math.min(Math.max(y, 0), height - 1));
  }

  const arrows = { ArrowLeft: [-kTurn, 0], ArrowRight: [kTurn, 0], ArrowUp: [0, -kTurn], ArrowDown: [0, kTurn] };
  host.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const box = host.getBoundingClientRect();
    if (arrows[event.key]) act.drag(...arrows[event.key]);
    else if (event.key === "+" || event.key === "=") act.zoom(1);
    else if (event.key === "-") act.zoom(-1);
    else if (event.key === "Enter") pick(box.left + box.width / 2, box.top + box.height / 2);
    else if (!act.key(event.key === " " ? "space" : event.key.toLowerCase())) return;
    event.preventDefault();
  });

  let known = "";
  new ResizeObserver(() => {
    const { width, height } = size();
    if (canvas && known && known !== `${width}x${height}`) act.resize(width, height);
    known = `${width}x${height}`;
  }).observe(host);

  return { canvas: () => canvas, fresh, size };
}
