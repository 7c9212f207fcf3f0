# SPDX-License-Identifier: MIT
"""Error against cost, as tables in the terminal, as a page, and as docs/accuracy.md with its plots and tables."""
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
GOES = 4  # the cases of a lab whose costs have not parted are timed again, so often

INTRODUCTION = """# What we learned

How far each method of each lab is from the exact answer in double precision, and what a frame costs, as `./run accuracy` measured
on {}. Each lab has its figures on a page of its own, made by the same command.
`./run bench` measures on your machine and writes `out/bench/index.html`: point at a dot there to see more.

A filled dot is on the Pareto front: no other method of the case is cheaper and as close, or closer and as cheap.
Colours are ranked by the rms of their error, everything else by the mean. The line through a dot goes from the median of its
pixels' errors to their 99th percentile. A picture has 256x256 pixels, or what its case says, and one sample in each.

**What a method costs is counted in instructions.** Times do not repeat: two runs after each other disagreed about the front in 6 of 44
cases, whatever counted as equal. So `callgrind` counts what the software renderer executes for one frame, with its vertices,
rasterising, shading and the texels that a filter reads. The count has no model and no weights in it, and two whole runs
differed by at most 0.04 %, and in none of 317 marks. It knows nothing of a cache that misses, and one instruction may work on
eight pixels at once.
The time stands beside it, with the interval in which its median lies with 95 %. Frames are timed in rounds, each method once in a
round; rounds are added until all intervals part, or after {} goes ({} to {} rounds).
A graphics card counts nothing. There the times rank, and methods whose intervals overlap cost the same.
"""

TABLES = """# {} {}: figures

Measured by `./run accuracy` on {}. [What we learned](../accuracy.md) says how.

● is on the Pareto front of instructions and error; in the column `memory`, on that of bytes and error. Counts within 1 % and
errors within 2 % are equal. `max aside` is the largest error where each pixel may show what is right one pixel aside, and then in
brackets how many pixels are beyond it: a mesh has its outline elsewhere than the exact surface, and these pixels show that alone.
`covered` is the part of the exact object's pixels in which the method draws something. `instructions` are those of a frame, in
millions. `frame` is the median of the rounds, `ratio` that time over the time of the case's cheapest method, ± half the interval
in which its median lies with 95 %. `memory` holds vertices, indices and textures.
"""

GPU = """`ratio, GPU` is the ratio by a graphics card, {}, by its own clock; ● there is the front of its times and errors.
A frame takes it {:.2f} to {:.2f} ms, a good part of which is the same for all methods. In {} of {} rows its error is within 10 % of the one here.
"""

OTHER_RENDERERS = """
## Other renderers

[All renderers that were tried]({0}/renderers.md) shows how far they are from each other, and the room that limits leave them.
The pages of figures have a column for a graphics card, {1}.
"""

PAGE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><title>Speed against error</title>
<style>
{style}</style></head><body>
<div class="masthead"><h1>Speed against error</h1><p>Every method of every lab on its easy and hard cases: how far it is from \
the exact answer, and what a frame costs. Further left is cheaper, further down is closer to the truth. A filled dot is on the \
Pareto front: no other method is cheaper and as close, or closer and as cheap. The lines through a dot are intervals: upwards from the \
median of its pixels' errors to their 99th percentile, and across, where times rank, the interval in which its time lies. \
Point at a dot to see its picture, and where its error is. Measured on {renderer}.</p></div>
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


def millions(count):
    return "" if count is None else f"{count / 1e6:.3g}"


