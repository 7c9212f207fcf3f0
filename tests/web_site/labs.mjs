// SPDX-License-Identifier: MIT
// node tests/web_site/labs.mjs OUT_WEB BIN [DOCUMENT]: each lab's default look and data views in the browser beside the
// desktop's snapshots of the same parameters. Exit code 1 where too many pixels are past the limit, 77 where the pages are not
// built. With a document (docs/browser.md), its table is written anew.
//
// A data view's limit is the smallest of the lab's cases of that view (of any lab's, where this one has no case); a colour's is
// 2 levels. Edges are left out: a pixel counts only where the desktop's picture changes by no more than `smooth` in the 3x3
// pixels around it. Elsewhere a triangle's or a texture's edge passes, and which pixels it covers is the rasteriser's choice.
//
// SwiftShader rounds vertices to 1/16 of a pixel, and an edge between triangles covers other pixels than by llvmpipe. On models of
// many triangles up to 2.2 % of the pixels are past the limit (lab 5, texcoord), so `least` of them must be within it. Colours are
// filtered by mipmap levels, whose choice OpenGL leaves to the driver: 5.1 % in lab 9 differ by more than 2 levels. Both leave a
// factor of two.
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { enginePage, launch } from "./browser.mjs";

const [site, bin, documentFile] = process.argv.slice(2);
if (!existsSync(join(site, "engine/engine.wasm"))) {
  console.log(`skipped: there is no engine in ${site}; type ./run web`);
  process.exit(77);
}
const least = (view) => (view === "color" ? 0.9 : 0.95);
const only = process.env.TEXEL_LABS?.split(",").map(Number);

function readPfm(file) {
  const bytes = readFileSync(file);
  const header = bytes.subarray(0, 64).toString("latin1").match(/^P[Ff]\n(\d+) (\d+)\n(-?[\d.]+)\n/);
  const data = new Float32Array(bytes.buffer.slice(bytes.byteOffset + header[0].length, bytes.byteOffset + bytes.length));
  return { width: +header[1], height: +header[2], at: (x, y, c) => data[(y * header[1] + x) * 3 + c] };
}

/// The difference of two pixels in the view's unit.
const differences = {
  color: (a, b) => Math.max(...[0, 1, 2].map((c) => Math.abs(a[c] - b[c]))),
  normal: angle, tangent: angle, direction: angle,
  texcoord: (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]),
  lod: (a, b) => Math.abs(a[0] - b[0]),
  depth: (a, b) => Math.abs(a[0] - b[0]),
  mask: (a, b) => Math.abs(a[0] - b[0]),
};
function angle(a, b) {
  const cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  return (Math.atan2(Math.hypot(...cross), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) * 180) / Math.PI;
}

/// So much a view may change from pixel to pixel where no edge is, in its unit.
const smooth = { color: 24, normal: 10, tangent: 10, direction: 10, texcoord: 0.1, lod: 0.5, depth: 0.1, mask: 0 };

function compare(view, size, limit, own, desktop) {
  const difference = differences[view];
  const pixel = (picture, x, y) => [0, 1, 2].map((c) => picture.at(x, y, c));
  const all = [];
  for (let y = 1; y < size - 1; ++y)
    for (let x = 1; x < size - 1; ++x) {
      const here = pixel(desktop, x, y);
      let edge = false;
      for (let j = y - 1; j <= y + 1; ++j)
        for (let i = x - 1; i <= x + 1; ++i) edge ||= !(difference(here, pixel(desktop, i, j)) <= smooth[view]);
      if (edge) continue;
      const found = difference(pixel(own, x, y), here);
      all.push(Number.isNaN(found) ? Infinity : found);
    }
  all.sort((a, b) => a - b);
  const at = (q) => all[Math.max(Math.ceil(q * all.length) - 1, 0)];
  return {
    within: all.filter((one) => one <= limit).length / all.length,
    p95: at(0.95), max: at(1), compared: all.length / (size - 2) ** 2,
  };
}

/// Between the document's two comments.
function write(file, version, renderer) {
  const text = readFileSync(file, "utf8"), begin = "<!-- views begin -->\n", end = "<!-- views end -->";
  const table = rows.map((row) => `| ${parseInt(row.lab)} | ${row.view} | ${row.limit} | ${(100 * row.within).toFixed(1)} % | ${+row.p95.toPrecision(2)} |`);
  const [before, rest] = text.split(begin), after = rest.slice(rest.indexOf(end));
  writeFileSync(file, `${before}${begin}${version}, ${/SwiftShader/.exec(renderer)?.[0] ?? renderer}, ${size}x${size} pixels, beside the desktop's llvmpipe.
Degrees, texture widths, levels, units of depth, or steps of 8 bits for colours.

| lab | view | limit | pixels within it | 95 % of the pixels differ by at most |
| --- | --- | --: | --: | --: |
${table.join("\n")}
${after}`);
}

