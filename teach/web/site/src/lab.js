// SPDX-License-Identifier: MIT
// The page of a lab: engine, picture, panel, steps and address are put together here.
import "../../../../common/core/legend.js";
import { contract } from "./contract.js";
import { buildExperiment } from "./experiment.js";
import { afterPause, download, element, figure } from "./dom.js";
import { imageOf } from "./image.js";
import { keepOffline } from "./offline.js";
import { buildCompare, buildParameters, buildViews, part } from "./panel.js";
import { makePicture } from "./picture.js";
import { pixelTable } from "./pixel.js";
import { buildProgress } from "./progress.js";
import { Session, Stopped } from "./session.js";
import { changed, readState, textOf, writeState } from "./state.js";
import { buildSteps } from "./steps.js";
import { Work } from "./storage.js";

const find = (selector) => document.querySelector(selector);
const main = find("main");
const opening = () => now.looks.find((look) => look.right) ?? now.looks.find((look) => look.hero);
const ui = {
  host: find(".picture"), divider: find(".divider"), message: find(".message"), pixel: find(".pixel"), waiting: find(".waiting"),
  legend: find(".legend-place"), compared: find(".compared"), followed: find(".followed"),
  said: find(".said"), panel: find(".controls-of-lab"), drawer: find(".panel"), help: find(".help"), article: find(".handout"), progress: find(".progress"),
};

const wanted = readState(location.search);
const now = { looks: [], look: null, parameters: [], values: {}, view: "color", split: null, report: null, lab: null };
let show = { parameters() {}, views() {}, compare() {} };
let benches = new Map(), progress = null, experiment = null;

const work = new Work(new URL("..", location.href).pathname);
const picture = makePicture(ui.host, {
  drag: (dx, dy) => drawn(byHand(session.call("drag", dx, dy)), true),
  zoom: (steps) => drawn(byHand(session.call("zoom", steps)), true),
  resize: (width, height) => drawn(session.call("resize", width, height)),
  pick: (x, y) => pick(x, y).catch(complain),
  key,
});
const session = new Session({
  lab: Number(main.dataset.lab),
  freshCanvas: picture.fresh,
  work,
  state: () => ({ set: changed(now.parameters, now.values), view: now.view, split: now.split, size: picture.size() }),
  on: { stuck, lost, failed: complain, restarted, undone: (step, text) => benches.get(step)?.take(text).catch(complain) },
});

// ---- What a frame says ----

/** Waits for a frame that was asked for and shows what it says. `moved`: the camera may have changed. */
async function drawn(promise, moved = false) {
  try {
    now.report = await promise;
    say(null);
    showStatistics();
    showLegend();
    if (moved) {
      readBack();
      keepMoving();
    } else saveState();
    return true;
  } catch (error) {
    complain(error);
    return false;
  }
}

/** The picture is there, or will not come. */
function arrived() {
  for (const one of [ui.waiting, find(".still")]) one?.remove();
}

function showLegend() {
  const legend = now.report?.legend;
  ui.legend.replaceChildren(...(legend ? [texelLegend(legend)] : []));
}

const kSlow = 100;  // milliseconds of a frame: from here on a picture that follows the hand jerks
let isCoarse = false;

/** On a slow machine a moving picture has one sample a pixel, and four when it rests. */
function keepMoving() {
  rest();
  if (isCoarse || now.report.frame_ms < kSlow) return;
  isCoarse = true;
  session.call("samples", 1).catch(() => {});
}
const rest = afterPause(400, () => {
  if (!isCoarse) return;
  isCoarse = false;
  drawn(session.call("samples", 4));
});

/** A message over the last good picture; null takes it away. With a button, where something can be done. */
function say(text, button, act) {
  ui.message.hidden = text === null;
  ui.message.replaceChildren(...(text === null ? [] : [element("p", {}, text)]));
  if (!button) return;
  const made = element("button", { type: "button" }, button);
  made.addEventListener("click", act);
  ui.message.append(made);
}

function complain(error) {
  if (error instanceof Stopped) return;  // told already, with a button
  console.warn(error);
  const problems = error.problems ?? [];
  say(problems.length > 0 ? problems.slice(0, 4).map((one) => `${one.file}:${one.line}: ${one.message}`).join("\n") : error.message);
}

