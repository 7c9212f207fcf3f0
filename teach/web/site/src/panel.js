// SPDX-License-Identifier: MIT
// The panel, made from the lab's own declaration of its parameters. Native controls: keyboard, screen readers and phones
// know them.
import { element } from "./dom.js";
import { textOf } from "./state.js";

const kSteps = 1000;  // positions of a slider

const label = (name) => name.replaceAll("_", " ");

/** Where a value lies on its slider, 0 to 1, and back. */
function scaleOf(p) {
  if (p.scale !== "logarithmic")
    return { to: (value) => (value - p.min) / (p.max - p.min), from: (t) => p.min + t * (p.max - p.min) };
  const low = Math.log(p.min), high = Math.log(p.max);
  return { to: (value) => (Math.log(value) - low) / (high - low), from: (t) => Math.exp(low + t * (high - low)) };
}

/** A value as it is shown and set: an integer, tenths of a degree, else four digits. */
function rounded(p, value) {
  const inside = Math.min(Math.max(value, p.min), p.max);
  if (p.type === "integer") return Math.round(inside);
  if (p.unit === "degrees") return Number(inside.toFixed(1));
  return Number(inside.toPrecision(4));
}

const unitSign = (unit) => (unit === "degrees" ? "°" : unit);

/** A slider and a field for typing; both say the unit. */
function numberControl(p, id, change) {
  const scale = scaleOf(p);
  const whole = p.type === "integer" && p.scale !== "logarithmic";
  const slider = element("input", { type: "range", id, min: whole ? p.min : 0, max: whole ? p.max : kSteps, step: whole ? 1 : "any" });
  const field = element("input", { type: "number", min: p.min, max: p.max, step: p.type === "integer" ? 1 : "any", "aria-label": `${label(p.name)}, typed` });
  if (!whole) slider.step = 1;
  const show = (text) => {
    const value = Number(text);
    slider.value = whole ? value : kSteps * scale.to(value);
    slider.setAttribute("aria-valuetext", `${rounded(p, value)} ${p.unit}`.trim());
    if (document.activeElement !== field) field.value = rounded(p, value);
  };
  slider.addEventListener("input", () => {
    const value = String(rounded(p, whole ? Number(slider.value) : scale.from(slider.value / kSteps)));
    slider.setAttribute("aria-valuetext", `${value} ${p.unit}`.trim());
    field.value = value;
    change(value);
  });
  field.addEventListener("change", () => {
    const value = field.value === "" ? Number.NaN : Number(field.value);
    if (Number.isFinite(value)) change(String(rounded(p, value)));
    field.value = Number.isFinite(value) ? rounded(p, value) : field.defaultValue;
  });
  return { parts: [slider, element("span", { className: "typed" }, field, element("span", { className: "unit", "aria-hidden": "true" }, unitSign(p.unit)))], show };
}

function choiceControl(p, id, change) {
  const options = p.choices.map(({ name, help }) => element("option", { value: name, title: help }, name));
  const select = element("select", { id }, ...options);
  const said = element("p", { className: "chosen", id: `${id}-chosen` });
  const show = (text) => {
    select.value = text;
    said.textContent = p.choices.find(({ name }) => name === text)?.help ?? "";
  };
  select.setAttribute("aria-describedby", said.id);
  select.addEventListener("change", () => {
    show(select.value);
    change(select.value);
  });
  return { parts: [select, said], show };
}

function toggleControl(p, id, change) {
  const box = element("input", { type: "checkbox", id, role: "switch" });
  box.addEventListener("change", () => change(textOf(box.checked)));
  return { parts: [box], show: (text) => (box.checked = text === "on") };
}

