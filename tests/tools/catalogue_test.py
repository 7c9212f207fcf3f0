#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The course's catalogues of mutants, of mistakes, and of right solutions written another way."""
import pathlib
import unittest

import tree


def title_of(says):
    """What the sentence begins with, up to a colon or a full stop, as material::title_of has it."""
    end = min([says.find(mark) for mark in (": ", ". ") if mark in says], default=len(says))
    return says[:end].removesuffix(".") if end == len(says) else says[:end]


WRONG = tree.catalogue("mutants", "mutant") + tree.catalogue("mistakes", "mutant")
RIGHT = [one for folder in ("mutants", "mistakes", "equivalents") for one in tree.catalogue(folder, "equivalent")]
MISTAKES = [one for one in WRONG if one["step"]]  # which a student can make


class Catalogue(unittest.TestCase):
    def test_applies_to_the_files_as_they_are_where_the_step_is(self):
        for one in WRONG + RIGHT:
            with self.subTest(f"{one['place']}: {one['name']}"):
                text = pathlib.Path(one["file"]).read_text(encoding="utf-8")
                self.assertEqual(text.count(one["what"]), 1)
                if one["step"]:
                    self.assertIn(f"@step {one['step']} begin", text)

    def test_has_enough_for_each_lab(self):
        for lab in tree.labs():
            for folder, kind, least in (("mutants", "mutant", 6), ("equivalents", "equivalent", 4)):
                self.assertGreaterEqual(sum(pathlib.Path(one["place"]).stem == lab["folder"] for one in tree.catalogue(folder, kind)), least)
        self.assertGreaterEqual(len(tree.catalogue("mutants", "mutant")), 110)
        # `texel marks` holds that these are told apart by their pictures.
        self.assertGreaterEqual(sum("same" not in one for one in MISTAKES), 200)

    def test_has_a_title_for_each_mistake_that_is_a_sentence_of_its_own(self):
        titles = [(one["step"], title_of(one["says"])) for one in MISTAKES if "same" not in one]
        self.assertEqual(len(titles), len(set(titles)))
        for one in MISTAKES:
            with self.subTest(f"{one['place']}: {one['name']}"):
                title = title_of(one["says"])
                self.assertGreaterEqual(title.count(" "), 2, "a sentence has some words")
                self.assertLessEqual(len(title), 120)
                self.assertNotRegex(title, "^(Use|Take|Subtract|Multiply|Divide|Set|Do not|Invert|Draw) ", "says what is wrong, not what to do")

    def test_says_one_sentence_of_each(self):
        sentences = [(one["step"], one["says"]) for one in WRONG]
        self.assertEqual([one for one in sentences if sentences.count(one) > 1], [])
        for one in WRONG:
            with self.subTest(f"{one['place']}: {one['name']}"):
                self.assertTrue(one["says"].endswith("."))
                self.assertNotIn("\n", one["says"])
                self.assertLessEqual(len(one["says"]), 160)


if __name__ == "__main__":
    unittest.main()
