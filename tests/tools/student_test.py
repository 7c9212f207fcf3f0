#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The student's way through a tree: check, watch, hint, reset, progress, in a starter whose programs are the course's (so that its C++
steps are solved and its shaders are not), and in the course's own tree. student_test.py BUILD [unittest's arguments]"""
import contextlib
import json
import pathlib
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from unittest import mock

import tree

ROOT = pathlib.Path.cwd()
sys.path.insert(0, str(ROOT / "tests/figures"))
import labs  # noqa: E402

BUILD = pathlib.Path(sys.argv[1])
BIN = BUILD / "bin"
TEXEL = BIN / "texel"
LABS = tree.labs()
MISTAKES = [one for one in tree.catalogue("mutants", "mutant") + tree.catalogue("mistakes", "mutant") if one["step"]]
DECODE = "shaders/05_normal_map/decode_normal.glsl"


def shell(line):
    """The exit code and all that a line of shell prints."""
    done = subprocess.run(line, shell=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    return done.returncode, done.stdout.decode(errors="replace")


def in_course(arguments):
    return shell(f"{TEXEL} {arguments}")


def solved(text):
    return tree.with_steps(text, lambda step: True)


def mutated(mutant, text):
    assert text.count(mutant["what"]) == 1, mutant["name"]
    return text.replace(mutant["what"], mutant["by"])


def read_rows(file):
    """The rows of a PNG, the uppermost first."""
    picture = labs.Picture(file)
    size = picture.channels * picture.width
    return [picture.samples[y * size:(y + 1) * size] for y in reversed(range(picture.height))]


class CourseTree(unittest.TestCase):
    def test_passes_its_own_checks(self):
        code, said = in_course("check --json")
        self.assertEqual(code, 0, said)
        labs = json.loads(said)
        self.assertEqual([int(lab["lab"][:2]) for lab in labs], [lab["number"] for lab in LABS])
        steps = [step for lab in labs for step in lab["steps"]]
        self.assertEqual([step for step in steps if step["status"] != "passed"], [])
        # No renderer differs by more than a third of a limit. What is further off has an expected picture of an earlier shader.
        self.assertEqual([case for step in steps for case in step["cases"] if 3 * case["error"] > case["limit"]], [])

    def test_has_its_catalogue_in_the_samples_of_mistakes(self):
        # ./run expected renews them.
        catalogue = {one["name"]: one for one in MISTAKES}
        for lab in LABS:
            mistakes = json.loads(pathlib.Path("labs", lab["folder"], "expected/mistakes.json").read_text(encoding="utf-8"))
            self.assertGreaterEqual(len(mistakes), 6, lab["folder"])
            for mistake in mistakes:
                with self.subTest(mistake["name"]):
                    self.assertEqual([mistake[key] for key in ("step", "says")], [catalogue[mistake["name"]][key] for key in ("step", "says")])
                    self.assertLessEqual(set(mistake["cases"]), {case["name"] for case in lab["case"] if case["step"] == mistake["step"]})

    def test_has_a_help_that_fits_a_terminal(self):
        self.assertEqual([line for line in shell(f"{ROOT}/run help")[1].splitlines() if len(line) > 80], [])

    def test_does_not_let_its_solutions_be_reset(self):
        before = pathlib.Path(DECODE).read_bytes()
        code, said = in_course("reset 5.1")
        self.assertEqual(code, 2)
        self.assertIn("texel starter --out DIR", said)
        self.assertEqual(pathlib.Path(DECODE).read_bytes(), before)


class StudentTree(unittest.TestCase):
    """A tree as students get it, once for all tests; each works on labs of its own."""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="texel_student_"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.root = cls.folder / "tree"
        code, said = in_course(f"starter --out {cls.root}")
        assert code == 0, said

    def line(self, arguments):
        return f"TEXEL_ROOT={self.root} {TEXEL} {arguments}"

    def texel(self, arguments):
        return shell(self.line(arguments))

    def steps(self, lab):
        """The steps of a lab by id, as --json has them."""
        done = subprocess.run(self.line(f"check {lab} --json"), shell=True, stdout=subprocess.PIPE, check=False)
        return {step["id"]: step for step in json.loads(done.stdout)["steps"]}

    def solve(self, file, step):
        """Puts the course's solution of a step into the student's file."""
        text = tree.with_step_from((self.root / file).read_text(encoding="utf-8"), step, solved((ROOT / file).read_text(encoding="utf-8")))
        (self.root / file).write_text(text, encoding="utf-8")

    @contextlib.contextmanager
    def changed(self, file, text):
        """A file with another text, for a while."""
        path = self.root / file
        before = path.read_bytes()
        path.write_text(text, encoding="utf-8")
        try:
            yield
        finally:
            path.write_bytes(before)


class Starter(StudentTree):
    def test_has_no_solution_no_truth_and_no_test(self):
        for folder in ("tests", "teach", "docs/accuracy"):
            self.assertFalse((self.root / folder).exists(), folder)
        for given in ("labs/05_normal_map/README.md", "docs/student.md", "docs/pictures/05_normal_map.png", "docs/pictures/steps/5.1.png",
                      "labs/05_normal_map/expected/decode_bumps.pfm", "run"):
            self.assertTrue((self.root / given).exists(), given)
        # The README is the first page and not the guide once more; all that the two and the handouts link is there.
        self.assertEqual((self.root / "README.md").read_bytes(), pathlib.Path("STARTER.md").read_bytes())
        for page in (*self.root.glob("*.md"), *self.root.glob("docs/*.md"), *self.root.glob("labs/*/*.md")):
            for link in re.findall(r"\]\(([^):#]+)", page.read_text(encoding="utf-8")):
                self.assertTrue(link == "https" or (page.parent / link).exists(), f"{page.name} links {link}")
        # No file has a step's solution, its own or another.
        given = {path: "".join(path.read_text(encoding="utf-8").split()) for folder in ("labs", "shaders", "common", "tools")
                 for path in (self.root / folder).rglob("*") if path.suffix in (".cpp", ".hpp", ".glsl", ".frag", ".vert")}
        for file in (file for folder in ("labs", "shaders") for file in pathlib.Path(folder).rglob("*.*") if file.suffix in (".cpp", ".glsl", ".frag", ".vert")):
            for step, text in tree.step_parts(solved(file.read_text(encoding="utf-8"))):
                for path, starter in given.items():
                    self.assertNotIn("".join(text.split()), starter, f"{path} has step {step}")


class Checked(StudentTree):
    def test_step_by_step(self):
        step = self.steps(9)["9.2"]
        self.assertEqual(step["status"], "skipped")
        self.assertIn("9.1", step["message"])  # which is not done
        step = self.steps(6)["6.1"]
        self.assertEqual(step["status"], "failed")
        self.assertTrue(step["message"].startswith("This step is still as the starter has it. "), step)
        self.assertGreater(step["error"], step["limit"])
        self.assertTrue(step["unit"])
        self.solve(step["file"], "6.1")
        step = self.steps(6)["6.1"]
        self.assertEqual(step["status"], "passed")
        self.assertLessEqual(step["error"], step["limit"])
        self.assertEqual(self.steps(9)["9.1"]["status"], "failed", "another lab's")

    def test_where_a_mistake_is_known(self):
        self.solve(DECODE, "5.1")
        mutant = next(one for one in MISTAKES if one["name"] == "normal-green-flipped")
        text = (self.root / mutant["file"]).read_text(encoding="utf-8")
        if mutant["what"] not in text:
            self.skipTest("a tree of ./run mutants")
        (self.root / mutant["file"]).write_text(mutated(mutant, text), encoding="utf-8")
        step = self.steps(5)["5.1"]
        self.assertEqual([step[key] for key in ("status", "looks_like", "looks_like_says")], ["failed", mutant["name"], mutant["says"]])
        code, report = self.texel("check 5")
        self.assertEqual(code, 1)
        for words in ("This looks like: ", "wrong  5.1", "rawn by ", f"{DECODE}:"):  # "Drawn by llvmpipe", or "… are drawn by …"
            self.assertIn(words, report)
        # Git's other line endings make no other renderer of the one that is named.
        renderer = self.root / "labs/05_normal_map/expected/renderer.txt"
        renderer.write_bytes(renderer.read_bytes().partition(b"\n")[0] + b"\r\n")
        self.assertEqual(self.texel("check 5")[1], report)

    def test_in_any_order(self):
        """A step that was begun is told what is wrong with it, also while others come first, and can be checked by itself."""
        mirror, frame = (self.steps(9)[step]["file"] for step in ("9.4", "9.3"))
        texts = {file: (self.root / file).read_text(encoding="utf-8") for file in (mirror, frame)}
        backwards = texts[mirror].replace("return normal;", "return reflect(eye - position, normal);")
        with self.changed(mirror, backwards), self.changed(frame, texts[frame].replace("vec3(0.0, 1.0, 0.0), n", "vec3(0.0, 1.0, 0.0), -n")):
            report, alone, see = self.texel("check 9")[1], self.texel("check 9.4"), self.texel("see 9.4")[1]
            hint = self.texel("hint 9")[1]
        self.assertRegex(report, r"  waits  9\.3 .*\n +\S+frame\.glsl:\d+\n +tangent: Off by")
        for said in (report, alone[1], see):
            self.assertIn("This looks like: The reflected ray points into the ball", said)
        self.assertIn("  wrong  9.4", alone[1])
        self.assertNotIn("9.1", alone[1])
        self.assertEqual(alone[0], 1)
        self.assertIn("Step 9.4", hint, "the one that was begun, before the first that is not")
        with self.changed(mirror, solved((ROOT / mirror).read_text(encoding="utf-8"))):
            self.assertEqual(self.texel("check 9.4"), (0, mock.ANY))
        self.assertEqual([self.texel(f"check {place}")[0] for place in ("9.9", "9.", "12", "nine")], [2] * 4)

    def test_where_nine_of_ten_mistakes_in_shaders_get_their_name(self):
        """Of lab 9, on a build server of lab 5 too; ./run expected counts those of all labs, C++ too."""
        labs = ("5", "9") if tree.EXHAUSTIVE else ("9",)
        for folder in ("05_normal_map", "09_bump", "lib"):
            for file in pathlib.Path("shaders", folder).iterdir():
                (self.root / file).write_text(solved(file.read_text(encoding="utf-8")), encoding="utf-8")
        count = named = 0
        for mutant in tree.catalogue("mutants", "mutant"):
            lab = mutant["step"].partition(".")[0]
            text = (ROOT / mutant["file"]).read_text(encoding="utf-8")
            # In a tree of ./run mutants one does not apply; tree.catalogue finds it elsewhere.
            if lab not in labs or not mutant["file"].startswith("shaders/") or mutant["what"] not in text:
                continue
            with self.changed(mutant["file"], solved(mutated(mutant, text))):
                step = self.steps(lab)[mutant["step"]]
            if step["status"] == "passed":
                continue  # seen in hidden cases alone
            count += 1
            named += step["looks_like"] == mutant["name"]
            if step["looks_like"] != mutant["name"]:
                print(f"{mutant['name']} was called '{step['looks_like']}'")
        self.assertGreater(count, 15 if tree.EXHAUSTIVE else 7)
        self.assertGreaterEqual(named, 0.9 * count)

    def test_where_a_shader_does_not_compile(self):
        with self.changed(DECODE, (self.root / DECODE).read_text(encoding="utf-8") + "vec3 broken( {\n"):
            (code, report), (code_of_see, see) = self.texel("check 5"), self.texel("see 5.1")
        self.assertEqual(code, 1)
        self.assertIn(f"{DECODE}:", report)
        self.assertEqual(report.count("error: "), 1, "is said once")
        self.assertNotIn("see it:", report, "there is no picture")
        self.assertNotIn("decode_bumps", report, "it concerns all cases")
        self.assertEqual(code_of_see, 3)
        self.assertIn("error: ", see)

    def test_and_keeps_its_pictures_when_another_tree_is_checked(self):
        # The window shows a case's picture when it likes: by then another tree of the same build may be checked.
        picture = pathlib.Path(self.steps(9)["9.4"]["cases"][0]["picture"])
        before = picture.read_bytes()
        self.assertEqual(in_course("check 9")[0], 0)
        self.assertEqual(picture.read_bytes(), before)

    def test_where_markers_are_spoilt_and_pictures_missing(self):
        file = self.steps(9)["9.2"]["file"]
        before = (self.root / file).read_text(encoding="utf-8")
        head, _, tail = before.rpartition("//@end")
        with self.changed(file, head + tail):
            spoilt = [self.texel("check 9"), self.texel("reset 9.2")]
        # Without its first marker nobody knows where the step is.
        with self.changed(file, "//@todo\n" + before.replace("//@step 9.2 begin", "", 1)):
            (code, lost), progress, other = self.texel("check 9"), self.texel("progress"), self.texel("reset 9.1")
        (self.root / file).rename(self.folder / "away")
        renamed = self.texel("check 1")
        (self.folder / "away").rename(self.root / file)
        # The step is judged all the same, as the others are.
        self.assertLessEqual(max(code, spoilt[0][0]), 1)
        for said in (lost, spoilt[0][1]):
            self.assertIn("  9.3", said)
        self.assertIn("'//@step 9.2 begin' is missing", lost)
        self.assertEqual([progress[0], other[0], spoilt[1][0], renamed[0]], [0, 0, 3, 3])
        self.assertIn("is missing; it has steps", renamed[1])
        for _, said in spoilt:
            self.assertIn("step 9.2 has no '//@end'", said)
            self.assertIn(".glsl:", said)
        expected = self.root / "labs/07_environment/expected"
        expected.rename(self.folder / "expected")
        code, said = self.texel("check 7")
        (self.folder / "expected").rename(expected)
        self.assertEqual(code, 3)
        self.assertIn("expected pictures", said)
        self.assertEqual(self.texel("check 12")[0], 2)

    def test_again_after_each_save(self):
        output = self.root / "watch.txt"
        file = self.steps(8)["8.1"]["file"]

        def shows(text, times=1):
            """Waits a minute at most until the output has the text so many times, wherever its lines end."""
            for _ in range(600):
                said = output.read_text(errors="replace")
                if (said if "  " in text else re.sub(r"\s+", " ", said)).count(text) >= times:
                    return
                time.sleep(0.1)
            self.fail(f"'{text}' is not in {output.read_text(errors='replace')}")

        with open(output, "wb") as stream:
            watch = subprocess.Popen(shlex.split(f"env {self.line('watch 8')}"), stdin=subprocess.DEVNULL, stdout=stream, stderr=stream)
        self.addCleanup(watch.kill)
        shows("next   8.1")
        for step in ("8.1", "8.2"):
            self.solve(file, step)
            shows(f"done   {step}")
        before = (self.root / file).read_text(encoding="utf-8")
        # What passed is remembered: the step that changed is wrong, and not the one that it spoils.
        with self.changed(file, before.replace("incident - 2.0 *", "incident + 2.0 *", 1)):
            shows("It passed until you changed 8.1.")
            shows("wrong  8.1")
        shows("done   8.2", 2)
        # A marker that is gone is said, and the watch goes on.
        head, _, tail = before.rpartition("//@end")
        with self.changed(file, head + tail):
            shows("has no '//@end' of its own")
        shows("done   8.2", 3)
        watch.send_signal(signal.SIGINT)
        self.assertEqual(watch.wait(), 0)


class Helped(StudentTree):
    def test_by_a_picture_beside_the_expected_one(self):
        code, said = self.texel("see 6.2")
        self.assertEqual(code, 0, said)
        self.assertIn(str(self.root / "out/see/6.2.png"), said)

        def squares(rows):
            """The green of the three squares, with gaps of 6 pixels between them: yours, expected and difference."""
            rows, line = rows[:-28], rows[-28:]
            size = len(rows)
            self.assertEqual(len(rows[0]), 3 * (3 * size + 2 * 6))
            letters = [max(value for row in line for value in row[3 * n * (size + 6):][:3 * 30]) for n in range(3)]
            self.assertEqual(letters, [235] * 3)
            scale = line[14][3 * 2 * (size + 6):][3 * 32:3 * 128:3]
            self.assertGreater(scale[-1] - scale[0], 200)
            return [[value for row in rows for value in row[3 * n * (size + 6) + 1:3 * (n * (size + 6) + size):3]] for n in range(3)]

        yours, expected, difference = squares(read_rows(self.root / "out/see/6.2.png"))
        self.assertNotEqual(yours, expected)
        # These are no pictures of one colour.
        self.assertGreater(len(set(expected)), 10)
        self.assertGreater(max(difference), 200)
        # In the course's own tree nothing differs, or what renderers differ by: 1 step of 3, with a scale to 15.
        self.assertEqual(in_course(f"see 6.2 --out {self.folder}/solved.png")[0], 0)
        _, same, nothing = squares(read_rows(self.folder / "solved.png"))
        self.assertEqual(same, expected)
        self.assertLess(max(nothing), 30)
        self.assertEqual(self.texel("see 6.9")[0], 2)
        code, vertices = self.texel("see 4.1")
        self.assertEqual(code, 0)
        self.assertIn("./run lab 4", vertices)

    def test_within_eighty_columns(self):
        for command in ("check 6", "see 6.2", "hint 6.2", "predict 6.4", "progress"):
            for line in self.texel(command)[1].splitlines():
                self.assertTrue(len(line.encode()) <= 80 or str(self.root) in line, line)  # a path is not cut

    def test_by_the_reason_once_why_several_steps_wait(self):
        said = self.texel("check 8")[1]
        self.assertRegex(said, r"8\.2 .*: It needs 8\.1 first\.\n  waits  8\.3 [^:]*\n  waits  8\.4 .*: It needs 8\.1 and 8\.3 first\.")

    def test_by_a_question_before_the_step(self):
        code, said = self.texel("predict 9.4")
        self.assertEqual((code, said.count("Predict:"), "Right:" in said), (0, 1, False))
        answers = [self.texel(f"predict 9.4 {choice}") for choice in (1, 2, 3)]
        self.assertEqual(["Right:" in said for _, said in answers], [False, True, False])
        self.assertEqual(["No:" in said for _, said in answers], [True, False, True])
        self.assertEqual([self.texel(line)[0] for line in ("predict 9.4 4", "predict 9.9")], [2, 2])
        self.assertIn("./run predict 9.4", self.texel("check 9.4")[1])
        file = "shaders/09_bump/reflect_ray.glsl"
        with self.changed(file, solved((ROOT / file).read_text(encoding="utf-8"))):
            self.assertIn("9.4: The ball mirrors as if it were bumpy.", self.texel("check 9.4")[1])

    def test_by_one_hint_after_the_other(self):
        shown = BUILD / "check/hints.json"
        shown.unlink(missing_ok=True)
        first, second = self.texel("hint 2.2"), self.texel("hint 2.2")
        self.assertEqual(first[0], 0)
        self.assertEqual(["hint 1 of " in said for _, said in (first, second)], [True, True])
        self.assertEqual(["hint 2 of " in said for _, said in (first, second)], [False, True])
        shown.write_text("{ broken")
        self.assertIn("hint 1 of ", self.texel("hint 2.2")[1])
        code, said = self.texel("hint 5.99")
        self.assertEqual(code, 2)
        self.assertIn("5.99", said)
        self.assertEqual(self.texel("hint five")[0], 2)

    def test_by_a_reset_that_keeps_what_was_written(self):
        steps = self.steps(9)
        self.solve(self.steps(6)["6.1"]["file"], "6.1")
        self.solve(steps["9.1"]["file"], "9.1")
        name = steps["9.2"]["file"]
        file = self.root / name
        first = file.read_text(encoding="utf-8")
        self.assertIn("already has its starting code", self.texel("reset 9.2")[1])
        self.solve(name, "9.2")
        own = file.read_text(encoding="utf-8")
        self.assertNotEqual(own, first)
        for kept in (".before-reset", ".before-reset-2"):  # a second time, nothing is written over
            file.write_text(own, encoding="utf-8")
            code, said = self.texel("reset 9.2")
            self.assertEqual(code, 0, said)
            self.assertEqual(file.read_text(encoding="utf-8"), first)
            self.assertEqual((self.root / (name + kept)).read_text(encoding="utf-8"), own)
        # What is kept beside the file is no other step: what is written now is a mistake, and not "Not begun".
        untouched = "This step is still as the starter has it. "
        self.assertTrue(self.steps(9)["9.2"]["message"].startswith(untouched))
        with self.changed(name, first.replace("//@step 9.2 begin\n", "//@step 9.2 begin\n  int a_new_attempt;\n", 1)):
            self.assertFalse(self.steps(9)["9.2"]["message"].startswith(untouched))

    def test_by_the_progress_in_all_labs(self):
        code, said = self.texel("progress")
        self.assertEqual(code, 0, said)
        # The programs are built with all steps: what is to do is in shaders.
        for words in ("  1-.....  2##-#  3#####  4####", " of 42 steps: ", "\nnext: 1.1 ", "What is left takes about 1",
                      *(f"{lab['number']}  {lab['title']}" for lab in LABS)):
            self.assertIn(words, said)
        # Where one stopped is a step that was begun, in any lab.
        with self.changed(DECODE, (self.root / DECODE).read_text(encoding="utf-8").replace("return color;", "return 2.0 * color;")):
            self.assertIn("\nyou were at: 5.1 ", self.texel("progress")[1])


class Built(StudentTree):
    """./run in a tree whose build does what a test says."""

    ALL = "build texel: phony\nbuild lab05_normal_map: phony\nbuild labs/all: phony\nbuild tools/all: phony\n"

    def setUp(self):
        self.build = self.root / "build/release"
        (self.build / "bin").mkdir(parents=True)
        self.addCleanup(shutil.rmtree, self.root / "build", ignore_errors=True)
        for program in ("texel", "lab05_normal_map"):
            (self.build / "bin" / program).symlink_to(BIN / program)
        self.is_configured_for(self.root)

    def is_configured_for(self, folder):
        (self.build / "CMakeCache.txt").write_text(f"CMAKE_HOME_DIRECTORY:INTERNAL={folder}\n")

    def run_with(self, ninja, arguments, before=":"):
        """The exit code and what ./run says; `before` is a line of shell in the same folder."""
        (self.build / "build.ninja").write_text("rule r\n command = $does\n" + ninja)
        return shell(f"cd {self.root} && {before} && TEXEL_NO_APT=1 TEXEL_ROOT={self.root} ./run {arguments} 2>&1")

    def test_names_the_form_of_a_command_before_it_builds(self):
        for typed, says in (("watch", "./run watch 1"), ("reset 1", "./run reset 5.1"), ("see 1", "./run see 5.1")):
            code, said = shell(f"{self.root}/run {typed}")
            self.assertEqual(code, 2, said)
            self.assertIn(says, said)

    def test_says_why_it_fails(self):
        for ninja, says in (
                ("build texel: r\n does = exit 1\n", "does not say why: exit 1"),
                ("build texel: r\n does = echo cc1plus is killed; exit 1\n", "cc1plus is killed"),
                (f"build texel: r {self.root}/gone.cpp\n", "'gone.cpp', needed by 'texel', missing"),
                ("build texel: r gone.cpp\n", "type: ./run build"),
                ("build other: phony\n", "unknown target"),
                # Of two errors one is shown.
                ("build texel: phony x y\nbuild x: r\n does = echo error: e; exit 1\nbuild y: r\n does = echo error: e; exit 1\n", "error: e")):
            code, said = self.run_with(ninja + "build lab05_normal_map: phony\n", "check 5")
            self.assertEqual(code, 3, said)
            self.assertIn(says, said)
            self.assertEqual("does not say why" in said, "does not say why" in says, said)
        shutil.rmtree(self.root / "build")
        (self.root / "build").write_text("")  # no folder can be made there
        self.addCleanup((self.root / "build").unlink)
        code, said = shell(f"{self.root}/run check 5")
        self.assertEqual(code, 3, said)
        self.assertIn("cannot write build/release/build.lock", said)

    def test_is_made_anew_in_a_tree_that_was_copied(self):
        self.is_configured_for(self.root.parent)
        cmake = self.root / "build/cmake"
        cmake.write_text('#!/bin/sh\necho "asked $*"\nexit 1\n')
        cmake.chmod(0o700)
        code, said = self.run_with(self.ALL, "check 5", "export PATH=$PWD/build:$PATH")
        self.assertEqual(code, 3, said)
        self.assertIn("asked --fresh --preset release", said)

    def test_waits_for_another_and_says_for_whom(self):
        # The other one builds until ./run says that it waits.
        other = ("(flock build/release/build.lock sh -c 'printf \"the window of lab 5\" >build/release/build.lock; touch build/held; "
                 "for i in $(seq 600); do grep -qs waiting build/said && break; sleep 0.05; done; touch build/done' &) && "
                 "while [ ! -e build/held ]; do sleep 0.05; done && exec >build/said")
        code, _ = self.run_with("build texel: r\n does = ls ../../build/done\nbuild lab05_normal_map: phony\n", "check 5", other)
        self.assertLessEqual(code, 1)
        said = (self.root / "build/said").read_text()
        self.assertIn("waiting for another build: the window of lab 5", said)
        self.assertIn("Lab 5: ", said)

    def test_takes_no_copy_for_a_lab(self):
        mine, copy = self.root / "labs/10_mine", self.root / "labs/05_a_copy"
        mine.mkdir()
        shutil.copytree(self.root / "labs/05_normal_map", copy)
        fifth = self.run_with("build texel: phony\nbuild lab05_normal_map: phony\n", "check 5")
        tenth, progress = self.run_with(self.ALL, "check 10"), self.run_with(self.ALL, "progress")
        shutil.rmtree(mine)
        shutil.rmtree(copy)
        self.assertIn("labs/05_a_copy is a copy of this lab", fifth[1])
        self.assertEqual((tenth[0], progress[0]), (2, 0))
        self.assertIn("there is no lab 10", tenth[1])
        self.assertIn("labs/05_a_copy is a copy of lab 5", progress[1])

    def test_gives_a_picture_where_the_display_is_gone(self):
        picture = self.root / "out/see/5.1.png"
        for gone in ("export DISPLAY=:997", "unset DISPLAY && export WAYLAND_DISPLAY=wayland-997"):
            picture.unlink(missing_ok=True)
            code, said = self.run_with(self.ALL, "see 5.1", gone)
            self.assertEqual(code, 0, said)
            self.assertIn("cannot open a window", said)
            self.assertNotIn("--snapshot", said)
            self.assertTrue(picture.exists())
        self.assertEqual(self.run_with(self.ALL, "see 5.1 --out here.png")[0], 0)
        (self.root / "here.png").unlink()


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
