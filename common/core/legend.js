// SPDX-License-Identifier: MIT
// How the colours of a data view are read, as the labs describe it (common/app/include/app/legend.hpp).
globalThis.texelLegend = ({ title, width, height, colors, ball, ticks }) => {
  const make = (tag, className, text = "") => Object.assign(document.createElement(tag), { className, textContent: text });
  const legend = make("div", "view-legend"), canvas = Object.assign(make("canvas", ball ? "ball" : ""), { width, height });
  const picture = new ImageData(width, height);
  for (let i = 0; i < width * height; ++i) {
    const at = ((height - 1 - Math.floor(i / width)) * width + (i % width)) * 4;  // the bottom row comes first
    for (let c = 0; c < 3; ++c) picture.data[at + c] = Number.parseInt(colors.substr(6 * i + 2 * c, 2), 16);
    picture.data[at + 3] = 255;
  }
  canvas.getContext("2d").putImageData(picture, 0, 0);
  legend.append(make("div", "title", title), canvas);
  if (ticks.length === 0) return legend;
  canvas.className = "bar-of-legend";
  const scale = make("div", "ticks");
  for (const [place, text] of ticks) {
    const tick = make("span", "", text);
    tick.style.left = `${100 * place}%`;
    scale.append(tick);
  }
  legend.append(scale);
  return legend;
};
