#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the readers of a report's files find in those of the demo class: formats_test.py PROGRAM, which writes them."""
import csv
import html.parser
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
from xml.etree import ElementTree

MARKED = ["index", "ada-half", "ben-nothing", "cleo-broken", "script-1a2b3c4d", "wolfeschlegelsteinhausenbergerdorff", "emil-bomb"]
STUDENTS = [*MARKED, "dora-incident"]  # to whom the grader gives no mark
NUMBER = (int, float)
HARM = "document.title='harmed'"

# Fields with their type or their values; a "?" before the name: not always there. Of Gradescope "Autograder Specifications",
# https://gradescope-autograders.readthedocs.io/en/latest/specs/
FORMATS = ["text", "html", "simple_format", "md", "ansi"]
GRADESCOPE = {"score": NUMBER, "output": str, "output_format": FORMATS, "visibility": ["visible"], "tests": list}
GRADESCOPE_TEST = {"score": NUMBER, "max_score": NUMBER, "status": ["passed", "failed"], "name": str, "number": str, "output": str,
                   "output_format": FORMATS, "visibility": ["visible", "hidden"], "tags": list}
# "Grading results", https://docs.prairielearn.com/externalGrading/: the score is 0 to 1, and there where it is gradable.
PRAIRIELEARN = {"gradable": [True], "score": NUMBER, "message": str, "output": str, "images": list, "tests": list}
NOT_GRADABLE = {"gradable": [False], "message": str, "format_errors": list}
PRAIRIELEARN_TEST = {"name": str, "points": NUMBER, "max_points": NUMBER, "message": str, "output": str, "?images": list}
IMAGE = {"label": str, "url": str}
# Elements: attributes that each has, that it may have, and children. What Jenkins (junit-10.xsd of its xUnit plugin,
# https://github.com/jenkinsci/xunit-plugin) and GitLab (https://docs.gitlab.com/ci/testing/unit_test_reports/) both read.
JUNIT = {
    "testsuites": ("", "name tests failures errors skipped", "testsuite"),
    "testsuite": ("name tests failures errors", "skipped", "testcase system-out system-err"),
    "testcase": ("name classname", "", "failure error skipped system-out system-err"),
    "failure": ("message", "type", ""),
    "error": ("message", "type", ""),
    "system-out": ("", "", ""),
    "system-err": ("", "", ""),
}


class Page(html.parser.HTMLParser):
    """The attributes of a page's elements, and the texts of its scripts."""

    def __init__(self, text):
        super().__init__()
        self.attributes, self.scripts, self.inside = [], [], ""
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.attributes += attrs
        self.inside = tag
        if tag == "script":
            self.scripts.append("")

    def handle_endtag(self, tag):
        self.inside = ""

    def handle_data(self, data):
        if self.inside == "script":
            self.scripts[-1] += data


