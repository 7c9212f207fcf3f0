#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""`texel marks`: each mistake loses marks, each right answer has them all.

marks_test.py TEXEL [CLASS ..]"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "teach/commands"))
os.environ["TEXEL"] = sys.argv.pop(1)
from course import BIN, read_labs  # noqa: E402
from marks import Far, Step  # noqa: E402

import tree  # noqa: E402


def marks(*arguments):
    return subprocess.run([BIN / "texel", "marks", *arguments, "--cache", BIN.parent / "grade"], capture_output=True, text=True, check=False)


def solution(name, is_right, *errors, called=""):
    """One with these errors in two cases with the limits 1 and 10, for each seed; None where nothing can be compared."""
    seeds = []
    for seed in errors:
        cases = [{"case": f"case_{limit}", "passed": error is not None and error <= limit, "error": error, "limit": limit, "unit": "degrees"}
                 for error, limit in zip(seed, (1, 10))]
        seeds.append({"passed": all(case["passed"] for case in cases), "score": 1 if seed[0] == 0 else 0.5, "cases": cases})
    return {"step": "5.1", "name": name, "is_right": is_right, "called": called, "is_called": "" if is_right else name, "seeds": seeds}


class Judging(unittest.TestCase):
    """Of made-up errors."""

    @staticmethod
    def step(*solutions, spread=0.0):
        faults = []
        return Step({"id": "5.1"}, list(solutions), [Far("renderers", "case_1", spread, spread, 1, "degrees")], faults), faults

    def test_takes_the_seed_by_which_a_solution_is_most_like_the_other_side(self):
        step, faults = self.step(solution("late", True, (0, 2), (0.1, 5)), solution("flipped", False, (6, 2), (4, 90), called="flipped"))
        self.assertEqual(faults, [])
        self.assertEqual((step.rights[0].by, step.rights[0].times, step.rights[0].mark), ("late", 0.5, 0.5))
        self.assertEqual((step.mistakes[0].times, step.mistakes[0].at), (6, "case_1"))
        self.assertEqual(step.row(), "| 5.1 | 5 degrees of 10 | 0.5 | late | 6 degrees of 1 | 6 | flipped | 12 | 0.5 |\n")

    def test_sorts_both_sides_and_has_nothing_beside_what_is_the_same(self):
        step, faults = self.step(solution("same", True, (0, 0)), solution("b", False, (9, 0), called="b"),
                                 solution("a", False, (4, None), called="a"), solution("c", False, (4, 0), called="c"))
        self.assertEqual([one.by for one in step.mistakes], ["c", "b", "a"])
        self.assertEqual(step.row(), "| 5.1 | 0 | 0 | all are the same | 4 degrees of 1 | 4 | c |  | 0.5 |\n")
        self.assertEqual(faults, [])
        self.assertIn("5.1 mistake mark 0.500, nothing to compare times the limit in case_10: a\n", step.lines())

    def test_blames_what_is_not_so(self):
        for solutions, says in (([solution("m", False, (2, 0), (0.5, 0), called="m")],
                                 ["5.1: 'm' passes with seed 2: 0.5 degrees off in case_1, 0.5 times the limit"]),
                                ([solution("r", True, (2, 0)), solution("m", False, (9, 0), called="m")],
                                 ["5.1: 'r' fails with seed 1: 2 degrees off in case_1, 2 times the limit"]),
                                ([solution("m", False, (2, 0), called="n")], ["5.1: 'm' is called 'n'"]),
                                ([solution("r", True, (0.5, 0))], ["5.1: the catalogue has no mistake of this step"])):
            self.assertEqual([fault for fault in self.step(*solutions)[1] if "as far off" not in fault], says)
        mistake = solution("m", False, (2.9, 0), called="m")
        self.assertEqual(self.step(mistake, spread=1.0)[1], ["5.1: 'm' is 2.9 times as far off as 'renderers', which is right; not 3 times"])
        self.assertEqual(self.step(mistake, spread=0.9)[1], [])


