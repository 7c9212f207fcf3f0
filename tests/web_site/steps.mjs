// SPDX-License-Identifier: MIT
// node tests/web_site/steps.mjs STARTER_SITE COURSE [LAB ..]: the shader steps in a browser. Each fails as it is in the
// starter, passes with the solution's text, fails with one that does not compile, fails with each mutant of the catalogue, and
// gives none another mutant's name. Most get their own. The other steps are solved. Mutants that no public case shows, here as by
// `texel check`, are left out. Exit code 1 where one of this does not hold, 77 where the site is not built.
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { enginePage, launch } from "./browser.mjs";

const [site, course, ...numbers] = process.argv.slice(2);
if (!existsSync(join(site, "engine/engine.wasm"))) {
  console.log(`skipped: there is no engine in ${site}; type ./run web --starter`);
  process.exit(77);
}

/// What stands between a step's markers in the course's tree: the solutions' texts.
function solution(file, step) {
  const places = [];
  let inside = false;
  for (const line of readFileSync(join(course, file), "utf8").split("\n")) {
    if (line.trim() === `//@step ${step} begin`) { inside = true; places.push(""); }
    else if (/^\s*\/\/@(starter|end)\s*$/.test(line)) inside = false;
    else if (inside) places[places.length - 1] += line + "\n";
  }
  return places.join("//@next\n");
}

/// The catalogue's tables whose strings are in one line.
function mutants() {
  const all = [];
  for (const folder of ["tests/mutants", "tests/mistakes"])
    for (const file of readdirSync(join(course, folder)).sort())
      for (const table of readFileSync(join(course, folder, file), "utf8").split("[[mutant]]").slice(1)) {
        const one = {};
        for (const [, key, value] of table.matchAll(/^(\w+) = ("(?:[^"\\]|\\.)+")$/gm)) one[key] = JSON.parse(value);
        for (const [, key, value] of table.matchAll(/^(\w+) = """\n?([^]*?)"""$/gm)) one[key] = value.replace(/\\\n\s*/g, "");
        if (one.step && one.file?.startsWith("shaders/") && one.what !== undefined && one.by !== undefined) all.push(one);
      }
  return all;
}

/// The names of the mistakes that the public cases show.
const shown = new Set(readdirSync(join(course, "labs")).map((folder) => join(course, "labs", folder, "expected/mistakes.json")).filter(existsSync)
  .flatMap((file) => JSON.parse(readFileSync(file, "utf8")).map(({ name }) => name)));

const browser = await launch();
let wrong = 0, tried = 0, unnamed = 0;
const hold = (holds, text) => { wrong += holds ? 0 : 1; console.log(`${holds ? "ok    " : "WRONG "} ${text}`); };
try {
  const engine = await enginePage(browser, site);
  const labs = JSON.parse(readFileSync(join(site, "engine/files.json"))).labs.map((lab) => lab.number);
  const shaderSteps = [];
  for (const lab of labs)
    for (const step of await engine.call("steps_of", lab)) if (step.kind === "shader") shaderSteps.push({ lab, ...step });
  const wanted = (lab) => numbers.length === 0 || numbers.includes(String(lab));
  // Each alone: all others are solved.
  for (const { id, lab, file } of shaderSteps) {
    await engine.call("open", lab);
    await engine.call("write", id, solution(file, id));
  }
  for (const { id, lab, file } of shaderSteps) {
    if (!wanted(lab)) continue;
    await engine.call("open", lab);
    const first = (await engine.call("read", id)).first;
    await engine.call("write", id, first);
    const [before] = (await engine.call("check", id)).steps;
    hold(before.status === "failed", `${id} unsolved: ${before.status} ${before.error}`);
    await engine.call("write", id, solution(file, id));
    const [after] = (await engine.call("check", id)).steps;
    hold(after.status === "passed", `${id} solved: ${after.status}, ${after.error} of ${after.limit} ${after.unit} ${after.message}`);
    // A right picture of an earlier check is not taken for one of a shader that does not compile.
    await engine.call("check", id);
    await engine.call("write", id, solution(file, id) + "nothing\n").catch(() => {});
    const [broken] = (await engine.call("check", id)).steps;
    hold(broken.status === "failed", `${id} not compiled: ${broken.status}`);
    await engine.call("write", id, solution(file, id));
  }
  for (const mutant of mutants()) {
    const step = shaderSteps.find((one) => one.id === mutant.step);
    if (!step || !wanted(step.lab) || !(shown.has(mutant.name) || shown.has(mutant.same))) continue;
    await engine.call("open", step.lab);
    const right = await engine.call("file", mutant.file);
    if (!right.includes(mutant.what)) continue;  // in a part that is no student's
    let drawn = "";
    await engine.call("put", mutant.file, right.replace(mutant.what, () => mutant.by)).catch((error) => (drawn = error.message));
    const [found] = (await engine.call("check", mutant.step)).steps;
    const named = found.looks_like === mutant.name || found.looks_like === mutant.same;
    ++tried;
    unnamed += found.looks_like === "" ? 1 : 0;
    hold(found.status === "failed" && (named || found.looks_like === ""), `${mutant.step} ${mutant.name}: ${found.status}, called ${found.looks_like || "nothing"} ${drawn}`);
    await engine.call("put", mutant.file, right).catch(() => {});
  }
  // A mistake's name is found by its picture's values. Ten of 167 wrong pictures follow the rasteriser's rounding (they divide by
  // differences between pixels, or by nearly nothing), and have other values by SwiftShader than by llvmpipe.
  if (numbers.length === 0) hold(unnamed <= 0.1 * tried, `${unnamed} of ${tried} mutants without a name, at most a tenth`);
  engine.close();
} finally {
  await browser.close().catch(() => {});
}
process.exit(wrong ? 1 : 0);