/** One parameter: its name, its control, and a button that takes it back when it is not the default. */
function row(p, change, help) {
  const id = `parameter-${p.name}`;
  const make = p.type === "toggle" ? toggleControl : p.choices.length > 0 ? choiceControl : numberControl;
  const control = make(p, id, change);
  const initial = textOf(p.default);
  const back = element("button", { type: "button", className: "back", title: `Back to ${initial}`, "aria-label": `Reset ${label(p.name)} to ${initial}` }, "↺");
  back.addEventListener("click", () => {
    change(initial);
    control.parts[0].focus();
  });
  const spoken = element("span", { className: "spoken", id: `${id}-help` }, p.help);
  const first = control.parts[0];
  first.setAttribute("aria-describedby", [spoken.id, first.getAttribute("aria-describedby")].filter(Boolean).join(" "));
  const line = element("div", { className: `parameter ${p.type}` }, element("label", { for: id, title: p.help }, label(p.name)),
    element("div", { className: "control" }, ...control.parts), back, spoken);
  for (const event of ["pointerenter", "focusin"]) line.addEventListener(event, () => help(p.help));
  return {
    line,
    show(text) {
      control.show(text);
      line.classList.toggle("is-set", text !== initial);
      back.hidden = text === initial;
    },
  };
}

/** A part of the panel that can be folded, and stays as the user left it. */
export function part(name, title, open, ...children) {
  const made = element("details", { className: "part", open }, element("summary", {}, title), ...children);
  made.dataset.part = name;
  return made;
}

/**
 * Builds the parameters' controls into `host`. `change(name, text)` is called for each change by the user, `help(text)`
 * with the line of help of what the pointer or the focus is at. Gives `show({name: text})`, which shows values that came
 * from elsewhere.
 */
export function buildParameters(host, parameters, change, help) {
  const rows = new Map();
  let section, body = host;
  for (const p of parameters) {
    if (p.section !== section) {
      section = p.section;
      // The pointer moves the camera: its numbers are seldom wanted.
      body = part(`parameters-${section || "lab"}`, section || "Parameters", section !== "Camera");
      host.append(body);
    }
    const made = row(p, (text) => {
      made.show(text);
      change(p.name, text);
    }, help);
    rows.set(p.name, made);
    body.append(made.line);
  }
  return (values) => {
    for (const [name, text] of Object.entries(values)) rows.get(name)?.show(text);
  };
}

/** The views as a group of radio buttons. */
export function buildViews(views, choose) {
  const inputs = new Map();
  const group = element("fieldset", { className: "views" }, element("legend", { className: "spoken" }, "View"));
  for (const view of views) {
    const input = element("input", { type: "radio", name: "view", value: view });
    input.addEventListener("change", () => choose(view));
    inputs.set(view, input);
    group.append(element("label", {}, input, element("span", {}, view)));
  }
  return { group, show: (view) => inputs.get(view) && (inputs.get(view).checked = true) };
}

/** Another value of a parameter right of a line: which parameter, and which value. `choose(parameter, value)`, or null. */
export function buildCompare(parameters, choose) {
  const comparable = parameters.filter((p) => p.type === "toggle" || p.choices.length > 0);
  const which = element("select", { id: "compare" }, element("option", { value: "" }, "nothing"),
    ...comparable.map((p) => element("option", { value: p.name }, label(p.name))));
  const value = element("select", { id: "compare-value" });
  const second = element("div", { className: "parameter" }, element("label", { for: "compare-value" }, "right side"), element("div", { className: "control" }, value));
  const choices = (p) => (p.type === "toggle" ? ["on", "off"] : p.choices.map(({ name }) => name));
  const fill = (p) => value.replaceChildren(...choices(p).map((name) => element("option", { value: name }, name)));
  let values = {};
  which.addEventListener("change", () => {
    const p = comparable.find((one) => one.name === which.value);
    if (!p) return choose(null);
    const all = choices(p);
    choose(p.name, all[0] === values[p.name] ? all[all.length - 1] : all[0]);
  });
  value.addEventListener("change", () => choose(which.value, value.value));
  const show = (split, now) => {
    values = now;
    which.value = split?.parameter ?? "";
    second.hidden = !split;
    const p = comparable.find((one) => one.name === split?.parameter);
    if (!p) return;
    fill(p);
    value.value = split.value;
  };
  const group = element("div", { className: "compare" }, element("div", { className: "parameter" },
    element("label", { for: "compare", title: "Draws the right part of the picture with another value of a parameter" }, "compare"), element("div", { className: "control" }, which)), second);
  return { group, show };
}
