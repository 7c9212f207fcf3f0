# SPDX-License-Identifier: MIT
"""Error against cost, as tables in the terminal, as a page, and as docs/accuracy.md with its plots."""
import dataclasses
import itertools
import math
import pathlib
import re
import textwrap

from bench_plot import Panel, Plot, Point, escaped, panel_svgs
from bench_results import ALL_CASES, error, error_name, number_of, over_all_cases, slopes, values_of, without
from course import ROOT

PICTURES = "pictures"  # the folder of the page's pictures, beside the page; each lab has one below it
SIDE = 200  # of those, in pixels

INTRODUCTION = """# Speed against error

Every method of every lab on its easy and hard cases: how far it is from the exact answer in double precision,
and what a frame costs, as `./run accuracy` measured on {}.
`./run bench` measures on your machine and writes `out/bench/index.html`: point at a dot there to see more.

A filled dot, ● in the tables, is on the Pareto front: no other method of the case is cheaper and as close, or closer and as cheap.
Colours are ranked by the rms of their error, everything else by the mean.
A picture has 256x256 pixels, or what its case says, and one sample in each. `max` is often one pixel at a silhouette; `P99` leaves
the worst hundredth out. `covered` is the part of the exact object's pixels in which the method draws something.
`frame` is the median of interleaved rounds, {} to {} of them. `ratio` is that time over the time of the case's cheapest method, ± half \
the interval in which the median lies with 95 %.
Costs whose intervals overlap (at least 3 %) and errors within 2 % count as equal. `memory` holds vertices, indices and textures.
"""

GPU = """`ratio, GPU` is the ratio by a graphics card, {}, by its own clock.
A frame takes it {:.2f} to {:.2f} ms, a good part of which is the same for all methods. In {} of {} rows its error is within 10 % of the one here.
"""

