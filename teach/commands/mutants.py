#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes each small wrong change of the catalogue in a copy of the tree, and checks that the tests notice it.

Exit codes: 0 at least 95 % are caught, 1 fewer, 2 wrong usage, 3 a mutant does not apply or compile, or nothing can be measured."""
import argparse
import contextlib
import difflib
import filecmp
import hashlib
import json
import math
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import time
import tomllib
from xml.etree import ElementTree

WANTED = 95  # per cent
SECONDS = 120  # for a test: the slowest one of a lab takes 12 on a free machine
QUICK = 1.5  # seconds: such tests run together
LEFT_OUT = {".git", ".cache", "build", "out"}  # what is made from the rest, and what is not the tree's
PAGE, STORE = "docs/mutants.md", "docs/mutants.json"  # written after each mutant
LIBRARIES = {"common/core", "common/params", "common/image", "teach/procedural"}  # assets and what must not compile use these


class Failure(Exception):
    """What ends the program, and its exit code."""

    def __init__(self, text, code=3):
        super().__init__(text)
        self.code = code


# ---- The catalogue and the copy.

def read_catalogue(folder):
    """The mutants of all files, each a dictionary; one of [[equivalent]] is right."""
    mutants = []
    for file in sorted(folder.glob("*.toml")):
        tables = tomllib.loads(file.read_text(encoding="utf-8"))
        for kind in ("mutant", "equivalent"):
            mutants += [{"survives": "", **one, "is_right": kind == "equivalent", "place": file} for one in tables.get(kind, [])]
    if not mutants:
        raise Failure(f"{folder}: holds no mutants; name another catalogue")
    return mutants


def applied(mutant, text):
    """The text of the mutant's file with its change."""
    if (count := text.count(mutant["what"])) != 1:
        how = "occurs more than once in" if count else "is not in"
        raise Failure(f"{mutant['place']}: '{mutant['name']}' does not apply: its text {how} {mutant['file']}")
    return text.replace(mutant["what"], mutant["by"])


def files_below(folder):
    files = []
    for path, folders, names in os.walk(folder):
        if path == str(folder):
            folders[:] = [name for name in folders if name not in LEFT_OUT]
        files += [os.path.relpath(os.path.join(path, name), folder) for name in names if os.path.isfile(os.path.join(path, name))]
    return sorted(files)


