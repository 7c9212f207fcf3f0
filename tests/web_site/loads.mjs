// SPDX-License-Identifier: MIT
// node tests/web_site/loads.mjs OUT_WEB COURSE: what a lab's page loads. The engine gets the bytes of the tree's pictures from their
// WebP files; the code of a page has at most 1.2 MB compressed; its first paint has the picture that it opens with; from a server that knows nothing but files, below a path; and without a
// net after the first visit. Exit code 1 where one of this does not hold, 77 where the pages are not built.
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { serve } from "../../teach/web/engine/serve.mjs";
import { launch } from "./browser.mjs";

const [site, course] = process.argv.slice(2);
if (!existsSync(join(site, "engine/engine.wasm"))) {
  console.log(`skipped: there is no engine in ${site}; type ./run web`);
  process.exit(77);
}
const { PNG } = createRequire(join(course, "teach/web/site/package.json"))("pngjs");
const kMostCode = 1.2e6;
// Between a page's still and its live picture. The nearest texels of lab 1's fine checker make another pattern in a picture of another
// size: 15 were measured there, and at most 3.6 in the others.
const mostJump = (folder) => (folder.startsWith("01") ? 45 : 12);
let wrong = 0;
const hold = (holds, text) => { wrong += holds ? 0 : 1; console.log(`${holds ? "ok    " : "WRONG "} ${text}`); };

const server = await serve(site, "/a/path/"), browser = await launch();

/** The largest difference of a block's mean colour between two pictures of a page, in this part of it. */
function blockDifference(one, other, { x: left, y: top, width, height }) {
  const kBlock = 40;
  let most = 0;
  for (let y = Math.ceil(top); y + kBlock <= top + height; y += kBlock)
    for (let x = Math.ceil(left); x + kBlock <= left + width; x += kBlock)
      for (let c = 0; c < 3; ++c) {
        let sum = 0;
        for (let i = 0; i < kBlock * kBlock; ++i) {
          const at = 4 * ((y + Math.floor(i / kBlock)) * one.width + x + (i % kBlock)) + c;
          sum += one.data[at] - other.data[at];
        }
        most = Math.max(most, Math.abs(sum) / kBlock ** 2);
      }
  return most;
}

/** How much the picture of a page changes at most from its still on, in any frame that the browser shows until it is live. */
async function jump(url) {
  const context = await browser.createBrowserContext(), page = await context.newPage(), held = [];
  await page.setViewport({ width: 1300, height: 900 });
  await page.setRequestInterception(true);
  const holdBack = (request) => (request.url().endsWith("engine/worker.mjs") ? held.push(request) : request.continue());
  page.on("request", holdBack);
  await page.goto(url, { waitUntil: "domcontentloaded" });
  await page.addStyleTag({ content: ".divider, .legend-place, .spoken { display: none !important }" });
  const picture = await (await page.$(".picture")).boundingBox();
  const shot = () => page.screenshot({ captureBeyondViewport: false });  // the other kind lays the page out anew, without the canvas at first
  const still = await shot();
  const frames = [], cast = await page.createCDPSession();
  cast.on("Page.screencastFrame", ({ data, sessionId }) => {
    frames.push(Buffer.from(data, "base64"));
    cast.send("Page.screencastFrameAck", { sessionId }).catch(() => {});
  });
  await cast.send("Page.startScreencast", { format: "png" });
  page.off("request", holdBack);
  held.forEach((request) => request.continue());
  await page.setRequestInterception(false);
  await page.evaluate(() => texel.ready);
  frames.push(await shot());
  await context.close();
  const [first, ...later] = [still, ...frames].map((png) => PNG.sync.read(Buffer.from(png)));
  return Math.max(...later.map((frame) => blockDifference(first, frame, picture)));
}

try {
  const page = await browser.newPage();
  const asked = [], failed = [];
  page.on("response", (response) => asked.push(response.url()));
  page.on("requestfailed", (request) => failed.push(request.url()));
  await page.goto(`${server.url}engine/files.json`);
  const { packed } = JSON.parse(readFileSync(join(site, "engine/files.json")));
  hold(packed.length > 10, `${packed.length} pictures come as WebP`);
  for (const path of packed) {
    const got = await page.evaluate(async (path) => {
      const { asPpm } = await import(new URL("pictures.mjs", location));
      const ppm = await asPpm(await (await fetch(new URL(`tree/${path.replace(/png$/, "webp")}`, location))).arrayBuffer());
      let text = "";
      for (let i = 0; i < ppm.length; i += 32768) text += String.fromCharCode(...ppm.subarray(i, i + 32768));
      return btoa(text);
    }, path);
    const ppm = Buffer.from(got, "base64"), png = PNG.sync.read(readFileSync(join(course, path)));
    const header = `P6 ${png.width} ${png.height} 255\n`, begin = header.length;
    let differ = ppm.length === begin + 3 * png.width * png.height && ppm.toString("latin1", 0, begin) === header ? 0 : 1;
    for (let i = 0; i < png.width * png.height; ++i) for (let c = 0; c < 3; ++c) differ += ppm[begin + 3 * i + c] === png.data[4 * i + c] ? 0 : 1;
    if (differ > 0) hold(false, `${path}: ${differ} bytes are others`);
  }

  asked.length = 0;
  const lab = `${server.url}09_bump/index.html`;
  await page.goto(lab);
  await page.evaluate(() => texel.ready);
  for (const worker of page.workers()) asked.push(...(await worker.evaluate(() => performance.getEntriesByType("resource").map(({ name }) => name))));
  const code = [...new Set(asked)].filter((url) => /\.(html|m?js|css|json|wasm)$/.test(url));
  const bytes = code.reduce((sum, url) => sum + gzipSync(readFileSync(join(site, new URL(url).pathname.replace("/a/path/", "")))).length, 0);
  hold(code.length > 5 && bytes <= kMostCode, `${code.length} files of code have ${bytes} bytes compressed, at most ${kMostCode}`);

  for (const folder of readdirSync(site).filter((name) => /^\d\d_/.test(name))) {
    const most = await jump(`${server.url}${folder}/index.html`);
    hold(most <= mostJump(folder), `${folder}: from its still to the live picture a block changes by ${most.toFixed(1)} of 255, at most ${mostJump(folder)}`);
  }

  // What it keeps for a time without a net, it loads when it has drawn.
  const first = await page.evaluate(async () => Array.from((await texel.draw({ size: "64x64" })).data));
  await page.waitForFunction(async () => {
    const kept = await (await caches.open("texel-labs")).keys();
    return kept.some(({ url }) => url.endsWith("cube_maps/scene/pz.webp")) && kept.some(({ url }) => url.endsWith("normal_maps/wood.webp"));
  }, { timeout: 300000, polling: 500 });
  server.close();
  failed.length = 0;
  await page.goto(lab);
  const again = await page.evaluate(async () => {
    await texel.ready;
    return Array.from((await texel.draw({ size: "64x64" })).data);
  });
  hold(first.every((value, i) => value === again[i]), "without a net the page draws the same picture");
} finally {
  await browser.close().catch(() => {});
  server.close();
}
process.exit(wrong ? 1 : 0);
