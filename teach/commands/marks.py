#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that each mistake of the catalogue loses marks, and no right answer.

Exit codes: 0 holds, 1 a mistake passes, a right answer fails, or they are less than three times apart, 2 wrong usage, 3 could not draw."""
import argparse
import dataclasses
import json
import math
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True
from course import ROOT, labs_option, read_labs, run, texel, text_of, write  # noqa: E402
from renderers_table import most_of, read_renderers  # noqa: E402

APART = 3  # how many times further off than any right answer the smallest mistake of a step must be

HEAD = """# Right answers and mistakes

A right answer must never lose a mark, and a mistake must always lose some. The table has both sides of each step: the right
answer that is furthest from the expected picture, on any renderer or written another way, and the smallest mistake of the
catalogue. Both are given in the case where they are furthest off, with the case's limit and as a share of it. The mistake
is off at least three times as far. The last column is the best mark that a mistake of this step gets.

`./run marks` judges each mutant and each equivalent, and the solution with each place of a step as the starter has it, with
several seeds. It fails when a mistake passes, when a right answer fails, or when they are less than three times apart.
`./run marks --list` prints all of them.

| step | furthest right answer | times the limit | which | smallest mistake | times the limit | which | apart | best mark |
| --- | --- | --- | --- | --- | --- | --- | --- | --- |
"""


@dataclasses.dataclass
class Far:
    """How far a solution of a step is off, in the case where it is furthest."""
    by: str  # the entry of the catalogue, the place, or "renderers"
    at: str  # the case
    times: float  # the limit; infinite where nothing can be compared
    error: float
    limit: float
    unit: str
    mark: float = 1  # of the step, 0 to 1

    def cell(self):
        return f"{figure(self.error)} {self.unit} of {self.limit:g} | {figure(self.times)} | {self.by}"


def figure(value):
    return f"{value:.2g}" if math.isfinite(value) else "nothing to compare"


def furthest(solution, seed):
    """In one seed's cases."""

    def far(case):
        error = math.nan if case["error"] is None else case["error"]
        times = error / case["limit"] if case["passed"] or error > case["limit"] else math.inf  # also where single pixels are not finite
        return Far(solution["name"], case["case"], times, error, case["limit"], case["unit"], seed["score"])

    return max(map(far, seed["cases"]), key=lambda one: one.times)


def judge(solution, faults):
    """Over the seeds: the one by which it is most like the other side, with the lower mark of a right answer and the higher of a mistake."""
    kept, is_right = None, solution["is_right"]
    for number, seed in enumerate(solution["seeds"], 1):
        far = furthest(solution, seed)
        if seed["passed"] != is_right:
            faults.append(f"{solution['step']}: '{far.by}' {'passes' if seed['passed'] else 'fails'} with seed {number}: {text_of(far.error)} "
                          f"{far.unit} off in {far.at}, {far.times:.3g} times the limit")
        if kept is None:
            kept = far
        elif (far.times > kept.times) == is_right:
            kept = dataclasses.replace(far, mark=(min if is_right else max)(far.mark, kept.mark))
    return kept


class Step:
    """A step's marks from both sides: the furthest right answer and the smallest mistake first."""

    def __init__(self, step, solutions, spreads, faults):
        self.id, sides = step["id"], {True: [], False: []}
        for one in solutions:
            if one["called"] != one["is_called"]:
                faults.append(f"{self.id}: '{one['name']}' is called '{one['called']}'")
            sides[one["is_right"]].append(judge(one, faults))
        self.rights = sorted(sides[True] + spreads, key=lambda one: one.times, reverse=True)
        self.mistakes = sorted(sides[False], key=lambda one: one.times)
        self.furthest = self.rights[0] if self.rights and self.rights[0].times > 0 else None
        # Infinite where all that are right are the same.
        self.apart = self.mistakes[0].times / self.furthest.times if self.furthest and self.mistakes else math.inf
        if not self.mistakes:
            faults.append(f"{self.id}: the catalogue has no mistake of this step")
        elif self.apart < APART:
            faults.append(f"{self.id}: '{self.mistakes[0].by}' is {self.apart:.3g} times as far off as '{self.furthest.by}', which is right; "
                          f"not {APART} times")

    def row(self):
        right = self.furthest.cell() if self.furthest else "0 | 0 | all are the same"
        apart = figure(self.apart) if math.isfinite(self.apart) else ""
        best = max(one.mark for one in self.mistakes)
        return f"| {self.id} | {right} | {self.mistakes[0].cell()} | {apart} | {best:.2g} |\n"

    def lines(self):
        return "".join(f"{self.id} {side} mark {one.mark:.3f}, {figure(one.times)} times the limit in {one.at}: {one.by}\n"
                       for side, all_of in (("right  ", self.rights), ("mistake", self.mistakes)) for one in all_of)


def renderer_spreads(labs):
    """What renderers differ by, by step: right answers too."""
    cases = {(lab["number"], case["name"]): case for lab in labs for case in lab["case"]}
    spreads = {}
    for row in read_renderers(ROOT / "docs/renderers.json")["cases"]:
        if case := cases.get((row["lab"], row["case"])):
            far = Far("renderers", row["case"], most_of(row) / case["limit"], most_of(row), case["limit"], row["unit"])
            spreads.setdefault(case["step"], []).append(far)
    return spreads


def judged_solutions(given):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "marks.json"
        texel("cases", "marks", "--out", file, "--seeds", given.seeds, *labs_option(given.labs), *(["--places"] if given.places else []),
              *(["--cache", given.cache] if given.cache else []))
        return json.loads(file.read_text(encoding="utf-8"))


def main():
    parser = argparse.ArgumentParser(prog="texel marks", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("labs", metavar="LAB", nargs="*", type=int, help="numbers of labs [all]")
    parser.add_argument("--seeds", type=int, default=3, choices=range(1, 1001), metavar="N", help="with so many seeds of the hidden cases [3]")
    parser.add_argument("--places", action="store_true", help="only check that no place of a step may stay as in the starter")
    parser.add_argument("--list", action="store_true", help="print each solution")
    parser.add_argument("--markdown", type=pathlib.Path, help="write the table, as in docs/marks.md")
    parser.add_argument("--cache", help="folder for starter, references and programs [build/grade]")
    given = parser.parse_intermixed_args()
    labs, faults = read_labs(given.labs), []
    spreads, solutions = renderer_spreads(labs), judged_solutions(given)
    steps = [Step(step, [one for one in solutions if one["step"] == step["id"]], spreads.get(step["id"], []), faults)
             for lab in labs for step in lab["step"]]
    table = HEAD + "".join(step.row() for step in steps if step.mistakes)
    if given.list:
        print("".join(step.lines() for step in steps), end="")
    if given.markdown:
        write(given.markdown, table)
    elif not given.list:
        print(table)
    print("".join(f"{fault}\n" for fault in faults), end="")
    return 1 if faults else 0


if __name__ == "__main__":
    run("texel marks", main)
