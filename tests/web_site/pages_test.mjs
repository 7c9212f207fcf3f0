// SPDX-License-Identifier: MIT
// The pages of the labs in a real browser, with a stand-in for the engine (engine/). CHROMIUM names the browser.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, before, beforeEach, test } from "node:test";
import { fileURLToPath } from "node:url";
import { serve } from "../../teach/web/engine/serve.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const site = join(here, "../../teach/web/site");
if (!existsSync(join(site, "node_modules"))) {
  console.log("skipped: the packages of teach/web/site are not installed (npm ci)");
  process.exit(77);
}
const require = createRequire(join(site, "package.json"));
const puppeteer = require("puppeteer-core");
const { unzipSync, strFromU8, zipSync, strToU8 } = require("fflate");

const folder = mkdtempSync(join(tmpdir(), "texel_pages_"));
const kFile = "shaders/05_normal_map/decode_normal.glsl";
let server, browser, page, complaints;

before(async () => {
  cpSync(join(here, "engine"), join(folder, "engine"), { recursive: true });
  // Of a program that draws: the pages need no more of it.
  const programs = join(folder, "programs"), program = join(programs, "lab05_normal_map");
  mkdirSync(programs);
  writeFileSync(program, `#!/bin/sh\nwhile [ "$1" != --snapshot ] && [ $# -gt 0 ]; do shift; done\n` +
    `if [ $# -gt 0 ]; then cp "${join(here, "../../docs/pictures/05_normal_map.png")}" "$2"; else echo "[]"; fi\n`, { mode: 0o755 });
  const built = spawnSync(process.execPath, [join(site, "build.mjs"), "--out", folder, "--programs", programs], { encoding: "utf8" });
  assert.equal(built.status, 0, built.stderr);
  server = await serve(folder, "/some/where/");
  browser = await puppeteer.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", headless: true,
    args: ["--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"] });
});
after(async () => {
  await browser?.close();
  server?.close();
  rmSync(folder, { recursive: true, force: true });
});
beforeEach(async () => {
  const before = page;
  page = undefined;  // else a close that fails would fail in each later test too
  await before?.browserContext().close();
  page = await (await browser.createBrowserContext()).newPage();
  complaints = [];
  page.on("pageerror", (error) => complaints.push(String(error)));
  page.on("requestfailed", (request) => complaints.push(request.url()));
  await page.setViewport({ width: 1300, height: 900 });
});

/** Opens the page of lab 5 and waits for its steps. */
async function open(search = "") {
  await page.goto(`${server.url}05_normal_map/index.html${search}`);
  await page.evaluate(() => texel.ready);
}
const text = (selector) => page.$eval(selector, (node) => node.textContent);
const until = (condition, ...values) => page.waitForFunction(condition, { timeout: 20_000 }, ...values);
/** Types into the editor of step 5.1, in place of all that stands there. */
async function type(code) {
  await page.evaluate(() => document.querySelector(".workbench").scrollIntoView());
  await page.waitForSelector(".cm-content", { timeout: 20_000 });
  await page.focus(".cm-content");
  await page.keyboard.down("Control");
  await page.keyboard.press("a");
  await page.keyboard.up("Control");
  await page.keyboard.type(code);
}
/** The files that "Save as .zip" gives to the user, without a folder for downloads. */
async function saved(of) {
  const bytes = await of.evaluate(() => {
    const given = new Promise((done) => {
      const make = URL.createObjectURL;
      URL.createObjectURL = (blob) => {
        URL.createObjectURL = make;
        blob.arrayBuffer().then((content) => done([...new Uint8Array(content)]));
        return make(blob);
      };
    });
    [...document.querySelectorAll(".progress button")].find((b) => b.textContent === "Save as .zip").click();
    return given;
  });
  return unzipSync(Uint8Array.from(bytes));
}
const badge = (wanted) => until((w) => document.querySelector(".badge")?.textContent === w, wanted);

