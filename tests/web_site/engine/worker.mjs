// SPDX-License-Identifier: MIT
// The stand-in's worker: see client.mjs.
const degrees = { type: "number", unit: "degrees", section: "Camera", scale: "linear" };
const parameters = [
  { name: "method", type: "choice", default: "mikktspace", unit: "", help: "How the frame is made", section: "Normal map",
    choices: [{ name: "raw", help: "The map as it is" }, { name: "averaged", help: "Averaged per vertex" }, { name: "mikktspace", help: "Mikkelsen's rules" }] },
  { name: "normal_mapping", type: "toggle", default: true, unit: "", help: "Whether the map is used", section: "Normal map" },
  { name: "texture", type: "file", default: "brick", unit: "", help: "The picture", section: "Normal map",
    choices: [{ name: "brick", help: "Bricks" }, { name: "wood", help: "Planks" }] },
  { name: "segments", type: "integer", default: 24, min: 3, max: 96, unit: "", help: "Around the model", section: "Normal map", scale: "linear" },
  { name: "near", type: "number", default: 0.1, min: 0.0001, max: 10, unit: "units", help: "The near plane", section: "Normal map", scale: "logarithmic" },
  { name: "yaw", default: 30, min: -360, max: 360, help: "Around the vertical axis", ...degrees },
  { name: "pitch", default: 20, min: -89, max: 89, help: "Above the horizon", ...degrees },
].map((p) => ({ choices: [], ...p, flag: p.name.replaceAll("_", "-") }));
const file = "shaders/05_normal_map/decode_normal.glsl";
const first = "  return color;\n";
const around = (text) => `// A normal from a colour.\nvec3 decode_normal(vec3 color) {\n  //@step 5.1 begin\n${text}  //@end\n}\n`;
const line = 4;
const oneCase = { name: "decode_bumps", view: "normal", size: "128x96", set: { method: "raw" }, limit: 0.05, unit: "degrees", command: "" };

const text = (value) => (typeof value === "boolean" ? (value ? "on" : "off") : String(value));
const initial = () => Object.fromEntries(parameters.map((p) => [p.name, text(p.default)]));
let canvas = null, lab = null, values = initial(), view = "color", split = null, step = first, frames = 0, experiment = "";

