#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Holds the course to what it promises of its starter, lab by lab, hidden cases included: as it is it fails every step; with the first
k steps solved it passes those k and no other; with all it passes all. Called by texel starter --verify."""
import argparse
import csv
import pathlib
import shutil
import sys
import tempfile

sys.dont_write_bytecode = True
from course import BIN, Failure, captured, read_labs, run  # noqa: E402


def hand_in(folder, solved):
    """What a student hands in who has solved these steps and no others."""
    with tempfile.TemporaryDirectory(dir=folder.parent) as work:
        tree = pathlib.Path(work) / "starter"
        made = captured(BIN / "texel", "starter", "--out", tree, *(["--solve", ",".join(solved)] if solved else []))
        if made.returncode != 0:
            raise Failure(f"texel starter failed: {made.stdout}")
        for part in ("labs", "shaders"):
            shutil.move(tree / part, folder / part)


def faults_of(lab, solved_elsewhere, work, options):
    """What is not as it should be, a line each. Steps that the lab needs of others are solved."""
    steps = {step["id"]: step.get("points", 1) for step in lab["step"]}
    for k in range(len(steps) + 1):
        (work / "class" / f"stage-{k:02}").mkdir(parents=True)
        hand_in(work / "class" / f"stage-{k:02}", solved_elsewhere + list(steps)[:k])
    # What is graded is the course's own: it needs no sandbox.
    print(f"lab {lab['number']}", file=sys.stderr)
    graded = captured(BIN / "texel", "grade", work / "class", "--out", work / "out", "--labs", lab["number"], "--unsafe", "--format", "csv",
                      *options, errors=None)
    if graded.returncode != 0:
        raise Failure("texel grade failed; see its message above")
    with open(work / "out/class.csv", encoding="utf-8", newline="") as file:
        passed = [[step for step, points in steps.items() if float(row[f"step {step}"]) == points] for row in csv.DictReader(file)]
    return [f"lab {lab['number']} with {k} of {len(steps)} steps solved passes [{' '.join(found)}], not [{' '.join(list(steps)[:k])}]"
            for k, found in enumerate(passed) if found != list(steps)[:k]]


def main():
    parser = argparse.ArgumentParser(prog="texel starter --verify", description=__doc__)
    parser.add_argument("labs", metavar="LAB", nargs="*", type=int, help="numbers of labs [all]")
    parser.add_argument("--cache", help="folder for what is made on the way [build/grade]")
    given = parser.parse_args()
    faults = []
    for lab in read_labs(given.labs):
        elsewhere = [step["id"] for other in read_labs() for step in other["step"] if other["number"] != lab["number"]]
        with tempfile.TemporaryDirectory() as work:
            faults += faults_of(lab, elsewhere, pathlib.Path(work), ["--cache", given.cache] if given.cache else [])
    print("\n".join(faults) or "the starter fails every step; with the first k steps solved, exactly those pass; all pass in the end")
    return 1 if faults else 0


if __name__ == "__main__":
    run("texel starter --verify", main)