test("the panel is made from the declaration", async () => {
  await open("?look=default");
  const controls = await page.$$eval(".parameter > label", (labels) => labels.map((label) => [label.textContent, document.getElementById(label.htmlFor)?.type ?? ""]));
  const made = Object.fromEntries(controls);
  assert.equal(made.method, "select-one");
  assert.equal(made["normal mapping"], "checkbox");
  assert.equal(made.segments, "range");
  assert.deepEqual(await page.$$eval("#parameter-method option", (options) => options.map((o) => [o.value, o.title])),
    [["raw", "The map as it is"], ["averaged", "Averaged per vertex"], ["mikktspace", "Mikkelsen's rules"]]);
  assert.equal(await page.$eval("[data-part=parameters-Camera]", (part) => part.open), false);
  // The middle of a logarithmic slider from 0.0001 to 10 is their geometric mean.
  await page.$eval("#parameter-near", (slider) => {
    slider.value = 500;
    slider.dispatchEvent(new Event("input"));
  });
  assert.equal(await page.$eval("#parameter-near", (slider) => slider.getAttribute("aria-valuetext")), "0.03162 units");
  await until(() => location.search === "?near=0.03162");
  await page.click("[aria-label='Reset near to 0.1']");
  await until(() => location.search === "?look=default");
  assert.deepEqual(complaints, []);
});

test("the address is the state, there and back", async () => {
  await open("?method=raw&yaw=75&view=normal&compare=method:averaged:0.25");
  const state = () => page.evaluate(() => ({
    method: document.getElementById("parameter-method").value, yaw: document.getElementById("parameter-yaw").value,
    view: document.querySelector(".views input:checked").value, left: document.querySelector(".divider .left").textContent,
    right: document.querySelector(".divider .right").textContent, at: document.querySelector(".divider").getAttribute("aria-valuenow"),
  }));
  const first = await state();
  assert.deepEqual({ ...first, yaw: undefined }, { method: "raw", yaw: undefined, view: "normal", left: "raw", right: "averaged", at: "25" });
  await page.focus("#picture");
  await page.keyboard.press("ArrowLeft");  // turns the camera
  await until(() => new URLSearchParams(location.search).get("yaw") === "87");
  const address = page.url();
  await page.goto("about:blank");
  await page.goto(address);
  await page.evaluate(() => texel.ready);
  assert.deepEqual(await state(), { ...first, yaw: await page.$eval("#parameter-yaw", (slider) => slider.value) });
  assert.equal(page.url(), address);
  await page.click("[data-look=cube_raw]");
  await until(() => location.search === "?method=raw");
  assert.equal(await page.$eval(".divider", (divider) => divider.hidden), true);
  // Names that the lab does not have change nothing.
  await open("?nonsense=1&view=nonsense");
  assert.equal(await page.$eval(".message", (message) => message.hidden), true);
});

test("without a state in the address the lab opens on its lesson, with names at the line", async () => {
  await open("");
  const names = () => page.$$eval(".divider span", (spans) => spans.map((span) => span.textContent));
  assert.equal(await page.$eval("#parameter-segments", (slider) => slider.getAttribute("aria-valuetext")), "48");
  assert.deepEqual(await names(), ["as it is", "in the frame"]);
  await page.select("#compare-value", "averaged");
  assert.deepEqual(await names(), ["raw", "averaged"]);
});

test("the first paint has the picture that the lab opens with, and no other", async () => {
  await page.evaluateOnNewDocument(() => {
    addEventListener("DOMContentLoaded", () => {
      window.begins = document.querySelectorAll(".still").length;
      new MutationObserver(() => (window.ends = performance.now())).observe(document.querySelector(".picture"), { childList: true });
    });
    const send = Worker.prototype.postMessage;
    Worker.prototype.postMessage = function (message, ...more) {
      if (message.name === "presented") window.asked = performance.now();
      return send.call(this, message, ...more);
    };
  });
  const begins = () => page.evaluate(() => window.begins);
  await open("");
  assert.equal(await begins(), 1);
  assert.equal(await page.$(".still"), null, "the live picture is there");
  assert.ok(await page.evaluate(() => window.ends - window.asked) >= 199, "until the browser shows the live picture: the stand-in needs 200 ms");
  await open("?look=default");
  assert.equal(await begins(), 0);
  await type("  return right;");
  await badge("done");
  await open("");
  assert.equal(await begins(), 0, "what was written may draw another picture");
  await page.goto(`${server.url}09_bump/index.html`);
  assert.equal(await begins(), 0, "its program is not built");
});

