// SPDX-License-Identifier: MIT
// A headless Chromium with WebGL 2 by SwiftShader, and a page that has nothing but the engine.
import { createRequire } from "node:module";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { serve } from "../../web/engine/serve.mjs";

const site = new URL("../../web/site/package.json", import.meta.url).pathname;
const puppeteer = createRequire(process.env.TEXEL_PUPPETEER ?? site)("puppeteer-core");

export const chromium = process.env.TEXEL_CHROMIUM ?? "/usr/bin/chromium";

export async function launch() {
  const profile = mkdtempSync(join(tmpdir(), "texel_web_"));
  const browser = await puppeteer.launch({
    executablePath: chromium,
    userDataDir: profile,
    protocolTimeout: 600000,
    args: ["--no-sandbox", "--disable-dev-shm-usage", "--use-gl=angle", "--use-angle=swiftshader",
           "--enable-unsafe-swiftshader", "--disable-background-timer-throttling", "--disable-renderer-backgrounding"],
  });
  browser.once("disconnected", () => { try { rmSync(profile, { recursive: true, force: true, maxRetries: 5 }); } catch { /* a helper of the browser still writes */ } });
  return browser;
}

/// A page with `engine`, without a canvas, from the site in `folder`.
export async function enginePage(browser, folder) {
  writeFileSync(join(folder, "engine_test.html"), `<!doctype html><title>engine</title><canvas id="c" width="512" height="512"></canvas>
<script type="module">
import { startEngine } from "./engine/client.mjs";
window.ready = startEngine({ canvas: document.getElementById("c"), patience: 600000 }).then((e) => (window.engine = e));
window.text = (data) => { let s = ""; for (let i = 0; i < data.length; i += 32768) s += String.fromCharCode(...data.subarray(i, i + 32768)); return btoa(s); };
</script>`);
  const server = await serve(folder);
  const page = await browser.newPage();
  page.on("console", (message) => process.env.TEXEL_VERBOSE && console.log("  page:", message.text()));
  page.on("pageerror", (error) => console.log("  page error:", error.message));
  await page.goto(`http://127.0.0.1:${server.address().port}/engine_test.html`);
  await page.evaluate(() => window.ready.then(() => null));
  return {
    page,
    /// await call("open", 5)
    call: (name, ...args) => page.evaluate((name, args) => window.engine[name](...args), name, args),
    /// A picture with its samples.
    async draw(what) {
      const drawn = await page.evaluate(async (what) => {
        const { data, ...rest } = await window.engine.draw(what);
        return { ...rest, type: data.constructor.name, text: window.text(new Uint8Array(data.buffer)) };
      }, what);
      const bytes = Buffer.from(drawn.text, "base64");
      const data = drawn.type === "Float32Array"
        ? new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length)) : new Uint8Array(bytes);
      return { width: drawn.width, height: drawn.height, channels: drawn.channels, data };
    },
    close: () => server.close(),
  };
}
