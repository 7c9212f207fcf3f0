#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes a class folder whose grades are known: make_class.py BIN --out DIR --labs 8,9 --kinds … [--limit N] [--threats N], for the tree it lies in.

  entries          what they hand in                                     what must come out

  solution-N       everything solved                                     full marks
  starter-N        nothing solved                                        0
  steps-9.2        everything up to step 9.2 solved                      exactly these steps pass
  mutant-NAME      the solution with one of tests/mutants                its step alone fails, and is named
  mistake-NAME     the same, with one for each step; and some more       its step alone fails
  equivalent-NAME  the solution with one of tests/equivalents            full marks
  threat-NAME      the solution with one of tests/threats, hostile files 0 on what it fakes
  slow-NAME        the same, from tests/threats/slow.toml                0 on what it fakes
  broken-NAME      an archive that is none, or is hostile                0

Folders, zips and tarballs mix, some named as Canvas and Moodle do. Beside the folder comes DIR.json: for each student's id the entry's
kind and name, and what must come out: `passes`, the steps that must have full marks while no other passes; `zero`, the steps that must
score 0; `fails`, a step that must not pass; `mistake`, its name; `fault`, that nothing can be read."""
import argparse
import io
import json
import os
import pathlib
import re
import stat
import subprocess
import sys
import tarfile
import zipfile

import tree

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Mistakes on which many other steps build: name, step, file, what, by.
SPREADING = [
    ("decodes-to-minus-0.9", "5.1", "shaders/05_normal_map/decode_normal.glsl", "color * 2.0 - 1.0", "color * 2.0 - 0.9"),
    ("draws-nothing", "5.7", "labs/05_normal_map/normal_matrix.cpp", "glm::transpose(glm::inverse(glm::mat3(world_from_object)))",
     "(std::exit(1), glm::mat3(world_from_object))"),
    ("reflects-with-a-wrong-sign", "8.1", "shaders/08_reflection/rays.glsl", "incident - 2.0 *", "incident + 2.0 *")]
# Names that mean something to a page, a table or a shell: of files in an archive, and of archives.
FILE_NAMES = [b"<script>texel_threat()</script>.txt", b"\"><img src=x onerror=texel_threat()>", b"=cmd|' !A0.txt",
              b"$(touch texel_threat_was_here).txt", b"`touch texel_threat_was_here`", b"-rf", b"a\nb.txt", b"a\tb.txt", b"[[ATTACHMENT|x]]",
              b"\xff\xfe.txt", b"]]>.txt"]
ENTRY_NAMES = [b"<script>texel_threat()<script>", b"\"><img src=x onerror=texel_threat()>", b"'; touch texel_threat_was_here; '",
               b"$(touch texel_threat_was_here)", b"`touch texel_threat_was_here`", b"=HYPERLINK(\"x\",\"y\")", b"+1", b"@SUM(A1)", b"-rf",
               b"--out=x", b"a,\"b\",c", b"a\nb", b"a\rb\tc", b"[[ATTACHMENT|x]]", b"\xff\xfe", b"\xe2\x80\xaetxt.exe", b"a b  c", b"%s%n",
               b"x" * 200]
# Folders with names in other encodings than the grader's; the first three are UTF-8, and their zips say so.
FOLDER_NAMES = ["\u00dcbung 9 \u2013 L\u00f6sung".encode(), "\u4f5c\u4e1a\u4e5d".encode(), "final \U0001F642".encode(),
                b"\x9abung 9 - L\x94sung", b"\xd7\xf7\xd2\xb5"]


# ---- Archives. Names are text as Python has those of files: bytes that are no UTF-8 are surrogates.

class RawName(zipfile.ZipInfo):
    """A file of a zip whose name is written byte by byte, with or without the sign that it is UTF-8."""
    is_utf8 = False

    def _encodeFilenameFlags(self):  # pylint: disable=invalid-name
        return os.fsencode(self.filename), self.flag_bits | (0x800 if self.is_utf8 else 0)


def zip_of(files, links=None, is_utf8=False):
    """A zip of files, and of links by where they point."""
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for kind, entries in ((stat.S_IFREG | 0o644, files), (stat.S_IFLNK | 0o777, links or {})):
            for path, content in entries.items():
                info = RawName(path)
                info.is_utf8, info.external_attr, info.create_system = is_utf8, kind << 16, 3
                archive.writestr(info, content, zipfile.ZIP_DEFLATED)
    return packed.getvalue()


def tar_of(files, mode="w:gz", kind=tarfile.REGTYPE):
    """A tarball of files, or of links to what stands in place of their contents."""
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode=mode) as archive:
        for path, content in files.items():
            info = tarfile.TarInfo(path)
            info.type = kind
            if kind == tarfile.REGTYPE:
                info.size = len(content.encode())
            elif kind in (tarfile.SYMTYPE, tarfile.LNKTYPE):
                info.linkname = content
            archive.addfile(info, io.BytesIO(content.encode()))
    return packed.getvalue()


def write_folder(folder, files):
    for path, text in files.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text, encoding="utf-8")


def some_of(items, count):
    """At most so many of a list, from all over it."""
    count = min(count, len(items))
    return [items[i * len(items) // count] for i in range(count)]


def shown(name):
    """A name as texel prints it: each byte of what cannot be shown is U+FFFD."""
    return re.sub("[\x00-\x1f\x7f-\x9f\u200e\u200f\u2028-\u202e]", lambda found: "\ufffd" * len(found[0].encode()),
                  os.fsencode(name).decode(errors="replace"))


def code_of(text):
    """What of a text is code."""
    return re.sub(r"\s", "", re.sub(r"//[^\n]*", "", text))


class ClassMaker:
    def __init__(self, out, labs, limit=sys.maxsize, threats=sys.maxsize):
        self.out, self.labs, self.limit, self.threats, self.expected = pathlib.Path(out).resolve(), labs, limit, threats, {}
        if self.out.exists() and any(self.out.iterdir()):
            sys.exit(f"make_class: '{out}' holds something already; name a new folder")
        self.out.mkdir(parents=True, exist_ok=True)
        os.chdir(ROOT)
        texts = {str(file): file.read_text(encoding="utf-8") for folder in ("labs", "shaders")
                 for file in sorted(pathlib.Path(folder).rglob("*")) if file.suffix in (".cpp", ".glsl", ".vert", ".frag")}
        # The course's own, with both parts of each step.
        self.sources = {file: text for file, text in texts.items() if re.search(r"^\s*//@step", text, re.MULTILINE)}
        self.order = [step["id"] for lab in tree.labs() for step in lab["step"]]
        self.asked = [step for step in self.order if self.is_asked(step)]

    def is_asked(self, step):
        return int(step.split(".")[0]) in self.labs

    def student_files(self, solved, changed=None):
        """What a student has who solved these steps; `changed` stands for files of the course."""
        return {path: tree.with_steps((changed or {}).get(path, text), solved) for path, text in self.sources.items()}

    def solution(self, changed=None):
        return self.student_files(lambda step: True, changed)

    def starter(self):
        return self.student_files(lambda step: False)

    def all(self):
        return {"passes": self.asked}

    def nothing(self):
        return {"passes": [], "zero": self.asked}

    def unreadable(self):
        return {**self.nothing(), "fault": True}

    # ---- Entries.

    def expect(self, entry, kind, name, outcome):
        self.expected[shown(entry)] = {"entry": shown(entry), "kind": kind, "name": shown(name), **outcome}

    def put(self, kind, name, files, outcome):
        """An entry in one of the forms."""
        entry = f"{kind}-{name}"
        # By the name alone, so that a student has the same id in every class.
        turn = 0
        for byte in entry.encode():
            turn = (turn * 31 + byte) % 9973
        if turn % 5 == 0:
            write_folder(self.out / entry, files)
        elif turn % 5 == 1:
            entry += ".zip"
            (self.out / entry).write_bytes(zip_of(files))
        elif turn % 5 == 2:
            entry += ".tar.gz"
            (self.out / entry).write_bytes(tar_of(files))
        elif turn % 5 == 3:  # Canvas
            entry = re.sub("[-.]", "", entry) + f"_{1000 + turn}_{5000 + turn}_labs.zip"
            (self.out / entry).write_bytes(zip_of({f"my labs/{path}": text for path, text in files.items()}))
        else:  # Moodle
            entry += f"_{1000 + turn}_assignsubmission_file"
            (self.out / entry).mkdir()
            (self.out / entry / "labs.zip").write_bytes(zip_of(files))
        self.expect(entry, kind, name, outcome)

    def put_file(self, kind, entry, data, outcome):
        (self.out / entry).write_bytes(data)
        self.expect(entry, kind, entry, outcome)

    # ---- Kinds.

    def make_solution(self):
        for name in "123":
            self.put("solution", name, self.solution(), self.all())

    def make_starter(self):
        for name in "12":
            self.put("starter", name, self.starter(), self.nothing())

    def make_prefix(self):
        for step in some_of(self.asked[:-1], self.limit):  # with the last step it is the solution
            solved = self.order[:self.order.index(step) + 1]
            self.put("steps", step, self.student_files(lambda one, solved=solved: one in solved),
                     {"passes": [one for one in self.asked if one in solved], "zero": [one for one in self.asked if one not in solved]})

    def fitting(self, folder):
        """What a student can make of a catalogue who is graded in these labs."""
        return [{**one, "is_right": kind == "equivalent"} for kind in ("mutant", "equivalent") for one in tree.catalogue(folder, kind)
                if one["file"] in self.sources and one["step"] and self.is_asked(one["step"])]

    def make_mutant(self):
        self.put_changed(some_of(self.fitting("mutants"), self.limit), "mutant")

    def make_equivalent(self):
        self.put_changed(some_of(self.fitting("equivalents"), self.limit), "equivalent")

    def make_mistake(self):
        first = {}
        for one in self.fitting("mutants"):
            first.setdefault(one["step"], one)
        more = [dict(zip(("name", "step", "file", "what", "by"), one), is_right=False) for one in SPREADING if self.is_asked(one[1])]
        self.put_changed(some_of([*first.values(), *more], self.limit), "mistake")

    def changed(self, change, by):
        """The solution with a change of its catalogue."""
        text = self.sources[change["file"]]
        assert text.count(change["what"]) == 1, change
        return self.solution({change["file"]: text.replace(change["what"], by)})

    def put_changed(self, chosen, kind):
        for change in chosen:
            files, step, file = self.changed(change, change["by"]), change["step"], change["file"]
            outcome = self.all()
            if not change["is_right"]:
                outcome = {"passes": [one for one in self.asked if one != step], "fails": step}
                # Some mistakes are called as a mutant that draws the same.
                outcome |= {"mistake": change["name"]} if kind == "mutant" else {}
                given, own = ([code_of(part) for one, part in tree.step_parts(text) if one == step]
                              for text in (self.starter()[file], files[file]))
                if given == own:  # what the starter has there already is called that
                    outcome = {"zero": [step], "untouched": step}
            self.put(kind, change["name"], files, outcome)

    def make_threat(self, kind="threat"):
        asked = pathlib.Path("tests/threats/asked.hpp").read_text(encoding="utf-8")
        asked_for = [threat for threat in tree.catalogue("threats", "threat") if (pathlib.Path(threat["place"]).stem == "slow") == (kind == "slow")
                     and self.is_asked(threat["step"] or re.search(r"/0*(\d+)_", threat["file"])[1])]
        for threat in some_of(asked_for, self.threats):
            by = threat["by"].replace("@ASKED@", asked).replace("@ROOT@", str(ROOT)).replace("@CLASS@", str(self.out))
            files = self.changed(threat, by)
            outcome = {"zero": [threat["step"]]}
            if not threat["step"]:  # steps of other files are judged among the solution's
                own = {step for step, _ in tree.step_parts(files[threat["file"]])}
                outcome = {"zero": [one for one in self.asked if one in own], "passes": [one for one in self.asked if one not in own]}
            self.put(kind, threat["name"], files, outcome)

    def make_slow(self):
        self.make_threat("slow")

    def make_files(self):
        """Links, other files than those of the labs, and names that mean something to a page, a table or a shell."""
        for path in self.sources:
            (self.out / "files-links" / path).parent.mkdir(parents=True, exist_ok=True)
            (self.out / "files-links" / path).symlink_to(ROOT / path)
        (self.out / "files-linked-folders").mkdir()
        for folder in ("common", "labs", "shaders"):
            (self.out / "files-linked-folders" / folder).symlink_to(ROOT / folder)
        (self.out / "files-link").symlink_to(ROOT)
        for name in ("links", "linked-folders", "link"):
            self.expect(f"files-{name}", "files", name, self.unreadable())

        mark = f"{self.out}/texel_threat_was_here"
        cmake = f"cmake_minimum_required(VERSION 3.20)\nexecute_process(COMMAND sh -c \"touch '{mark}'\")\nfile(TOUCH \"{mark}\")\n"
        files = self.starter()
        for path in ("CMakeLists.txt", "labs/CMakeLists.txt", "labs/07_environment/CMakeLists.txt", "common/CMakeLists.txt",
                     "cmake/texel_targets.cmake", "cmake/texel_dependencies.cmake", "labs/09_bump/CMakeLists.txt"):
            files[path] = cmake
        files |= {"CMakePresets.json": "{}", "build.ninja": f"rule x\n command = touch {mark}\nbuild all: x\n",
                  "Makefile": f"all:\n\ttouch {mark}\n", "run": f"#!/bin/sh\ntouch {mark}\n",
                  "labs/07_environment/lab.toml": "lab = \"07_environment\"\n", "labs/09_bump/lab.toml": "lab = \"09_bump\"\n",
                  "common/core/include/core/error.hpp": "#error taken\n", "shaders/09_bump/bump.frag": "#error taken\n",
                  "results.sqlite": "1", "seed.txt": "1"}
        self.put("files", "build-files", files, self.nothing())

        files = self.solution() | {os.fsdecode(name): "x" for name in FILE_NAMES}
        for i, name in enumerate(ENTRY_NAMES):
            is_sound = i % 8 == 0
            self.put_file("files", os.fsdecode(name) + ".zip", zip_of(files) if is_sound else b"nothing that can be read",
                          self.all() if is_sound else self.unreadable())
        for i, name in enumerate(FOLDER_NAMES):
            below = {f"{os.fsdecode(name)}/{path}": text for path, text in self.solution().items()}
            below["n" * 256 + ".cpp"] = "// nobody asked for this\n"
            self.put_file("files", f"files-folder-{i}.zip", zip_of(below, is_utf8=i < 3), self.all())

        # A file that does not link costs its own steps, and no others of its lab.
        tangents = "labs/05_normal_map/triangle_frame.cpp"
        files = self.solution()
        files[tangents] += "int missing_function();\nint unlinked = missing_function();\n"
        own = [step for step in self.asked if f"//@step {step} begin" in files[tangents]]
        self.put("files", "does-not-link", files, {"zero": own} if own else self.all())

        # One name, two students: each keeps their own work.
        write_folder(self.out / "Jane Doe", self.solution())
        self.expect("Jane Doe", "files", "one-name", self.all())
        self.put_file("files", "jane doe.tar.gz", tar_of(self.solution()), self.all())
        for entry in ("Jane Doe.zip", "Jane Doe_77_assignsubmission_file_labs.zip"):
            self.put_file("files", entry, zip_of(self.starter()), self.nothing())
        self.put_file("files", "Jane Doe_78_assignsubmission_file_labs.zip", zip_of(self.solution()), self.all())

    def make_broken(self):
        files, links = self.solution(), {path: str(ROOT / path) for path in self.sources}
        whole_zip, whole_tar = zip_of(files), tar_of(files)
        bomb = {"bomb": "\0" * (64 << 20), **files}
        for name, data in {"cut.zip": whole_zip[:len(whole_zip) // 2],
                           "cut.tar.gz": whole_tar[:len(whole_tar) // 2],
                           "empty.zip": b"",
                           "empty.tar.gz": b"",
                           "text.zip": b"I could not get it to work, sorry.\n",
                           "essay.docx": b"My solution",
                           "without-files.zip": zip_of({}),
                           "bomb.zip": zip_of(bomb),
                           "bomb.tar.gz": tar_of(bomb),
                           "archive-in-archive.zip": zip_of({"labs.zip": whole_zip}),
                           "many.zip": zip_of({f"{i}.txt": "" for i in range(20_000)}),
                           "absolute.zip": zip_of({f"/{path}": text for path, text in files.items()}),
                           "above.tar.gz": tar_of({f"x/../../{path}": text for path, text in files.items()}),
                           "links.zip": zip_of({}, links),
                           "links.tar.gz": tar_of(links, kind=tarfile.SYMTYPE),
                           "hard-links.tar": tar_of(links, "w", tarfile.LNKTYPE),
                           "devices.tar.gz": tar_of(links, kind=tarfile.CHRTYPE),
                           "pipes.tar": tar_of(links, "w", tarfile.FIFOTYPE)}.items():
            self.put_file("broken", f"broken-{name}", data, self.unreadable())
        (self.out / "broken-empty-folder").mkdir()
        self.expect("broken-empty-folder", "broken", "empty-folder", self.unreadable())

    def write_expectations(self, texel):
        """DIR.json, by the ids that the grader gives."""
        listed = subprocess.run([texel, "grade", self.out, "--labs", ",".join(map(str, self.labs)), "--print-steps"],
                                env={**os.environ, "TEXEL_ROOT": str(ROOT)}, capture_output=True, text=True, check=True)
        # It may say the archive in a folder.
        students = {one["id"]: self.expected[one["entry"].split("/")[0]] for one in json.loads(listed.stdout)["submissions"]}
        self.out.with_name(self.out.name + ".json").write_text(
            json.dumps({"labs": self.labs, "steps": self.asked, "students": students}, indent=1) + "\n", encoding="utf-8")


def main():
    kinds = [name.removeprefix("make_") for name in vars(ClassMaker) if name.startswith("make_")]
    parser = argparse.ArgumentParser(description="Makes a class folder whose grades are known")
    parser.add_argument("bin", type=pathlib.Path, help="the programs' folder")
    parser.add_argument("--out", required=True, help="a new folder; what must come out goes into the same name with .json")
    parser.add_argument("--labs", required=True, type=lambda text: [int(lab) for lab in text.split(",")], help="numbers of labs")
    parser.add_argument("--kinds", required=True, type=lambda text: text.split(","), help=",".join(kinds))
    parser.add_argument("--limit", type=int, default=sys.maxsize,
                        help="at most so many prefixes, mutants, mistakes and equivalents each, from all over the list")
    parser.add_argument("--threats", type=int, default=sys.maxsize, help="at most so many threats of a kind, likewise")
    options = parser.parse_args()
    if unknown := set(options.kinds) - set(kinds):
        parser.error(f"there is no kind {', '.join(sorted(unknown))}")
    texel = options.bin.resolve() / "texel"
    maker = ClassMaker(options.out, options.labs, options.limit, options.threats)
    for kind in options.kinds:
        getattr(maker, f"make_{kind}")()
    maker.write_expectations(texel)
    print(f"{len(maker.expected)} entries")


if __name__ == "__main__":
    main()
