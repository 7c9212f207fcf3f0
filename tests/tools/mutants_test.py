#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""`./run mutants` on a tiny project: one function, with a test that sees one of its two branches."""
import json
import pathlib
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "teach/commands/mutants.py"
PROJECT = "cmake_minimum_required(VERSION 3.25)\nproject(tiny CXX)\nenable_testing()\n"
CLAMP = "int clamped(int x) {\n  if (x < 9) return x;\n  return 9;\n}\nint main() { return clamped(3) != 3; }\n"


def mutant(name, what, by, says, rest="", kind="mutant", file="clamp.cpp"):
    return f'[[{kind}]]\nname = "{name}"\nfile = "{file}"\nwhat = "{what}"\nby = "{by}"\nsays = "{says}"\n{rest}'


WRONG_BRANCH = mutant("wrong-branch", "return x;", "return -x;", "Small numbers stay as they are.")
WRONG_LIMIT = mutant("wrong-limit", "return 9;", "return 8;", "The limit is 9.")


class Mutants(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.tree = self.folder / "tree"
        self.write("CMakeLists.txt", PROJECT + "add_executable(clamp_test clamp.cpp)\n"
                   "add_test(NAME Clamp.keeps_small_numbers COMMAND clamp_test)\n")
        self.write("CMakePresets.json", '{"version": 6, "configurePresets": [{"name": "release", "generator": "Ninja"}]}')
        self.write("clamp.cpp", CLAMP)
        self.catalogue(WRONG_BRANCH + WRONG_LIMIT)

    def write(self, file, text):
        (self.tree / file).parent.mkdir(parents=True, exist_ok=True)
        (self.tree / file).write_text(text, encoding="utf-8")

    def catalogue(self, text):
        self.write("tests/mutants/clamp.toml", text)

    def mutants(self, *arguments, ends=None, says=(), not_said=(), complains=""):
        ran = subprocess.run([SCRIPT, "--root", self.tree, "--work", self.folder / "work", *arguments], capture_output=True, text=True,
                             check=False)
        if ends is not None:
            self.assertEqual(ran.returncode, ends, ran.stdout + ran.stderr)
        for words in says:
            self.assertIn(words, ran.stdout)
        for words in not_said:
            self.assertNotIn(words, ran.stdout)
        self.assertIn(complains, ran.stderr)

    def test_tells_what_the_tests_notice_from_what_they_do_not(self):
        report, page = self.tree / "docs/mutants.json", self.tree / "docs/mutants.md"
        self.mutants(ends=1,  # 50 % are fewer than 95
                     says=("caught by Clamp.keeps_small_numbers", "SURVIVED", "1 of 2 caught (50 %); 0 survive for a reason",
                           "survived: wrong-limit (clamp.cpp): the catalogue gives no reason"))
        self.assertEqual((self.tree / "clamp.cpp").read_text(encoding="utf-8"), CLAMP, "only the copy is changed")
        self.assertEqual((self.folder / "work/tree/clamp.cpp").read_text(encoding="utf-8"), CLAMP, "and changed back")
        found = json.loads(report.read_text(encoding="utf-8"))
        self.assertEqual([one["fate"] for one in found], ["caught", "survived"])

        # One of them again, with a test that sees it: the report keeps the other's result.
        self.write("clamp.cpp", CLAMP.replace("!= 3", "!= 3 || clamped(10) != 9"))
        self.mutants("--only", "wrong-limit", ends=0, says=("1 of 1 caught (100 %)",))
        text = page.read_text(encoding="utf-8")
        self.assertIn("2 of 2 caught (100 %)", text)
        self.assertIn("| Clamp.keeps_small_numbers | 2 | 2 |", text)

    def test_tells_what_is_wrong_with_the_catalogue_from_what_is_caught(self):
        self.catalogue(mutant("no-code", "return x;", "return y;", "There is no y.") +
                       mutant("not-there", "return 10;", "return 8;", "The limit is 9.") +
                       mutant("known", "return 9;", "return 8;", "The limit is 9.", 'survives = "Nobody asks."\n'))
        self.mutants(ends=3, complains="2 mutants do not apply or do not compile",
                     says=("BROKEN: it does not compile", "clamp.toml: 'not-there' does not apply: its text is not in clamp.cpp",
                           "survived: known (clamp.cpp): Nobody asks.", "0 of 1 caught (0 %); 1 survive for a reason"))

    def test_says_no_where_a_mutant_is_caught_that_no_test_can_notice(self):
        self.catalogue(mutant("known", "return x;", "return -x;", "Small numbers stay as they are.", 'survives = "Nobody asks."\n'))
        self.mutants(ends=1, says=("caught by Clamp.keeps_small_numbers: known (clamp.cpp), of which the catalogue says: Nobody asks.",))

    def test_takes_no_test_of_the_tree_for_a_catch_and_fails_where_nothing_is_caught(self):
        tests = PROJECT + """add_executable(clamp_test clamp.cpp)
add_test(NAME Clamp.keeps COMMAND clamp_test)
add_test(NAME Clamp.is_unedited COMMAND ${CMAKE_COMMAND} -E compare_files clamp.cpp ${CMAKE_BINARY_DIR}/copy.cpp WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
if(NOT EXISTS ${CMAKE_BINARY_DIR}/copy.cpp)
configure_file(clamp.cpp ${CMAKE_BINARY_DIR}/copy.cpp COPYONLY)
endif()
"""
        self.catalogue(mutant("swapped", "if (x < 9)", "if (9 > x)", "The sides are swapped.", kind="equivalent") + WRONG_BRANCH + WRONG_LIMIT)
        self.write("CMakeLists.txt", tests)
        self.mutants("--only", "wrong-branch", ends=3, complains="what changes nothing (swapped) is noticed: Clamp.is_unedited")

        self.write("CMakeLists.txt", tests + "set_tests_properties(Clamp.is_unedited PROPERTIES LABELS tree)\n")
        page = self.tree / "docs/mutants.md"
        self.mutants(ends=1, says=("1 of 2 caught (50 %)",), not_said=("is_unedited",))
        self.assertIn("- swapped (clamp.cpp): survived", page.read_text(encoding="utf-8"))
        self.assertIn("| Clamp.keeps | 1 | 1 |", page.read_text(encoding="utf-8"))

        # The same tree once more, but for the page that was written into it: nothing is made again.
        self.mutants("--resume", says=("(known; ", "1 of 2 caught (50 %)"), not_said=("changes that change nothing",))
        self.mutants("--every", "2", says=("1/1 wrong-branch",))

    def test_asks_the_tests_of_the_lab_first_and_those_of_other_labs_not_at_all(self):
        file = "labs/01_clamp/clamp.cpp"
        self.write(file, CLAMP)
        self.write("CMakeLists.txt", PROJECT + f"add_executable(clamp_test {file})\nforeach(name any in_lab_2 in_lab_1)\n"
                   "add_test(NAME Clamp.${name} COMMAND clamp_test)\nendforeach()\n")
        self.catalogue(mutant("one", "return x;", "return -x;", "It is wrong.", file=file))
        self.mutants(says=("caught by Clamp.in_lab_1",))
        self.catalogue(mutant("one", "return x;", "return x;  // still right", "It is wrong.", file=file))
        self.mutants(says=("SURVIVED",))
        self.assertNotIn("Clamp.in_lab_2", (self.folder / "work/logs/one.log").read_text(encoding="utf-8"))

    def test_asks_first_what_noticed_the_mutant_last_time(self):
        self.write("CMakeLists.txt", PROJECT + "add_executable(clamp_test clamp.cpp)\nforeach(name first second)\n"
                   "add_test(NAME Clamp.${name} COMMAND clamp_test)\nendforeach()\n")
        self.mutants("--only", "wrong-branch", says=("caught by Clamp.first; Clamp.second",))
        record = self.tree / "docs/mutants.json"
        record.write_text(record.read_text(encoding="utf-8").replace("Clamp.first", "Clamp.gone"), encoding="utf-8")
        self.mutants("--only", "wrong-branch", says=("caught by Clamp.second (",))

    def test_makes_first_what_nothing_is_known_of(self):
        self.mutants("--only", "wrong-branch")
        self.mutants(says=("1/2 wrong-limit", "2/2 wrong-branch"))
        self.catalogue(WRONG_BRANCH.replace("-x", "1 - x") + WRONG_LIMIT)  # another change now
        self.mutants("--resume", says=("1/2 wrong-branch",))

    def test_asks_a_test_that_failed_once_because_the_machine_was_busy(self):
        self.write("CMakeLists.txt", PROJECT + "add_executable(clamp_test clamp.cpp)\n"
                   "add_test(NAME Clamp.late COMMAND sh -c \"test -e been && ./clamp_test || { touch been; false; }\")\n")
        self.mutants("--only", "wrong-branch", ends=0, says=("caught by Clamp.late",))
        self.mutants("--only", "wrong-branch", ends=0, says=("caught by Clamp.late",), not_said=("changes that change nothing",))

    def test_refuses_what_cannot_be_measured(self):
        self.mutants("--only", "wrong-limits", ends=2, complains="did you mean 'wrong-limit'?")
        self.mutants("--work", self.tree / "copy", ends=2)
        self.mutants("--catalogue", self.folder / "none", ends=3)
        self.write("clamp.cpp", "int main() { return 1; }\n")
        self.catalogue(mutant("one", "return 1;", "return 0;", "One is not none."))
        self.mutants(ends=3, complains="no test passes in the unchanged tree")


if __name__ == "__main__":
    unittest.main()