def copy_tree(root, copy):
    """Makes the copy as the tree is now. Files that are the same are left alone: little is built again."""
    wanted = files_below(root)
    copy.mkdir(parents=True, exist_ok=True)
    for file in set(files_below(copy)) - set(wanted):
        (copy / file).unlink()
    for file in wanted:
        if not (copy / file).exists() or not filecmp.cmp(root / file, copy / file, shallow=False):
            (copy / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(root / file, copy / file)


def state_of(root):
    """A text that stands for all paths and contents, but for those that are written after each mutant."""
    state = hashlib.sha256()
    for file in files_below(root):
        if file not in (PAGE, STORE):
            state.update(file.encode() + b"\0" + (root / file).read_bytes() + b"\0")
    return state.hexdigest()[:16]


# ---- Which tests may notice a change, and in which order they are asked.

def lab_of(folder):
    """5 of shaders/05_normal_map; 0 for a folder that is no lab's."""
    found = re.match(r"(\d\d)_", folder.name)
    return int(found[1]) if found else 0


def subjects_of(tree, file):
    """What a test's key has that is about the file, the nearest first."""
    labs = [lab_of(file.parent)] if lab_of(file.parent) else []
    if file.parent == pathlib.PurePath("shaders/lib"):
        labs = sorted({lab_of(shader.parent) for shader in tree.glob("shaders/[0-9]*/*")
                       if f'"lib/{file.name}"' in shader.read_text(encoding="utf-8")})
    if labs:
        return [rf"lab_?0*({'|'.join(map(str, labs))})(?![0-9])"]
    if file.parts[0] not in ("common", "teach"):
        return []
    program = f"unit_{file.parts[1]} "
    # "unit_mesh tangentmethods.…" is about common/mesh/tangents.cpp. Pages are tested in JavaScript.
    own = [program + "[^.]*" + file.stem.removesuffix("s"), program]
    pages = [" web[._]"] if file.parts[1] in ("reports", "web") else []
    return pages + own if file.suffix == ".js" else own + pages


def order_of(test, tree, file):
    """When the test runs after a change of the file: (rank, pace), or None where it has no part in it."""
    subjects = subjects_of(tree, file)
    is_of_libraries = test["name"].startswith(("assets.", "compile_fail."))
    if is_of_libraries and str(file.parent) not in LIBRARIES:
        return None
    # What draws nothing never sees a shader; and no test that is named after one lab runs another.
    if file.parts[0] == "shaders" and re.fullmatch(r"unit_(?!app$).*", test["target"]):
        return None
    if lab_of(file.parent) and not re.search(subjects[0], test["key"]) and re.search("lab_?0*[1-9]", test["key"]):
        return None
    rank = next((i for i, subject in enumerate(subjects) if re.search(subject, test["key"])), len(subjects))
    if is_of_libraries or test["name"].startswith("window."):
        rank = len(subjects) + 1
    return rank, max(0, math.ceil(math.log2(max(test["seconds"], 1e-3) / QUICK)))


# ---- The tests of a tree: a CMake project with a preset `release`, built in build/release.

def short(name):
    return name.partition("  #")[0]  # without what GoogleTest adds for a parameter


class Suite:
    def __init__(self, tree, logs):
        self.tree, self.logs, self.tests = tree, logs, []
        logs.mkdir(parents=True, exist_ok=True)

    def shell(self, line, log):
        return subprocess.run(f"{line} >{shlex.quote(str(log))} 2>&1", shell=True, cwd=self.tree, check=False).returncode

    def build(self, targets, log):
        of = " ".join(["--target", *sorted(targets)]) if targets else ""
        return self.shell(f"cmake --build build/release --parallel {os.cpu_count()} {of}", log) == 0

    def prepare(self):
        # A mutant may well leave a variable unused: that is no reason not to build.
        options = "-B build/release -D TEXEL_TESTS=ON -D TEXEL_WARNINGS_AS_ERRORS=OFF"
        if self.shell(f"cmake --preset release {options}", self.logs / "configure.log") != 0:
            raise Failure(f"{self.logs / 'configure.log'}: cmake failed; see its log")
        if not self.build((), self.logs / "build.log"):
            raise Failure(f"{self.logs / 'build.log'}: the tree does not build; see the log")

    def run(self, numbers, xml, log):
        """Runs tests; {name: (seconds, ctest's word: run, fail, …)}."""
        xml.unlink(missing_ok=True)
        # The driver's cache of compiled shaders would keep what other mutants compiled; TEXEL_ROOT would name another tree. One more runs at
        # a time than there are processors: the tests of windows and pages mostly wait.
        self.shell(f"env -u TEXEL_ROOT MESA_SHADER_CACHE_DISABLE=true ctest --test-dir build/release -I 0,0,0,"
                   f"{','.join(map(str, numbers))} --parallel {os.cpu_count() + 1} --timeout {SECONDS} --output-on-failure "
                   f"--output-junit {shlex.quote(str(xml))}", log)
        if not xml.exists():
            raise Failure(f"{log}: ctest failed; see its log")
        return read_junit(xml)

    def measure(self, state, right):
        """Runs each test of behaviour in the tree with all changes that change nothing, unless that was done in a tree of this state. A test
        that fails there and not without them would notice anything."""
        listed = subprocess.run(["ctest", "--test-dir", "build/release", "--show-only=json-v1"], cwd=self.tree, capture_output=True,
                                check=False).stdout
        for number, entry in enumerate(json.loads(listed)["tests"], 1):
            command = entry.get("command", [""])  # none: it is not built
            built = [word for word in command if pathlib.PurePath(word).parent == self.tree / "build/release/bin"]
            program = pathlib.PurePath((built or command)[0])
            labels = [label for one in entry.get("properties", []) if one["name"] == "LABELS" for label in one["value"]]
            self.tests.append({"number": number, "name": entry["name"], "key": f"{program.name} {entry['name']}".lower(),
                               "target": program.name if built else "",
                               "is_used": not {"tree", "class", "exhaustive"} & set(labels), "seconds": 0})
        numbers = {test["name"]: test["number"] for test in self.tests if test["is_used"]}
        xml, store = self.logs / "unchanged.xml", self.logs / "unchanged.json"
        known, runs = json.loads(store.read_text(encoding="utf-8")) if store.exists() else ("", {})
        if known != state:
            print(f"running the tests once, with {len(right)} changes that change nothing", flush=True)
            with self.changed(right):
                if not self.build((), self.logs / "build.log"):
                    raise Failure(f"{self.logs / 'build.log'}: what changes nothing does not compile; see the log")
                runs = self.run(numbers.values(), xml, self.logs / "unchanged.log")
                runs |= self.again(runs, numbers)  # on a busy machine a test may fail once
            if failed := self.failing(runs):
                self.prepare()
                if noticed := [short(name) for name in sorted(set(failed) - set(self.failing(self.again(runs, numbers))))]:
                    raise Failure(f"what changes nothing ({', '.join(one['name'] for one in right)}) is noticed: {'; '.join(noticed)}; tests of "
                                  "sources, build or documents need the label tree (TREE in tests/CMakeLists.txt)")
            store.write_text(json.dumps([state, runs]), encoding="utf-8")
        for test in self.tests:
            if not test["is_used"]:
                continue
            test["seconds"], word = runs.get(test["name"], (0, ""))
            test["is_used"] = word == "run"
            if word == "fail":
                print(f"mutants: {short(test['name'])} fails even without a mutant and is left out", file=sys.stderr)
        if not any(test["is_used"] for test in self.tests):
            raise Failure(f"{self.logs / 'unchanged.log'}: no test passes in the unchanged tree")

    def again(self, runs, numbers):
        """How those of these tests that failed do once more."""
        failed = [numbers[name] for name in self.failing(runs)]
        return self.run(failed, self.logs / "again.xml", self.logs / "again.log") if failed else {}

    @staticmethod
    def failing(runs):
        return [name for name, (_, word) in runs.items() if word == "fail"]

    @contextlib.contextmanager
    def changed(self, mutants):
        """The tree with all these changes, from here to the end of the block."""
        texts = {}
        try:
            for mutant in mutants:
                file = self.tree / mutant["file"]
                texts.setdefault(file, file.read_text(encoding="utf-8"))
                file.write_text(applied(mutant, file.read_text(encoding="utf-8")), encoding="utf-8")
            yield
        finally:
            for file, text in texts.items():
                file.write_text(text, encoding="utf-8")

    def judge(self, file, name, catchers):
        """("caught", "survived" or "broken", the tests that failed): those that noticed it last time are asked first, then those that are likely
        to."""
        stages = {}
        for test in self.tests:
            order = order_of(test, self.tree, pathlib.PurePath(file))
            if short(test["name"]) in catchers:
                order = (-1, *(order or (sys.maxsize, 0)))
            if test["is_used"] and order:
                stages.setdefault(order, []).append(test)
        log = self.logs / f"{name}.log"
        for _, tests in sorted(stages.items()):
            targets = {test["target"] for test in tests}
            if not self.build(() if "" in targets else targets, log):
                return "broken", ["it does not compile"]
            runs = self.run([test["number"] for test in tests], self.logs / "mutant.xml", log)
            failed = sorted(map(short, self.failing(runs)))
            text = log.read_text(errors="replace")
            if failed and file.startswith("shaders/") and re.search(rf"{re.escape(pathlib.PurePath(file).name)}:\d+:\d+: error:", text):
                return "broken", ["it does not compile"]
            if failed:
                return "caught", failed
        return "survived", []


def read_junit(file):
    """{name: (seconds, ctest's word)}."""
    return {case.get("name"): (float(case.get("time")), case.get("status")) for case in ElementTree.parse(file).iter("testcase")}


# ---- Results.

def score(results):
    """(caught, sound, survivors for a reason, broken) of those that are wrong."""
    wrong = [one for one in results if not one["is_right"] or one["fate"] == "broken"]
    broken = sum(one["fate"] == "broken" for one in wrong)
    return (sum(one["fate"] == "caught" for one in wrong), len(wrong) - broken,
            sum(one["fate"] == "survived" and bool(one["survives"]) for one in wrong), broken)


def score_text(results):
    caught, sound, explained, _ = score(results)
    # Rounded down: it never says 95 % where the limit is missed.
    return f"{caught} of {sound} caught ({100 * caught // max(sound, 1)} %); {explained} survive for a reason"


def table(title, head, rows):
    """A table of Markdown, or nothing."""
    if not rows:
        return ""
    lines = ["| " + " | ".join(str(cell).replace("\n", " ").replace("|", "\\|") for cell in row) + " |\n" for row in rows]
    return f"\n## {title}\n\n| {' | '.join(head)} |\n|{'---|' * len(head)}\n" + "".join(lines)


def markdown(results, catalogue, state):
    wrong = [one for one in results if not one["is_right"]]
    folders = sorted({str(pathlib.PurePath(one["file"]).parent) for one in wrong})
    scores = [(folder, score([one for one in wrong if str(pathlib.PurePath(one["file"]).parent) == folder])) for folder in folders]
    tests = sorted({test for one in results if one["fate"] == "caught" for test in one["by"]})
    alone = [(test, sum(one["by"] == [test] for one in results), sum(test in one["by"] for one in results)) for test in tests]
    unchanged = [f"- {one['name']} ({one['file']}): survived\n"
                 for one in results if one["is_right"]]

    def of_fate(fate, title, column):
        return table(title, ("mutant", "file", "what it does wrong", column),
                     [(one["name"], one["file"], one["says"], one["survives"] if fate == "survived" else "; ".join(one["by"]))
                      for one in wrong if one["fate"] == fate])

    sample = "These are all mutants of the catalogue." if len(wrong) >= catalogue else f"This is a sample: the catalogue has {catalogue} mutants."
    earlier = sum(one["tree"] != state for one in wrong)
    trees = f"{earlier} of these results are of an earlier state of the tree." if earlier else "All are of one tree."
    return ("# Mutants\n\nWritten by `./run mutants`, which [CONTRIBUTING.md](../CONTRIBUTING.md#mutants) explains.\n\n"
            f"{score_text(results)}. {sample} {trees}\n"
            + table("By folder", ("folder", "mutants", "caught", "survive for a reason"), [(folder, of[1], of[0], of[2]) for folder, of in scores])
            + ("\n## Changes that change nothing\n\n" + "".join(unchanged) if unchanged else "")
            + of_fate("broken", "Broken", "why") + of_fate("survived", "Survivors", "why that is right")
            + table("Tests that caught what no test beside them did", ("test", "alone", "in all"), [row for row in alone if row[1] > 0]))


def change_of(mutant):
    """A text that stands for the change that a mutant makes."""
    return hashlib.sha256("\0".join((mutant["file"], mutant["what"], mutant["by"])).encode()).hexdigest()[:8]


class Record:
    """The last result of each mutant, in a file that goes with the tree from one machine to another; and the page that is made of it."""

    def __init__(self, root, catalogue):
        self.page, self.store = root / PAGE, root / STORE
        self.mutants = {one["name"]: one for one in catalogue}
        rows = json.loads(self.store.read_text(encoding="utf-8")) if self.store.exists() else []
        # Of a mutant that is another one now nothing is known.
        self.rows = {row["name"]: row for row in rows if row["name"] in self.mutants and row["change"] == change_of(self.mutants[row["name"]])}

    def is_known(self, name, state):
        return name in self.rows and self.rows[name]["tree"] == state and self.rows[name]["fate"] != "broken"

    def catchers(self, name):
        return set(self.rows[name]["by"]) if name in self.rows else set()

    def result(self, name):
        """With what the catalogue says."""
        return {**self.mutants[name], **self.rows[name]}

    def add(self, name, state, fate, by):
        self.rows[name] = {"name": name, "change": change_of(self.mutants[name]), "tree": state, "fate": fate, "by": by}
        known = [name for name in self.mutants if name in self.rows]  # in the catalogue's order
        self.write(self.store, "[\n" + ",\n".join(json.dumps(self.rows[name], ensure_ascii=False) for name in known) + "\n]\n")
        self.write(self.page, markdown([self.result(name) for name in known], sum(not one["is_right"] for one in self.mutants.values()), state))

    @staticmethod
    def write(file, text):
        file.parent.mkdir(parents=True, exist_ok=True)
        file.with_suffix(".part").write_text(text, encoding="utf-8")
        file.with_suffix(".part").replace(file)


def try_mutant(suite, mutant, catchers):
    """Makes a mutant and asks the tests: its fate, and by what."""
    try:
        with suite.changed([mutant]):
            return suite.judge(mutant["file"], mutant["name"], catchers)
    except (Failure, OSError) as error:
        return "broken", [str(error)]


def chosen(catalogue, only, every):
    wrong = [mutant for mutant in catalogue if not mutant["is_right"]]
    # The name of a file stands for the names in it.
    names = [name for word in only for name in (pathlib.Path(word).read_text().split() if os.path.isfile(word) else [word])]
    known = {mutant["name"] for mutant in wrong}
    for name in names:
        if name not in known:
            near = difflib.get_close_matches(name, known, 1)
            raise Failure(f"there is no mutant '{name}'; " + (f"did you mean '{near[0]}'?" if near else "the catalogue is tests/mutants"), 2)
    return [mutant for mutant in wrong if mutant["name"] in names] if names else wrong[::every]


def outcome(result):
    if result["fate"] == "survived":
        return "survives for a reason" if result["survives"] else "SURVIVED"
    return ("caught by " if result["fate"] == "caught" else "BROKEN: ") + "; ".join(result["by"])


def main():
    root = pathlib.Path(__file__).resolve().parents[2]
    parser = argparse.ArgumentParser(prog="./run mutants", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", type=lambda text: text.split(","), default=[], help="names with commas, or a file with names")
    parser.add_argument("--every", type=int, default=1, help="only each so many-th, as a sample")
    parser.add_argument("--resume", action="store_true", help="keep what was found in this very tree")
    parser.add_argument("--root", type=pathlib.Path, default=root, help="the tree [this one]")
    parser.add_argument("--catalogue", type=pathlib.Path, help="folder of the mutants [tests/mutants]")
    parser.add_argument("--work", type=pathlib.Path, help="folder for the copy, its build and the logs [build/mutants]")
    given = parser.parse_args()
    root, work = given.root.resolve(), (given.work or given.root / "build/mutants").resolve()
    if work.is_relative_to(root) and work.relative_to(root).parts[:1] and work.relative_to(root).parts[0] not in LEFT_OUT:
        raise Failure(f"the work folder {work} is part of the tree; choose one outside, or below its build folder", 2)
    if given.every < 1:
        raise Failure("--every takes a number from 1", 2)
    catalogue = read_catalogue(given.catalogue or root / "tests/mutants")
    mutants = chosen(catalogue, given.only, given.every)

    print(f"copying the tree into {work / 'tree'} and building it", flush=True)
    copy_tree(root, work / "tree")
    state, suite = state_of(root), Suite(work / "tree", work / "logs")
    suite.prepare()
    right = [mutant for mutant in catalogue if mutant["is_right"]]
    suite.measure(state, right)
    record = Record(root, catalogue)
    for mutant in right:
        record.add(mutant["name"], state, "survived", [])
    results, begin, made = [], time.monotonic(), 0
    # Those of which nothing is known come first: a call that is cut off has the most to tell.
    for place, mutant in enumerate(sorted(mutants, key=lambda one: one["name"] in record.rows), 1):
        began, is_known = time.monotonic(), given.resume and record.is_known(mutant["name"], state)
        if not is_known:
            record.add(mutant["name"], state, *try_mutant(suite, mutant, record.catchers(mutant["name"])))
        results.append(record.result(mutant["name"]))
        made += not is_known
        left = (time.monotonic() - begin) / max(made, 1) * (len(mutants) - place) / 60
        took = "known" if is_known else f"{time.monotonic() - began:.0f} s"
        print(f"{place:3}/{len(mutants)} {mutant['name']:<32} {outcome(results[-1])} ({took}; {left:.0f} min left)", flush=True)
    for one in results:
        if one["fate"] == "survived":
            print(f"survived: {one['name']} ({one['file']}): {one['survives'] or 'the catalogue gives no reason'}")
    impossible = [one for one in results if one["fate"] == "caught" and one["survives"]]
    for one in impossible:
        print(f"caught by {'; '.join(one['by'])}: {one['name']} ({one['file']}), of which the catalogue says: {one['survives']}")
    caught, sound, _, broken = score(results)
    print(f"{score_text(results)}; {made} took {(time.monotonic() - begin) / 60:.0f} min")
    if broken:
        raise Failure(f"{broken} mutants do not apply or do not compile; correct the catalogue in tests/mutants")
    return 0 if 100 * caught >= WANTED * sound and not impossible else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (Failure, OSError, tomllib.TOMLDecodeError) as error:
        print(f"mutants: {error}", file=sys.stderr)
        sys.exit(getattr(error, "code", 3))