class Marks(unittest.TestCase):
    def test_are_lost_with_any_place_of_a_step_left_as_the_starter_has_it(self):
        """Of lab 7, which is C++, and on a build server of all."""
        labs = [] if tree.EXHAUSTIVE else ["7"]
        ran, places = marks(*labs, "--places", "--seeds", "2", "--list"), {}
        self.assertEqual(ran.returncode, 0, ran.stdout + ran.stderr)
        for file in sorted(file for folder in ("common", "labs", "shaders") for file in (ROOT / folder).rglob("*") if file.suffix in
                           (".cpp", ".hpp", ".glsl", ".vert", ".frag")):
            for step in re.findall(r"^\s*//@step (\S+) begin", file.read_text(encoding="utf-8"), re.MULTILINE):
                if labs and step[0] not in labs:
                    continue
                places[step] = places.get(step, 0) + 1
                self.assertIn(f"place-{places[step]}-of-{step}-as-in-the-starter", ran.stdout)
        self.assertGreaterEqual(len(places), 4)
        self.assertEqual(places.get("9.3", 2), 2)

    def test_depend_on_no_way_that_the_seed_chooses_and_a_step_must_write(self):
        """The seed moves cameras and values and chooses pictures. What a student writes for each value of a choice has cases of its own: else
        the seed would decide whether a mistake is looked for."""
        pictures = {"texture", "texture0", "texture1", "model", "normal_map", "cube_map"}
        # Given in the lab's code; the step is the same for all of their values.
        given = {"2.1 method", "6.3 method", "7.3 precision", "8.2 normal_method", "9.4 incident"}
        hidden = [(case, parameter, values) for lab in read_labs() for case in lab["case"]
                  for parameter, values in case.get("hidden", {}).items()]
        self.assertGreater(len(hidden), 20)
        for case, parameter, values in hidden:
            are_numbers = all(re.fullmatch(r"-?[\d.]+", str(value)) for value in values)
            self.assertTrue(are_numbers or parameter in pictures or f"{case['step']} {parameter}" in given, (case["name"], parameter))


class OfLab(unittest.TestCase):
    """Lab 9 on a build server; the others, whose mistakes in C++ take minutes to compile, with ./run test --all."""


def of_lab(number):
    @unittest.skipUnless(tree.HOURS or tree.EXHAUSTIVE and number == 9, "./run test --all")
    def test(self):
        ran = marks(str(number), "--seeds", "2")
        self.assertEqual(ran.returncode, 0, ran.stdout + ran.stderr)
    return test


class Unforeseen(unittest.TestCase):
    """tests/unforeseen: wrong solutions that were written before the catalogue was read for them, and that it does not hold."""

    @unittest.skipUnless(tree.HOURS, "./run test --all")
    def test_lose_marks_and_have_the_sentences_that_were_read_and_found_true(self):
        folder = ROOT / "tests/unforeseen"
        wrong = [one for file in sorted(folder.glob("*.toml")) for one in tomllib.loads(file.read_text(encoding="utf-8"))["mutant"]]
        with tempfile.TemporaryDirectory() as scratch:
            file = pathlib.Path(scratch) / "marks.json"
            subprocess.run([BIN / "texel", "cases", "marks", "--catalogue", folder, "--seeds", "1", "--out", file,
                            "--cache", BIN.parent / "grade"], check=True)
            judged = {one["name"]: one for one in json.loads(file.read_text(encoding="utf-8"))}
        self.assertGreaterEqual(len(wrong), 120)
        lost = [one for one in wrong if not judged[one["name"]]["seeds"][0]["passed"]]
        self.assertGreaterEqual(len(lost), 0.95 * len(wrong))
        self.assertGreaterEqual(sum(one["says"] != "Nothing." for one in lost), 0.8 * len(wrong))
        for one in wrong:
            says = list(judged[one["name"]]["says"].values())
            self.assertEqual(says[0].split(": so it is at")[0] if says else "Nothing.", one["says"], one["name"])

    @unittest.skipUnless(tree.HOURS, "./run test --all")
    def test_are_refused_where_they_do_not_compile(self):
        # The solution's program would be drawn in its place, and count as right.
        with tempfile.TemporaryDirectory() as scratch:
            (pathlib.Path(scratch) / "03.toml").write_text(
                '[[mutant]]\nname = "no-such-word"\nstep = "3.2"\nsays = "No."\nfile = "labs/03_obj_texcoords/face_index.cpp"\n'
                'what = "count + written"\nby = "count + writen"\n', encoding="utf-8")
            ran = subprocess.run([BIN / "texel", "cases", "marks", "--catalogue", scratch, "--seeds", "1", "--out", f"{scratch}/marks.json",
                                  "--cache", BIN.parent / "grade"], capture_output=True, text=True, check=False)
        self.assertEqual(ran.returncode, 3)
        self.assertIn("'no-such-word' does not compile", ran.stderr)


for lab in read_labs():
    setattr(OfLab, f"test_{lab['number']}", of_lab(lab["number"]))

if __name__ == "__main__":
    unittest.main()