def dot(is_on_front):
    return "●" if is_on_front else ""


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
        def any_has(key):
            return any(one[key] is not None for one in self.results)

        def aside(one):
            return "" if one["max_aside"] is None else figure(one["max_aside"]) + f" ({one['outline_pixels']})" * (one["outline_pixels"] > 0)

        columns = {"": lambda one: dot(one["pareto"]),
                   self.results[0]["parameter"]: lambda one: one["method"],
                   "mean": lambda one: figure(one["mean"]),
                   "rms": lambda one: figure(one["rms"]),
                   "median": lambda one: "" if one["median"] is None else figure(one["median"]),
                   "P99": lambda one: figure(one["p99"]),
                   "max": lambda one: figure(one["max"]),
                   "max aside": aside,
                   "covered": covered}
        if any_has("error_low"):
            columns[f"{self.results[0]['cameras']} cameras"] = lambda one: f"{figure(one['error_low'])} to {figure(one['error_high'])}"
        if any_has("instructions"):
            columns["instructions"] = lambda one: millions(one["instructions"])
        if any_has("cost_ns"):
            columns |= {"frame": lambda one: "" if one["cost_ns"] is None else f"{one['cost_ns'] / 1e6:.2f} ms", "ratio": ratio}
        if self.of.by_gpu:
            columns["ratio, GPU"] = lambda one: f"{ratio(self.of.by_gpu_of(one))} {dot((self.of.by_gpu_of(one) or {'pareto': None})['pareto'])}".strip()
        if any_has("prepare_ns"):
            columns["prepared"] = lambda one: "" if one["prepare_ns"] is None else f"{one['prepare_ns']:.3g} ns a {one['prepare_of']}"
        return columns | {"memory": lambda one: f"{bytes_text(one['bytes'])} {dot(one['pareto_bytes'])}".strip()}

    def head(self):
        return list(self.columns())

    def cells(self, one):
        return [cell(one) for cell in self.columns().values()]

    def notes(self):
        """What is to be said of the whole table: its rounds, how far off the truth itself is, and how fast errors fall."""
        first, rounds = self.results[0], [one["rounds"] for one in self.results if one["rounds"]]
        lines = [f"{min(rounds)} rounds."] if rounds else []
        if first["truth_error"] is not None:
            lines.append("The truth has no samples." if first["truth_error"] < 1e-4 else
                         f"The truth itself is {figure(first['truth_error'])} {first['unit']} off (rms).")
        for name, of_error in (((error_name(first), error), ("largest", lambda one: one["max_aside"])) if self.bench else ()):
            if found := slopes(self.bench, self.of.results, of_error):
                number = list(self.bench["vary"])[number_of(self.bench)]
                parts = ", ".join(f"{series + ' ' if series else ''}{exponent:+.2f}" for series, exponent in found.items())
                lines.append(f"{name} error ~ {number} ^ exponent, fitted: {parts}.")
        return [" ".join(lines)] if lines else []

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
    if one["error_low"] is not None:
        lines.append(f"{figure(one['error_low'])} to {figure(one['error_high'])} over {one['cameras']} cameras")
    if one["non_finite"]:
        lines.append(f"{one['non_finite']} pixels not finite")
    if one["instructions"]:
        lines.append(f"{millions(one['instructions'])} million instructions a frame")
    if one["cost_ns"] is not None:
        lines.append(f"{one['cost_ns'] / 1e6:.2f} ms a frame, {ratio(one)} times the quickest in {one['rounds']} rounds")
    if one["pareto"]:
        lines.append("on the Pareto front")
    return "\n".join(lines)


def interval_of(one):
    """From the median of the pixels' errors to their 99th percentile; over cameras, from the smallest to the largest error."""
    if one["error_low"] is not None:
        return one["error_low"], one["error_high"]
    return (one["median"], one["p99"]) if one["median"] is not None else None


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
        panel.points.append(Point(float(values[number]), error(one), line, True, "", hover(one), section.pictures(one),
                                  interval_of(one)))
    for name, (points, _) in zip(names, panel.lines):  # at its last dot
        panel.points[points[-1]].label = name
    return Plot(list(section.bench["vary"])[number], section.error_label(), [panel])


def cost_panel(section, methods, in_counts):
    """Error against cost, with a line along the front. A method has its color in all panels."""
    panel = Panel(section.name, is_hard=section.bench.get("hard", False))
    fronts = [values_of(one) for one in section.results if one["pareto"]]
    shared = [len(fronts) > 1 and len(set(values)) == 1 for values in zip(*fronts)]  # values that need not stand beside a dot of the front
    for one in section.results:
        label = ", ".join(value for value, is_shared in zip(values_of(one), shared) if not is_shared) if one["pareto"] else ""
        cost = one["instructions"] and one["instructions"] / 1e6 if in_counts else one["cost_ratio"]
        if cost:
            spread = None if in_counts else (cost * (1 - one["cost_spread"]), cost * (1 + one["cost_spread"]))
            number = methods.setdefault(one["method"], len(methods))
            panel.points.append(Point(cost, error(one), number, bool(one["pareto"]), label or one["method"], hover(one), section.pictures(one),
                                      interval_of(one), spread))
    front = [i for i, point in enumerate(panel.points) if point.filled]
    panel.lines.append((sorted(front, key=lambda i: panel.points[i].x), None))
    return panel


def costs_label(of):
    """What the cost axes of a lab's plots show: what its marks hang on."""
    return "million instructions a frame" if all(one["instructions"] for one in of.results) else "time of a frame, times the quickest"


