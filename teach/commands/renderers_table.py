# SPDX-License-Identifier: MIT
"""docs/renderers.json, and docs/accuracy/renderers.md that shows it.

The report has `drawn_by`, {"mesa22_llvmpipe_sse2": "llvmpipe (LLVM 15.0.6), Mesa 22.3.6"}, and three lists of rows: `cases`, the graded
ones; `tests`, assertions of tests that draw, in shares of their limits; `filters`, lab 1's errors. A row has `lab`, `case`, `unit`, and
`by`: the largest distance from what is expected, the share or the error, by group_of. `least` is the share that some renderer used."""
import json
import math
import pathlib

from course import reading

LISTS = ("cases", "tests", "filters")
ROOM = 3  # a limit is so many times what the renderers differ by
TITLE = "# Renderers, and the room that limits leave them"
INTRODUCTION = """
No two drivers draw the same. The table has each graded case's limit and its spread: the largest distance of each renderer's
picture from the expected one, after one pixel of a thousand is left out. A limit is at least three times the spread.
Hidden cases are drawn with three seeds and compared with those of llvmpipe in Mesa 22.
A graphics card rounds a vertex's place in the window to 1/256 of a pixel, and all that it interpolates moves with it. So a
difference counts as none that a move by 1/64 of a pixel explains: 1/64 of what the pixel differs from one of those around it.
`check` and `grade` use these limits and draw in software: the solution has all points by each of these renderers. Pages in a
browser draw with the machine's graphics card. They judge the public cases of steps in shaders, and the column `hardware` has
these.
Where a column is empty, the case was changed since that renderer drew it.

`./run renderers` draws and measures. A machine has one version of Mesa only. To join several machines, copy the folders in
their `out/renderers` into one, and let `./run renderers --judge-only` measure there.
llvmpipe draws with vectors of 128 and 256 bits and with the instructions of older processors (SSE2, SSE4.1, AVX). Its 1/sqrt is the
processor's approximation: it is also drawn with an exact one, and with one that is off by as much as Intel specifies.
"""
TESTS_HEAD = """
## Tests that hold a limit, by the share of it that is used

Each row is an assertion in a test that draws. 0.2 means: the value was at most a fifth of its limit.
The room is (1 - smallest share) / (largest share - smallest share). It is at least 3.

"""
FILTERS_HEAD = """
## Lab 1's filters by driver, rms error in 8-bit steps

The anisotropic filter is the driver's, and Mesa changed it between 22 and 25 and again before 26.
`supersampled` is the lab's own: it is the same in all versions of Mesa, and nearly the same on a graphics card.

"""
WAYS = {"egl": "EGL", "osmesa": "OSMesa", "128": "128 bits", "256": "256 bits", "sse2": "SSE2", "sse41": "SSE4.1", "avx": "AVX",
        "rsqrt_exact": "exact 1/sqrt", "rsqrt_high": "1/sqrt too large", "rsqrt_low": "1/sqrt too small"}


def group_of(renderer):
    """llvmpipe, mesa22 of mesa22_llvmpipe_sse2"""
    version, driver, _ = renderer.split("_", 2)
    return f"{driver}, {version}"


def way_of(renderer):
    """SSE4.1 of mesa22_llvmpipe_sse41"""
    way = renderer.split("_", 2)[2]
    return WAYS.get(way, way)


def most_of(row):
    return max(row["by"].values(), default=0)


def room_of(row, limit):
    """The way to the limit, by how far the renderers are from each other. Infinite where they do not differ."""
    least, most = row.get("least", 0), most_of(row)
    return (limit - least) / (most - least) if most > least else math.inf


def room_text(row, limit):
    return "" if room_of(row, limit) == math.inf else f"{room_of(row, limit):.2g}"


def limits_of(labs):
    """{(5, "decode"): its limit}"""
    return {(lab["number"], case["name"]): case["limit"] for lab in labs for case in lab["case"]}


def read_renderers(file):
    with reading(file, "./run renderers writes it"):
        report = json.loads(pathlib.Path(file).read_text(encoding="utf-8"))
        for row in [row for name in LISTS for row in report[name]]:
            row["by"] = {group: math.inf if value is None else value for group, value in row["by"].items()}
        return report


def to_json(report):
    """One line a row, as a change of one row is to show. Infinity becomes null."""

    def line(value):
        return json.dumps(value, ensure_ascii=False, separators=(",", ":"))

    def written(row):
        by = {group: value if value < math.inf else None for group, value in sorted(row["by"].items())}
        return {key: value for key, value in (row | {"by": by}).items() if key != "least" or value > 0}

    def rows(name):
        return f' "{name}": [\n' + ",\n".join(f"  {line(written(row))}" for row in report[name]) + "\n ]"

    return f'{{\n "drawn_by": {line(dict(sorted(report["drawn_by"].items())))},\n' + ",\n".join(map(rows, LISTS)) + "\n}\n"


def table(rows, head, cells):
    """A table with a column for each group. `cells` gives those before, and those after the groups, of a row."""
    groups = sorted({group for row in rows for group in row["by"]})
    columns = [*head[0], *groups, *head[1]]
    out = f"| {' | '.join(columns)} |\n|{' --- |' * len(columns)}\n"
    for row in rows:
        first, last = cells(row)
        middle = [f" {row['by'][group]:.2g} |" if group in row["by"] else " |" for group in groups]
        out += "|" + "".join([*(f" {cell} |" for cell in first), *middle, *(f" {cell} |" for cell in last)]) + "\n"
    return out


def renderers_markdown(report, labs):
    """docs/accuracy/renderers.md."""
    limits, ways = limits_of(labs), {}
    for renderer, says in sorted(report["drawn_by"].items()):
        ways.setdefault(says, []).append(way_of(renderer))

    def case_cells(row):
        limit = limits.get((row["lab"], row["case"]), 0)
        return (str(row["lab"]), row["case"], row["unit"]), (f"{limit:g}", room_text(row, limit))

    def test_cells(row):
        code = row["unit"].replace("|", "\\|")
        return (row["case"], f"`{code}`"), (room_text(row, 1),)

    return (f"{TITLE}\n{INTRODUCTION}\n| renderer | with |\n| --- | --- |\n"
            + "".join(f"| {says} | {', '.join(all_ways)} |\n" for says, all_ways in sorted(ways.items())) + "\n"
            + table(report["cases"], (("lab", "case", "unit"), ("limit", "limit / spread")), case_cells)
            + TESTS_HEAD + table(report["tests"], (("test", "holds"), ("room",)), test_cells)
            + FILTERS_HEAD + table(report["filters"], (("case",), ()), lambda row: ((row["case"],), ())))
