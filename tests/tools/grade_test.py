#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Whole classes, graded by the program `texel` as a teacher runs it. make_class says what must come out.
grade_test.py BUILD [unittest's arguments]"""
import contextlib
import csv
import json
import os
import pathlib
import random
import re
import shlex
import shutil
import signal
import sqlite3
import subprocess
import sys
import time
import unittest

import tree

ROOT = pathlib.Path.cwd()
BUILD = pathlib.Path(sys.argv[1])
BIN = BUILD / "bin"
WORK, CACHE = BUILD / "grade_test", BUILD / "grade"
TEXEL = BIN / "texel"
SEED = "a seed that no report may show"
ALL_LABS = ",".join(str(lab["number"]) for lab in tree.labs())
WALL = "texel_threat_was_here"


def shell(line, **options):
    """The exit code and all that a line of shell prints."""
    done = subprocess.run(line, shell=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False, **options)
    return done.returncode, done.stdout.decode(errors="replace")


def quoted(*words):
    return shlex.join(map(str, words))


# ---- Classes, and what comes out of them.

class Class:
    """A class folder in WORK. With `kinds` make_class fills it and says what must come out."""

    def __init__(self, name, labs, kinds=""):
        self.folder, self.out, self.labs, self.students = WORK / name, WORK / f"{name}_out", labs, {}
        for old in (self.folder, self.out):
            shutil.rmtree(old, ignore_errors=True)
        WORK.mkdir(parents=True, exist_ok=True)
        (WORK / "seed.txt").write_text(SEED)
        if kinds:
            code, said = shell(f"{quoted(ROOT / 'tests/tools/make_class.py', BIN, '--out', self.folder)} --labs {labs} --kinds {kinds}")
            assert code == 0, said
            self.students = json.loads((WORK / f"{name}.json").read_text())["students"]
        else:
            self.folder.mkdir()

    def command(self, rest="", out=None):
        return (quoted(TEXEL, "grade", self.folder, "--out", out or self.out, "--cache", CACHE, "--seed-file", WORK / "seed.txt") +
                f" --labs {self.labs} {rest}")


def fresh(name):
    shutil.rmtree(WORK / name, ignore_errors=True)
    return WORK / name


@contextlib.contextmanager
def store(out):
    with contextlib.closing(sqlite3.connect(out / "results.sqlite")) as database, database:
        yield database


def rows_by_student(out, lab=""):
    """All rows of a store by their student; those that speak of one lab, or all."""
    rows = {}
    with store(out) as database:
        for (table,) in database.execute("SELECT name FROM sqlite_master WHERE type = 'table' AND name <> 'facts' ORDER BY name").fetchall():
            for row in database.execute(f"SELECT * FROM {table} ORDER BY 1, 2, 3"):
                if not lab or lab in row[1:]:
                    rows.setdefault(row[0], []).append((table, *row[1:]))
    return rows


def facts(out):
    with store(out) as database:
        return database.execute("SELECT * FROM facts ORDER BY 1").fetchall()


def query(out, sql, *values):
    with store(out) as database:
        return database.execute(sql, values).fetchall()


def table_of(out):
    with open(out / "class.csv", encoding="utf-8", newline="") as file:
        return list(csv.reader(file, strict=True))


def files_in(folder):
    return {str(file.relative_to(folder)): file.read_bytes() for file in folder.rglob("*") if file.is_file() and not file.is_symlink()}


def steps_of(out, student):
    """What Gradescope is told of each step, by its id."""
    results = json.loads((out / "gradescope" / student / "results.json").read_text(encoding="utf-8"))
    return {test["number"]: test for test in results["tests"] if test["visibility"] == "visible"}


class GraderTest(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        if shell("bwrap --ro-bind / / --unshare-net --unshare-pid true")[0] != 0:
            self.skipTest("bubblewrap cannot work here")

    def grade(self, one, rest="", out=None):
        code, said = shell(one.command(rest, out))
        self.assertEqual(code, 0, said)
        return said

    def check(self, one):
        """Holds all students of a class against what must come out."""
        code, said = shell(quoted(TEXEL, "grade", "report", one.out, "--format", "gradescope"))
        self.assertEqual(code, 0, said)
        self.assertEqual({row[0] for row in query(one.out, "SELECT student FROM students")}, set(one.students))
        self.assertEqual(query(one.out, "SELECT * FROM incidents"), [])
        named = [self.check_student(one, student, expected) for student, expected in one.students.items()]
        asked, right = sum(name is not None for name in named), sum(name is True for name in named)
        print(f"{right} of {asked} mutants were named rightly")
        self.assertGreaterEqual(right, 0.9 * asked)

    def check_student(self, one, student, expected):
        """Whether a mistake that has a name got it; None where none has."""
        with self.subTest(student, kind=expected["kind"], name=expected["name"]):
            fault = query(one.out, "SELECT fault FROM students WHERE student = ?", student)[0][0]
            self.assertEqual(bool(fault), expected.get("fault", False), fault)
            steps = steps_of(one.out, student)
            passed = {step for step, test in steps.items() if test["status"] == "passed"}
            for step, test in steps.items():
                self.assertEqual(step in passed, test["score"] == test["max_score"], test)
                if step in expected.get("zero", []):
                    self.assertEqual(test["score"], 0, test)
                if step == expected.get("fails"):
                    self.assertNotIn(step, passed, test)
            if "untouched" in expected:
                self.assertTrue(query(one.out, "SELECT * FROM cases WHERE student = ? AND step = ? AND status = 'untouched'", student,
                                      expected["untouched"]))
            if "passes" in expected:
                self.assertEqual(passed, set(expected["passes"]))
            if "mistake" in expected:
                tags = steps[expected["fails"]]["tags"]
                if expected["mistake"] not in tags:
                    print(f"{expected['mistake']} was called {tags}")
                return expected["mistake"] in tags
        return None

    def check_harmless(self, one, before):
        """That nothing of what the threats tried is to be seen."""
        self.assertTrue(files_in(one.folder) == before, "submissions were changed")
        for folder in (pathlib.Path("/"), pathlib.Path("/tmp"), ROOT, one.folder, one.out, pathlib.Path.cwd()):
            self.assertFalse((folder / WALL).exists(), folder)
        self.assertNotIn(SEED, str(rows_by_student(one.out)) + str(facts(one.out)))
        for name, text in files_in(one.out / "report").items():
            for harm in ("<script>texel_threat", "<img src=x", SEED):
                self.assertNotIn(harm.encode(), text, name)
        for cell in (cell for row in table_of(one.out) for cell in row):
            self.assertNotIn(cell[:1] or " ", "=+@")

    def check_same_rows(self, a, b, lab=""):
        """That students of both classes have the same results; how many these are."""
        others = rows_by_student(b, lab)
        both = {student: rows for student, rows in rows_by_student(a, lab).items() if student in others}
        for student, rows in both.items():
            self.assertEqual(rows, others[student], student)
        return len(both)

    def check_same(self, a, b):
        """That two folders hold the same grades, pictures and reports of the class."""
        self.assertEqual((facts(a), rows_by_student(a)), (facts(b), rows_by_student(b)))
        self.assertEqual((a / "class.csv").read_bytes(), (b / "class.csv").read_bytes())
        self.assertTrue(files_in(a / "pictures") == files_in(b / "pictures"))

    def grade_with_kills(self, one, out, moments):
        """Grades, is killed after each of the times (in seconds), and is taken up again until it ends."""
        for moment in moments:
            line = f"exec {one.command('--resume', out)} >/dev/null 2>&1"
            with subprocess.Popen(line, shell=True) as grader:
                time.sleep(moment)
                grader.send_signal(signal.SIGKILL)
        self.grade(one, "--resume --format csv", out)


class Starter(GraderTest):
    """Builds what the others share, by grading somebody who handed in nothing."""

    def test_is_built_and_an_empty_submission_scores_nothing(self):
        shutil.rmtree(WORK, ignore_errors=True)
        empty = Class("empty", ALL_LABS)
        (empty.folder / "nobody").mkdir()
        self.grade(empty, "--format gradescope")
        steps = steps_of(empty.out, "nobody").values()
        self.assertEqual(sum(test["score"] for test in steps), 0)
        self.assertGreater(sum(test["max_score"] for test in steps), 0)
        self.has_flags_of_the_course()

    def has_flags_of_the_course(self):
        """What no student edits is compiled as the course compiles it: the compiler's cache has it already."""
        def commands(tree, build):
            found = json.loads((build / "compile_commands.json").read_text())
            return {one["command"].replace(str(tree), "") for one in found if "/common/" in one["file"]}
        starter = max(CACHE.glob("starter-*"), key=lambda folder: folder.stat().st_mtime)
        own = commands(starter, starter / "build/release")
        self.assertGreaterEqual(len(own), 20)
        self.assertLessEqual(own, commands(ROOT, BUILD))


class GradedClass(GraderTest):
    """Two labs: one of C++, one of GLSL; and a few students on one lab for what does not depend on the labs."""
    LIMIT = "--limit 3" if tree.EXHAUSTIVE else "--limit 1 --threats 5"  # how many of each kind a class has

    @classmethod
    def setUpClass(cls):
        cls.two_labs = Class("two_labs", "7,9", f"solution,starter,prefix,mutant,equivalent {cls.LIMIT}")
        cls.graded = shell(cls.two_labs.command())
        cls.few = Class("few", "9", "solution,starter,prefix,mutant --limit 1")
        begin = time.monotonic()
        cls.graded_few = shell(cls.few.command("--format csv,gradescope,prairielearn,junit"))
        cls.seconds = time.monotonic() - begin  # that grading the few takes

    def setUp(self):
        super().setUp()
        for code, said in (self.graded, self.graded_few):
            self.assertEqual(code, 0, said)

    def test_gives_everybody_what_they_earned(self):
        self.check(self.two_labs)

    @unittest.skipUnless(tree.EXHAUSTIVE, "on a build server")
    def test_is_graded_alike_on_egl(self):
        # On OSMesa, which `auto` prefers, the two labs are graded above.
        solutions = Class("egl", "7,9", "solution,starter")
        self.grade(solutions, "--context egl")
        self.check(solutions)

    def test_is_not_touched_by_threats(self):
        # Most threats are programs, of lab 7; a few of them, and all on a build server.
        hostile = Class("hostile", "7", f"solution,starter,mutant,threat,files,broken {self.LIMIT}")
        before = files_in(hostile.folder)
        self.grade(hostile, "--format csv,junit")
        self.check(hostile)
        self.check_harmless(hostile, before)
        self.assertGreaterEqual(self.check_same_rows(hostile.out, self.two_labs.out, "07_environment"), 5)  # solutions and starters

    def test_gives_nothing_to_shaders_that_cheat(self):
        shaders = Class("shaders", "9", "threat")
        self.grade(shaders)
        self.check(shaders)

    @unittest.skipUnless(tree.EXHAUSTIVE, "on a build server")
    def test_is_the_same_after_sudden_ends(self):
        killed = fresh("killed_out")
        self.grade_with_kills(self.few, killed, [0.3 * self.seconds, 0.5 * self.seconds, 0.6 * self.seconds])
        self.check_same(killed, self.few.out)

    @unittest.skipUnless(tree.EXHAUSTIVE, "on a build server")
    def test_is_the_same_from_two_shards(self):
        shards, merged = [fresh("shard_1_out"), fresh("shard_2_out")], fresh("merged_out")
        for number, out in enumerate(shards, 1):
            self.grade(self.few, f"--shard {number}/2", out)
        code, said = shell(quoted(TEXEL, "grade", "merge", *shards, "--out", merged, "--format", "csv"))
        self.assertEqual(code, 0, said)
        self.check_same(merged, self.few.out)

    @unittest.skipUnless(tree.EXHAUSTIVE, "on a build server")
    def test_survives_a_disk_that_is_full_or_cannot_be_written(self):
        """A small disk of its own for the results, in which half the class is graded. Then it is full, and then it cannot be written:
        each time a run must fail and say why. At last all is well, and a run must end."""
        if os.geteuid() != 0 or shell("unshare -m true")[0] != 0:
            self.skipTest("needs to mount a disk, as root")
        disk, kept, half = fresh("disk"), fresh("disk_kept"), fresh("disk_half")
        for folder in (disk, kept, half):
            folder.mkdir()
        code, said = shell(quoted("unshare", "-m", "sh", "-c", f"""
            d={disk}
            mount -t tmpfs -o size=64m,mode=755 tmpfs $d && {self.few.command("--shard 1/2", disk)} >/dev/null 2>&1; echo first $?
            head -c $(($(df -B1 --output=avail $d | tail -1) - 700000)) /dev/zero >$d/filler
            {self.few.command("--resume", disk)}; echo full $?
            rm $d/filler; mount -o remount,ro $d; {self.few.command("--resume", disk)}; echo closed $?
            mount -o remount,rw $d; cp -p $d/results.sqlite* {half}
            {self.few.command("--resume --format csv", disk)} >/dev/null 2>&1; echo last $?; cp -r $d/. {kept}"""))
        for text in ("first 0\n", "full 3\n", "closed 3\n", "last 0\n", "texel: ", "the disk is full", "ead-only file system"):
            self.assertIn(text, said)
        # What was there stayed, and in the end nothing is missing.
        whole, rows = rows_by_student(self.few.out), rows_by_student(half)
        self.assertGreaterEqual(sum(rows[student] == whole[student] for student in rows), len(whole) // 2)
        self.check_same(kept, self.few.out)

    def test_says_that_a_run_is_not_finished(self):
        """The results as a run leaves them that was cut off: one student done, one in the middle, the others not begun."""
        cut, joined = fresh("cut_out"), fresh("cut_joined")
        cut.mkdir()
        with store(self.few.out) as whole, store(cut) as part:
            whole.backup(part)
        with store(cut) as part:
            first, second, *others = [row[0] for row in part.execute("SELECT student FROM students ORDER BY 1")]
            self.assertTrue(others)
            part.execute("DELETE FROM cases WHERE student NOT IN (?, ?)", (first, second))
            part.execute("DELETE FROM cases WHERE student = ? AND name IN (SELECT max(name) FROM cases GROUP BY step)", (second,))
        for line in (quoted(TEXEL, "grade", "report", cut, "--format", "csv,gradescope"),
                     quoted(TEXEL, "grade", "merge", cut, "--out", joined, "--format", "csv")):
            code, said = shell(line)
            self.assertEqual(code, 3, said)
            self.assertIn(f"not finished: {1 + len(others)} students", said)
            self.assertEqual(shell(line + " --unfinished")[0], 0)
        for folder in (cut, joined):
            self.assertEqual([row[3] == "" for row in table_of(folder)[1:]], [False, True, *(True for _ in others)])
        self.assertTrue((cut / "gradescope" / first / "results.json").exists())
        self.assertFalse((cut / "gradescope" / second / "results.json").exists())

    def test_has_reports_in_every_format(self):
        out = self.few.out
        self.assertEqual(len(table_of(out)), 1 + len(self.few.students))
        for student in self.few.students:
            for path, text in ((f"gradescope/{student}/results.json", '"tests"'), (f"prairielearn/{student}/results.json", '"score"'),
                               (f"junit/{student}.xml", "</testsuites>"), (f"report/{student}.html", "</html>"), ("report/index.html", "</html>")):
                self.assertIn(text, (out / path).read_text(encoding="utf-8"))
        with open(out / "times.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(sorted(row["id"] for row in rows), sorted(self.few.students))
        seconds = [float(row["seconds"]) for row in rows]
        self.assertEqual(seconds, sorted(seconds, reverse=True))
        self.assertGreater(seconds[0], 0)

    def test_tells_a_student_who_packs_the_whole_folder_only_what_is_theirs(self):
        """The guide tells students to hand in the whole folder. What they did not change is not worth a line."""
        whole, folder = Class("whole", "9"), fresh("whole_tree") / "my-labs"
        self.assertEqual(shell(quoted(TEXEL, "starter", "--out", folder))[0], 0)
        for path in ("build/release/build.ninja", "out/gallery/index.html", ".git/HEAD", "labs/.DS_Store", "__MACOSX/._labs",
                     ".before-update-2/run", "labs/05_normal_map/lab.cpp.before-reset-2"):
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / path).write_text("made there")
        shutil.make_archive(whole.folder / "inside", "zip", folder)
        shutil.make_archive(whole.folder / "around", "gztar", folder.parent, "my-labs")
        (folder / "common/core/include/core/error.hpp").write_text("#pragma once\n")
        (folder / "notes.txt").write_text("mine")
        shutil.copytree(folder, whole.folder / "changed", symlinks=True)
        self.grade(whole)
        self.assertEqual(query(whole.out, "SELECT student, fault FROM students ORDER BY 1"), [("around", ""), ("changed", ""), ("inside", "")])
        self.assertEqual(query(whole.out, "SELECT student, path FROM ignored ORDER BY 2"),
                         [("changed", "common/core/include/core/error.hpp"), ("changed", "notes.txt")])

    def test_is_found_again_by_a_second_run_that_judges_nothing(self):
        self.assertIn(": 0 cases in ", self.grade(self.few, "--resume --format csv"))


# ---- Steps that are judged among the solution's others: one mistake costs one step, and the solution stays secret.

def students_file(file, solved):
    """A course's file with these steps solved, as a student has it."""
    return tree.with_steps((ROOT / file).read_text(encoding="utf-8"), lambda step: step in solved)


def replaced(text, what, by):
    assert what in text, what
    return text.replace(what, by, 1)


def surrounded(text, step, before, behind):
    """Puts a line before the part of a step, and another one behind it."""
    return re.sub(rf"^( *//@step {re.escape(step)} begin$.*?//@end\n)", lambda found: f"{before}\n{found[1]}{behind}\n", text, count=1,
                  flags=re.MULTILINE | re.DOTALL)


CPP, GLSL = "labs/07_environment/lab.cpp", "shaders/08_reflection/rays.glsl"
ALL_STEPS = {"7.1", "7.2", "7.3", "7.4", "8.1", "8.2", "8.3"}

# Hands in text that carries the solution out, if what stands in for other steps is shown anywhere: as the program's own file, printed,
# as reasons why pictures are missing, as a picture and as a file's name.
CARRY_OUT = r'''
int carry_out(int argc, char** argv) {
  const Asked all = asked(argc, argv);
  std::puts(stolen);
  std::fputs(stolen, stderr);
  std::string said, text;
  for (const char* c = stolen; *c != 0; ++c)
    if (*c == '\n') text += "\\n"; else if (*c == '"' || *c == '\\') (text += '\\') += *c; else text += *c;
  for (std::size_t i = 0; i < all.files.size(); ++i)
    if (i % 2 == 0)
      said += (said.empty() ? "[" : ",") + std::string("{\"name\": \"") + all.files[i] +
              "\", \"status\": \"failed\", \"message\": \"" + text + "\", \"place\": \"" + text + "\"}";
    else
      std::ofstream(all.out / all.files[i]) << stolen;
  std::ofstream(all.out / "results.json") << said << "]";
  return 3;
}
int main('''


def thieves():
    """By name, the file and the text that each hands in."""
    stolen = ('\nasm(".section .rodata\\n.globl stolen\\nstolen: .incbin \\"" __FILE__ "\\"\\n.byte 0\\n.text");\nextern "C" const char stolen[];\n' +
              (ROOT / "tests/threats/asked.hpp").read_text(encoding="utf-8"))
    begun = replaced(students_file(CPP, set()), "-0.5F, -0.5F, 0", "-0.6F, -0.5F, 0")
    program = replaced(begun, "return texel::app::run<texel::environment::Environment>(argc, argv);", "return carry_out(argc, argv);")
    shader = replaced(students_file(GLSL, set()), "return normal;", "return 2.0 * normal;")
    return {"program": (CPP, replaced(program, "int main(", stolen + CARRY_OUT)),
            # What the compiler says, and the compiler of shaders.
            "compiler": (CPP, surrounded(begun, "7.3", 'static_assert(sizeof(Real) == 3, R"x(', ')x");')),
            "shader": (GLSL, surrounded(shader, "8.3", "#define float", "#undef float"))}


def secrets():
    """What stands in the parts of steps of a solution, and nowhere else in the starter: lines, and GLSL's names."""
    lines = {"cos_t_squared"}
    for file in (CPP, GLSL):
        starter = students_file(file, set())
        solution = [line.strip() for line in students_file(file, ALL_STEPS).splitlines()]
        lines |= {line for line in solution if len(line) > 20 and line not in starter}
    return lines


def put(one, student, file, text):
    path = one.folder / student / file
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


class JudgedAlone(GraderTest):
    def test_costs_each_mistake_one_step_and_right_ones_none(self):
        """Of half of the labs a wrong solution, and a right one written in another way; on a build server two each of all. Labs that
        share files with steps are graded together."""
        kinds, limit, least, some = [], *((2, 12, 1) if tree.EXHAUSTIVE else (1, 3, 2))
        for labs in ("1", "2", "3,4,5", "6,9", "7", "8")[::some]:
            made = Class(f"mistakes_{labs[0]}", labs, f"mistake,equivalent --limit {limit}")
            self.grade(made)
            self.check(made)
            kinds += [expected["kind"] for expected in made.students.values()]
            for student in made.students:
                for test in steps_of(made.out, student).values():
                    # One other step, or none where it is in another lab and lab.toml does not say that it is needed.
                    self.assertNotRegex(test["output"], r"is right: with [\d.]+(,| and) .* mended", student)
        self.assertGreaterEqual(kinds.count("mistake"), least)
        self.assertGreaterEqual(kinds.count("equivalent"), least)

    def test_shows_nothing_of_what_stands_in(self):
        one = Class("thieves", "7,8")
        for name, (file, text) in thieves().items():
            put(one, name, file, text)
        said = self.grade(one, "--format csv,gradescope,prairielearn,junit")
        shown = {name: text.decode(errors="replace") for name, text in files_in(one.out).items() if not name.startswith("references/")}
        shown["the console"] = said
        shown["the store"] = "\n".join(str(value) for rows in rows_by_student(one.out).values() for row in rows for value in row)
        self.assertGreaterEqual(len(secrets()), 10)
        for name, text in shown.items():
            for secret in secrets():
                # A page and the files of JSON have it escaped.
                for form in (secret, json.dumps(secret)[1:-1], json.dumps(secret)[1:-1].replace("<", "\\u003c"), secret.replace("<", "&lt;")):
                    self.assertNotIn(form, text, name)
        self.assertEqual(query(one.out, "SELECT * FROM incidents"), [])
        self.assertEqual([row[3] for row in table_of(one.out)[1:]], ["0", "0", "0"])

    def test_blames_the_step_that_spoils_pictures_of_others_only(self):
        """Each step of lab 2 is right by itself, but 2.1 puts its object into the first one's place too, where it is no decal."""
        one, file, steps = Class("spoiler", "2"), "labs/02_multi_texture/lab.cpp", {"2.1", "2.2", "2.3", "2.4"}
        put(one, "jane", file, replaced(students_file(file, steps), "p.texture1, premultiply) : nullptr;\n",
                                        "p.texture1, premultiply) : nullptr;\n"
                                        "    if (p.unit0_on && p.unit1_on && p.combine != Combine::decal) object0 = object1;\n"))
        shader = "shaders/02_multi_texture/combine.glsl"
        put(one, "jane", shader, students_file(shader, steps))
        self.grade(one, "--format gradescope")
        steps = steps_of(one.out, "jane")
        self.assertEqual({step: found["status"] for step, found in steps.items()},
                         {"2.1": "failed", "2.2": "passed", "2.3": "passed", "2.4": "passed"})
        self.assertIn("This picture is right, but the step spoils pictures of", steps["2.1"]["output"])
        self.assertNotIn(" off; full marks", steps["2.1"]["output"], "nothing of it is off")

    def test_says_why_a_step_without_its_own_markers_was_not(self):
        """8.2 and 8.3 are right and 8.1 is wrong. A comment that looks like a marker changes nothing; a damaged marker of 8.3 costs 8.3 alone."""
        one = Class("markers", "8")
        whole = replaced(students_file(GLSL, ALL_STEPS), "incident - 2.0 *", "incident + 2.0 *")
        whole = replaced(whole, "//@step 8.2 begin", "//@todo\n//@step 8.2 begin")
        put(one, "whole", GLSL, whole)
        put(one, "lost", GLSL, replaced(whole, "//@step 8.3 begin", "// step 8.3 begin"))
        self.grade(one, "--format csv,gradescope,junit,prairielearn")
        for student, says in (("whole", "8.2 is right: with 8.1 mended it has full marks."),
                              ("lost", "8.3 was not judged alone, since its line //@step 8.3 begin or its //@end")):
            steps = steps_of(one.out, student)
            self.assertEqual(steps["8.2"]["status"], "passed")
            self.assertIn("alone", steps["8.2"]["tags"])
            self.assertEqual("markers lost" in steps["8.3"]["tags"], student == "lost")
            self.assertEqual(steps["8.1"]["score"], 0)
            for shown in (f"report/{student}.html", f"gradescope/{student}/results.json", f"prairielearn/{student}/results.json",
                          f"junit/{student}.xml", "class.csv"):
                self.assertIn(says, (one.out / shown).read_text(encoding="utf-8"), shown)


@unittest.skipUnless(tree.HOURS, "takes hours: ./run test --all")
class WholeCourse(GraderTest):
    """The same over all labs, with every mutant, equivalent and threat there is. The tests follow each other in the order of their names."""

    def test_1_has_a_starter_that_keeps_its_promises(self):
        code, said = shell(quoted(TEXEL, "starter", "--verify", "--cache", CACHE))
        self.assertEqual(code, 0, said)

    def test_2_is_graded_rightly_for_every_wrong_and_every_right_solution(self):
        everybody = Class("all", ALL_LABS, "solution,starter,prefix,mutant,equivalent")
        self.grade(everybody)
        self.check(everybody)

    def test_3_is_not_touched_by_threats(self):
        hostile = Class("all_hostile", ALL_LABS, "solution,starter,prefix,mutant,equivalent,threat,slow,files,broken --limit 8")
        before = files_in(hostile.folder)
        self.grade(hostile, "--format csv,gradescope,prairielearn,junit")
        self.check(hostile)
        self.check_harmless(hostile, before)
        self.assertGreaterEqual(self.check_same_rows(hostile.out, WORK / "all_out"), 3 + 2 + 3 * 8)

    def test_4_is_the_same_after_twenty_sudden_ends_and_from_four_shards(self):
        some = Class("some", ALL_LABS, "solution,starter,prefix,mutant,equivalent --limit 5")
        begin = time.monotonic()
        self.grade(some, "--format csv")
        seconds = time.monotonic() - begin
        killed, merged = fresh("some_killed"), fresh("some_merged")
        self.grade_with_kills(some, killed, [random.uniform(0.5, 0.15 * seconds) for _ in range(20)])
        self.check_same(killed, some.out)
        if not shutil.which("parallel"):
            self.skipTest("GNU parallel is missing")
        shards = [fresh(f"some_shard_{number}") for number in range(1, 5)]
        code, said = shell(f"parallel -j 2 {quoted(some.command('--jobs 1 --shard {}/4', WORK / 'some_shard_{}'))} ::: 1 2 3 4")
        self.assertEqual(code, 0, said)
        code, said = shell(quoted(TEXEL, "grade", "merge", *shards, "--out", merged, "--format", "csv"))
        self.assertEqual(code, 0, said)
        self.check_same(merged, some.out)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