test("an address with a step opens there, on a desk and on a phone", async () => {
  for (const width of [1300, 375]) {
    await page.setViewport({ width, height: 800 });
    await page.goto(`${server.url}05_normal_map/index.html#step-5.6`);
    await page.evaluate(() => texel.ready);
    const from = (selector) => page.$eval(selector, (node) => node.getBoundingClientRect().top);
    await page.waitForFunction(() => Math.abs(document.querySelector("#step-5\\.6").getBoundingClientRect().top) < 450, { timeout: 5000 });
    assert.ok(await from("#step-5\\.6") > 0, width);
    await page.goto("about:blank");
  }
});

test("the picture follows the text, and goes back", async () => {
  await open("?yaw=40&view=tangent");
  assert.equal(await text(".view-legend .title"), "normal of a ball");
  const back = () => page.$eval(".followed", (line) => !line.hidden);
  assert.equal(await back(), false);
  await page.evaluate(() => document.querySelector("[data-step='5.1']").scrollIntoView());
  await until(() => location.search === "?method=raw&normal_map=bump&view=normal" || location.search === "?method=raw&view=normal");
  assert.ok(await back());
  await page.click("[data-tool=mine]");
  await until(() => location.search === "?yaw=40&view=tangent");
  assert.equal(await back(), false);
});

test("on a phone the handout comes first, and the parameters are a drawer", async () => {
  await page.setViewport({ width: 375, height: 760 });
  await open("?look=default");
  const top = (selector) => page.$eval(selector, (node) => node.getBoundingClientRect().top);
  assert.ok((await top(".handout")) < 760, "the handout begins on the first screen");
  const isOpen = () => page.$eval(".panel", (panel) => getComputedStyle(panel).visibility === "visible");
  assert.equal(await isOpen(), false);
  await page.click("[data-tool=panel]");
  await until(() => getComputedStyle(document.querySelector(".panel")).visibility === "visible");
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "nothing is wider than the screen");
});

test("a look by name, and a command of the handout, set the picture", async () => {
  await open("?look=raw");
  assert.equal(await page.$eval(".views input:checked", (input) => input.value), "normal");
  await page.$eval("a.see[href='?method=raw&normal_map=bump&view=normal']", (link) => link.click());
  assert.equal(await page.$eval("#parameter-method", (select) => select.value), "raw");
  await page.evaluate(() => texel.ready.then(() => [...document.querySelectorAll(".workbench button")].find((b) => b.textContent === "See the step's look").click()));
  await until(() => location.search === "?method=raw&view=normal");
});

test("what is written is judged after a pause, and survives a reload", async () => {
  await open("?look=default");
  assert.equal(await text(".badge"), "to do");
  await type("  return swapped;");
  await until(() => document.querySelector(".cause").textContent === "This looks like: red and green swapped");
  assert.match(await text(".verdict"), /Off by 12.4 degrees/);
  await badge("wrong");
  const told = () => page.$eval("[data-step='5.1'] details.after", (after) => after.open);
  assert.equal(await told(), false);
  await type("  return right;");
  await badge("done");
  assert.equal(await told(), true);  // why it is right, and a look to try
  assert.match(await text(".progress b"), /^1 of 1 shader steps is right, 1 of 1 points/);
  await page.reload();
  await page.evaluate(() => texel.ready);
  await badge("done");
  assert.match(await text(".editor"), /return right;/);
  await page.evaluate(() => [...document.querySelectorAll(".workbench button")].find((b) => b.textContent === "Start over").click());
  await badge("to do");
  await page.reload();
  await page.evaluate(() => texel.ready);
  assert.match(await text(".editor"), /return color;/);
});

test("a choice opens the answer to it, and closes the others", async () => {
  await open("?look=default");
  const steps = await page.$$eval(".step", (sections) => sections.map((one) => [...one.querySelectorAll(".predict details")].map((choice) => choice.querySelector("p").textContent.split(":")[0])));
  for (const answers of steps) assert.deepEqual([...answers].sort(), ["No", "No", "Right"]);
  const shown = () => page.$$eval("[data-step='5.1'] .predict details", (choices) => choices.map((choice) => choice.open));
  for (const i of [0, 2]) {
    await page.$$eval("[data-step='5.1'] .predict summary", (choices, n) => choices[n].click(), i);
    assert.deepEqual(await shown(), [0, 1, 2].map((n) => n === i));
  }
});