// ---- Stopped and started again ----

function suspect(step) {
  return step ? `the code of step ${step} may loop for ever` : "the machine may be very slow";
}

function offerRestart(text, step) {
  turn(false);
  say(text, step ? "Undo the last change and start again" : "Start again", () => {
    say("Starting again.");
    (step ? session.undoAndRestart() : session.restart()).catch(complain);
  });
}
function stuck(step) {
  offerRestart(`The picture has not answered for some seconds: ${suspect(step)}. It was stopped.`, step);
}
function lost(message, step) {
  offerRestart(`${message} This happened twice in a row: ${suspect(step)}.`, step);
}

function restarted() {
  isCoarse = false;
  say(null);
  drawn(session.call("frame"));
  experiment?.restarted();
}

// ---- State ----

const saveState = afterPause(200, () => history.replaceState(null, "", address()));
const address = () => `${location.pathname}${writeState({ set: changed(now.parameters, now.values), view: now.view, split: now.split })}${location.hash}`;

/** Values that the engine changed: the camera's. */
const readBack = afterPause(60, async () => {
  try {
    take((await session.call("values")).values);
  } catch (error) {
    complain(error);
  }
});

/** Shows values from elsewhere in the panel, and in the address. */
function take(values) {
  for (const p of now.parameters) if (values[p.name] !== undefined) now.values[p.name] = textOf(values[p.name]);
  show.parameters(now.values);
  show.compare(now.split, now.values);
  saveState();
}

function set(values) {
  byHand();
  Object.assign(now.values, values);
  show.parameters(values);
  return drawn(session.call("set", values));
}

async function setView(view) {
  byHand();
  now.view = view;
  show.views(view);
  return drawn(session.call("view", view));
}

function setSplit(split) {
  byHand();
  now.split = split;
  show.compare(split, now.values);
  showDivider();
  return drawn(split ? session.call("split", split.parameter, split.value, split.position) : session.call("split"));
}

/** All parameters of a look or a case: those that it does not name are the defaults. */
async function setLook(look) {
  now.look = look;
  const [width, height] = (look.size ?? "1x1").split("x").map(Number);
  session.call("aspect", width / height).catch(() => {});
  const set = Object.fromEntries(Object.entries(look.set ?? {}).map(([name, value]) => [name, textOf(value)]));
  const all = { ...Object.fromEntries(now.parameters.map((p) => [p.name, textOf(p.default)])), ...set };
  turn(false);
  const before = now.split;
  now.split = look.split ?? (look.right ? { ...look.right, position: 0.5 } : null);
  Object.assign(now.values, all);
  showDivider();
  show.parameters(all);
  show.compare(now.split, now.values);
  const view = look.view && look.view !== "mesh" ? look.view : "color";
  const asked = [];
  if (now.split) asked.push(session.call("split", now.split.parameter, now.split.value, now.split.position));
  else if (before) asked.push(session.call("split"));
  if (view !== now.view) asked.push(session.call("view", view));
  asked.forEach((promise) => promise.catch(() => {}));  // the old look with the new view; the next frame counts
  now.view = view;
  show.views(view);
  return drawn(session.call("set", all));
}

// ---- Picture ----

async function pick(x, y) {
  const values = await session.call("pixel", x, y);
  const close = element("button", { type: "button", "aria-label": "Close" }, "×");
  close.addEventListener("click", () => {
    ui.pixel.hidden = true;
    ui.host.focus();
  });
  ui.pixel.replaceChildren(element("header", {}, `Pixel ${x}, ${y}`, close), pixelTable(values));
  ui.pixel.hidden = false;
}

