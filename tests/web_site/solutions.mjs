// SPDX-License-Identifier: MIT
// node tests/web_site/solutions.mjs STARTER_SITE COURSE: no line of a shader step's solution is in any file of the starter's
// site. Files are searched as they are, decompressed, and with the marks of HTML and JSON taken away. Exit code 1 where one is,
// 77 where the site is not built.
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join, relative } from "node:path";
import { brotliDecompressSync, gunzipSync, inflateRawSync } from "node:zlib";

const [site, course] = process.argv.slice(2);
if (!existsSync(join(site, "engine/engine.wasm"))) {
  console.log(`skipped: there is no engine in ${site}; type ./run web --starter`);
  process.exit(77);
}
const filesBelow = (folder) => readdirSync(folder, { withFileTypes: true }).flatMap((entry) =>
  entry.isDirectory() ? filesBelow(join(folder, entry.name)) : [join(folder, entry.name)]);

const plain = (text) => text.replace(/\s+/g, "");
const kShortest = 12;  // without spaces: "}" and "return a;" say nothing

/// The lines of all solutions, and those that the starter has elsewhere.
const solved = new Set(), given = new Set();
for (const file of filesBelow(join(course, "shaders"))) {
  let part = given;
  for (const line of readFileSync(file, "utf8").split("\n")) {
    if (/^\s*\/\/@(step|teacher) .*begin/.test(line)) part = solved;
    else if (/^\s*\/\/@(starter|end)\s*$/.test(line)) part = given;
    else part.add(plain(line.replace(/^\s*\/\/ ?/, "").replace(/\/\/.*/, "")));  // the starter's own lines are comments there
  }
}
const lines = [...solved].filter((line) => line.length >= kShortest && !given.has(line));

/// A file's texts: as it is, and each way to read it that works.
function* texts(bytes) {
  yield bytes.toString("latin1");
  for (const decompress of [gunzipSync, brotliDecompressSync, inflateRawSync])
    try {
      yield decompress(bytes).toString("latin1");
    } catch { /* not of this kind */ }
}
const readings = (text) => [
  text,
  text.replace(/<[^<>]*>/g, "").replace(/&lt;/g, "<").replace(/&gt;/g, ">").replace(/&quot;/g, '"').replace(/&#39;/g, "'").replace(/&amp;/g, "&"),
  text.replace(/\\[nrt]/g, " ").replace(/\\(.)/g, "$1"),
].map(plain);

let found = 0, searched = 0;
for (const file of filesBelow(site)) {
  ++searched;
  for (const text of texts(readFileSync(file)))
    for (const reading of new Set(readings(text)))
      for (const line of lines)
        if (reading.includes(line)) {
          ++found;
          console.log(`${relative(site, file)} has ${line}`);
        }
}
console.log(`${lines.length} lines of solutions, ${searched} files`);
process.exit(found > 0 || lines.length === 0 ? 1 : 0);
