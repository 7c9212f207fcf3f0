// SPDX-License-Identifier: MIT
// node tests/web_site/loads.mjs OUT_WEB COURSE: what a lab's page loads. The engine gets the bytes of the tree's pictures from their
// WebP files; the code of a page has at most 1.2 MB compressed; from a server that knows nothing but files, below a path; and without a
// net after the first visit. Exit code 1 where one of this does not hold, 77 where the pages are not built.
import { existsSync, readFileSync } from "node:fs";
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
let wrong = 0;
const hold = (holds, text) => { wrong += holds ? 0 : 1; console.log(`${holds ? "ok    " : "WRONG "} ${text}`); };

const server = await serve(site, "/a/path/"), browser = await launch();
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
      const ppm = await asPpm(await (await fetch(new URL(`tree/${path.replace(/png$/, "webp")}`, location))).blob());
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
