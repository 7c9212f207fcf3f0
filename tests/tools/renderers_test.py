#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""`texel renderers`: each limit is three times what docs/renderers.json says, and that is whole."""
import math
import pathlib
import re
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "teach/commands"))
from course import Failure, read_labs  # noqa: E402
from renderers import RENDERERS, faults_of, filter_rows, test_rows, version_of  # noqa: E402
from renderers_table import group_of, limits_of, read_renderers, renderers_markdown, room_of, to_json  # noqa: E402

KEPT = read_renderers(ROOT / "docs/renderers.json")
LABS = read_labs()
VERSIONS = ("mesa22", "mesa25", "mesa26")


def arguments_of(text, begin):
    """The arguments of a macro whose parenthesis opens before `begin`, with single blanks."""
    arguments, depth = [""], 1
    for letter in text[begin:]:
        depth += (letter in "({[") - (letter in ")}]")
        if depth == 0:
            return [" ".join(argument.split()) for argument in arguments]
        if letter == "," and depth == 1:
            arguments.append("")
        else:
            arguments[-1] += letter
    raise ValueError(text[begin:begin + 80])


def written_limits():
    """"measured(lab).mean < 0.4" of each EXPECT_BELOW(measured(lab).mean, 0.4) in the tests that draw, and of its like; the limits of
    figures/some_labs.py; and the lines of the tables that figures/check.py holds to a limit."""
    written = set(re.findall(r'is_below\(.*, "(.*?)", ', (ROOT / "tests/figures/some_labs.py").read_text(encoding="utf-8")))
    for file in [*ROOT.glob("tests/labs/*"), *ROOT.glob("tests/gl/*")]:
        text = file.read_text(encoding="utf-8")
        for macro in re.finditer(r"(?:EXPECT|ASSERT)_(BELOW|ABOVE|WITHIN)\(", text):
            value, first, *second = arguments_of(text, macro.end())
            written.add(f"{value} within {second[0]} of {first}" if second else f"{value} {'<' if macro[1] == 'BELOW' else '>'} {first}")
    for file in ROOT.glob("tests/figures/*.toml"):
        text = file.read_text(encoding="utf-8")
        written.update(line[0] for line in re.findall(r'"((?:mean|p99|max)\([^"]* ([<>] (?!0")|[^"]*\+-)[^"]*)"', text))
    return written


class Kept(unittest.TestCase):
    def test_has_a_row_for_each_case_and_no_limit_is_below_three_times_the_spread(self):
        known = {(row["lab"], row["case"]) for row in KEPT["cases"]}
        self.assertEqual(known, set(limits_of(LABS)), "after a change of a case type ./run renderers")
        self.assertEqual(len(KEPT["cases"]), len(limits_of(LABS)))
        self.assertEqual(faults_of(KEPT, LABS), [])

    def test_has_a_row_for_each_limit_of_a_test(self):
        written = written_limits()
        self.assertGreater(len(written), 100)
        self.assertEqual({row["unit"] for row in KEPT["tests"]} ^ written, set(), "after a change of a test's limit type ./run renderers")

    def test_is_of_three_versions_of_mesa(self):
        ways = [one.name for one in RENDERERS if one.context == "egl" and one.name != "hardware_egl"]
        self.assertEqual(len(ways), 11)
        names = {f"{mesa}_{way}" for mesa in VERSIONS for way in ways} | {"mesa22_llvmpipe_osmesa", "mesa22_softpipe_osmesa"}
        self.assertEqual(names - set(KEPT["drawn_by"]), set())
        for row in KEPT["cases"]:  # each case was drawn by them
            self.assertEqual({group_of(name) for name in names} - set(row["by"]), set(), (row["lab"], row["case"]))

    def test_has_a_graphics_card_for_the_cases_that_pages_judge_by_one(self):
        in_shaders = {step for file in ROOT.glob("shaders/*/*") for step in re.findall(r"//@step (\S+) begin", file.read_text(encoding="utf-8"))}
        in_pages = {(lab["number"], case["name"]) for lab in LABS for case in lab["case"] if case["step"] in in_shaders and "hidden" not in case
                    and not any(str(value).startswith("unseen") for value in case.get("set", {}).values())}
        drawn = {(row["lab"], row["case"]) for row in KEPT["cases"] if "hardware, nvidia580" in row["by"]}
        self.assertEqual(drawn - in_pages, set())
        # So many were changed since the card drew: one is to draw them again.
        self.assertLessEqual(len(in_pages - drawn), 14)

    def test_has_its_document(self):
        text = (ROOT / "docs/accuracy/renderers.md").read_text(encoding="utf-8")
        self.assertEqual(text, renderers_markdown(KEPT, LABS), "./run renderers --judge-only renews it")

    def test_is_as_it_is_written(self):
        self.assertEqual(to_json(KEPT), (ROOT / "docs/renderers.json").read_text(encoding="utf-8"))


