// SPDX-License-Identifier: MIT
// node teach/commands/screens.mjs SITE GRADES BIN OUT: the README's first pictures: a shader that is mended in the browser, with its
// verdict (mended.gif), and a window, a step's page and a class page (window.png, browser.png, class.png). SITE is out/web, GRADES a
// folder that ./run grade wrote, BIN the labs' programs. Needs xvfb-run and ImageMagick. Exit code 1 where a picture cannot be made.
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { serve } from "../web/engine/serve.mjs";
import { launch } from "../../tests/web_site/browser.mjs";

const [site, grades, bin, out] = process.argv.slice(2).map((path) => resolve(path));
const frames = mkdtempSync(join(tmpdir(), "texel_screens_"));
const convert = (...words) => execFileSync("convert", words);
const pause = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));
mkdirSync(out, { recursive: true });

/** A page of the site of that size, with its steps. */
async function open(browser, url, width, height) {
  const page = await browser.newPage();
  await page.setViewport({ width, height });
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: "light" }]);
  await page.goto(url);
  await page.evaluate(() => globalThis.texel?.ready);
  return page;
}

/** Puts the step's code into the middle of the handout. */
const toStep = (page, step) => page.evaluate((id) => document.querySelector(`[data-step="${id}"] .workbench`).scrollIntoView({ block: "start" }), step);

/** Step 8.1 with its factor forgotten, which is then typed. */
async function mended(browser, url) {
  const page = await open(browser, `${url}08_reflection/index.html?yaw=60&pitch=15`, 1080, 600);
  await page.evaluate(() => texel.write("8.1", "  return incident - dot(normal, incident) * normal;\n"));
  await toStep(page, "8.1");
  await page.waitForSelector("[data-step='8.1'] .cm-content");
  await page.focus("[data-step='8.1'] .cm-content");
  await page.keyboard.down("Control");
  await page.keyboard.press("Home");
  await page.keyboard.up("Control");
  for (let i = 0; i < "  return incident - ".length; ++i) await page.keyboard.press("ArrowRight");
  const files = [];
  const shot = async (hundredths) => {
    const path = join(frames, `${files.length}.png`);
    await page.screenshot({ path });
    files.push("-delay", String(hundredths), path);
  };
  await pause(1500);
  await shot(220);
  for (const key of "2.0 * ") {
    await page.keyboard.type(key);
    await shot(14);
  }
  await page.waitForFunction(() => document.querySelector("[data-step='8.1'] .badge").textContent === "done", { timeout: 60_000 });
  await pause(1500);
  await shot(350);
  convert("-loop", "0", ...files, "-resize", "880x", "+dither", "-colors", "200", "-layers", "OptimizePlus", "-layers", "OptimizeTransparency", join(out, "mended.gif"));
}

async function still(browser, url, step, name) {
  const page = await open(browser, url, 1280, 800);
  if (step) await toStep(page, step);
  await pause(3000);
  await page.screenshot({ path: join(frames, name) });
  convert(join(frames, name), "-resize", "880x", "+dither", "-colors", "256", join(out, name));
}

/** The window of lab 6 with step 6.3 open, on a display of its own. */
async function window_() {
  const shot = join(frames, "window.png");
  const script = `"$1" --size 1280x800 --see faces_right_top_front & program=$!; sleep 20; import -window root "$2"; kill $program; wait $program || true`;
  execFileSync("xvfb-run", ["-a", "-s", "-screen 0 1280x800x24 -noreset", "bash", "-c", script, "", join(bin, "lab06_cube_map"), shot]);
  convert(shot, "-resize", "880x", "+dither", "-colors", "256", `png8:${join(out, "window.png")}`);
}

const server = await serve(site), browser = await launch();
try {
  await mended(browser, server.url);
  await still(browser, `${server.url}05_normal_map/index.html`, "5.5", "browser.png");
  await still(browser, pathToFileURL(join(grades, "report/index.html")).href, null, "class.png");
  await window_();
} finally {
  await browser.close();
  server.close();
  rmSync(frames, { recursive: true, force: true });
}
