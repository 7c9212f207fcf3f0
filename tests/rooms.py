#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Counts the lines of C++ by room, and checks the rules of docs/architecture.md that a compiler does not.

Exit codes: 0 all hold, 1 one is broken, 3 the tree cannot be read."""
import collections
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIMITS = {"all": 50_000, "tests": 15_100, "starter": 21_000, "a room": 3_600}  # lines of C++
ROOMS = ("common", "teach")  # each folder below these is a library with a namespace of its own
WITHHELD = ("teach", "tests")
LANGUAGES = {"Python": ["*.py", "teach/commands/scripts/*"], "JavaScript": ["*.js", "*.mjs"], "GLSL": ["*.glsl", "*.vert", "*.frag"],
             "Bash": ["*.sh", "*.bash", "run", ".ci/run"], "Markdown": ["*.md"], "TOML": ["*.toml"]}  # counted, without a limit
# What others declare is defined by who starts the labs, on a desktop and on a page.
ELSEWHERE = ("common/start/run.cpp", "teach/web/engine/source/")


def sources(*names):
    """{path: text} of all files with these endings."""
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z", *names], capture_output=True, text=True, check=False)
    if listed.returncode != 0:
        sys.exit(f"rooms.py: git lists no files in {ROOT}: {listed.stderr.strip()}")
    paths = [path for path in listed.stdout.split("\0") if path and (ROOT / path).exists()]
    return {path: (ROOT / path).read_text(encoding="utf-8") for path in paths}


def room_of(path):
    """teach/grade of teach/grade/include/grade/grader.hpp; "" for a file outside of all rooms."""
    parts = path.split("/")
    return "/".join(parts[:2]) if parts[0] in ROOMS and len(parts) > 2 else ""


def code(text):
    """The text without comments and strings."""
    return re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', "", text, flags=re.S)


def without_solutions(text):
    """A file as a starter has it; twice if it has steps, since .starter keeps it as it was at first."""
    given = re.sub(r"(//@step [^\n]* begin\n).*?^[^\n]*//@starter\n", r"\1", text, flags=re.S | re.M)
    return given if given == text else given * 2


def line_faults(files):
    def count(keep, shown=str):
        return sum(shown(text).count("\n") for path, text in files.items() if keep(path))

    rooms = sorted({room_of(path) for path in files} - {""})
    figures = [("all", count(lambda path: True), "all"), ("tests", count(lambda path: path.startswith("tests/")), "tests"),
               ("starter", count(lambda path: not path.startswith(tuple(f"{folder}/" for folder in WITHHELD)), without_solutions), "starter")]
    figures += [(room, count(lambda path, room=room: room_of(path) == room), "a room") for room in rooms]
    for name, lines, _ in figures:
        print(f"{lines:7} {name}")
    return [f"{name} has {lines} lines of C++, more than its limit of {LIMITS[limit]}: remove some, or raise LIMITS and say why"
            for name, lines, limit in figures if lines > LIMITS[limit]]


def step_faults(files):
    """What a student edits lies in labs and shaders, and nowhere else."""
    return [f"{path} has a step; steps are written in labs/NN_name and shaders/NN_name" for path, text in files.items()
            if not path.startswith(("labs/", "tests/")) and re.search(r"^\s*//@step", text, flags=re.M)]


def namespace_faults(files):
    """A namespace is its folder's name."""
    faults = []
    for path, text in files.items():
        room, lab = room_of(path), re.search(r"\d\d_(\w+)", path)  # an answer is a part of its lab
        names = {room.split("/")[-1], lab and lab[1]} | ({"mesh"} if path.startswith("labs/") else set())  # which declares steps
        is_held = (room or path.startswith("labs/")) and not path.startswith(ELSEWHERE)
        for name in re.findall(r"^namespace texel::(\w+)", text, flags=re.M) if is_held else []:
            if name not in names:
                faults.append(f"{path} is in namespace {name}; a namespace has its folder's name")
    return faults


# A function's declaration or definition begins a line.
FUNCTION = re.compile(r"^(?!return\b|using\b|else\b|static_assert\b|#)[A-Za-z\[][\w:<>,&*\[\] ]*?[ &*>](?:\w+::)*(\w+)\(", re.M)


def caller_faults(files):
    """Nothing in a room's headers has tests as its only callers."""
    times, declared = collections.Counter(), collections.Counter()
    for path, text in files.items():
        if not path.startswith("tests/"):
            times.update(re.findall(r"\w+", code(text)))
            declared.update(FUNCTION.findall(code(text)))
    return [f"{path} declares {name}, which nothing but tests calls; it belongs to tests/support"
            for path, text in files.items() if room_of(path) and "/include/" in path
            for name in sorted(set(FUNCTION.findall(code(text)))) if times[name] <= declared[name]]


def main():
    files = sources("*.cpp", "*.hpp")
    for language, names in LANGUAGES.items():
        print(f"{sum(text.count(chr(10)) for text in sources(*names).values()):7} {language}")
    faults = line_faults(files) + step_faults(files) + namespace_faults(files) + caller_faults(files)
    for fault in faults:
        print(f"rooms.py: {fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