def main_plot(of):
    """The lab's one plot: of the case that its lab.toml chooses, else of its first."""
    section = next((each for each in of.sections() if each.bench and each.bench.get("plot")), of.sections()[0])
    if (number := number_of(section.bench)) is not None:
        return number_plot(section, number)
    return Plot(costs_label(of), section.error_label(), [cost_panel(section, {}, costs_label(of).startswith("million"))])


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
        plot, methods = cost_plots.setdefault(key, (Plot(costs_label(of), section.error_label()), {}))
        if (panel := cost_panel(section, methods, costs_label(of).startswith("million"))).points:
            plot.panels.append(panel)
    return [plot for plot, _ in cost_plots.values() if plot.panels] + number_plots


def plot_file(lab, index):
    """The name of a lab's plot, counted from 0: 05_normal_map-1.svg"""
    return f"{lab['lab']}-{index + 1}.svg"


IN_PAGE_ALONE = ("rms", "median", "max", "max aside", "covered", "frame", "memory")  # columns for which a terminal has no room


def terminal_table(of):
    """Within 80 columns."""
    out = f"\nLab {of.lab['number']}: {of.lab['title']}\n"
    for section in of.sections():
        keep = [i for i, name in enumerate(section.head()) if name not in IN_PAGE_ALONE and not name.endswith(" cameras")]
        rows = [[re.sub(r" ns a \w+$| ± .*", "", row[i]) for i in keep] for row in (section.head(), *map(section.cells, section.results))]
        made = next((one["prepare_of"] for one in section.results if one["prepare_ns"] is not None), "")
        rows[0] = [f"ns/{made}" if name == "prepared" else name for name in rows[0]]
        widths = [max(map(len, column)) for column in zip(*rows)]
        gap = "  " if sum(widths) + 2 * len(widths) <= 80 else " "
        out += "\n" + textwrap.fill(section.title(), 80, initial_indent="  ", subsequent_indent="    ") + "\n"
        for row in rows:
            cells = [f"{cell:{'<' if i < 2 else '>'}{widths[i]}}" for i, cell in enumerate(row)]
            out += f"  {gap.join(cells)}".rstrip() + "\n"
        out += "".join(textwrap.fill(line, 80, initial_indent="  ", subsequent_indent="    ") + "\n" for line in section.notes())
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
    out += "</tbody></table></div>\n" + "".join(f"<p>{escaped(line)}</p>\n" for line in section.notes())
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


def gpu_text(of, gpu):
    """How the graphics card's figures of a lab compare, over the cases that both renderers measured."""
    pairs = [(one, other) for one in of.results if one["case"] != ALL_CASES and (other := of.by_gpu_of(one)) and other["cost_ns"] is not None]
    if not pairs:
        return ""
    times = [other["cost_ns"] / 1e6 for _, other in pairs]
    alike = sum(abs(error(other) - error(one)) <= 0.1 * error(one) for one, other in pairs)
    return GPU.format(gpu, min(times), max(times), alike, len(pairs))


def lab_markdown(of, renderer, gpu):
    """docs/accuracy/NN_name.md: all that was measured of a lab; `gpu` is the graphics card's name."""
    out = TABLES.format(of.lab["number"], of.lab["title"], renderer) + gpu_text(of, gpu)
    for i, plot in enumerate(plots(of)):
        out += f"\n![{plot.y_label}, by {plot.x_label}]({plot_file(of.lab, i)})\n"
    for section in of.sections():
        head = section.head()
        out += f"\n## {section.title()}\n\n" + markdown_row(head) + markdown_row(["---"] * 2 + ["--:"] * (len(head) - 2))
        out += "".join(markdown_row(section.cells(one)) for one in section.results)
        out += "".join(f"\n{line}\n" for line in section.notes())
        out += f"\n{section.bench['teaches']}\n" if section.bench else ""
    return out


def markdown(labs, renderer, gpu, folder):
    """docs/accuracy.md: what we learned of each lab; its plot and its page of figures lie in `folder`."""
    rounds = [one["rounds"] for of in labs for one in of.results if one["rounds"]] or [0]
    out = INTRODUCTION.format(renderer, GOES, min(rounds), max(rounds)) + claims(labs)
    for of in labs:
        plot = main_plot(of)
        out += (f"\n## {of.lab['number']} {of.lab['title']}\n\n{of.lab.get('choice', '')}\n"
                f"\n![{plot.panels[0].name}: {plot.y_label}, by {plot.x_label}]({folder}/{of.lab['lab']}.svg)\n"
                f"\n`./run bench {of.lab['number']}` measures it; [all figures]({folder}/{of.lab['lab']}.md)\n")
    return out + OTHER_RENDERERS.format(folder, gpu)
