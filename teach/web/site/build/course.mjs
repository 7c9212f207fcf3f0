// SPDX-License-Identifier: MIT
// What the pages need to know of the course before a browser runs it: read from the tree itself.
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { parse } from "smol-toml";

/** A parameter's value as the command line takes it. */
const asText = (value) => (typeof value === "boolean" ? (value ? "on" : "off") : String(value));

const texts = (set = {}) =>
  Object.fromEntries(Object.entries(set).map(([name, value]) => [name, asText(value)]));

/** Files below a folder, as paths from the tree's root. */
function filesBelow(tree, folder) {
  return readdirSync(join(tree, folder), { withFileTypes: true }).flatMap((entry) =>
    entry.isDirectory() ? filesBelow(tree, `${folder}/${entry.name}`) : [`${folder}/${entry.name}`]);
}

/** The steps that are written in shaders: a browser can compile these, and no C++. */
export function shaderSteps(tree) {
  const steps = new Set();
  for (const file of filesBelow(tree, "shaders"))
    for (const [, step] of readFileSync(join(tree, file), "utf8").matchAll(/^\s*\/\/@step (\S+) begin/gm)) steps.add(step);
  return steps;
}

/** Which pictures and models a lab shows at first, as {texture: "brick"}: a page loads them at once. Empty where it is not built. */
function firstFiles(programs, folder) {
  const program = programs && join(programs, `lab${folder}`);
  if (!program || !existsSync(program)) return {};
  const parameters = JSON.parse(execFileSync(program, ["--list-parameters", "--json"]));
  return Object.fromEntries(parameters.filter((p) => p.type === "file").map((p) => [p.name, p.default]));
}

/** The fragment shader that draws a lab's object. */
function mainShader(tree, folder) {
  const all = readdirSync(join(tree, "shaders", folder)).filter((name) => name.endsWith(".frag") && name !== "background.frag");
  return `shaders/${folder}/${all[0]}`;
}

/**
 * The labs in their order: {number, folder, title, lesson, files, shader, looks, steps}. `programs`: the folder of the desktop's programs,
 * or nothing. Throws where a lab.toml cannot be read.
 */
export function readLabs(tree, programs) {
  const inShaders = shaderSteps(tree);
  const folders = readdirSync(join(tree, "labs")).filter((name) => /^\d\d_/.test(name)).sort();
  return folders.map((folder) => {
    const toml = parse(readFileSync(join(tree, "labs", folder, "lab.toml"), "utf8"));
    return {
      number: Number(folder.slice(0, 2)),
      folder,
      title: toml.title,
      lesson: toml.lesson,
      files: firstFiles(programs, folder),
      shader: mainShader(tree, folder),
      opening: toml.opening && { set: texts(toml.opening[0].set), view: toml.opening[0].view ?? "color", right: texts(toml.opening[0].right) },
      looks: toml.look.map((look) => ({
        name: look.name,
        caption: look.caption,
        view: look.view ?? "color",
        hero: look.hero ?? false,
        set: texts(look.set),
      })),
      steps: (toml.step ?? []).map((step) => ({
        id: step.id,
        title: step.title,
        points: step.points,
        kind: inShaders.has(step.id) ? "shader" : "c++",
        view: step.view ?? "color",
        set: texts(step.set),
      })),
    };
  });
}

/** The address of a look: its parameters and view as a query. Empty for the default look. */
export function query({ set, view }) {
  const search = new URLSearchParams(set);
  if (view && view !== "color") search.set("view", view);
  const text = search.toString();
  return text === "" ? "" : `?${text}`;
}