test("two tabs have the same text, and so have the .zip of the older one and a reload", async () => {
  await open("?look=default");
  const older = page;
  // A page behind another has no frames: it is asked from time to time.
  const stands = (wanted, selector = ".editor") => older.waitForFunction((node, code) => document.querySelector(node).textContent.includes(code),
    { timeout: 20_000, polling: 100 }, selector, wanted);
  await older.evaluate(() => localStorage.setItem(`texel-labs ${new URL("..", location.href).pathname} 9.4`, "of lab 9"));
  page = await older.browserContext().newPage();
  await open("?look=default");
  await page.evaluate(() => texel.write("5.1", "  return swapped;\n"));
  await stands("return swapped;");
  await type("  return right;");
  await stands("return right;");
  await stands("done", ".badge");
  assert.match(strFromU8((await saved(older))[kFile]), /return right;/);
  await older.reload();
  await older.evaluate(() => texel.ready);
  assert.match(await older.$eval(".editor", (editor) => editor.textContent), /return right;/);
  assert.deepEqual(await older.evaluate(() => Object.keys(localStorage).map((key) => key.split(" ").slice(2).join(" ")).sort()),
    ["5.1", "5.1 good", "9.4", "last"]);  // the stand-in has one text for all steps: 5.1 is wrong by that of 9.4
  await page.evaluate(() => [...document.querySelectorAll(".workbench button")].find((b) => b.textContent === "Start over").click());
  await stands("return color;");
});

test("a key is kept at once", async () => {
  await open("?look=default");
  await type("  return right;");
  await page.reload();
  await page.evaluate(() => texel.ready);
  assert.match(await text(".editor"), /return right;/);
});

test("a full storage is said at once, and the page saves again when there is room", async () => {
  page.on("dialog", (dialog) => dialog.accept());
  await open("?look=default");
  const says = () => page.$eval(".progress p", (p) => p.textContent);
  assert.match(await says(), /Your code stays in this browser\.$/);
  assert.equal(await page.$eval(".refused", (line) => line.hidden), true);
  await page.evaluate(() => {
    for (let size = 1 << 22, n = 0; size >= 1; size >>= 1)
      for (;;)
        try { localStorage.setItem(`fill ${++n}`, "x".repeat(size)); } catch { break; }
  });
  await type("  return swapped;");
  await until(() => !document.querySelector(".refused").hidden);
  assert.doesNotMatch(await says(), /stays/);
  assert.equal(await page.evaluate(() => !dispatchEvent(new Event("beforeunload", { cancelable: true }))), true);  // asks before it is left
  await page.evaluate(() => Object.keys(localStorage).filter((key) => key.startsWith("fill")).forEach((key) => localStorage.removeItem(key)));
  await type("  return right;");
  await until(() => document.querySelector(".refused").hidden);
  assert.match(await says(), /stays in this browser/);
  assert.equal(await page.evaluate(() => !dispatchEvent(new Event("beforeunload", { cancelable: true }))), false);
  await page.reload();
  await page.evaluate(() => texel.ready);
  assert.match(await text(".editor"), /return right;/);
});

test("a blocked storage is said from the beginning", async () => {
  await page.evaluateOnNewDocument(() => Object.defineProperty(window, "localStorage", { get() { throw new DOMException("blocked", "SecurityError"); } }));
  await open("?look=default");
  assert.equal(await page.$eval(".refused", (line) => line.checkVisibility()), true);
  assert.doesNotMatch(await text(".progress"), /stays/);
  await type("  return right;");
  await badge("done");
  assert.match(strFromU8((await saved(page))[kFile]), /return right;/);
  assert.deepEqual(complaints, []);
});

