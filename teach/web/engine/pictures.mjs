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
  const pixels = new Uint32Array(count);
  await image.copyTo(pixels, { format: "RGBA" });
  image.close();
  decoder.close();
  // Four pixels at a time are three words. Blanks let them begin at a word.
  const text = `${width} ${height} 255\n`, length = 4 * Math.ceil((text.length + 3) / 4);
  const header = new TextEncoder().encode(`P6 ${text.padStart(length - 3)}`);
  const ppm = new Uint8Array(header.length + 4 * Math.ceil((3 * count) / 4));
  ppm.set(header);
  const words = new Uint32Array(ppm.buffer, header.length);
  for (let from = 0, to = 0; from < count; from += 4, to += 3) {
    const a = pixels[from], b = pixels[from + 1], c = pixels[from + 2], d = pixels[from + 3];
    words[to] = (a & 0xffffff) | (b << 24);
    words[to + 1] = ((b >>> 8) & 0xffff) | (c << 16);
    words[to + 2] = ((c >>> 16) & 0xff) | (d << 8);
  }
  return ppm.subarray(0, header.length + 3 * count);
}
