// SPDX-License-Identifier: MIT
// node tests/bench/peers/measure.mjs [ROUNDS]: our page of lab 9 and three.js' page of the same mirror ball (mirror_ball.js), in
// turns, in one headless Chromium with SwiftShader: time from navigation to the first picture, a picture of 512x512 with and
// without antialiasing, and the bytes until the first picture. Prints the medians. A fresh page each time, without a cache.
// Needs out/web (./run web) and, in this folder, npm ci. Numbers of a busy machine are worth nothing.
import { cpSync, existsSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { enginePage, launch } from "../../web_site/browser.mjs";
import { serve } from "../../../web/engine/serve.mjs";

const here = dirname(fileURLToPath(import.meta.url)), tree = join(here, "../../..");
const rounds = Number(process.argv[2] ?? 5), kFrames = 7;
for (const [needed, by] of [[join(tree, "out/web/engine/engine.wasm"), "./run web"], [join(here, "node_modules"), `npm ci in ${here}`]])
  if (!existsSync(needed)) {
    console.error(`${needed} is missing: type ${by}`);
    process.exit(3);
  }
const { build } = await import("esbuild");

const folder = mkdtempSync(join(tmpdir(), "texel_peers_"));
await build({ entryPoints: [join(here, "mirror_ball.js")], outfile: join(folder, "peer.js"), bundle: true, minify: true, format: "esm", logLevel: "error" });
writeFileSync(join(folder, "index.html"), `<!doctype html><title>three.js</title><canvas width="512" height="512"></canvas><script type="module" src="peer.js"></script>\n`);
for (const assets of ["assets/cube_maps/scene", "assets/normal_maps"]) {
  mkdirSync(join(folder, assets), { recursive: true });
  cpSync(join(tree, assets), join(folder, assets), { recursive: true });
}

const median = (values) => values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)];
const times = {};
const note = (who, what, value) => ((times[what] ??= {})[who] ??= []).push(value);

const browser = await launch(), peers = await serve(folder), ours = await serve(join(tree, "out/web"));
/** What `ask` gives on a fresh page of the address. */
async function visit(url, ask) {
  const context = await browser.createBrowserContext(), page = await context.newPage();
  await page.setCacheEnabled(false);
  await page.goto(url);
  const result = await page.evaluate(ask, kFrames);
  await context.close();
  return result;
}
async function peer(query, which) {
  const { first_picture_ms, bytes, frames } = await visit(`${peers.url}${query}`, async (frames) => {
    const first = await window.peer.ready;
    return { ...first, frames: Array.from({ length: frames }, () => window.peer.draw()) };
  });
  note("three.js", which, median(frames));
  return { first_picture_ms, bytes };
}
try {
  const engine = await enginePage(browser, join(tree, "out/web"));
  await engine.call("open", 9);
  await engine.call("resize", 512, 512);
  for (let round = 0; round < rounds; ++round) {
    const own = await visit(`${ours.url}09_bump/`, () => window.texel.ready.then(() => window.texel.figures()));
    note("ours", "first picture, ms", own.first_picture_ms);
    note("ours", "bytes", own.bytes);
    for (const [samples, which, query] of [[4, "512x512 antialiased, ms", "?antialias"], [1, "512x512, ms", ""]]) {
      await engine.call("samples", samples);
      const frames = [];
      for (let i = 0; i < kFrames; ++i) frames.push((await engine.call("frame")).frame_ms);
      note("ours", which, median(frames));
      const other = await peer(query, which);
      if (query === "") continue;
      note("three.js", "first picture, ms", other.first_picture_ms);
      note("three.js", "bytes", other.bytes);
    }
  }
  engine.close();
} finally {
  await browser.close();
  peers.close();
  ours.close();
  rmSync(folder, { recursive: true, force: true });
}
for (const [what, by] of Object.entries(times))
  console.log(`${what.padEnd(24)} ${Object.entries(by).map(([who, all]) => `${who} ${Math.round(median(all))}`).join(", ")}`);