class Formats(unittest.TestCase):
    maxDiff = None

    def read(self, path):
        return (FOLDER / path).read_text(encoding="utf-8")  # strictly

    def check_fields(self, value, fields):
        self.assertLessEqual(set(value), {name.removeprefix("?") for name in fields})
        for name, kind in fields.items():
            if name.removeprefix("?") not in value:
                self.assertTrue(name.startswith("?"), f"no {name}")
            elif isinstance(kind, list):
                self.assertIn(value[name], kind)
            else:
                self.assertIsInstance(value[name.removeprefix("?")], kind, name)

    def test_gradescope_has_its_fields(self):
        for student in MARKED:
            results = json.loads(self.read(f"gradescope/{student}/results.json"))
            self.check_fields(results, GRADESCOPE)
            for test in results["tests"]:
                self.check_fields(test, GRADESCOPE_TEST)
                self.assertLessEqual(test["score"], test["max_score"])
                # Other hidden tests would hide the student's total.
                self.assertTrue(test["visibility"] == "visible" or test["max_score"] == 0)
        self.assertFalse((FOLDER / "gradescope/dora-incident").exists())

    def test_gradescope_has_a_test_a_step_and_hidden_ones_for_teachers(self):
        results = json.loads(self.read("gradescope/ada-half/results.json"))
        tests, visible = results["tests"], [test for test in results["tests"] if test["visibility"] == "visible"]
        self.assertEqual([test["number"] for test in visible], ["3.1", "5.1", "5.2", "5.3", "9.1"])
        self.assertEqual([test["status"] for test in visible], ["passed", "passed", "failed", "failed", "failed"])
        self.assertEqual((results["score"], sum(test["score"] for test in tests), sum(test["max_score"] for test in tests)), (6, 6, 12))
        self.assertEqual(len(tests), 10)
        for test in tests:
            self.assertEqual("unseen_" in test["output"], test not in visible)
        self.assertEqual(visible[2]["tags"], ["failed", "normal-green-flipped"])
        for said in ("This looks like: Green is inverted", "shaders/05_normal_map/tangent_frame.glsl:42", "1 of 1 hidden case failed."):
            self.assertIn(said, visible[2]["output"])

    def test_prairielearn_has_its_fields(self):
        for student in STUDENTS:
            results = json.loads(self.read(f"prairielearn/{student}/results.json"))
            if student in ("dora-incident", "emil-bomb"):
                self.check_fields(results, NOT_GRADABLE)
                continue
            self.check_fields(results, PRAIRIELEARN)
            self.assertTrue(0 <= results["score"] <= 1)
            for test in results["tests"]:
                self.check_fields(test, PRAIRIELEARN_TEST)
                self.assertLessEqual(test["points"], test["max_points"])
                for image in test.get("images", []):
                    self.check_fields(image, IMAGE)
                    self.assertTrue(image["url"].startswith("data:image/png;base64,"))

    def test_prairielearn_has_a_score_of_0_to_1_and_pictures_of_failed_cases(self):
        results = json.loads(self.read("prairielearn/ada-half/results.json"))
        self.assertEqual(results["score"], 0.5)
        self.assertNotIn("images", results["tests"][0])  # 3.1 passed
        # Of 5.2: a public case's two, and a hidden one's own.
        self.assertEqual([image["label"] for image in results["tests"][2]["images"]],
                         ["turned_normal, yours", "turned_normal, expected", "unseen_normal, yours"])
        self.assertEqual(json.loads(self.read("prairielearn/index/results.json"))["score"], 1)

    def test_junit_has_known_elements_and_counts_them(self):
        for student in STUDENTS:
            root = ElementTree.fromstring(self.read(f"junit/{student}.xml"))
            self.assertEqual(root.tag, "testsuites")
            for element in root.iter():
                required, optional, children = (words.split() for words in JUNIT[element.tag])
                self.assertLessEqual(set(required), set(element.attrib))
                self.assertLessEqual(set(element.attrib), {*required, *optional})
                self.assertLessEqual({child.tag for child in element}, set(children))
            for suite in root:
                for counted, tag in (("tests", "testcase"), ("failures", "failure"), ("errors", "error"), ("skipped", "skipped")):
                    self.assertEqual(int(suite.get(counted)), len(list(suite.iter(tag))), f"{student}: {counted}")
                names = [(test.get("classname"), test.get("name")) for test in suite.iter("testcase")]
                self.assertEqual(len(names), len(set(names)))  # GitLab takes only the first of two tests of one name
            for counted in ("tests", "failures", "errors"):
                self.assertEqual(int(root.get(counted)), sum(int(suite.get(counted)) for suite in root))
        for student, counted, count in (("ben-nothing", "tests", 15), ("ben-nothing", "failures", 15), ("dora-incident", "errors", 1),
                                        ("emil-bomb", "failures", 1)):
            self.assertEqual(int(ElementTree.fromstring(self.read(f"junit/{student}.xml")).get(counted)), count)

    def test_junit_attaches_pictures_and_nothing_that_a_student_names(self):
        for student in STUDENTS:
            attached = re.findall(r"\[\[ATTACHMENT\|(.*)", self.read(f"junit/{student}.xml"))
            for path in attached:
                self.assertTrue(path.startswith(f"{FOLDER}/pictures/"), path)
            self.assertEqual(f"{FOLDER}/pictures/wrong.png]]" in attached, student not in ("index", "emil-bomb"))

    def test_csv_has_a_row_a_student_and_a_column_a_step(self):
        text = (FOLDER / "class.csv").read_bytes().decode()
        self.assertEqual(text.count("\n"), text.count("\r\n"))
        rows = list(csv.reader(text.splitlines(keepends=True), strict=True))
        self.assertEqual(rows[0], "name,id,number,total,lab 3,lab 5,lab 9,step 3.1,step 5.1,step 5.2,step 5.3,step 9.1,begun,note".split(","))
        self.assertEqual(rows[1], ["Index Page", "index", "10231", "12", "2", "7", "3", "2", "2", "4", "1", "3", "3 5 9", ""])
        self.assertEqual({len(row) for row in rows}, {len(rows[0])})
        self.assertEqual([row[3] for row in rows[1:]], ["12", "6", "0", "4.5", "3", "8", "", "0"])
        self.assertEqual(rows[7][4:13], [""] * 9)  # an incident is no zero
        self.assertIn("not graded", rows[7][-1])
        self.assertEqual(rows[5][2], "'=HYPERLINK(\"http://x\")")

    def test_pages_let_nothing_of_a_student_be_more_than_text(self):
        names = {file.name for file in (FOLDER / "report").iterdir()}
        self.assertEqual(names, {"index.html", *(f"{student}.html" for student in STUDENTS[1:]), "index.student.html"})
        for name in names:
            text = self.read(f"report/{name}")
            page = Page(text)
            self.assertEqual(len(page.scripts), 2)
            self.assertEqual(len(re.findall("</?script|<!--", text)), 4)
            self.assertNotIn("\\u001b", page.scripts[0])
            data = json.loads(page.scripts[0])
            self.assertEqual(HARM in json.dumps(data), name in ("index.html", "script-1a2b3c4d.html"))
            policy = ""
            for attribute, value in page.attributes:
                self.assertFalse(attribute.startswith("on") or attribute == "style")
                if attribute in ("src", "href"):
                    self.assertTrue(value.startswith("data:"))
                if attribute == "content" and value.startswith("default-src"):
                    policy = value
            # Only the page's own style and script may be used.
            self.assertRegex(policy, r"^default-src 'none'; img-src data:; style-src 'sha256-[^ ]+'; script-src 'sha256-[^ ]+'; base-uri")


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        FOLDER = pathlib.Path(folder)
        subprocess.run([sys.argv[1], folder], check=True)
        unittest.main(argv=sys.argv[:1])
