// SPDX-License-Identifier: MIT
// FIREFOX=… xvfb-run -a node tests/web_site/firefox.mjs OUT_WEB [LAB …]: the course's pages in Firefox, by what scripts may call
// (docs/browser.md). Each lab's page (all without numbers) draws a colour picture and its data views, and all its steps pass. Exit
// code 77 where Firefox or the pages are missing.
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { serve } from "../../teach/web/engine/serve.mjs";
import { launch } from "./browser.mjs";

const [site, ...numbers] = process.argv.slice(2);
if (!existsSync(process.env.FIREFOX ?? "") || !existsSync(join(site, "engine/engine.wasm"))) {
  console.log(`skipped: FIREFOX names no browser, or there is no engine in ${site}`);
  process.exit(77);
}
let wrong = 0;
const hold = (holds, text) => { wrong += holds ? 0 : 1; console.log(`${holds ? "ok    " : "WRONG "} ${text}`); };
const server = await serve(site), browser = await launch();
try {
  const { labs } = JSON.parse(readFileSync(join(site, "engine/files.json")));
  for (const { number, folder } of labs) {
    if (numbers.length > 0 && !numbers.includes(String(number))) continue;
    const page = await browser.newPage();
    await page.goto(`${server.url}${folder}/index.html`);
    const drawn = await page.evaluate(async () => {
      await texel.ready;
      const views = [...document.querySelectorAll(".views input")].map(({ value }) => value).filter((view) => view !== "error");
      const pictures = [];
      for (const view of views) {
        const { width, height, channels, data } = await texel.draw({ view, size: "64x48" });
        pictures.push({ view, width, height, channels, kind: data.constructor.name, length: data.length, values: new Set(data).size, isFinite: data.every(Number.isFinite) });
      }
      return { pictures, figures: texel.figures(), steps: (await texel.check()).steps.map(({ id, status, message }) => ({ id, status, message })) };
    });
    for (const one of drawn.pictures) {
      const isColour = one.view === "color";
      hold(one.width === 64 && one.height === 48 && one.kind === (isColour ? "Uint8Array" : "Float32Array") && one.length === 64 * 48 * one.channels &&
        one.values > 1 && one.isFinite, `lab ${number}, ${one.view}: ${one.kind} of ${one.channels} channels, ${one.values} values`);
    }
    for (const { id, status, message } of drawn.steps) hold(status === "passed", `${id}: ${status} ${message}`);
    hold(drawn.figures.first_picture_ms > 0, `figures ${JSON.stringify(drawn.figures)}`);
    await page.close();
  }
} finally {
  await browser.close();
  server.close();
}
process.exit(wrong ? 1 : 0);