function showDivider() {
  ui.divider.hidden = !now.split;
  if (!now.split) return;
  const percent = Math.round(100 * now.split.position);
  ui.divider.style.left = `${100 * now.split.position}%`;
  ui.divider.setAttribute("aria-valuenow", percent);
  const { parameter, value } = now.split, { right, sides, set } = now.look ?? {}, left = now.values[parameter];
  const isOpening = right?.parameter === parameter && right.value === value && set[parameter] === left;
  const isToggle = now.parameters.find((p) => p.name === parameter)?.type === "toggle";
  const [leftName, rightName] = isOpening ? sides : [left, value].map((text) => (isToggle ? `${parameter.replaceAll("_", " ")} ${text}` : text));
  ui.divider.querySelector(".left").textContent = leftName;
  ui.divider.querySelector(".right").textContent = rightName;
}

function moveDivider(position) {
  setSplit({ ...now.split, position: Math.min(Math.max(position, 0.02), 0.98) });
}
ui.divider.addEventListener("pointerdown", (event) => ui.divider.setPointerCapture(event.pointerId));
ui.divider.addEventListener("pointermove", (event) => {
  if (!(event.buttons & 1)) return;
  const box = ui.host.getBoundingClientRect();
  moveDivider((event.clientX - box.left) / box.width);
});
ui.divider.addEventListener("keydown", (event) => {
  const step = { ArrowLeft: -0.02, ArrowRight: 0.02, ArrowDown: -0.02, ArrowUp: 0.02 }[event.key];
  if (step === undefined) return;
  event.preventDefault();
  moveDivider(now.split.position + step);
});

let turning = false;
function turn(on) {
  if (turning === on) return;
  turning = on;
  find("[data-tool=turn]").setAttribute("aria-pressed", String(on));
  if (on) turnOn(performance.now());
}
async function turnOn(last) {
  while (turning) {
    const time = await new Promise(requestAnimationFrame);
    if (!(await drawn(session.call("turn", 0.03 * Math.min(Math.max(time - last, 0), 100)), true))) turn(false);
    last = time;
  }
  readBack();
}

/** A key on the picture, as in the desktop's window; false where it has no meaning. */
function key(name) {
  const next = (by) => {
    const p = now.parameters.find((one) => one.name === "texture") ?? now.parameters.find((one) => one.type === "file");
    const names = p?.choices.map(({ name }) => name) ?? [];
    if (names.length > 0) set({ [p.name]: names[(names.indexOf(now.values[p.name]) + by + names.length) % names.length] });
  };
  const keys = {
    space: () => turn(!turning),
    j: tools.look,
    r: tools.view,
    s: tools.snapshot,
    k: () => next(-1),
    l: () => next(1),
    m: () => now.values.normal_mapping && set({ normal_mapping: now.values.normal_mapping === "on" ? "off" : "on" }),
  };
  keys[name]?.();
  return name in keys;
}

const tools = {
  turn: () => turn(!turning),
  view: () => set(Object.fromEntries(now.parameters.filter((p) => p.section === "Camera").map((p) => [p.name, textOf(p.default)]))),
  look: () => setLook(opening() ?? { set: {} }),
  mine,
  end: () => experiment.close(),
  panel(open = !ui.drawer.classList.contains("is-open")) {
    ui.drawer.classList.toggle("is-open", open);
    find("[data-tool=panel]").setAttribute("aria-pressed", String(open));
  },
  link: () => copy(new URL(address(), location.href).href),
  async snapshot() {
    const { width, height } = picture.size();
    const asked = { view: now.view, size: `${width}x${height}`, set: changed(now.parameters, now.values) };
    const isColor = now.view === "color";
    const drawing = await session.call(isColor ? "draw" : "shown", asked);
    const canvas = element("canvas", { width, height });
    canvas.getContext("2d").putImageData(imageOf(drawing.data ?? drawing, width, height), 0, 0);
    download(`${now.lab.folder}${isColor ? "" : `-${now.view}`}.png`, await new Promise((done) => canvas.toBlob(done)));
    said("Saved");
  },
};
async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
    said("Copied");
  } catch {
    said(text);
  }
}
const quietAgain = afterPause(4000, () => (ui.said.textContent = ""));
function said(text) {
  ui.said.textContent = text;
  quietAgain();
}
for (const button of document.querySelectorAll("[data-tool]"))
  button.addEventListener("click", () => Promise.resolve(tools[button.dataset.tool]()).catch(complain));

// ---- Panel ----

