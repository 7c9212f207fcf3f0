// SPDX-License-Identifier: MIT
// The tree's large pictures come as lossless WebP, a quarter smaller than PNG, and the browser unpacks them: beside this
// thread, and sooner than the C++. It gets them as a PPM file, which has the bytes as they are.

/// Not all browsers have such a decoder, and none has it on a page without https: the PNG is loaded there.
export const unpacks = "ImageDecoder" in globalThis;

/// The file of an opaque picture as a PPM file: a line of text, then red, green and blue from the top row on.
export async function asPpm(webp) {
  const decoder = new ImageDecoder({ data: webp, type: "image/webp", colorSpaceConversion: "none" });
  const { image } = await decoder.decode();
  const { codedWidth: width, codedHeight: height } = image, count = width * height;
  const pixels = new Uint8Array(4 * count);
  await image.copyTo(pixels, { format: "RGBA" });
  image.close();
  decoder.close();
  const header = new TextEncoder().encode(`P6 ${width} ${height} 255\n`), ppm = new Uint8Array(header.length + 3 * count);
  ppm.set(header);
  for (let from = 0, to = header.length; from < pixels.length; from += 4, to += 3) {
    ppm[to] = pixels[from];
    ppm[to + 1] = pixels[from + 1];
    ppm[to + 2] = pixels[from + 2];
  }
  return ppm;
}
