// SPDX-License-Identifier: MIT
// A headless Chromium with WebGL 2 by SwiftShader, and a page that has nothing but the engine. CHROMIUM_ANGLE=vulkan draws with the
// graphics card instead, if Vulkan's driver is there. With FIREFOX (a path) that browser in its place; it needs a display
// (xvfb-run): without one and without a graphics card it has no WebGL.
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { serve } from "../../teach/web/engine/serve.mjs";

const site = join(dirname(fileURLToPath(import.meta.url)), "../../teach/web/site");
if (!existsSync(join(site, "node_modules"))) {
  console.log("skipped: the packages of teach/web/site are not installed (npm ci)");
  process.exit(77);
}
const puppeteer = createRequire(join(site, "package.json"))("puppeteer-core");

export const chromium = process.env.CHROMIUM ?? "/usr/bin/chromium";

export async function launch() {
  if (process.env.FIREFOX)
    return puppeteer.launch({ browser: "firefox", executablePath: process.env.FIREFOX, headless: false, protocolTimeout: 600000 });
  const angle = process.env.CHROMIUM_ANGLE ?? "swiftshader", profile = mkdtempSync(join(tmpdir(), "texel_web_"));
  const browser = await puppeteer.launch({
    executablePath: chromium,
    userDataDir: profile,
    protocolTimeout: 600000,
    args: ["--no-sandbox", "--disable-dev-shm-usage", "--use-gl=angle", `--use-angle=${angle}`,
           ...(angle === "vulkan" ? ["--enable-features=Vulkan", "--disable-vulkan-surface", "--ignore-gpu-blocklist"] : []),
           "--enable-unsafe-swiftshader", "--disable-background-timer-throttling", "--disable-renderer-backgrounding"],
  });
  browser.once("disconnected", () => { try { rmSync(profile, { recursive: true, force: true, maxRetries: 5 }); } catch { /* a helper of the browser still writes */ } });
  return browser;
}

/// A page with `engine`, without a canvas, from the site in `folder`.
export async function enginePage(browser, folder) {
  const server = await serve(folder);
  const page = await browser.newPage();
  page.on("console", (message) => process.env.TEXEL_VERBOSE && console.log("  page:", message.text()));
  page.on("pageerror", (error) => console.log("  page error:", error.message));
  await page.goto(`${server.url}engine/client.mjs`);  // any file of the site that a browser shows as text
  await page.evaluate(async () => {
    const { startEngine } = await import("/engine/client.mjs");
    const canvas = document.body.appendChild(document.createElement("canvas"));
    window.engine = await startEngine({ canvas, patience: 600000 });
    window.text = (data) => {
      let text = "";
      for (let i = 0; i < data.length; i += 32768) text += String.fromCharCode(...data.subarray(i, i + 32768));
      return btoa(text);
    };
  });
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
