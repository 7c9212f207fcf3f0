// SPDX-License-Identifier: MIT
// Pictures of the tree, as small as a page needs them.
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { PNG } from "pngjs";

/** Width and height of a PNG, without decoding it. */
export function pngSize(file) {
  const bytes = readFileSync(file);
  return { width: bytes.readUInt32BE(16), height: bytes.readUInt32BE(20) };
}

/** Width and height of a picture: of a PNG, or of an SVG by its viewBox. */
export function pictureSize(file) {
  if (!file.endsWith(".svg")) return pngSize(file);
  const [, width, height] = /viewBox="0 0 (\d+) (\d+)"/.exec(readFileSync(file, "utf8"));
  return { width, height };
}

const linear = Float64Array.from({ length: 256 }, (_, i) => (i / 255 <= 0.04045 ? i / 255 / 12.92 : ((i / 255 + 0.055) / 1.055) ** 2.4));
const encoded = (value) => Math.round(255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055));

/** A PNG (its bytes) as WebP of a quality, 0 to 100. */
export function asWebp(png, quality) {
  return execFileSync("cwebp", ["-quiet", "-q", String(quality), "-o", "-", "--", "-"], { input: png, maxBuffer: 1 << 24 });
}

/** The middle of a PNG, fitted to width x height by averaging in linear light. */
function fitted(file, width, height) {
  const from = PNG.sync.read(readFileSync(file));
  const scale = Math.min(from.width / width, from.height / height);
  const left = (from.width - scale * width) / 2, top = (from.height - scale * height) / 2;
  const small = new PNG({ width, height }), { data } = small;
  data.fill(255);
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      const x0 = Math.floor(left + x * scale), x1 = Math.max(x0 + 1, Math.floor(left + (x + 1) * scale));
      const y0 = Math.floor(top + y * scale), y1 = Math.max(y0 + 1, Math.floor(top + (y + 1) * scale));
      for (let c = 0; c < 3; ++c) {
        let sum = 0;
        for (let v = y0; v < y1; ++v) for (let u = x0; u < x1; ++u) sum += linear[from.data[4 * (v * from.width + u) + c]];
        data[4 * (y * width + x) + c] = encoded(sum / ((x1 - x0) * (y1 - y0)));
      }
    }
  return small;
}

export const smallPicture = (file, width, height, quality) => asWebp(PNG.sync.write(fitted(file, width, height)), quality);

/** The middles of PNGs as squares of one WebP, one below the other. */
export function strip(files, side, quality) {
  const all = new PNG({ width: side, height: side * files.length });
  files.forEach((file, i) => PNG.bitblt(fitted(file, side, side), all, 0, 0, side, side, 0, i * side));
  return asWebp(PNG.sync.write(all), quality);
}

/**
 * What a lab opens with, as its program draws it with the tree's shaders: a small WebP. A page shows it until its own picture is there;
 * it is wide, and the page cuts off what it has no room for. null where the program is not built.
 */
export function still(program, tree, { set, view, right }) {
  if (!program || !existsSync(program)) return null;
  const folder = mkdtempSync(join(tmpdir(), "texel_still_")), file = join(folder, "still.png");
  try {
    const drawn = (values) => {
      const flags = Object.entries(values).flatMap(([name, value]) => [`--${name.replaceAll("_", "-")}`, value]);
      execFileSync(program, ["--assets", tree, "--snapshot", file, "--size", "784x448", "--view", view, ...flags]);
      return PNG.sync.read(readFileSync(file));
    };
    const picture = drawn(set), half = picture.width / 2;
    PNG.bitblt(drawn({ ...set, ...right }), picture, half, 0, half, picture.height, half, 0);
    // A plane of fine checkers is large at any quality.
    const webps = [62, 45, 30].map((quality) => asWebp(PNG.sync.write(picture), quality));
    return webps.find((webp) => webp.length < 32768) ?? webps.at(-1);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** The gallery's picture of a look, or null where the gallery was not drawn. */
export function galleryPicture(gallery, lab, look) {
  if (!gallery) return null;
  const file = join(gallery, lab.folder, `${look.name}.png`);
  return existsSync(file) ? file : null;
}
