#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What a handout says of its steps, and whether lab.toml says the same."""
import pathlib
import re
import unittest

import tree

LABS = tree.labs()


def handout_of(lab):
    return pathlib.Path("labs", lab["folder"], "README.md").read_text(encoding="utf-8")


def limits_in(text):
    """What a handout says with "within 3/255" or "within 0.05 degrees", as lab.toml has its limits."""
    return {float(number) for number in re.findall(r"within\s+(\d+(?:\.\d+)?(?:e-?\d+)?)", text)}


def has_option(case, name, value):
    """Whether a case has that option of the lab's program, by its settings or as one of the values that are drawn."""
    name = name.replace("-", "_")
    if name == "view":
        return case.get("view", "color") == value
    drawn = case.get("hidden", {}).get(name, [])
    words = drawn if any(isinstance(one, str) for one in drawn) else []
    return tree.as_text(case.get("set", {}).get(name)) == value or value in words


def steps():
    """Each lab with each of its steps, and the handout's section of it."""
    for lab in LABS:
        text = handout_of(lab)
        for step in lab["step"]:
            yield lab, step, tree.section(text, f"### {step['id']} {step['title']}\n")


def is_hidden(case):
    return "hidden" in case or any(str(value).startswith("unseen:") for value in case.get("set", {}).values())


class Handouts(unittest.TestCase):
    def test_show_each_step_before_and_after_with_the_command_to_see_it(self):
        for lab, step, section in steps():
            with self.subTest(step["id"]):
                self.assertTrue(section, "has no heading as in lab.toml")
                self.assertRegex(section, r"^### [^\n]*\n!\[Before: [^\n]*\. After: [^\n]*\.\]\(../../docs/pictures/steps/"
                                 + re.escape(step["id"]) + r"\.png\)\n")
                view = step.get("view", "color")
                command = f"./run lab {lab['number']}{tree.flags(step.get('set', {}))}{'' if view == 'color' else f' --view {view}'}"
                self.assertEqual(re.search(r"- \*\*See it:\*\*\s+`([^`]*)`", section)[1], command)
        # ./run docs draws what is missing; remove what no step has.
        self.assertEqual({file.name for file in pathlib.Path("docs/pictures/steps").iterdir()}, {f"{step['id']}.png" for _, step, _ in steps()})

    def test_have_hints_of_cases_that_exist(self):
        for lab in LABS:
            for step in lab["step"]:
                names = [case["name"] for case in lab["case"] if case["step"] == step["id"]]
                for begin in step.get("hint_of", {}):
                    self.assertTrue(any(name.startswith(begin) for name in names), f"{step['id']}: no case begins with {begin}")

    def test_have_no_case_that_hangs_on_lab_3(self):
        # An OBJ file is read by the student's own steps of lab 3; all other labs read meshes (PLY).
        for lab in LABS:
            for case in lab["case"] if lab["number"] != 3 else ():
                values = [case.get("set", {}).get("model", ""), *case.get("hidden", {}).get("model", ())]
                with self.subTest(f"{lab['folder']}: {case['name']}"):
                    self.assertEqual([value for value in values if re.search(r"\.obj$|^unseen:.*(?<!\.ply)$", value)], [])

    def test_have_the_cases_and_limits_of_the_check(self):
        for lab, step, section in steps():
            with self.subTest(step["id"]):
                self.assertNotRegex(section, r"not\s+checked", "is a case of it")
                checked = re.search(r"- \*\*Checked by:\*\*.*?(?=\n- \*\*|\Z)", section, re.DOTALL)[0]
                public, _, hidden = checked.partition("Hidden:")
                cases = [one for one in lab["case"] if one["step"] == step["id"]]
                self.assertLessEqual(limits_in(section), {one["limit"] for one in cases}, "is no limit")
                for case in cases:
                    # Vertex streams have one limit, which the handout explains where they come first.
                    if case.get("view") != "mesh":
                        self.assertIn(case["limit"], limits_in(public) | (limits_in(hidden) if is_hidden(case) else set()), "is not said")
                for is_of_hidden, part in ((False, public), (True, hidden)):
                    for name, value in re.findall(r"--([a-z0-9-]+)\s+([a-z0-9.-]+)`", part):
                        self.assertTrue(any(is_hidden(case) == is_of_hidden and has_option(case, name, value) for case in cases),
                                        f"--{name} {value} is in no case")

    def test_ask_before_a_step_and_tell_after_it(self):
        # The form that window, browser and terminal read: a question with three choices, and an answer to each.
        question = re.compile(r"\n\n\*\*Predict:\*\* .*?\n1\. (.*?)\n\n<details><summary>Answers</summary>\n\n1\. (.*?)\n\n</details>\n\n- \*\*Where", re.DOTALL)
        for lab, step, section in steps():
            with self.subTest(step["id"]):
                choices, answers = (re.split(r"\n\d\. ", part) for part in question.search(section).groups())
                self.assertEqual(len(choices), 3)
                self.assertEqual(sorted(answer.split()[0] for answer in answers), ["No:", "No:", "Right:"])
                self.assertRegex(section, r"\*\*Where:\*\*[^*]*\d points?, (easy|medium|hard)[,.]")
                after = re.search(r"\n\n<details><summary>After it passes</summary>\n\n(.*)\n\n</details>\n*$", section, re.DOTALL)
                self.assertTrue(after, "says nothing after it")
                self.assertIn(f"`./run lab {lab['number']}", after[1].replace("\n", " "), "has no look to try")
        for lab in LABS:
            text = handout_of(lab)
            for heading in ("Steps", "Things to try (nice)", "Challenge (nice, no points)", "Questions (nice)", "Background (deep)"):
                self.assertIn(f"\n## {heading}\n", text, lab["folder"])
            asked, answers = (re.findall(r"^\d\. ", part, re.MULTILINE) for part in
                              tree.section(text, "## Questions (nice)\n").split("<details><summary>Answers</summary>"))
            self.assertEqual(asked, answers, lab["folder"])
            self.assertNotRegex(text, r"[Yy]our teacher has|course's\s+own\s+tree", "is no student's to type")

    def test_begin_with_the_picture_and_the_first_step_within_one_screen(self):
        for lab in LABS:
            head = handout_of(lab).partition("\n### ")[0]
            self.assertLessEqual(head.count("\n"), 24, lab["folder"])
            self.assertLess(head.index("!["), head.index("You learn"), lab["folder"])

    def test_link_every_source_to_what_it_is(self):
        self.assertIn("\n## The sources\n", pathlib.Path("docs/student.md").read_text(encoding="utf-8"))
        for lab in LABS:
            text = handout_of(lab)
            prose = re.sub(r"```[^`]*```|`[^`]*`|(^|\n)#[^\n]*", "", text)
            self.assertNotRegex(prose, r"(^|[^\[])\b(Report|Worksheet|Slides|[Tt]he (report|worksheet|slides))\b", lab["folder"])
            for source in ("Report", "Worksheet", "Slides"):
                is_linked = f"\n[{source}]: ../../docs/student.md#the-sources\n" in text
                self.assertEqual(f"[{source}]" in prose, is_linked, f"{lab['folder']}: {source}")


if __name__ == "__main__":
    unittest.main()
