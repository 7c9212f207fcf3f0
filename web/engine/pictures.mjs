// SPDX-License-Identifier: MIT
// The tree's large pictures come as lossless WebP, a quarter smaller than PNG, and the browser unpacks them: beside this
// thread, and sooner than the C++. It gets them as a TGA file, which has the bytes as they are.

/// Whether this browser gives a picture's bytes back as they are. Some that hide who one is change a few of them.
export function isExact() {
  const context = new OffscreenCanvas(16, 16).getContext("2d", { willReadFrequently: true });
  if (!context) return false;
  const image = context.createImageData(16, 16);
  for (let i = 0; i < image.data.length; ++i) image.data[i] = i % 4 === 3 ? 255 : (i * 167 + 13) % 256;
  context.putImageData(image, 0, 0);
  return context.getImageData(0, 0, 16, 16).data.every((value, i) => value === image.data[i]);
}

/// An opaque picture (a Blob) as a TGA file: a header of 18 bytes, then blue, green and red from the top row on.
export async function asTga(blob) {
  const bitmap = await createImageBitmap(blob, { colorSpaceConversion: "none", premultiplyAlpha: "none" });
  const { width, height } = bitmap;
  const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
  context.drawImage(bitmap, 0, 0);
  bitmap.close();
  const { data } = context.getImageData(0, 0, width, height);
  const tga = new Uint8Array(18 + 3 * width * height);
  tga.set([0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, width & 255, width >> 8, height & 255, height >> 8, 24, 0x20]);
  for (let from = 0, to = 18; from < data.length; from += 4, to += 3) {
    tga[to] = data[from + 2];
    tga[to + 1] = data[from + 1];
    tga[to + 2] = data[from];
  }
  return tga;
}