/// Each value of each choice of each lab in colour, beside the desktop's.
async function drawChoices(engine, labs) {
  for (const lab of labs) {
    if (only && !only.includes(lab.number)) continue;
    await engine.call("open", lab.number);
    const wanted = (await engine.call("parameters")).flatMap(({ name, choices = [] }) => choices.map((one) => ({ name, value: one.name ?? one })));
    const shown = ({ name, value }) => `${lab.folder} --${name.replaceAll("_", "-")} ${value}`;
    writeFileSync(join(folder, "batch.json"), JSON.stringify(wanted.map(({ name, value }, i) => ({ name: `${i}.png`, size: `${size}x${size}`, set: { [name]: value } }))));
    execFileSync(join(bin, `lab${lab.folder}`), ["--batch", join(folder, "batch.json"), "--out", join(folder, lab.folder)]);
    for (const [i, one] of wanted.entries()) {
      const drawn = await engine.draw({ view: "color", size: `${size}x${size}`, set: { [one.name]: one.value } }).catch((error) => ({ error }));
      if (drawn.error) {
        ++failed;
        console.log(`FAILED ${shown(one)}: ${drawn.error.message}`);
        continue;
      }
      const own = { at: (x, y, c) => drawn.data[(y * size + x) * drawn.channels + c] };
      const found = compare("color", size, 2, own, desktopColours(join(folder, lab.folder, `${i}.png`)));
      console.log(`${found.within >= 0.9 ? "ok    " : "FAILED"} ${shown(one)}: ${(100 * found.within).toFixed(2)} % within 2`);
      failed += found.within >= 0.9 ? 0 : 1;
    }
  }
}

/// Of a .png, the bottom row first as the engine has it.
function desktopColours(file) {
  execFileSync("convert", [file, "-flip", "-depth", "8", `rgb:${join(folder, "raw")}`]);
  const raw = readFileSync(join(folder, "raw"));
  return { at: (x, y, c) => raw[(y * size + x) * 3 + c] };
}

const size = 256;
/** What an experiment may begin with draws another picture than the lab, in each view, and nothing of it stays. */
async function drawExperiments(engine) {
  const folder = new URL("../../teach/web/site/experiments/", import.meta.url);
  for (const [number, file, path] of [[4, "triplanar", "shaders/04_cube_wrap/cube_wrap.frag"], [5, "parallax", "shaders/05_normal_map/normal_map.frag"],
    [8, "matcap", "shaders/08_reflection/reflection.frag"]]) {
    if (only && !only.includes(number)) continue;
    const { views } = await engine.call("open", number);
    const picture = async () => Buffer.from((await engine.draw({ size: "96x96" })).data);
    const before = await picture();
    await engine.call("experiment", path, readFileSync(new URL(`${file}.frag`, folder), "utf8"));
    const other = await picture();
    for (const view of views.filter((one) => one !== "error")) await engine.draw({ view, size: "32x32" });
    await engine.call("experiment", path, "");
    const holds = !other.equals(before) && (await picture()).equals(before);
    failed += holds ? 0 : 1;
    console.log(`${holds ? "ok    " : "FAILED"} experiment ${file}`);
  }
}

const folder = mkdtempSync(join(tmpdir(), "texel_labs_"));
const browser = await launch();
const rows = [];
let failed = 0;
try {
  const engine = await enginePage(browser, site);
  const labs = JSON.parse(readFileSync(join(site, "engine/files.json"))).labs;
  // The limits of the graded cases, by view.
  const limits = {};
  for (const lab of labs)
    for (const step of await engine.call("steps_of", lab.number))
      for (const one of step.cases) {
        if (one.size === "") continue;
        for (const key of [`${lab.number} ${one.view}`, one.view]) limits[key] = Math.min(limits[key] ?? Infinity, one.limit);
      }
  for (const lab of labs) {
    if (only && !only.includes(lab.number)) continue;
    const { views } = await engine.call("open", lab.number);
    const wanted = views.filter((view) => view !== "error");
    // Data views without mipmaps, where the lab has a choice: their levels are the driver's.
    const filter = (await engine.call("parameters")).find(({ name, choices }) => name === "filter" && choices.some((one) => (one.name ?? one) === "bilinear"));
    const settings = (view) => (filter && view !== "color" ? { filter: "bilinear" } : {});
    writeFileSync(join(folder, "batch.json"), JSON.stringify(wanted.map((view) =>
      ({ name: view === "color" ? "color.png" : `${view}.pfm`, view, size: `${size}x${size}`, set: settings(view) }))));
    execFileSync(join(bin, `lab${lab.folder}`), ["--batch", join(folder, "batch.json"), "--out", join(folder, lab.folder)]);
    for (const view of wanted) {
      const drawn = await engine.draw({ view, size: `${size}x${size}`, set: settings(view) });
      const own = { at: (x, y, c) => drawn.data[(y * size + x) * drawn.channels + c] };
      const desktop = view === "color" ? desktopColours(join(folder, lab.folder, "color.png")) : readPfm(join(folder, lab.folder, `${view}.pfm`));
      const limit = view === "color" ? 2 : limits[`${lab.number} ${view}`] ?? limits[view] ?? (view === "mask" ? 0 : 0.001);
      const row = { lab: lab.folder, view, limit, ...compare(view, size, limit, own, desktop) };
      row.passed = row.within >= least(view);
      failed += row.passed ? 0 : 1;
      rows.push(row);
      console.log(`${row.passed ? "ok    " : "FAILED"} ${lab.folder} ${view}: ${(100 * row.within).toFixed(2)} % within ${limit}, 95 % within ${row.p95.toPrecision(3)}, at most ${row.max.toPrecision(3)}, ${(100 * row.compared).toFixed(0)} % compared`);
    }
  }
  await drawChoices(engine, labs);
  await drawExperiments(engine);
  const { renderer } = await engine.call("figures");
  if (documentFile) write(documentFile, (await browser.version()).split(".")[0], renderer);
  engine.close();
} finally {
  await browser.close().catch(() => {});
  rmSync(folder, { recursive: true, force: true });
}
process.exit(failed ? 1 : 0);
