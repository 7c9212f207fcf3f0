// SPDX-License-Identifier: MIT
/** A picture of the engine, RGB or RGBA and bottom row first, as a canvas takes it: opaque, top row first. */
export function imageOf(bytes, width, height) {
  const image = new ImageData(width, height);
  const channels = bytes.length / (width * height);
  for (let y = 0, to = 0; y < height; ++y)
    for (let x = 0; x < width; ++x, to += 4) {
      const from = channels * ((height - 1 - y) * width + x);
      for (let c = 0; c < 3; ++c) image.data[to + c] = bytes[from + c];
      image.data[to + 3] = 255;
    }
  return image;
}