test("an error of the compiler stands at its line, over the last good picture", async () => {
  await open("?look=default");
  await type("  float a;\nsyntax error");
  await badge("does not compile");
  assert.match(await text(".workbench .problem"), /^line 5: /);
  assert.equal(await page.$$eval(".cm-lint-marker-error", (marks) => marks.length), 1);
  assert.equal(await text(".verdict"), "");  // the last verdict is of another text
  await type("  return right;");
  await badge("done");
  assert.equal(await page.$eval(".workbench .problem", (problem) => problem.hidden), true);
});

test("an experiment is drawn and never judged, is kept, goes to others by a link, and ends", async () => {
  const bench = ".experiment .bench", drawn = () => page.evaluate(() =>
    [...document.querySelectorAll(".statistics dt")].find((dt) => dt.textContent === "experiment")?.nextSibling.textContent ?? "");
  const press = (name) => page.evaluate((of, wanted) => [...document.querySelectorAll(`${of} button`)].find((b) => b.textContent === wanted).click(), bench, name);
  const write = async (code) => {
    await page.waitForSelector(`${bench} .cm-content`, { timeout: 20_000 });
    await page.focus(`${bench} .cm-content`);
    await page.keyboard.down("Control");
    await page.keyboard.press("a");
    await page.keyboard.up("Control");
    await page.keyboard.type(code);
  };
  const isDrawn = async (wanted) => {
    for (let i = 0; i < 100 && (await drawn()) !== wanted; ++i) await new Promise((done) => setTimeout(done, 100));
    assert.equal(await drawn(), wanted);
  };
  await open("?look=default");
  await press("Begin");
  await until(() => document.querySelector(".experiment .cm-content")?.textContent.includes("Parallax by steps"));
  assert.equal(await page.$eval(".experimenting", (sign) => sign.hidden), false);
  await write("void main() { mine }");
  await isDrawn("void main() { mine }");
  await write("a\nsyntax error");
  await until(() => document.querySelector(".experiment .problem").textContent.startsWith("shaders/05_normal_map/normal_map.frag:2: "));
  assert.equal(await drawn(), "void main() { mine }");  // the last good one
  await write("void main() { mine again }");
  await isDrawn("void main() { mine again }");
  assert.equal(await text(".badge"), "to do");  // no step has noticed
  await page.evaluate(() => Object.defineProperty(navigator, "clipboard", { value: { writeText: (given) => void (window.given = given) } }));
  await press("Copy link");
  await until(() => window.given);
  const link = await page.evaluate(() => window.given);
  await page.reload();
  await page.evaluate(() => texel.ready);
  await press("Begin");
  await isDrawn("void main() { mine again }");
  await press("End");
  await isDrawn("");
  assert.equal(await page.$eval(".experimenting", (sign) => sign.hidden), true);
  await (await page.browserContext()).close();
  page = await (await browser.createBrowserContext()).newPage();
  await page.goto(link);
  await page.evaluate(() => texel.ready);
  await isDrawn("void main() { mine again }");
});

test("a case shows yours and the expected picture", async () => {
  await open("?look=default");
  await page.evaluate(() => document.querySelector(".cases button").click());
  await page.waitForSelector(".viewer canvas", { timeout: 20_000 });
  const pixel = (x) => page.evaluate((at) => document.querySelector(".viewer canvas").getContext("2d").getImageData(at, 0, 1, 1).data[0], x);
  assert.deepEqual([await pixel(0), await pixel(3)], [40, 200]);
  await page.click(".viewer input[value=heat_map]");
  assert.equal(await pixel(0), 90);
  assert.equal(await page.$eval("#parameter-method", (select) => select.value), "raw");
});

test("a .zip goes out and comes in again with the same text", async () => {
  await open("?look=default");
  await page.evaluate(() => texel.write("5.1", "  return right; // é\n"));
  const files = await saved(page);
  assert.deepEqual(Object.keys(files), [kFile]);
  assert.match(strFromU8(files[kFile]), /begin\n {2}return right; \/\/ é\n {2}\/\/@end/);
  // In a browser that has nothing yet; a folder around the tree does not matter.
  await page.evaluate(() => localStorage.clear());
  await open("?look=default");
  const bring = async (content) => {
    await page.evaluate((list) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([Uint8Array.from(list)], "work.zip"));
      const input = document.querySelector(".progress input[type=file]");
      input.files = transfer.files;
      input.dispatchEvent(new Event("change"));
    }, [...content]);
  };
  await bring(zipSync({ [`my-labs/${kFile}`]: files[kFile] }));
  await badge("done");
  assert.match(await text(".editor"), /return right; \/\/ é/);
  await bring(zipSync({ "notes.txt": strToU8("none") }));
  await until((path) => document.querySelector(".progress [role=status]").textContent.includes(path), kFile);
  await bring(Uint8Array.from([1, 2, 3]));
  await until(() => document.querySelector(".progress [role=status]").textContent.includes("no .zip"));
});

