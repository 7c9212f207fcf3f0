// SPDX-License-Identifier: MIT
// node teach/web/engine/pack.mjs TREE BUILD OUT KIND: puts the engine into OUT: the program, and what the labs of TREE read.
// Shaders, lab files and sources with steps go into files.json, since a session reads them all; pictures, models and
// expected pictures are files, loaded when they are needed. Large pictures come as lossless WebP too (pictures.mjs).
import { execFileSync } from "node:child_process";
import { cpSync, mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { dirname, join, relative } from "node:path";

const [tree, build, out, kind] = process.argv.slice(2);
const own = import.meta.dirname ?? dirname(new URL(import.meta.url).pathname);

function* files(folder) {
  for (const entry of readdirSync(join(tree, folder), { withFileTypes: true })) {
    const path = join(folder, entry.name);
    if (entry.isDirectory()) yield* files(path);
    else yield path;
  }
}
const has = (folder) => statSync(join(tree, folder), { throwIfNoEntry: false })?.isDirectory();
const all = ["shaders", "labs", ".starter", "assets/textures", "assets/normal_maps", "assets/cube_maps", "assets/models"]
  .filter(has).flatMap((folder) => [...files(folder)]);

const listing = { kind, labs: [], texts: {}, files: {}, packed: [] };
rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
/// Puts a PNG of 8 bits a colour into OUT as lossless WebP too. BUILD keeps it: it takes half a second.
function pack(path) {
  const source = join(tree, path), png = readFileSync(source);
  const isPlain = path.startsWith("assets/") && path.endsWith(".png") && png[24] === 8 && png[25] === 2 && !png.includes("tRNS");
  if (!isPlain || png.length < 4096) return;
  const kept = join(build, "webp", path.replace(/png$/, "webp"));
  if (!(statSync(kept, { throwIfNoEntry: false })?.mtimeMs > statSync(source).mtimeMs)) {
    mkdirSync(dirname(kept), { recursive: true });
    execFileSync("cwebp", ["-quiet", "-lossless", "-z", "9", "-exact", source, "-o", kept]);
  }
  listing.packed.push(path);
  cpSync(kept, join(out, "tree", path.replace(/png$/, "webp")));
}
/// C++ is not compiled here: what stands between the markers is kept, at its lines.
function stepsAlone(text) {
  let inside = false;
  return text.split("\n").map((line) => {
    const isMarker = /^\s*\/\/@/.test(line);
    if (isMarker) inside = !line.includes("//@end");
    return isMarker || inside ? line : "";
  }).join("\n");
}
const hasStep = (text) => /^\s*\/\/@step /m.test(text);
for (const path of all) {
  const source = join(tree, path);
  const isPicture = path.startsWith("assets/") || path.includes("/expected/");
  if (!isPicture) {
    if (!/\.(glsl|vert|frag|toml|cpp|hpp)$/.test(path)) continue;
    const text = readFileSync(source, "utf8");
    if (!/\.(cpp|hpp)$/.test(path)) listing.texts[path] = text;
    else if (hasStep(text)) listing.texts[path] = stepsAlone(text);
    continue;
  }
  if (/\.(md|sha256)$|LICENSE/.test(path)) continue;
  listing.files[path] = statSync(source).size;
  mkdirSync(join(out, "tree", dirname(path)), { recursive: true });
  cpSync(source, join(out, "tree", path));
  pack(path);
}
for (const [path, text] of Object.entries(listing.texts)) {
  if (!path.endsWith("/lab.toml")) continue;
  const folder = path.split("/")[1], entry = (key) => text.match(new RegExp(`^${key} = "(.*)"$`, "m"))?.[1] ?? "";
  listing.labs.push({ number: parseInt(folder), folder, title: entry("title"), lesson: entry("lesson") });
}
listing.labs.sort((a, b) => a.number - b.number);
writeFileSync(join(out, "files.json"), JSON.stringify(listing));
for (const file of ["client.mjs", "pictures.mjs", "worker.mjs"]) cpSync(join(own, file), join(out, file));
for (const file of ["engine.mjs", "engine.wasm"]) cpSync(join(build, file), join(out, file));
console.log(`${relative(process.cwd(), out)}: ${Object.keys(listing.texts).length} texts, ${Object.keys(listing.files).length} files`);