function paint(context, width, height) {
  const hue = (Number(values.yaw) + 720) % 360;
  for (let x = 0; x < width; x += 8) {
    const right = split && x / width > split.position;
    context.fillStyle = `hsl(${(hue + x) % 360} ${view === "color" ? 60 : 90}% ${right ? 70 : 40}%)`;
    context.fillRect(x, 0, 8, height);
  }
}
function frame() {
  if (step.includes("for (;;)")) for (;;);
  ++frames;
  if (canvas) paint(canvas.getContext("2d"), canvas.width, canvas.height);
  const legend = { title: "normal of a ball", width: 2, height: 1, colors: "ff000000ff00", ball: true, ticks: [] };
  return { ...(view === "color" ? {} : { legend }), frame_ms: 1.5, warnings: [], facts: [["triangles", 12], ...(experiment ? [["experiment", experiment]] : [])], key: "", flags: "", command: "" };
}
function fail(message, more = {}) {
  throw { message, kind: "usage", problems: [], ...more };
}
const stepResult = () => {
  const right = step.includes("right"), untouched = step.includes("return color;");
  const error = right ? 0.001 : 12.4;
  return { id: "5.1", status: right ? "passed" : "failed", error, unit: "degrees", limit: 0.05, title: "Decode", points: 1, hints: ["Look.", "Write 2c - 1."],
    message: right ? "" : "Off by 12.4 degrees in 97 % of the object. At most 0.05 is right.", looks_like_says: step.includes("swapped") ? "red and green swapped" : "", spoilt_by: [],
    cases: [{ ...oneCase, status: right ? "passed" : untouched ? "untouched" : "failed", error, message: "" }] };
};
const filled = (n, value) => new Uint8Array(n).fill(value);
const calls = {
  start: ([surface]) => void (canvas = surface ?? null),
  open([number]) {
    lab = number;
    values = initial();
    frame();
    return { number: lab, folder: "05_normal_map", title: "Normal map", lesson: "", choice: "", views: ["color", "normal", "tangent"],
      parameters: calls.parameters(), looks: calls.looks() };
  },
  parameters: () => parameters.map((p) => ({ ...p, value: values[p.name] })),
  values: () => ({ values, key: "", flags: "", view }),
  looks: () => [{ name: "opening", caption: "Wrong and right", hero: false, view: "color", size: "512x512", set: { method: "raw", segments: "48" },
    right: { parameter: "method", value: "mikktspace" }, sides: ["as it is", "in the frame"] }, { name: "fine", caption: "Fine", hero: true, view: "color", size: "512x512", set: { segments: "96" } }, { name: "raw", caption: "Raw", view: "normal", size: "512x512", set: { method: "raw" } }],
  set([wanted]) {
    for (const [name, value] of Object.entries(wanted)) {
      const p = parameters.find((one) => one.name === name) ?? fail(`there is no parameter '${name}'`);
      if (p.choices.length > 0 && !p.choices.some((one) => one.name === text(value))) fail(`'${value}' is no ${name}`);
    }
    for (const [name, value] of Object.entries(wanted)) values[name] = text(value);
    return frame();
  },
  reset() {
    values = initial();
    return frame();
  },
  view([name]) {
    view = name;
    return frame();
  },
  split([parameter, value, position]) {
    split = parameter ? { parameter, value, position } : null;
    return frame();
  },
  resize([width, height]) {
    if (canvas) Object.assign(canvas, { width, height });
    return frame();
  },
  drag([dx, dy]) {
    values.yaw = String(Number(values.yaw) - dx);
    values.pitch = String(Number(values.pitch) + dy);
    return frame();
  },
  zoom: () => frame(),
  turn: () => frame(),
  samples: () => frame(),
  aspect: () => frame(),
  frame: () => frame(),
  draw([{ size }]) {
    const [width, height] = size.split("x").map(Number);
    return { width, height, channels: 3, data: filled(3 * width * height, 128) };
  },
  shown([{ size }]) {
    const [width, height] = size.split("x").map(Number);
    return filled(4 * width * height, 128);
  },
  pixel: ([x, y]) => ({ x, y, views: [{ view: "normal", values: [0, 0.6, -0.8, 1] }, { view: "depth", values: [2.5, 0, 0, 0] }] }),
  steps: () => [{ id: "5.1", title: "Decode the map's colour", points: 1, needs: [], hints: ["Look.", "Write 2c - 1."], kind: "shader", file, line,
    untouched: step === first, cases: [oneCase] }],
  steps_of: ([number]) => (number === 5 ? calls.steps() : []),
  read: () => ({ text: step, first, file, line }),
  write([, wanted]) {
    step = wanted;
    if (step.includes("syntax error")) {
      const problem = { file, line: line + step.split("\n").findIndex((one) => one.includes("syntax error")), column: 3, message: "'syntax' : undeclared identifier" };
      throw { ...problem, kind: "failed", problems: [problem] };
    }
    return frame();
  },
  experiment([path, wanted]) {
    const problem = { file: path, line: 2, column: 1, message: "'syntax' : undeclared identifier" };
    if (wanted.includes("syntax error")) throw { ...problem, kind: "failed", problems: [problem] };
    experiment = wanted;
    return frame();
  },
  file: () => around(step),
  files: () => [file],
  put([, whole]) {
    const match = /\/\/@step 5\.1 begin\n([^]*?) *\/\/@end/.exec(whole) ?? fail("has 0 parts of step 5.1, but 1 are expected");
    step = match[1];
    return frame();
  },
  check: () => ({ lab: "05_normal_map", title: "Normal map", steps: [stepResult()] }),
  compare: () => ({ width: 4, height: 2, own: filled(32, 40), expected: filled(32, 200), heat_map: filled(32, 90) }),
  figures: () => ({ first_picture_ms: performance.now(), frame_ms: 1.5, bytes: 1000, renderer: "stripes" }),
  presented: () => new Promise((done) => setTimeout(done, 200)),
  lose: () => void postMessage({ lost: "the context was lost" }),
  frames: () => frames,
};

onmessage = async ({ data: { id, name, values: given, call, args } }) => {
  if (call === "start") {  // by the page, before its script is there
    canvas = args.canvas;
    return postMessage({ id, result: {} });
  }
  try {
    postMessage({ id, value: await calls[name](given) });
  } catch (error) {
    postMessage({ id, error: error.kind ? error : { message: String(error), kind: "internal", problems: [] } });
  }
};
