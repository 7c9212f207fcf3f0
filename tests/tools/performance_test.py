#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""`./run performance`: what it makes of figures, and what it hands in. It measures nothing here.

performance_test.py TEXEL"""
import contextlib
import io
import json
import os
import pathlib
import sqlite3
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "teach/commands"))
os.environ["TEXEL"] = sys.argv.pop(1)
from course import Failure  # noqa: E402
from performance import PARTS  # noqa: E402
from performance_grading import TenthOfStepsWrong, check_grades, mistaken  # noqa: E402
from performance_kernels import target_of  # noqa: E402
from performance_report import Report, Setting, interleaved, output_of, run_process, spread_of  # noqa: E402
from performance_waits import edit  # noqa: E402


class Measuring(unittest.TestCase):
    def test_takes_both_sides_in_turn_after_one_to_warm_up(self):
        calls = []
        pairs = interleaved(3, lambda: calls.append("ours") or len(calls), lambda: calls.append("theirs") or len(calls))
        self.assertEqual(calls, ["theirs", "ours", "ours", "theirs", "theirs", "ours", "ours", "theirs"])
        self.assertEqual(pairs, [(3, 4), (6, 5), (7, 8)])

    def test_has_quarters_between_two_figures(self):
        self.assertEqual(spread_of([4, 1, 2, 3]), {"median": 2.5, "lower": 1.75, "upper": 3.25})
        self.assertEqual(spread_of([7]), {"median": 7, "lower": 7, "upper": 7})

    def test_starts_programs_and_fails_with_them(self):
        milliseconds, mebibytes = run_process("sh", "-c", "test $TEXEL_A = b", variables={"TEXEL_A": "b"})
        self.assertTrue(0 < milliseconds < 60e3 and 0 < mebibytes < 1e3)
        self.assertIn("bench", output_of("texel", "--help"))
        self.assertEqual(output_of("sh", "-c", "echo $TEXEL_A", variables={"TEXEL_A": "b"}), "b\n")
        for command in (("false",), ("sh", "-c", "kill $$"), ("no_such_program",)):
            with self.assertRaisesRegex(Failure, command[0]):
                run_process(*command)
        with self.assertRaisesRegex(Failure, "false"):
            output_of("false")

    def test_has_targets_for_kernels(self):
        for stem, target in (("tangents/heap", 0), ("tangents/fan", 3), ("flip/64x64", 5), ("obj/cube", 1), ("obj/quads_2m", 3)):
            self.assertEqual(target_of(stem), target, stem)


class OfReport(unittest.TestCase):
    def setUp(self):
        self.report, printed = Report(), io.StringIO()
        with contextlib.redirect_stdout(printed):
            self.report.begin("Title", "A text\n   over lines.", "lab", "floor")
            self.report.add("one", "ms", [(2, 4), (3, 4), (4, 4)], at_most=0.75, why="not told")
            self.report.add("two", "MiB", [(21324, 10662)], at_least=0.6, why="told\n  why")
            self.report.add("three", "ms", [(2, 1)], at_most=0, names=("lab", "window"))
            self.report.note("A note.")
            self.report.begin("Empty", "No display.", "a", "b")
        self.report.stages = {"lab 1": {"start": 1.25, "total": 3, "draw": 2}, "lab 5": {"start": 1, "mesh": 4, "total": 5}}
        self.printed = printed.getvalue()

    def test_prints_each_line(self):
        self.assertIn(f"  {'one':<44}     0.75 (0.62 to 0.88)  at most 0.75\n", self.printed)
        self.assertIn(f"  {'two':<44}     0.50 (0.50 to 0.50)  at least 0.6  MISSED\n", self.printed)

    def test_is_markdown(self):
        text = self.report.as_markdown(Setting(pathlib.Path(), 11))
        self.assertIn("in 11 rounds (batches, grading and the first `./run` in 2)", text)
        self.assertIn("""
## Title
A text over lines.

