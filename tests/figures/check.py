#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the figures of a lab's pictures: check.py TABLE.toml PROGRAM. Exit code 1 where a line does not hold.

    [[figure]]
    name = "of the screen's axes is tens of degrees"
    because = "The reason that gives the figure, and what was measured."
    set = { normal_map = "bump", model = ["quad", "cube"] }   # a list: each of its values, in every combination
    looks = [{}, { tilt = 30 }]                               # more settings: the lines hold for each
    size = "128x128"                                          # [256x256]
    lines = ["mean(method=screen-axes, turn=50) > 20", "mean() = 0.3 +- 0.01", "mean(method=a) < 1.2 * mean(method=b)", "unknown(model=ship)"]

A line compares what --measure says (mean, p99, max, pixels, non_finite) of the settings with a number, or with the same of other
settings. `unknown`: there is no exact answer, and the lab says so. With TEXEL_TOLERANCES, a file in this folder says how much of each
limit was used, as tests/support/tolerance.hpp does for the tests in C++."""
import concurrent.futures
import functools
import itertools
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tomllib

LINE = re.compile(r"(?P<what>\w+)\((?P<of>[^)]*)\)(?: (?P<sign>[<>=]) (?:(?P<times>[\d.e-]+) \* )?(?:(?P<other>\w+)\((?P<beside>[^)]*)\)|"
                  r"(?P<number>[\d.e-]+))(?: \+- (?P<tolerance>[\d.e-]+))?)?")


@functools.cache
def measured(program, size, settings):
    flags = [word for name, value in settings for word in (f"--{name.replace('_', '-')}", value)]
    return subprocess.run([program, "--measure", "-", "--size", size, *flags], capture_output=True, text=True, check=False)


def text(value):
    return ("on" if value else "off") if isinstance(value, bool) else str(value)


def combinations(settings):
    """The settings with one value for each list, for all its values."""
    names, values = list(settings), [value if isinstance(value, list) else [value] for value in settings.values()]
    return [dict(zip(names, map(text, chosen))) for chosen in itertools.product(*values)]


def problem(program, size, settings, line, use):
    """Why a line does not hold, or None."""
    found = LINE.fullmatch(line)
    if not found:
        return "is no line that can be checked"

    def run(changes):
        own = dict(part.split("=", 1) for part in re.split(r", *", changes) if part)
        return measured(program, size, tuple(sorted({**settings, **own}.items())))

    if found["what"] == "unknown":
        said = run(found["of"])
        return None if said.returncode == 3 and "no exact answer" in said.stderr and "choose" in said.stderr else said.stderr or said.stdout

    def figure(what, changes):
        said = run(changes)
        if said.returncode != 0:
            raise ValueError(said.stderr.strip())
        return json.loads(said.stdout)[what]

    try:
        value = figure(found["what"], found["of"])
        other = figure(found["other"], found["beside"]) if found["other"] else float(found["number"])
    except (ValueError, KeyError) as error:
        return str(error)
    other *= float(found["times"] or 1)
    if found["sign"] == "=":
        share = abs(value - other) / float(found["tolerance"]) if found["tolerance"] else (0 if value == other else math.inf)
    elif value == other:
        share = 1
    else:
        share = value / other if found["sign"] == "<" else other / value if value else math.inf
    # A count, and what must be equal or 0, is no limit that a renderer comes near to.
    if found["what"] in ("mean", "p99", "max") and other != 0 and (found["sign"] != "=" or found["tolerance"]):
        use(line, share)
    return None if share < 1 or (found["sign"] == "=" and share <= 1) else f"it is {value:.6g} beside {other:.6g}"


def main():
    table, program = map(pathlib.Path, sys.argv[1:])
    used, checks = {}, []
    for one in tomllib.loads(table.read_text(encoding="utf-8"))["figure"]:
        for look in one.get("looks", [{}]):
            for settings in combinations({**one.get("set", {}), **look}):
                checks += [(one, settings, line) for line in one["lines"]]

    def check(of):
        one, settings, line = of

        def use(said, share):
            key = f"Figures.{one['name'].replace(' ', '_')}\t{said}"
            used[key] = max(used.get(key, 0), share)

        return problem(str(program), one.get("size", "256x256"), settings, line, use)

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        failed = [(of, why) for of, why in zip(checks, pool.map(check, checks)) if why]
    for (one, settings, line), why in failed:
        print(f"{table.name}: the error {one['name']}: {line} with {settings}: {why}\n  {one['because']}")
    if folder := os.environ.get("TEXEL_TOLERANCES"):
        lines = [f"{key}\t{share:.9g}\n" for key, share in sorted(used.items())]
        pathlib.Path(folder, f"{os.getpid()}.tsv").write_text("".join(lines), encoding="utf-8")
    print(f"{len(checks) - len(failed)} of {len(checks)} lines hold")
    return 1 if failed or not checks else 0


sys.exit(main())