const statistics = element("dl", { className: "statistics" });
function showStatistics() {
  const { frame_ms, facts = [], warnings = [], error_figures: error } = now.report ?? {};
  const rows = [["a frame", `${figure(frame_ms)} ms`]];
  if (error) rows.push(["error", error.reason ?? `mean ${figure(error.mean)}, P99 ${figure(error.p99)}, most ${figure(error.max)} ${error.unit}`]);
  const notes = facts.map((fact) => (Array.isArray(fact) ? fact : ["note", fact]));
  statistics.replaceChildren(...[...rows, ...notes].flatMap(([name, value]) => [element("dt", {}, name), element("dd", {}, String(value))]),
    ...warnings.flatMap((text) => [element("dt", { className: "warn" }, "note"), element("dd", {}, text)]));
}

function buildPanel() {
  const views = buildViews(now.lab.views, setView);
  const compare = buildCompare(now.parameters, (parameter, value) =>
    setSplit(parameter && { parameter, value, position: now.split?.position ?? 0.5 }));
  const parameters = element("div");
  const help = (text) => (ui.help.textContent = text);
  show = { parameters: buildParameters(parameters, now.parameters, (name, text) => set({ [name]: text }), help), views: views.show, compare: compare.show };
  ui.panel.replaceChildren(part("view", "View", true, views.group, compare.group), parameters, part("statistics", "Statistics", false, statistics));
  show.parameters(now.values);
  show.views(now.view);
  show.compare(now.split, now.values);
}

/** Links of looks and of the handout's commands set the picture; with Ctrl they open a tab, as links do. */
document.addEventListener("click", (event) => {
  const link = event.target.closest?.("a.look, a.see");
  if (!link || event.ctrlKey || event.metaKey || event.shiftKey || event.button !== 0 || now.parameters.length === 0) return;
  event.preventDefault();
  const { set: values, view } = readState(new URL(link.href).search);
  byHand();
  setLook({ set: values, view, size: now.looks.find(({ name }) => name === link.dataset.look)?.size });
});

// ---- Start ----

const known = ({ set: values, ...rest }) => {
  const names = new Set(now.parameters.map((p) => p.name));
  return { ...rest, set: Object.fromEntries(Object.entries(values).filter(([name]) => names.has(name))) };
};

async function start() {
  now.lab = await session.start();
  now.parameters = now.lab.parameters;
  now.values = Object.fromEntries(now.parameters.map((p) => [p.name, textOf(p.value ?? p.default)]));
  // As the window does: without a state in the address the lab opens on its lesson.
  now.looks = now.lab.looks;
  const named = location.search === "" ? opening() : now.looks.find((look) => look.name === wanted.look);
  const state = known(named ? { ...wanted, view: named.view, set: { ...named.set, ...wanted.set } } : wanted);
  now.view = now.lab.views.includes(state.view) ? state.view : "color";
  now.split = state.split ?? (named?.right ? { ...named.right, position: 0.5 } : null);
  now.look = named ?? null;
  if (named) {
    const [width, height] = named.size.split("x").map(Number);
    await session.call("aspect", width / height);
  }
  Object.assign(now.values, Object.fromEntries(Object.entries(state.set).map(([name, value]) => [name, textOf(value)])));
  now.report = await session.resume().catch((error) => {
    if (error instanceof Stopped) throw error;
    complain(error);
  });
  showLegend();
  await session.call("presented");
  arrived();
  take((await session.call("values")).values);
  buildPanel();
  showDivider();
}

async function startSteps() {
  benches = await buildSteps({ article: ui.article, session, work, showCase: setLook, showCompared, next, changed: () => progress?.show() });
  progress = buildProgress({ host: ui.progress, labNumbers: [...document.querySelectorAll(".bar li")].map((_, i) => i + 1), benches, session, work, checkAll: () => check() });
  for (const [id, bench] of benches) if (work.text(id) !== undefined) await bench.check().catch(complain);
  const host = find(".experiment"), sign = find(".experimenting");
  experiment = await buildExperiment({ host, sign, lab: session.lab, path: host.dataset.path, session, work, draw: drawn, copy });
}