| | lab | floor | ratio | target |
|---|---|---|---|---|
| one | 3 ms | 4 ms | **0.75** (0.625 to 0.875) | at most 0.75 |
| two | 21324 MiB | 10662 MiB | **0.5** (0.5 to 0.5) | at least 0.6, **missed** |
| three | 2 ms | 1 ms | **2** (2 to 2) |  |

**two**: told why

A note.

## Where""", text)
        self.assertIn("""
| stage | lab 1 | lab 5 |
|---|---|---|
| start | 1.2 | 1.0 |
| mesh | 0.0 | 4.0 |
| total | 3.0 | 5.0 |
| draw | 2.0 | 0.0 |
""", text)

    def test_begins_with_what_a_user_gains(self):
        with contextlib.redirect_stdout(io.StringIO()):
            self.report.begin("The first ./run", "", "now", "before")
            self.report.add("a student's", "ms", [(3, 4)])
        self.assertIn("loses**\n- A student's first `./run` takes 0.75 of an earlier commit's.\n\n## Title", self.report.as_markdown(Setting(pathlib.Path(), 1)))

    def test_is_json(self):
        figures = json.loads(self.report.as_json())
        self.assertEqual(list(figures), ["notes", "results", "stages"])
        self.assertEqual([(row["what"], row["target"], row["reached"]) for row in figures["results"]],
                         [("one", "at most 0.75", True), ("two", "at least 0.6", False), ("three", "", True)])
        self.assertEqual(list(figures["results"][2]), ["section", "what", "unit", "lab", "window", "ratio", "target", "reached"])


class Wrong(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.setting = Setting(pathlib.Path(folder.name), 2)

    def test_solutions_have_a_mistake_in_every_tenth_step(self):
        made = TenthOfStepsWrong(self.setting, list(range(1, 10)), 6)
        self.assertEqual(str(made), f"6 students, {-(-6 * len(made.steps) // 10)} mistakes in {6 * len(made.steps)} steps")
        self.assertEqual([(student, mistake["step"]) for student, mistake in made.made[:2]], [(0, made.steps[0]), (0, made.steps[10])])
        for _, mistake in made.made:
            self.assertIn(mistake["by"], mistaken(made.solution.texts, mistake)[mistake["file"]])
        with self.assertRaisesRegex(Failure, "does not apply"):
            mistaken({"a": "x x"}, {"name": "twice", "file": "a", "what": "x", "by": "y"})

    def test_grades_are_of_those_who_made_it(self):
        (self.setting.work / "grades").mkdir()
        right, wrong, alone = ("passed", "together"), ("failed", "together"), ("passed", "alone")
        with contextlib.closing(sqlite3.connect(self.setting.work / "grades/results.sqlite")) as store:
            store.execute("CREATE TABLE cases (student, status, judged)")
            for cases, expected, is_so in (([("a", right), ("b", right)], 0, True), ([("a", right), ("b", alone)], 0, False),
                                           ([("a", right), ("b", wrong), ("b", right)], 1, True), ([("a", right), ("b", right)], 1, False),
                                           ([("a", right), ("b", wrong), ("c", wrong)], 1, False),
                                           ([("a", wrong), ("b", wrong), ("b", alone)], 2, True),
                                           ([("a", wrong), ("b", wrong), ("b", right)], 2, False)):
                store.execute("DELETE FROM cases")
                store.executemany("INSERT INTO cases VALUES (?, ?, ?)", [(student, *case) for student, case in cases])
                store.commit()
                with contextlib.nullcontext() if is_so else self.assertRaises(Failure):
                    check_grades(self.setting, 2, expected)

    def test_files_are_edited_anew(self):
        for name in ("lab.cpp", "a.glsl"):
            file = self.setting.work / name
            file.write_text("first\n")
            edit(file, 1)
            once = file.read_text()
            edit(file, 2)
            self.assertEqual(file.read_text(), once.replace("edited_1", "edited_2"))
            self.assertTrue(once.startswith("first\n"))

    def test_parts_have_their_names(self):
        self.assertEqual(list(PARTS), ["snapshots", "warm", "batch", "grading", "kernels", "peers", "waits", "tests"])


if __name__ == "__main__":
    unittest.main()
