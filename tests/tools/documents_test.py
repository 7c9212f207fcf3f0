#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs every command that a document shows, as it is typed: in the course's tree what its makers type, in a starter what its students
type. And checks that the files that it names are there. documents_test.py BUILD DOCUMENT"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import tree

ROOT = pathlib.Path.cwd()
BUILD, DOCUMENT = (pathlib.Path(word) for word in sys.argv[1:])
BIN = BUILD / "bin"
TEXEL = str(BIN / "texel")
FILES = {
    "looks.json": '[{"name": "brick", "size": "64x64", "set": {"texture": "brick"}}]',
    "seed.txt": "a seed of the course\n",
    "roster.csv": "id,sis,name\nada,s1,Ada\n",
    "due.csv": "lab,due\n5,2026-11-20T23:59+01:00\n",
    "times.csv": "id,submitted\nada,2026-11-21T12:00+01:00\n",
    "out/lab1/class.csv": "name,id,number,lab 1\nAda,ada,,6\n",
    "out/lab5/class.csv": "name,id,number,lab 5\nAda,ada,,6\n",
}
# What of a lab's options opens no window.
WITHOUT_WINDOW = r"--(snapshot|stats|mesh|measure|batch|bench|help|list-parameters|list-views|frames|save-config)\b"


def commands_of(text):
    """The commands of a document: lines of its blocks of shell, and code within its text; without remarks."""
    lines, prose, in_block = [], [], False
    for line in text.splitlines():
        if "```" in line:
            in_block = not in_block
        else:
            (lines if in_block else prose).append(line)
    lines += re.findall(r"`([^`]+)`", " ".join(prose))
    commands = {line.partition("  #")[0].strip() for line in lines}
    return sorted(one for one in commands if re.fullmatch(r"(\./run|texel|build/release/bin/\w+)( .*)?", one))


