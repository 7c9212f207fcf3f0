// SPDX-License-Identifier: MIT
// Where a file stands in the tree, and a step's text in its file. A step with two places is one text here, with a line between
// the two.

const kNext = "//@next";

/** The one of `paths` that the file of an archive is, whatever folders are around it, or undefined. */
export const pathOf = (name, paths) => paths.find((path) => name === path || name.endsWith(`/${path}`));

/** The first line and the number of lines of each place of a step; lines count from 1. */
function placesOf(file, step) {
  const places = [];
  let open = null;
  file.split("\n").forEach((line, i) => {
    if (line.trim() === `//@step ${step} begin`) places.push((open = { line: i + 2, count: 0 }));
    else if (line.trim() === "//@end") open = null;
    else if (open) ++open.count;
  });
  return places;
}

/** Gives a function that gives the file's line numbers of a text's lines, also when the text has grown; null between places. */
export function lineNumbersOf(file, step) {
  const places = placesOf(file, step);
  return (text) => {
    let place = 0, count = 0, grown = 0;
    return text.split("\n").map((line) => {
      if (line.trim() === kNext && place + 1 < places.length) {
        grown += count - places[place++].count;
        count = 0;
        return null;
      }
      return places[place].line + grown + count++;
    });
  };
}

/** The lines around a step's only place that show where it stands, up to the blank lines before and after. */
export function surroundingsOf(file, step) {
  const lines = file.split("\n"), places = placesOf(file, step);
  const first = places[0].line - 1, past = first + places[0].count;
  let from = first, to = past;
  while (from > 0 && lines[from - 1].trim() !== "" && first - from < 12) --from;
  while (to < lines.length && lines[to].trim() !== "" && to - past < 6) ++to;
  // Not what means nothing here: the license, and the marks of the step, which the editor's frame shows.
  const shown = (from, to) => lines.slice(from, to).filter((line) => !/^\s*\/\/(@|\s*SPDX)/.test(line)).join("\n");
  return { before: shown(from, first), after: places.length > 1 ? "" : shown(past, to) };
}
