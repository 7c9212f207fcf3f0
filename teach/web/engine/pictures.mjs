// SPDX-License-Identifier: MIT
// The tree's large pictures come as lossless WebP, a quarter smaller than PNG, and the browser unpacks them: beside this
// thread, and sooner than the C++. It gets them as a PPM file, which has the bytes as they are.

/// Whether this browser gives a picture's bytes back as they are. Some that hide who one is change a few of them.
export function isExact() {
  const context = new OffscreenCanvas(16, 16).getContext("2d", { willReadFrequently: true });
  if (!context) return false;
  const image = context.createImageData(16, 16);
  for (let i = 0; i < image.data.length; ++i) image.data[i] = i % 4 === 3 ? 255 : (i * 167 + 13) % 256;
  context.putImageData(image, 0, 0);
  return context.getImageData(0, 0, 16, 16).data.every((value, i) => value === image.data[i]);
}

/// An opaque picture (a Blob) as a PPM file: a line of text, then red, green and blue from the top row on.
export async function asPpm(blob) {
  const bitmap = await createImageBitmap(blob, { colorSpaceConversion: "none", premultiplyAlpha: "none" });
  const { width, height } = bitmap;
  const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
  context.drawImage(bitmap, 0, 0);
  bitmap.close();
  const { data } = context.getImageData(0, 0, width, height);
  const header = new TextEncoder().encode(`P6 ${width} ${height} 255\n`);
  const ppm = new Uint8Array(header.length + 3 * width * height);
  ppm.set(header);
  for (let from = 0, to = header.length; from < data.length; from += 4, to += 3) {
    ppm[to] = data[from];
    ppm[to + 1] = data[from + 1];
    ppm[to + 2] = data[from + 2];
  }
  return ppm;
}
