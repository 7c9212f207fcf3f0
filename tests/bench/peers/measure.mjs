// SPDX-License-Identifier: MIT
// node tests/bench/peers/measure.mjs [ROUNDS] [--json]: our page of lab 9 and three.js' page of the same mirror ball
// (mirror_ball.js), in turns, in headless Chromium with SwiftShader. Prints the medians, or all rounds as JSON:
// [{ours: {…}, theirs: {…}}] with
// - cold_ms: of three.js, from the start of a browser to the first picture,
// - first_picture_ms: from navigation to the first picture, and bytes: loaded when the page says that it is ready. In a browser
//   that has drawn both and is at rest, on a fresh page without a cache,
// - still_ms: of ours, from navigation until the still that stands for the first picture is on the screen,
// - antialiased_ms, plain_ms: a picture of 512x512 with 4 samples a pixel and with one, the median of several.
// Both draw the same picture: one cube map and one normal map of 512x512 with all mipmaps, trilinear, a ball of 128x64 quads, the
// background. Needs out/web (./run web) and, in this folder, npm ci. Numbers of a busy machine are worth nothing.
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { brotliCompressSync } from "node:zlib";
import { enginePage, launch } from "../../web_site/browser.mjs";
import { serve } from "../../../teach/web/engine/serve.mjs";

const here = dirname(fileURLToPath(import.meta.url)), tree = join(here, "../../..");
const isJson = process.argv.includes("--json"), rounds = Number(process.argv.slice(2).find((word) => word !== "--json") ?? 5), kFrames = 7;
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

const code = readFileSync(join(folder, "peer.js"));
writeFileSync(join(folder, "peer.js.br"), brotliCompressSync(code));  // as our page's

const median = (values) => values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)];
const peers = await serve(folder), ours = await serve(join(tree, "out/web"));

const kRest = 1200;  // milliseconds in which a browser makes its own window's pages

/** What `ask` gives on a fresh page, which is asked for after `rest` milliseconds. */
async function visit(browser, url, ask, rest = kRest) {
  const context = await browser.createBrowserContext(), page = await context.newPage();
  await page.setViewport({ width: 1300, height: 900 });  // the lab's picture has 596x480 pixels there
  await new Promise((done) => setTimeout(done, rest));
  await page.goto(url);
  const result = await page.evaluate(ask, kFrames);
  await context.close();
  return result;
}

const visitTheirs = (browser, query, rest) => visit(browser, `${peers.url}${query}`, async (frames) => {
  const { first_picture_ms, bytes } = await window.peer.ready, times = [];
  for (let i = 0; i < frames; ++i) {
    await new Promise(requestAnimationFrame);
    times.push(window.peer.draw());
  }
  return { first_picture_ms, first_picture_at: performance.timeOrigin + first_picture_ms, bytes, times };
}, rest);
const visitOurs = (browser) => visit(browser, `${ours.url}09_bump/index.html?look=default`, async () => {
  await window.texel.ready;
  const { first_picture_ms, bytes } = window.texel.figures();
  return { first_picture_ms, bytes };
});
const visitStill = (browser) => visit(browser, `${ours.url}09_bump/index.html`, () => new Promise((done) => {
  new PerformanceObserver((list) => done(list.getEntries()[0].renderTime)).observe({ type: "element", buffered: true });
}));

async function drawTheirs(browser) {
  const { first_picture_ms, bytes, times } = await visitTheirs(browser, "?antialias");
  return { first_picture_ms, bytes, antialiased_ms: median(times), plain_ms: median((await visitTheirs(browser, "")).times) };
}

async function drawOurs(browser) {
  const still_ms = await visitStill(browser), first = await visitOurs(browser), engine = await enginePage(browser, join(tree, "out/web"));
  await engine.call("open", 9);
  await engine.call("resize", 512, 512);
  const frame = async (samples) => {
    await engine.call("samples", samples);
    const times = [];
    for (let i = 0; i < kFrames; ++i) times.push((await engine.call("frame")).frame_ms);
    return median(times);
  };
  const result = { still_ms, ...first, antialiased_ms: await frame(4), plain_ms: await frame(1) };
  await engine.page.close();
  engine.close();
  return result;
}

const all = [];
try {
  for (let round = 0; round < rounds; ++round) {
    const one = {}, begin = Date.now(), browser = await launch();
    try {
      const cold_ms = (await visitTheirs(browser, "?antialias", 0)).first_picture_at - begin;
      await visitOurs(browser);
      // Who comes second finds the machine as the first left it: they change places.
      for (const who of round % 2 === 0 ? ["ours", "theirs"] : ["theirs", "ours"])
        one[who] = await (who === "ours" ? drawOurs : drawTheirs)(browser);
      one.theirs.cold_ms = cold_ms;
    } finally {
      await browser.close();
    }
    all.push(one);
  }
} finally {
  peers.close();
  ours.close();
  rmSync(folder, { recursive: true, force: true });
}
if (isJson) console.log(JSON.stringify(all));
else
  for (const what of Object.keys({ ...all[0].ours, ...all[0].theirs })) {
    const of = (who) => (all[0][who][what] === undefined ? "" : `${who} ${Math.round(median(all.map((one) => one[who][what])))}  `);
    console.log(what.padEnd(18), of("ours") + of("theirs"));
  }
