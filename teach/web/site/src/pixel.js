// SPDX-License-Identifier: MIT
// What a clicked pixel holds: each data view's value, and the method beside the truth where the course's tree knows it.
import { element, figure } from "./dom.js";

/** A value as the desktop's panel writes it. */
function written(view, values) {
  const fixed = (count, digits) => values.slice(0, count).map((value) => value.toFixed(digits)).join("  ");
  if (view === "texcoord") return fixed(2, 5);
  if (["normal", "tangent", "direction"].includes(view)) return fixed(3, 4);
  if (view === "color") return fixed(3, 1);
  return String(Number(values[0]?.toPrecision(5)));
}

/** The table of a pixel, as the engine's `pixel` gives it. */
export function pixelTable({ views, comparison }) {
  const row = (name, text) => element("tr", {}, element("th", { scope: "row" }, name), element("td", {}, text));
  const rows = views.map(({ view, values }) => row(view, values[3] > 0 ? written(view, values) : "background"));
  if (comparison)
    rows.push(row("method", written(comparison.view, comparison.value)), row("truth", written(comparison.view, comparison.truth)),
      row("error", `${figure(comparison.error)} ${comparison.unit}`));
  return element("table", {}, ...rows);
}
