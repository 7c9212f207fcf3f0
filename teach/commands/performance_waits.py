# SPDX-License-Identifier: MIT
"""What people wait for in this tree and in an earlier commit's: a student for the first ./run, and from a save to the verdict; who changes the
course for its tests."""
import itertools
import pathlib
import shlex
import shutil
import time

from course import ROOT, Failure, captured
from performance_report import interleaved, output_of


def run_in(tree, arguments, most_code=0, environment=""):
    """Milliseconds of `./run …` in a tree. It ends with at most this exit code. `environment` is as env takes it."""
    begin = time.perf_counter()
    ran = captured("sh", "-c", f"cd {shlex.quote(str(tree))} && env TEXEL_NO_APT=1 {environment} ./run {arguments}")
    if ran.returncode > most_code:
        raise Failure(f"{tree}: ./run {arguments} failed: {ran.stdout}")
    return 1e3 * (time.perf_counter() - begin)


def first_run(tree, cache):
    """Milliseconds of `./run` with nothing built, and nothing in the compiler's cache."""
    for folder in (tree / "build", tree / "out", cache):
        shutil.rmtree(folder, ignore_errors=True)
    return run_in(tree, "", 0, f"CCACHE_DIR={shlex.quote(str(cache))}")


def edit(file, number):
    """A line that was never compiled, so that the compiler's cache does not have it, at the end of a file."""
    mark = "\n// edited: "
    line = f"const float edited_{number} = 0.0;"
    if file.suffix == ".cpp":
        line = f"namespace {{ [[maybe_unused]] constexpr int edited_{number} = 0; }}"
    file.write_text(f"{file.read_text(encoding='utf-8').partition(mark)[0]}{mark}\n{line}\n", encoding="utf-8")


def commit_of(tree):
    return output_of("git", "-C", tree, "rev-parse", "--short", "HEAD").strip()


class Tested:
    """A course's tree as its last commit has it, with a compiler's cache of its own that starts empty."""

    def __init__(self, course, tree):
        self.tree, self.cache = tree, tree.with_name(f"{tree.name}_cache")
        output_of("git", "clone", "--quiet", course, tree)

    def run(self, arguments=""):
        """The tests have their own display, and the driver's cache as ./run sets it."""
        return run_in(self.tree, f"test {arguments}", 0,
                      f"--unset=DISPLAY --unset=MESA_SHADER_CACHE_DISABLE CCACHE_DIR={shlex.quote(str(self.cache))}")

    def run_of_changed_lab(self, number):
        edit(self.tree / "labs/05_normal_map/lab.cpp", number)
        return self.run("5")


class Starter:
    """A starter that a course's tree made."""

    def __init__(self, course, tree):
        self.tree = tree
        output_of(pathlib.Path(course) / "build/release/bin/texel", "starter", "--out", tree)

    def save_to_verdict(self, files, number):
        """Of the first of the files that this tree has: an older one may have the step elsewhere."""
        edit(next(self.tree / file for file in files if (self.tree / file).exists()), number)
        return run_in(self.tree, "check 5", 1)

    def lines_of_cpp(self):
        files = [file for file in self.tree.rglob("*.?pp") if "build" not in file.relative_to(self.tree).parts]
        return sum(file.read_bytes().count(b"\n") for file in files)


def measure_waits(setting, report):
    if setting.first_run_before:
        report.begin("The first ./run", f"""
            In clones of this tree and of the earlier commit {commit_of(setting.first_run_before)}, and in their starters, in
            turn: with nothing built, nothing in the compiler's cache, all packages installed.""", "now", "before")
        cache = setting.work / "cache"
        now, before = Tested(ROOT, setting.work / "clone_now").tree, Tested(setting.first_run_before, setting.work / "clone_before").tree
        report.add("the course's", "ms", interleaved(setting.long_rounds, lambda: first_run(now, cache), lambda: first_run(before, cache)),
                   at_most=0.6, why="""
            most of it compiles, files that nobody edits seven at a time. The solution is graded by the programs that were
            just built, and the compiler's cache has most objects of the starter.""")
        now, before = Starter(ROOT, setting.work / "now"), Starter(setting.first_run_before, setting.work / "before")
        report.add("C++ in a student's tree", "lines", [(now.lines_of_cpp(), before.lines_of_cpp())], at_most=0.75, why="""
            `.starter` counts, which has the files with steps as they were at first. `tests/rooms.py` counts by folder.""")
        report.add("a student's", "ms", interleaved(setting.long_rounds, lambda: first_run(now.tree, cache),
                                                     lambda: first_run(before.tree, cache)), at_most=0.75, why="""
            nearly all of it compiles. Files that nobody edits are compiled seven at a time. What waits for
            files and people is compiled with `-Og`, for which GCC 12 needs 0.68 of the time of `-O2`, as for `-O0`; what goes through
            every pixel or vertex with `-O3`. `std::regex` is in one file alone. We tried to instantiate the JSON
            library only once: that costs 10 s and saves 9.""")
    if not setting.saves_before:
        return
    report.begin("From a save to the verdict", f"""
        `./run check 5` in starters of this tree and of the earlier commit {commit_of(setting.saves_before)}, in turn, after a
        save of a file.""",
                 "now", "before")
    now, before = Starter(ROOT, setting.work / "saved_now"), Starter(setting.saves_before, setting.work / "saved_before")
    edits = itertools.count()
    for starter in (now, before):
        run_in(starter.tree, "build")
    for files, target, why in (
            (("shaders/05_normal_map/decode_normal.glsl",), 1, "`texel check` takes two thirds of it."),
            (("labs/05_normal_map/lab.cpp",), 0.71, "It is compiled with few optimisations and with precompiled headers."),
            (("labs/05_normal_map/triangle_frame.cpp", "common/mesh/tangents.cpp"), 0.5, "It is a small file, and the lab alone is linked.")):
        report.add(files[0], "ms", interleaved(setting.rounds, lambda: now.save_to_verdict(files, next(edits)),
                                               lambda: before.save_to_verdict(files, next(edits))), at_most=target, why=why)


def measure_tests(setting, report):
    if not setting.saves_before:
        return
    report.begin("The tests", f"""
        `./run test` in clones of this commit and of the earlier commit {commit_of(setting.saves_before)}, once each, with nothing
        built, nothing in the compiler's cache, all packages installed; and `./run test 5` in the same clone after a line was added
        to lab 5's `lab.cpp`.""", "now", "before")
    now, before = Tested(ROOT, setting.work / "tests_now"), Tested(setting.saves_before, setting.work / "tests_before")
    from_nothing = before.run()
    # 480 s were wanted of a machine on which the earlier commit's took 939 to 1,070.
    report.add("./run test", "ms", [(now.run(), from_nothing)], at_most=0.5, why="""
        more than half are the tests, the rest compiles. A third of the tests' processor time are windows and whole classes, which are
        drawn and compiled.""")
    report.add("./run test 5, beside all from nothing", "ms", [(now.run_of_changed_lab(i), from_nothing) for i in range(setting.long_rounds)],
               at_most=0.05)
