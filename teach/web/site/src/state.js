// SPDX-License-Identifier: MIT
// The address is the state: each parameter that is not the default, the view, and what is compared.
//   ?method=raw&yaw=40&view=normal&compare=method:mikktspace:0.5    or a look by its name: ?look=gator

/** {set: {parameter: text}, view, split: {parameter, value, position} or null, look} of an address' query. */
export function readState(search) {
  const state = { set: {}, view: "color", split: null, look: null };
  for (const [name, value] of new URLSearchParams(search)) {
    if (name === "view") state.view = value;
    else if (name === "look") state.look = value;
    else if (name === "compare") {
      const [, parameter, other, position] = /^([^:]+):(.*):([^:]+)$/.exec(value) ?? [];
      const at = Number(position);
      if (parameter && at >= 0 && at <= 1) state.split = { parameter, value: other, position: at };
    } else state.set[name] = value;
  }
  return state;
}

/** The query of a state. That of the default look is not empty: an empty one opens the lab on its lesson. */
export function writeState({ set, view, split }) {
  const search = new URLSearchParams(set);
  if (view && view !== "color") search.set("view", view);
  if (split) search.set("compare", `${split.parameter}:${split.value}:${Number(split.position.toFixed(3))}`);
  const text = search.toString();
  return `?${text || "look=default"}`;
}

/** The values that are not the defaults. */
export function changed(parameters, values) {
  return Object.fromEntries(parameters.filter((p) => values[p.name] !== textOf(p.default)).map((p) => [p.name, values[p.name]]));
}

/** A value of the declaration as the command line takes it. */
export const textOf = (value) => (typeof value === "boolean" ? (value ? "on" : "off") : String(value));