test("an endless shader is stopped, and its last change can be undone", async () => {
  await open("?look=default");
  await page.evaluate(() => texel.write("5.1", "  return right;\n"));
  await badge("done");
  await type("for (;;)");
  await until(() => document.querySelector(".message button")?.textContent === "Undo the last change and start again");
  assert.match(await text(".message"), /step 5.1 may loop for ever/);
  assert.equal(await page.evaluate(() => 6 * 7), 42);  // the page itself goes on
  await page.click(".message button");
  await badge("done");
  assert.match(await text(".editor"), /return right;/);
  await until(() => document.querySelector(".message").hidden);
  // After a reload in the middle of it the same is offered: only the first text is known to draw.
  await type("for (;;)");
  await page.waitForSelector(".message button", { timeout: 20_000 });
  await page.reload();
  await page.waitForSelector(".message button", { timeout: 20_000 });
});

test("a lost context comes back with the same look", async () => {
  await open("?method=raw");
  await page.evaluate(() => { window.old = document.querySelector(".picture canvas"); });
  await page.evaluate(() => texel.lose());
  await until(() => document.querySelector(".picture canvas") !== window.old && document.querySelector(".message").hidden);
  await until(() => texel.draw({ size: "8x8" }).then(() => true, () => false));  // the new engine is on its way
  assert.equal(page.url().split("?")[1], "method=raw");
});

test("pages fit a phone, a desk and a large screen, in light and dark", async () => {
  for (const width of [375, 768, 1300, 1920, 2560])
    for (const scheme of ["light", "dark"]) {
      await page.setViewport({ width, height: 900 });
      await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: scheme }]);
      for (const path of ["index.html", "05_normal_map/index.html", "guide/index.html"]) {
        await page.goto(server.url + path);
        await page.evaluate(() => window.texel?.ready);
        const widest = await page.evaluate(() => Math.max(document.documentElement.scrollWidth, ...[...document.querySelectorAll(".handout, .panel")].map((e) => e.scrollWidth - e.clientWidth + innerWidth)));
        assert.ok(widest <= width, `${path} is ${widest} wide at ${width}, ${scheme}`);
      }
    }
  assert.deepEqual(complaints, []);
});

test("no page scrolls into an empty part, at any size", async () => {
  const labs = readdirSync(folder).filter((name) => /^\d\d_/.test(name));
  assert.equal(labs.length, 9);
  for (const path of [...labs.map((lab) => `${lab}/index.html`), "index.html", "guide/index.html"]) {
    await page.goto(server.url + path);
    await page.evaluate(() => window.texel?.ready);
    for (const [width, height] of [[375, 667], [800, 600], [1000, 200], [1280, 800], [1920, 1080], [2560, 300]]) {
      await page.setViewport({ width, height });
      const [all, content] = await page.evaluate(() => [document.documentElement.scrollHeight, document.querySelector("main").getBoundingClientRect().bottom + scrollY]);
      // On a phone the page scrolls; else a lab's picture stays, and the handout scrolls beside it. 4rem are below the first page's cards.
      const most = path.startsWith("0") && width > 992 ? height : Math.max(height, Math.ceil(content) + 64);
      assert.ok(all <= most, `${path} is ${all} high at ${width}x${height}, its content ${content}`);
    }
  }
});