PAGE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><title>Speed against error</title>
<style>
{style}</style></head><body>
<div class="masthead"><h1>Speed against error</h1><p>Every method of every lab on its easy and hard cases: how far it is from \
the exact answer, and what a frame costs. Further left is cheaper, further down is closer to the truth. A filled dot is on the \
Pareto front: no method is both cheaper and closer. Point at a dot to see its picture, and where its error is. \
Measured on {renderer}.</p></div>
<nav><ol>
{links}</ol></nav>
<main>
{sections}</main>
<script>
{script}</script></body></html>
"""


@dataclasses.dataclass
class LabResults:
    """A lab with what was measured of it: its cases in their order, then what is over all cases."""
    lab: dict
    results: list
    by_gpu: list  # the same as a graphics card measured it

    def sections(self):
        """The results case by case."""
        cases = {bench["case"]: bench for bench in self.lab["bench"]}
        return [Section(self, list(group), cases.get(key[0]))
                for key, group in itertools.groupby(self.results, key=lambda one: (one["case"], one["case"] == ALL_CASES and one["truth"]))]

    def by_gpu_of(self, one):
        """The same method in the same case, or None."""
        return next((other for other in self.by_gpu if all(other[key] == one[key] for key in ("case", "truth", "method"))), None)


def by_lab(labs, report, by_gpu):
    """The results of a report by lab. Cases that the lab.toml no longer has are left out."""

    def results_of(lab, results):
        own = [one for bench in lab["bench"] for one in results if one["lab"] == lab["lab"] and one["case"] == bench["case"]]
        return own + over_all_cases(lab, own)

    all_labs = [LabResults(lab, results_of(lab, report["results"]), results_of(lab, by_gpu["results"])) for lab in labs]
    return [one for one in all_labs if one.results]


def figure(value):
    return f"{value:.3g}"


def bytes_text(count):
    return f"{count / 1e3:.1f} kB" if count < 10_000_000 else f"{count / 1e6:.1f} MB"


def covered(one):
    text = f"{100 * one['pixels'] / one['truth_pixels']:.1f} %"
    return f"{text}, {one['non_finite']} not finite" if one["non_finite"] else text


def ratio(one):
    return "" if one is None or one["cost_ns"] is None else f"{one['cost_ratio']:.2f} ± {one['cost_ratio'] * one['cost_spread']:.2f}"


@dataclasses.dataclass
class Section:
    """The results of one case, as a table and in words."""
    of: LabResults
    results: list
    bench: dict  # None for all cases together

    @property
    def name(self):
        return self.results[0]["case"] if self.bench else f"{ALL_CASES}: {self.results[0]['truth']}"

    def title(self):
        """jittered torus, in degrees against the exact relief as a baked map (hard)"""
        first = self.results[0]
        if not self.bench:
            return f"{self.name}, in {first['unit']}"
        return f"{self.name}, in {first['unit']} against {first['truth']}{' (hard)' if self.bench.get('hard') else ''}"

    def columns(self):
        """{head: the cell of a result}."""
        columns = {"": lambda one: "●" if one["pareto"] else "",
                   self.results[0]["parameter"]: lambda one: one["method"],
                   "mean": lambda one: figure(one["mean"]),
                   "rms": lambda one: figure(one["rms"]),
                   "P99": lambda one: figure(one["p99"]),
                   "max": lambda one: figure(one["max"]),
                   "covered": covered,
                   "frame": lambda one: "" if one["cost_ns"] is None else f"{one['cost_ns'] / 1e6:.2f} ms",
                   "ratio": ratio}
        if self.of.by_gpu:
            columns["ratio, GPU"] = lambda one: ratio(self.of.by_gpu_of(one))
        if any("prepare_ns" in one for one in self.results):
            columns["prepared"] = lambda one: f"{one['prepare_ns']:.3g} ns a {one['prepare_of']}" if "prepare_ns" in one else ""
        return columns | {"memory": lambda one: bytes_text(one["bytes"])}

    def head(self):
        return list(self.columns())

    def cells(self, one):
        return [cell(one) for cell in self.columns().values()]

    def slope_lines(self):
        found = slopes(self.bench, self.of.results) if self.bench else {}
        if not found:
            return []
        number = list(self.bench["vary"])[number_of(self.bench)]
        parts = ", ".join(f"{series + ' ' if series else ''}{exponent:+.2f}" for series, exponent in found.items())
        return [f"{error_name(self.results[0])} error ~ {number} ^ exponent, fitted: {parts}."]

    def error_label(self):
        return f"{error_name(self.results[0])} error, {self.results[0]['unit']}"

    def pictures(self, one):
        """The files of a result's pictures, as the page names them."""
        return [f"{PICTURES}/{one['lab']}/{picture['name']}" for picture in pictures_of(self.bench, one)]


