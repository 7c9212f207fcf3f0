# SPDX-License-Identifier: MIT
"""`texel grade` beside drawing alone, and what a large class takes."""
import concurrent.futures
import itertools
import os
import shutil
import sqlite3
import time
import tomllib

from course import BIN, ROOT, Failure, captured, labs_option, read_labs
from performance_report import interleaved, output_of, time_of

SEED = "a seed of no course"
ONE_OF = 10  # steps has a mistake
CLASS, MACHINES = 1000, 16  # students and machines of which the report speaks
STUDENTS = 6  # who are graded for that


def mistakes(folders=("mutants", "mistakes")):
    """What students may do wrong in a step, as the catalogues have it."""
    files = [file for folder in folders for file in sorted((ROOT / "tests" / folder).glob("*.toml"))]
    return [one for file in files for one in tomllib.loads(file.read_text(encoding="utf-8")).get("mutant", []) if one.get("step")]


def mistaken(texts, mistake):
    """The files of a student who made a mistake too."""
    text = texts[mistake["file"]]
    if text.count(mistake["what"]) != 1:
        raise Failure(f"the mistake '{mistake['name']}' does not apply to {mistake['file']}")
    return texts | {mistake["file"]: text.replace(mistake["what"], mistake["by"])}


class Solution:
    """The files with steps of a student who solved all."""

    def __init__(self, setting):
        self.tree = setting.work / "solved"
        if not self.tree.exists():
            steps = ",".join(step["id"] for lab in read_labs() for step in lab["step"])
            output_of("texel", "starter", "--out", self.tree, "--solve", steps)
        files = [file for folder in ("common", "labs", "shaders") for file in sorted((self.tree / folder).rglob("*")) if file.is_file()]
        texts = {str(file.relative_to(self.tree)): file.read_bytes().decode(errors="replace") for file in files}
        self.texts = {file: text for file, text in texts.items() if "//@step " in text}

    @staticmethod
    def hand_in(folder, texts, comment, endings):
        """Writes a student's files. A comment makes those with these endings new to the grader."""
        for file, text in texts.items():
            (folder / file).parent.mkdir(parents=True, exist_ok=True)
            (folder / file).write_text(text + (f"// {comment}\n" if file.endswith(endings) else ""), encoding="utf-8")


def grade(setting, students, labs, *arguments):
    """Milliseconds that grading a class takes, with its reports."""
    out = setting.work / "grades"
    shutil.rmtree(out, ignore_errors=True)
    (setting.work / "seed").write_text(SEED, encoding="utf-8")
    begin = time.perf_counter()
    ran = captured(BIN / "texel", "grade", students, "--out", out, *labs_option(labs), "--seed-file", setting.work / "seed", *arguments)
    if ran.returncode:
        raise Failure(f"the class is not graded: {ran.stdout}")
    return 1e3 * (time.perf_counter() - begin)


def check_grades(setting, students, wrong):
    """As many students lost points as made the mistake. Where all made it, none of their own pictures is right."""
    with sqlite3.connect(setting.work / "grades/results.sqlite") as store:
        cases = store.execute("SELECT student, status = 'passed', judged = 'alone' FROM cases").fetchall()
    right, failed = sum(passed and not alone for _, passed, alone in cases), {student for student, passed, _ in cases if not passed}
    if not cases or (wrong == 0 and right != len(cases)) or (wrong == students and right):
        raise Failure(f"{right} of {len(cases)} cases are right")
    if len(failed) != wrong:
        raise Failure(f"{len(failed)} of {students} students lost points, and {wrong} are to")


def add_grading(setting, report, what, lab, target, size, changes=()):
    """A class of `size` students, of which the first made a change each."""
    solution, students, drawn = Solution(setting), setting.work / "class", setting.work / "drawn"
    shutil.rmtree(students, ignore_errors=True)
    for i in range(size):
        tree = students / f"student_{i}"
        shutil.copytree(ROOT / "shaders", tree / "shaders")
        texts = mistaken(solution.texts, changes[i]) if i < len(changes) else solution.texts
        solution.hand_in(tree, texts, f"student {i}", (".glsl",))
        (tree / "assets").symlink_to(ROOT / "assets")
    (setting.work / "seed").write_text(SEED, encoding="utf-8")
    output_of("texel", "cases", "batch", "--labs", lab, "--seed", SEED, "--out", setting.work / "batches")
    batch = next((setting.work / "batches").glob(f"{lab:02}_*.json"))
    count = size * batch.read_text(encoding="utf-8").count('"name"')

    def draw(i):
        variables = {"LP_NUM_THREADS": "0", "TEXEL_THREADS": "1", "TEXEL_ROOT": str(students / f"student_{i}")}
        time_of(f"lab{batch.stem}", "--samples", 1, "--batch", batch, "--out", drawn / f"student_{i}", variables=variables)

    def draw_all():
        begin = time.perf_counter()
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            list(pool.map(draw, range(size)))
        return 1e3 * (time.perf_counter() - begin)

    pairs = interleaved(setting.long_rounds, lambda: grade(setting, students, [lab]), draw_all)
    report.add(f"{what}, {count} cases", "ms", pairs, at_most=target)
    check_grades(setting, size, len(changes))