test("every control has a name and can be reached and worked by keys", async () => {
  await open("?look=default");
  const nameless = await page.evaluate(() => [...document.querySelectorAll("button, input, select, a, [role=slider], [tabindex='0']")]
    .filter((e) => e.checkVisibility() && !(e.getAttribute("aria-label") || e.textContent.trim() || e.labels?.length || e.title || e.querySelector("img[alt]")?.alt))
    .map((e) => e.outerHTML.slice(0, 120)));
  assert.deepEqual(nameless, []);
  const reached = new Set();
  for (let i = 0; i < 60; ++i) {
    await page.keyboard.press("Tab");
    reached.add(await page.evaluate(() => document.activeElement.id || document.activeElement.dataset.tool || document.activeElement.className));
  }
  for (const wanted of ["skip", "picture", "turn", "snapshot", "look", "parameter-method", "parameter-segments"]) assert.ok(reached.has(wanted), wanted);
  await page.focus("#parameter-segments");
  await page.keyboard.press("ArrowRight");
  await until(() => new URLSearchParams(location.search).get("segments") === "25");
  await page.focus("#picture");
  await page.keyboard.press("Enter");
  await until(() => !document.querySelector(".pixel").hidden);
  assert.deepEqual(await page.$$eval(".pixel td", (cells) => cells.map((cell) => cell.textContent)), ["0.0000  0.6000  -0.8000", "background"]);
  await page.keyboard.press("j");
  await until(() => location.search === "?method=raw&segments=48&compare=method%3Amikktspace%3A0.5");
  await page.keyboard.press(" ");
  await until(() => document.querySelector("[data-tool=turn]").getAttribute("aria-pressed") === "true");
});

test("fingers and the wheel turn and zoom, and a tap reads a pixel", async () => {
  await page.setViewport({ width: 375, height: 812, isMobile: true, hasTouch: true });
  await open("?look=default");
  await page.touchscreen.tap(100, 200);
  await until(() => document.querySelector(".pixel").textContent.startsWith("Pixel"));
  await page.touchscreen.touchStart(100, 200);
  await page.touchscreen.touchMove(140, 200);
  await page.touchscreen.touchMove(160, 200);
  await page.touchscreen.touchEnd();
  await until(() => new URLSearchParams(location.search).has("yaw"));
});

test("the pages work without a net after the first visit", async () => {
  await open("?look=default");
  const kept = (file) => page.evaluate((name) => caches.match(new URL(name, location.href).href).then(Boolean), file);
  const all = ["../09_bump/index.html", "../engine/worker.mjs", "../pictures/steps/5.7.png"];
  for (let i = 0; i < 200 && !(await Promise.all(all.map(kept))).every(Boolean); ++i) await new Promise((done) => setTimeout(done, 100));
  assert.equal(await kept("../pictures/steps/9.4.png"), false);  // of a lab that was not open
  server.close();
  try {
    await open("?method=raw");
    assert.equal(await page.$eval("#parameter-method", (select) => select.value), "raw");
  } finally {
    server = await serve(folder, "/some/where/", Number(new URL(server.url).port));
  }
});

test("no link of a document is left as it is written", () => {
  const pages = readdirSync(folder).map((name) => join(folder, name, "index.html")).filter(existsSync);
  assert.ok(pages.length > 9);
  for (const file of pages) {
    const shown = readFileSync(file, "utf8").replace(/<(script|code|annotation)[^]*?<\/\1>/g, "").replace(/<[^>]*>/g, "");
    assert.doesNotMatch(shown, /\[[A-Z][a-z]+\]|\]\(/, file);
  }
});

test("formulas are typeset in the page, in the text's size, and no page names another host", async () => {
  for (const lab of ["05_normal_map", "08_reflection"]) {
    const html = readFileSync(join(folder, lab, "index.html"), "utf8");
    assert.match(html, /class="katex"/);
    assert.doesNotMatch(html.replace(/<annotation[^]*?<\/annotation>/g, ""), />[^<]*\$[a-zA-Z\\]/);
    assert.doesNotMatch(html, /(?:src|href)="(?:https?:)?\/\//);
    await page.goto(`${server.url}${lab}/index.html`);
    const times = await page.$eval(".katex", (formula) =>
      parseFloat(getComputedStyle(formula).fontSize) / parseFloat(getComputedStyle(formula.parentElement).fontSize));
    assert.ok(Math.abs(times - 1.1) < 0.01, `${times}`);
  }
});