class Report(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_is_kept_with_what_was_infinitely_far(self):
        report = {"drawn_by": {"mesa22_softpipe_egl": "softpipe, Mesa 22.3.6"},
                  "cases": [{"lab": 1, "case": "a", "unit": "steps", "by": {"softpipe, mesa22": 2.5, "zink, mesa22": math.inf}}],
                  "tests": [{"lab": 0, "case": "Views.depth", "unit": "most < 2", "by": {"zink, mesa22": 0.5}, "least": 0.25}],
                  "filters": [{"lab": 1, "case": "wall", "unit": "rms", "by": {"anisotropic, mesa22": 9.0}}]}
        file = self.folder / "renderers.json"
        file.write_text(to_json(report))
        self.assertEqual(read_renderers(file), report)
        self.assertEqual(room_of(report["tests"][0], 1), 3)
        file.write_text("{}")
        with self.assertRaisesRegex(Failure, "renderers.json"):
            read_renderers(file)

    def test_blames_limits_that_leave_no_room(self):
        labs = [{"number": 1, "case": [{"name": "a", "limit": 6}, {"name": "b", "limit": 6}]}]
        report = {"cases": [{"lab": 1, "case": "a", "unit": "", "by": {"zink, mesa22": 2, "softpipe, mesa22": 2.1}},
                            {"lab": 1, "case": "b", "unit": "", "by": {"zink, mesa22": math.inf}}],
                  "tests": [{"case": "T", "unit": "x < 2", "by": {"zink, mesa22": 0.5}, "least": 0.25},
                            {"case": "T", "unit": "y < 2", "by": {"zink, mesa22": 0.6}, "least": 0.25}]}
        self.assertEqual(faults_of(report, labs), ["lab 1, a: the limit 6 is too small for the difference 2.1 of softpipe, mesa22",
                                                   "lab 1, b: the limit 6 is too small for the difference inf of zink, mesa22",
                                                   "T: y < 2 leaves room for 2.1 times the spread between renderers, not for 3"])

    def test_joins_what_tests_used_of_their_limits(self):
        for renderer, shares in (("mesa22_zink_egl", (0.25, 0.5)), ("mesa22_zink_b", (0.75, 0.125)), ("mesa25_zink_egl", (0.375,))):
            for i, share in enumerate(shares):
                file = self.folder / renderer / f"tolerances/process_{i}"
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(f"T.one\tx < 2\t{share}\n")
        self.assertEqual(test_rows(sorted(self.folder.iterdir())), [{"lab": 0, "case": "T.one", "unit": "x < 2", "least": 0.375,
                                                                     "by": {"zink, mesa22": 0.75, "zink, mesa25": 0.375}}])
        self.assertEqual(filter_rows([self.folder]), [])

    def test_groups_by_driver_and_version(self):
        for name, group in (("mesa22_llvmpipe_sse2", "llvmpipe, mesa22"), ("mesa25_zink_egl", "zink, mesa25"),
                            ("nvidia580_hardware_egl", "hardware, nvidia580")):
            self.assertEqual(group_of(name), group)
        for says, version in (("llvmpipe (LLVM 15.0.6), Mesa 22.3.6", "mesa22"), ("NVIDIA H100, NVIDIA 580.95.05", "nvidia580"),
                              ("Another 1.2", "gpu")):
            self.assertEqual(version_of(says), version)


if __name__ == "__main__":
    unittest.main()