/** The step to do after this one: its heading as a link, or null. */
function next(id) {
  const after = [...benches.values()].find((bench) => bench.step.id !== id && bench.result?.status !== "passed" && (bench.result || bench.step.untouched));
  return after && element("a", { href: `#step-${after.step.id}` }, after.step.id);
}

/** A case's pictures in place of the large one; null takes them away. */
function showCompared(view, close) {
  ui.compared.hidden = !view;
  if (!view) return ui.compared.replaceChildren();
  const button = element("button", { type: "button", "aria-label": "Close" }, "×");
  button.addEventListener("click", close);
  ui.compared.replaceChildren(view, button);
}

// ---- The picture follows the text ----

let own = null, follows = true, isScrolled = false;
/** The user has another look now: that is the one to which one goes back. */
function byHand(promise) {
  own = null;
  isScrolled = false;  // a step that just came into view does not take it away
  ui.followed.hidden = true;
  return promise;
}
function mine() {
  const back = own;
  follows = false;
  byHand();
  return back && setLook(back);
}
/** A step that comes into view while one reads sets its look. */
function followText() {
  let last = null;
  const steps = [...ui.article.querySelectorAll(".step")];
  const follow = afterPause(350, () => {
    if (!follows || !isScrolled) return;
    const line = innerHeight * (matchMedia("(max-width: 62rem)").matches ? 0.7 : 0.45);
    const step = steps.find((one) => one.getBoundingClientRect().bottom > line);
    if (!step || step.getBoundingClientRect().top > line || step === last) return;
    last = step;
    own ??= { set: changed(now.parameters, now.values), view: now.view, split: now.split, right: now.look?.right, sides: now.look?.sides, size: now.look?.size };
    setLook(readState(step.dataset.look));
    ui.followed.hidden = false;
    ui.followed.firstChild.textContent = `The look of step ${step.dataset.step}.`;
  });
  for (const place of [ui.article, document])
    place.addEventListener("scroll", () => {
      isScrolled = true;
      follow();
    }, { passive: true });
}

/** Takes up what another tab wrote. */
function follow(step) {
  if (benches.has(step)) benches.get(step).follow();
  else session.follow(step).catch(() => {});  // of another course, or the page has stopped
}

/** Judges the whole lab and shows each step's verdict. */
async function check() {
  const results = await session.judge("check");
  for (const step of results.steps) benches.get(step.id)?.show(step, true);
  progress?.show();
  return results;
}

work.watch = () => progress?.show();
addEventListener("storage", ({ key }) => {
  work.heard(key);
  const step = work.stepOf(key);
  if (step !== null) withSteps.then(() => follow(step), () => {});
});
// A page that slept heard nothing.
for (const back of ["visibilitychange", "pageshow"])
  addEventListener(back, () => {
    work.save();
    if (!document.hidden) withSteps.then(() => work.steps().forEach(follow), () => {});
  });
addEventListener("beforeunload", (event) => work.hasUnsaved && event.preventDefault());

const ready = start();
const withSteps = ready.then(startSteps);
ready.then(() => void keepOffline("../sw.js", main.dataset.lab.padStart(2, "0"))).catch((error) => {
  arrived();
  complain(error);
});
/**
 * To what the address asks for. Steps and editors are laid out when they come near, and move it: until it stands still, or the user
 * does something.
 */
async function toAnchor() {
  const anchor = location.hash && document.getElementById(location.hash.slice(1));
  let isFree = true;
  for (const by of ["wheel", "touchstart", "pointerdown", "keydown"]) addEventListener(by, () => (isFree = false), { once: true, passive: true });
  for (let still = 0, i = 0; anchor && isFree && still < 10 && i < 60; ++i) {
    const before = anchor.getBoundingClientRect().top;
    anchor.scrollIntoView();
    await new Promise((done) => requestAnimationFrame(() => setTimeout(done, 30)));
    still = Math.abs(anchor.getBoundingClientRect().top - before) < 2 ? still + 1 : 0;
  }
}
withSteps.then(toAnchor).then(followText, complain);
window.texel = contract({ ready: withSteps, session, now, check, write: (step, text) => benches.get(step).write(text) });