class Runner:
    """Runs commands in a folder beside the tree: what they write shall not land in it."""

    def __init__(self, folder):
        self.work, self.starter, self.benched = folder / "work", folder / "starter", None
        self.work.mkdir()
        for name in ("assets", "docs", "labs"):
            (self.work / name).symlink_to(ROOT / name)
        for name in ("right.png", "mine.png"):
            shutil.copy(ROOT / "docs/pictures/01_texture_quad.png", self.work / name)
        for name, text in FILES.items():
            (self.work / name).parent.mkdir(parents=True, exist_ok=True)
            (self.work / name).write_text(text)
        self.help = self.shell(f"{ROOT}/run help")[1]

    def shell(self, line):
        done = subprocess.run(line, shell=True, cwd=self.work, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        return done.returncode, done.stdout.decode(errors="replace")

    def as_student(self, line):
        if not self.starter.exists():
            code, said = self.shell(f"{TEXEL} starter --out {self.starter}")
            assert code == 0, said
        return self.shell(f"TEXEL_ROOT={self.starter} {line}")

    def lab(self, number, rest):
        if not re.search(WITHOUT_WINDOW, rest):
            rest += " --size 64x64 --snapshot document.png"
        return self.shell(f"{BIN}/lab{int(number):02}_*{rest}")

    def course(self, line):
        if "classroom" in line:
            self.as_student("true")  # makes the starter beside this folder
        if "similar" in line:
            (self.work / "CLASS/ada").mkdir(parents=True, exist_ok=True)
            if not shutil.which("sim_c"):
                return 0, ""
        line = "course --help" if line == "course NAME" else line.replace("../my-labs", "../starter")
        return self.shell(f"{TEXEL} {line}")

    def other(self, command):
        line = re.sub(r"^(build/release/bin/|(?=texel ))", f"{BIN}/", command)
        # Minutes for one lab.
        line = re.sub(r"(renderers --mutants).*", r"\1" if tree.HOURS else r"renderers --help", line)
        # One lab's is a share of it: the starter that the grader's tests have built.
        if "--verify" in line:
            line += f" --cache {BUILD}/grade" if "--labs 9" in line or tree.HOURS else " --help"
        return self.shell(line)

    def is_right(self, command):
        """Whether the command does what it promises, and what it said."""
        if found := re.fullmatch(r"\./run lab (\d+)(.*)", command):
            code, said = self.lab(*found.groups())
        elif found := re.fullmatch(r"\./run ((check|hint|predict|reset|progress)( .*)?)", command):
            code, said = self.as_student(f"{TEXEL} {found[1]}")
            code = 0 if code == 1 else code  # a step is not right
        elif found := re.fullmatch(r"\./run (watch \d+)", command):
            code, said = self.as_student(f"timeout --signal=INT 1 {TEXEL} {found[1]} </dev/null")
            return "Save a file" in said or code == 124, said
        elif re.fullmatch(r"\./run bench( [1-9])?", command):
            # The measuring itself is tested by accuracy.*; this has the same page made of what was measured, of one lab.
            self.benched = self.benched or self.shell(f"TEXEL_ROOT={ROOT} {TEXEL} bench 7 --from docs/accuracy.json --out bench")
            code, said = self.benched
        elif found := re.fullmatch(r"(?:\./run|texel) (course .*)", command):
            code, said = self.course(found[1])
        elif found := re.fullmatch(r"(?:\./run|texel) (grade .*)", command):
            # Whole classes are graded in grade_test; here what it is told is understood, and only the class is missing.
            code, said = self.shell(f"{TEXEL} {found[1]}")
            return code != 2, said
        elif found := re.fullmatch(r"\./run(?: (\S+).*)?", command):
            # What sets up, tests or renews the whole tree is what continuous integration and its makers run.
            return f"./run {found[1] or ''}" in self.help, self.help
        elif found := re.fullmatch(r"texel( \w+)?( --verify)?", command):
            # The name alone; all of the starter is verified by grade_test's WholeCourse.
            code, said = self.shell(f"{TEXEL}{found[1] or ''} --help")
        else:
            code, said = self.other(command)
        return code == 0, f"exit code {code}: {said}"


def is_in_tree(name):
    """A folder or file of the tree, or one without its ending, or a room's header without include/ROOM."""
    path = pathlib.Path(name)
    return "/NN_" in name or any(one.exists() for one in (path, path.with_name(path.name + ".cpp"),
                                                          path.parent / "include" / path.parent.name / path.name))


def missing_files(text):
    """What the document links or names as code, and is not there."""
    links = [a or b for a, b in re.findall(r"\]\(([^):#]+)|src=\"([^\"]+)", text)]
    named = re.findall(r"`((?:common|labs|shaders|tests|teach|tools|web)/[\w./]+)`", text)
    return ([link for link in links if link != "https" and not (DOCUMENT.parent / link).exists()] +
            [name for name in named if not is_in_tree(name)])


def main():
    text = DOCUMENT.read_text(encoding="utf-8")
    # One document makes a lab that is not there.
    faults = [f"names {name}, which is not there" for name in missing_files(text)] if DOCUMENT.stem != "adding_a_lab" else []
    # What visitors see first fits the column of a code host.
    blocks = re.findall(r"```\w*\n(.*?)```", text, re.DOTALL) if DOCUMENT.parent == pathlib.Path() else []
    faults += [f"has a block wider than 80 columns: {line}" for block in blocks for line in block.splitlines() if len(line) > 80]
    commands = commands_of(text)
    if not commands:
        faults.append("shows no command")
    with tempfile.TemporaryDirectory(prefix="texel_document_") as folder:
        runner = Runner(pathlib.Path(folder))
        for command in commands:
            is_right, said = runner.is_right(command)
            if not is_right:
                faults.append(f"'{command}' fails: {said}")
    for fault in faults:
        print(f"{DOCUMENT}: {fault}")
    return 1 if faults else 0


sys.exit(main())
