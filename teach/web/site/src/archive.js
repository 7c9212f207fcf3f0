// SPDX-License-Identifier: MIT
// A .zip of shader files with the starter's paths: it can be unpacked over the desktop's tree, and `texel grade` takes it.
import { strFromU8, strToU8, unzip, zip } from "fflate";
import { pathOf } from "./places.js";

const kMostBytes = 4 << 20;  // of one file: a shader has some kilobytes
const kEpoch = new Date(1980, 0, 1);  // equal texts give equal bytes

/** `texts`: {path: text}. */
export function packed(texts) {
  const files = Object.fromEntries(Object.entries(texts).map(([path, text]) => [path, [strToU8(text), { mtime: kEpoch }]]));
  return new Promise((done, failed) =>
    zip(files, { level: 9 }, (error, bytes) => (error ? failed(error) : done(new Blob([bytes], { type: "application/zip" })))));
}

/**
 * The files of a .zip that are among `paths`, as {path: text}. Folders around them are left out of account: a whole tree in
 * a folder of its own is taken too. Throws Error for what is no .zip, and where none of the files is in it.
 */
export async function unpacked(bytes, paths) {
  const files = await new Promise((done, failed) =>
    unzip(new Uint8Array(bytes), { filter: (file) => pathOf(file.name, paths) !== undefined && file.originalSize <= kMostBytes },
      (error, found) => (error ? failed(new Error(`This is no .zip that can be read: ${error.message}.`)) : done(found))));
  const texts = {};
  for (const [name, content] of Object.entries(files)) texts[pathOf(name, paths)] = strFromU8(content);
  if (Object.keys(texts).length === 0)
    throw new Error(`None of the course's shader files is in the .zip. It should hold, for example, ${paths[0]}.`);
  return texts;
}