def pictures_of(bench, one):
    """What the page shows of a result, as entries of a lab's --batch: the colours, and the error of each pixel."""
    name = re.sub("[^a-z0-9_-]", "-", f"{bench['case']}-{one['method']}".lower())
    size = [int(side) for side in bench["size"].split("x")]
    size = "x".join(str(max(1, side * SIDE // max(size))) for side in size)
    settings = bench["set"] | dict(zip(one["parameter"].split(", "), values_of(one)))
    return [{"name": f"{name}-{view}.png", "view": view, "size": size, "set": settings} for view in ("color", "error")]


def hover(one):
    lines = [one["method"], one["case"], f"mean {figure(one['mean'])} P99 {figure(one['p99'])} max {figure(one['max'])} {one['unit']}"]
    if one["non_finite"]:
        lines.append(f"{one['non_finite']} pixels not finite")
    if one["cost_ns"] is not None:
        lines.append(f"{one['cost_ns'] / 1e6:.2f} ms a frame, {one['cost_ratio']:.2f} times the cheapest")
    if one["pareto"]:
        lines.append("on the Pareto front")
    return "\n".join(lines)


def number_plot(section, number):
    """Error against the number that varies; one line for each combination of the others."""
    panel, names = Panel(section.name), []
    for one in section.results:
        values = values_of(one)
        if not float(values[number]) > 0:
            continue
        name = without(values, number)
        if name not in names:
            panel.lines.append(([], len(names)))
            names.append(name)
        line = names.index(name)
        panel.lines[line][0].append(len(panel.points))
        panel.points.append(Point(float(values[number]), error(one), line, True, "", hover(one), section.pictures(one)))
    for name, (points, _) in zip(names, panel.lines):  # at its last dot
        panel.points[points[-1]].label = name
    return Plot(list(section.bench["vary"])[number], section.error_label(), [panel])


def cost_panel(section, methods):
    """Error against cost, with a line along the front. A method has its color in all panels."""
    panel = Panel(section.name, is_hard=section.bench.get("hard", False))
    for one in section.results:
        if one["cost_ns"] is not None:
            number = methods.setdefault(one["method"], len(methods))
            panel.points.append(Point(one["cost_ns"] / 1e6, error(one), number, one["pareto"], one["method"], hover(one), section.pictures(one)))
    front = [i for i, point in enumerate(panel.points) if point.filled]
    panel.lines.append((sorted(front, key=lambda i: panel.points[i].x), None))
    return panel


def plots(of):
    """Error against cost: cases over the same parameters, in the same unit, share a plot. Then error against the number of each case over
    one."""
    cost_plots, number_plots = {}, []
    for section in of.sections():
        if not section.bench:
            continue
        if (number := number_of(section.bench)) is not None:
            number_plots.append(number_plot(section, number))
            continue
        key = section.results[0]["parameter"], section.results[0]["unit"]
        plot, methods = cost_plots.setdefault(key, (Plot("milliseconds a frame", section.error_label()), {}))
        if (panel := cost_panel(section, methods)).points:
            plot.panels.append(panel)
    return [plot for plot, _ in cost_plots.values() if plot.panels] + number_plots


def plot_file(lab, index):
    """The name of a lab's plot, counted from 0: 05_normal_map-1.svg"""
    return f"{lab['lab']}-{index + 1}.svg"


IN_PAGE_ALONE = ("rms", "covered", "memory")  # columns for which a terminal has no room


def terminal_table(of):
    """Within 80 columns."""
    out = f"\nLab {of.lab['number']}: {of.lab['title']}\n"
    for section in of.sections():
        keep = [i for i, name in enumerate(section.head()) if name not in IN_PAGE_ALONE]
        rows = [[re.sub(r" ns a \w+$| ± .*", "", row[i]) for i in keep] for row in (section.head(), *map(section.cells, section.results))]
        made = next((one["prepare_of"] for one in section.results if "prepare_ns" in one), "")
        rows[0] = [f"ns/{made}" if name == "prepared" else name for name in rows[0]]
        widths = [max(map(len, column)) for column in zip(*rows)]
        gap = "  " if sum(widths) + 2 * len(widths) <= 80 else " "
        out += "\n" + textwrap.fill(section.title(), 80, initial_indent="  ", subsequent_indent="    ") + "\n"
        for row in rows:
            cells = [f"{cell:{'<' if i < 2 else '>'}{widths[i]}}" for i, cell in enumerate(row)]
            out += f"  {gap.join(cells)}".rstrip() + "\n"
        out += "".join(textwrap.fill(line, 80, initial_indent="  ", subsequent_indent="    ") + "\n" for line in section.slope_lines())
    return out


def with_code(text):
    """HTML of a text with its `words` as code."""
    return re.sub("`([^`]*)`", "<code>\\1</code>", escaped(text))


def html_table(section):
    def row(cells, tag):
        return "".join(f"<{tag}>{escaped(cell)}</{tag}>" for cell in cells) + "</tr>"

    out = f'<h3>{escaped(section.title())}</h3>\n<div class="scroll"><table><thead><tr>{row(section.head(), "th")}</thead><tbody>\n'
    for one in section.results:
        out += ('<tr class="front">' if one["pareto"] else "<tr>") + row(section.cells(one), "td") + "\n"
    out += "</tbody></table></div>\n" + "".join(f"<p>{escaped(line)}</p>\n" for line in section.slope_lines())
    return out + (f"<p>{with_code(section.bench['teaches'])}</p>\n" if section.bench else "")


def page_section(of):
    svgs = "".join(svg for plot in plots(of) for svg in panel_svgs(plot))
    return (f'<section class="bench" id="{of.lab["lab"]}"><h2>{of.lab["number"]} {escaped(of.lab["title"])}</h2>\n'
            f'<p class="choice">{with_code(of.lab.get("choice", ""))}</p>\n<div class="plots">\n{svgs}</div>\n'
            f'{"".join(map(html_table, of.sections()))}</section>\n')


def page(labs, renderer):
    """The whole page as HTML. It names the pictures, and nothing else outside of itself."""
    own = pathlib.Path(__file__)
    styles = (ROOT / "common/core/page.css", ROOT / "tools/gallery/style.css", own.with_name("bench.css"))
    links = "".join(f'<li><a href="#{of.lab["lab"]}"><b>{of.lab["number"]}</b> {escaped(of.lab["title"])}</a></li>\n' for of in labs)
    return PAGE.format(style="".join(file.read_text(encoding="utf-8") for file in styles), renderer=escaped(renderer), links=links,
                       sections="".join(map(page_section, labs)), script=own.with_name("bench.js").read_text(encoding="utf-8"))


def markdown_row(cells):
    return f"| {' | '.join(cells)} |\n"


def claims(labs):
    """What the sources say, and what measuring it gave."""
    rows = [(str(of.lab["number"]), f"{claim['says']} ([{claim['source']}](student.md#the-sources))", claim["found"], f"`{claim['see']}`")
            for of in labs for claim in of.lab.get("claim", [])]
    head = [("lab", "says", "found", "see"), ("---",) * 4]
    return "\n## What the sources say, tested\n\n" + "".join(map(markdown_row, head + rows))


def gpu_text(labs, gpu):
    """How the graphics card's figures compare, over the cases that both renderers measured."""
    pairs = [(one, other) for of in labs for one in of.results if one["case"] != ALL_CASES
             and (other := of.by_gpu_of(one)) and other["cost_ns"] is not None]
    if not pairs:
        return ""
    times = [other["cost_ns"] / 1e6 for _, other in pairs]
    alike = sum(abs(error(other) - error(one)) <= 0.1 * error(one) for one, other in pairs)
    return GPU.format(gpu, min(times), max(times), alike, len(pairs))


def markdown(labs, renderer, gpu, folder):
    """docs/accuracy.md, whose plots are `folder`/NN_name-1.svg …; `gpu` is the graphics card's name."""
    rounds = [one["rounds"] for of in labs for one in of.results if one.get("rounds")] or [0]
    out = INTRODUCTION.format(renderer, min(rounds), max(rounds)) + gpu_text(labs, gpu) + claims(labs)
    for of in labs:
        out += f"\n## {of.lab['number']} {of.lab['title']}\n\n{of.lab.get('choice', '')}\n"
        for i, plot in enumerate(plots(of)):
            out += f"\n![{plot.y_label}, by {plot.x_label}]({folder}/{plot_file(of.lab, i)})\n"
        for section in of.sections():
            head = section.head()
            out += f"\n### {section.title()}\n\n" + markdown_row(head) + markdown_row(["---"] * 2 + ["--:"] * (len(head) - 2))
            out += "".join(markdown_row(section.cells(one)) for one in section.results)
            out += "".join(f"\n{line}\n" for line in section.slope_lines())
            out += f"\n{section.bench['teaches']}\n" if section.bench else ""
    return out