class TenthOfStepsWrong:
    """A class that made a mistake in every tenth step of some labs. All texts are new in each run, as a class's are: nothing is compiled
    before."""

    def __init__(self, setting, labs, students):
        self.setting, self.labs, self.students, self.solution = setting, labs, students, Solution(setting)
        self.steps, self.runs = [step["id"] for lab in read_labs(labs) for step in lab["step"]], itertools.count()
        # Of those that change the course's file where a student's has nothing, there is another one.
        first = {one["step"]: one for one in reversed(mistakes()) if self.solution.texts.get(one["file"], "").count(one["what"]) == 1}
        places = [(student, step) for student in range(students) for step in self.steps]
        self.made = [(student, first[step]) for student, step in places[::ONE_OF]]

    def grade(self, *arguments):
        """Milliseconds. The first run makes what a course does once."""
        folder, run = self.setting.work / "tenth", next(self.runs)
        shutil.rmtree(folder, ignore_errors=True)
        for student in range(self.students):
            texts = self.solution.texts
            for mistake in [mistake for who, mistake in self.made if who == student]:
                texts = mistaken(texts, mistake)
            self.solution.hand_in(folder / f"student_{student}", texts, f"student {student} of class {run} in {self.setting.work.name}", ("",))
        return grade(self.setting, folder, self.labs, "--cache", self.setting.work / f"cache_{len(self.labs)}", *arguments)

    def __str__(self):
        return f"{self.students} students, {len(self.made)} mistakes in {self.students * len(self.steps)} steps"


def add_judged_alone(setting, report):
    """Judged with each step that fails once more alone, beside judged without."""
    made = TenthOfStepsWrong(setting, [1, 5, 8], 4)
    made.grade()
    report.add(f"labs 1, 5 and 8, {made}", "ms", interleaved(setting.long_rounds, made.grade, lambda: made.grade("--judge-once")), at_most=1.3,
               names=("failed steps once more alone", "judged once"))


def add_course(setting, report):
    """What a large class takes, from a small one. Students are graded apart, so twice as many take twice as long."""
    made = TenthOfStepsWrong(setting, list(range(1, 10)), STUDENTS)
    first, again = made.grade() / 1e3, made.grade() / 1e3
    once, hours = max(0, first - again), again / STUDENTS * CLASS / 3600
    minutes = (hours * 3600 / MACHINES + once) / 60
    report.note(f"""
        **{CLASS} students of nine labs**: {made}, all C++ new, took {again:.0f} s on {os.cpu_count()} processors: {again /
        STUDENTS:.0f} s a student. So {CLASS} students take {hours:.1f} hours on this machine, and {minutes:.0f} minutes on
        {MACHINES} such machines (`--shard`), which share nothing while they grade. What a course does once took {once:.0f} s; it
        takes longer where the compiler's cache does not have the starter.""")


def measure_grading(setting, report):
    report.begin("Grading beside drawing", """
        `texel grade` with its reports over a class whose shaders are right, or some or all of them wrong; beside as many
        `--batch` that draw the same cases, one for each processor at a time. Each step that fails is drawn again, alone, unless
        it has the solution's code; the last row has that beside drawing once. What a course does once (starter, references, the
        pictures of known mistakes) is done before. Before `grade` compared known mistakes by their samples, the class of lab 5
        took 1.49 and 1.51 times as long.""", "grade", "batches")
    turned = {"name": "turned", "file": "shaders/01_texture_quad/texture_quad.vert", "what": "fragment_texcoord = texcoord *",
              "by": "fragment_texcoord = 1.3 * texcoord.ts *"}
    of_lab_5 = [one for one in mistakes(["mutants"]) if one["step"].startswith("5.") and one["file"].endswith(".glsl") and "same" not in one]
    add_grading(setting, report, "lab 1, 8 students, all right", 1, 1.3, 8)
    add_grading(setting, report, "lab 9, 8 students, all right", 9, 1.3, 8)
    add_grading(setting, report, "lab 1, 8 students, all wrong", 1, 2.2, 8, [turned] * 8)
    add_grading(setting, report, "lab 5, 24 students, 10 with a mistake each", 5, 1.5, 24, list(itertools.islice(itertools.cycle(of_lab_5), 10)))
    add_judged_alone(setting, report)
    add_course(setting, report)
