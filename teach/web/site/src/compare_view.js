// SPDX-License-Identifier: MIT
// A case's pictures: yours and the expected one with a line between them, or how large the error is.
import { element } from "./dom.js";
import { imageOf } from "./image.js";


const modes = { split: "yours | expected", heat_map: "difference" };
let count = 0;

/** The viewer of one comparison, as the engine's `compare` gives it. */
export function compareView({ width, height, own, expected, heat_map, mark }) {
  const pictures = { own, expected, heat_map };
  const images = Object.fromEntries(Object.entries(pictures).map(([name, bytes]) => [name, bytes && imageOf(bytes, width, height)]));
  const canvas = element("canvas", { width, height, role: "img" });
  const context = canvas.getContext("2d");
  const ring = element("span", { className: "mark", title: "A pixel that has the error", hidden: !mark });
  if (mark) Object.assign(ring.style, { left: `${(100 * (mark[0] + 0.5)) / width}%`, bottom: `${(100 * (mark[1] + 0.5)) / height}%` });
  const slider = element("input", { type: "range", min: 0, max: 100, value: 50, "aria-label": "How much is yours, and how much the expected picture" });
  let mode = "split";
  const draw = () => {
    slider.disabled = mode !== "split";
    if (mode !== "split") {
      if (images[mode]) context.putImageData(images[mode], 0, 0);
      canvas.setAttribute("aria-label", modes[mode]);
      return;
    }
    const x = Math.round((slider.value / 100) * width);
    context.clearRect(0, 0, width, height);
    if (images.own) context.putImageData(images.own, 0, 0, 0, 0, x, height);
    if (images.expected) context.putImageData(images.expected, 0, 0, x, 0, width - x, height);
    context.fillStyle = "white";
    context.fillRect(x - 1, 0, 2, height);
    canvas.setAttribute("aria-label", `left ${slider.value} %: your picture; right: the expected one`);
  };
  slider.addEventListener("input", draw);
  const drag = (event) => {
    if (mode !== "split" || !(event.buttons & 1)) return;
    const box = canvas.getBoundingClientRect();
    slider.value = (100 * (event.clientX - box.left)) / box.width;
    draw();
  };
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    drag(event);
  });
  canvas.addEventListener("pointermove", drag);
  const group = `compare-mode-${++count}`;
  const choices = Object.entries(modes).filter(([name]) => name === "split" || images[name]).map(([name, text]) => {
    const input = element("input", { type: "radio", name: group, value: name, checked: name === mode });
    input.addEventListener("change", () => {
      mode = name;
      draw();
    });
    return element("label", {}, input, element("span", {}, text));
  });
  draw();
  return element("div", { className: "viewer" }, element("div", { className: "views", role: "radiogroup", "aria-label": "What is shown" }, ...choices), element("div", { className: "pictures", style: `aspect-ratio: ${width} / ${height}` }, canvas, ring), slider);
}
