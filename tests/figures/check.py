#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks what a lab measures, draws and says: check.py TABLE.toml PROGRAM. Exit code 1 where a line does not hold.

    labs = [3, 4, 5]            # of a table for several labs; NN_name.toml is that lab's own
    says = ["in 32-bit floats"] # what batches may say on standard error; else they say nothing

    [files]                     # their path is @name
    "slope.png" = { size = [1, 1], texels = [190, 90, 220] }  # one texel for all, or a list of them from the uppermost row; `bytes`: cut off there
    "line.obj" = "v 0 0 0 ..."  # text; a list: of "@name", whose text stands there, and text

    [[figure]]
    name = "of the screen's axes is tens of degrees"
    because = "The reason that gives the figure, and what was measured."
    set = { normal_map = "bump", model = ["quad", "cube"] }   # a list: each of its values, in every combination
    looks = [{}, { tilt = 30 }]                               # more settings: the lines hold for each
    size = "128x128"                                          # [256x256]
    lines = ["mean(method=screen-axes, turn=50) > 20", "mean() = 0.3 +- 0.01", "mean(method=a) < 1.2 * mean(method=b)", "unknown(model=ship)"]

    [[picture]]                 # the same, where the name does not speak of an error
    name = "the smile stands upright"
    lines = ["letters(half=0.7) = ABCD"]

    [[refused]]
    name = "sizes that are none"
    exit = 2
    each = [["--size 0x64", "--size", "1 to 16384"]]          # what is typed, and what the one line of the error says; with the path of each @name

What is refused leaves no file. It is a snapshot, or what is asked to be written into OUT, a folder that is empty; `window = true`: neither.
A file in `sound` is right, so the error does not name it.

A line compares one call with a number, several numbers, a word, or with the same call of other settings. Beside settings, a call may
hold `view`, `size`, and `at`, a pixel from the lower left. `view=each`: in every view but color and error. The calls:
  mean, rms, median, p99, max, max_aside, outline_pixels, pixels, truth_pixels, non_finite   what --measure says; non_finite with a view: of that picture's pixels
  unknown                              there is no exact answer, and the lab says so
  value(at=64 64)                      a pixel, one number for each channel; `channel` for one alone
  drawn                                the picture's width and height
  picture(a=1) = picture(a=2)          they have the same bytes; != others
  apart(a=1; a=2)                      the mean difference of two pictures, over all samples
  detail                               how far neighbours in a row are apart, in the mean: the finer the detail, the more
  off_unit                             how far vectors are from length 1 at most
  letters(half=0.7, middle=0 0.35)     which of the label grid's corners lie in the corners of a square: lower left, lower right, upper left,
                                       upper right. Middle and half side are in halves of the picture's height, from the picture's middle
  notes, warnings                      what --stats says, which `has` a text, or `lacks` it
  vertices, triangles                  how many of them --stats counts
  vertex(number=2, of=s t)             numbers of a vertex as drawn, for a negative number from the last on
  off_tangents                         how far the tangents as drawn are from length 1, and from a right angle to the normal, at most

With TEXEL_TOLERANCES, a file in this folder says how much of each limit was used, as tests/support/tolerance.hpp does for the tests
in C++."""
import concurrent.futures
import functools
import itertools
import json
import math
import os
import pathlib
import re
import shlex
import sys
import tempfile
import threading
import tomllib

sys.dont_write_bytecode = True
import labs

NUMBERS = r"-?[\d.]+(?:e-?\d+)?(?: -?[\d.]+(?:e-?\d+)?)*"
LINE = re.compile(rf"(?P<what>\w+)\((?P<of>[^)]*)\)(?: (?P<sign>[<>=]|!=|has|lacks) (?:(?:(?P<times>[\d.e-]+) \* )?(?P<other>\w+)\((?P<beside>[^)]*)\)|"
                  rf"(?P<numbers>{NUMBERS})|(?P<word>.+?))(?: \+- (?P<tolerance>[\d.e-]+))?)?")
CALL = re.compile(r"(\w+)\(([^)]*)\)")
FIGURES = ("mean", "rms", "median", "p99", "max", "max_aside", "outline_pixels", "pixels", "truth_pixels", "non_finite")  # of --measure
NO_SETTINGS = ("view", "size", "at", "channel", "half", "middle", "number", "of")


def text(value):
    return ("on" if value else "off") if isinstance(value, bool) else str(value)


def combinations(settings):
    """The settings with one value for each list, for all its values."""
    names, values = list(settings), [value if isinstance(value, list) else [value] for value in settings.values()]
    return [dict(zip(names, map(text, chosen))) for chosen in itertools.product(*values)]


class Look:
    """What a call asks for: settings, and which picture of them."""

    def __init__(self, lab, words):
        self.lab = lab
        self.settings = {name: lab.path(value) for name, value in words.items() if name not in NO_SETTINGS}
        self.words = words
        self.shot = {"view": words.get("view", "color"), "size": words["size"], "set": self.settings}

    @property
    def key(self):
        return json.dumps(self.shot, sort_keys=True)

    @property
    def file(self):
        return self.lab.files[self.key]

    @functools.cached_property
    def picture(self):
        return self.lab.picture(self.file)

    def numbers(self, name, otherwise):
        return [float(number) for number in self.words.get(name, otherwise).split()]

    def said(self, option):
        return self.lab.said(option, self.shot["size"], self.shot["view"], tuple(sorted(self.settings.items())))


def measured(what, look):
    if not look.file.exists():
        raise AssertionError(look.lab.not_drawn)
    found = json.loads(labs.texts(look.file.read_bytes())["Error"])
    if found[what] is None:
        raise AssertionError(found["reason"])
    return [found[what]]


def stats(what, look):
    said = look.said("--stats")
    if said.returncode != 0:
        raise AssertionError(said.stderr.strip())
    found = json.loads(said.stdout)
    for line in said.stderr.splitlines():  # what is said is among the warnings
        if line.split(": warning: ", 1)[-1] not in "\n".join(found["warnings"]):
            raise AssertionError(line)
    return found[what]


def value(look):
    pixel = look.picture.at(*map(int, look.numbers("at", "")))
    return [pixel[int(look.words["channel"])]] if "channel" in look.words else pixel


def apart(one, other):
    pairs = zip(one.picture.samples, other.picture.samples, strict=True)
    return [sum(abs(a - b) for a, b in pairs) / len(one.picture.samples)]


def detail(look):
    picture, step = look.picture, look.picture.channels
    rows = (picture.samples[begin:begin + picture.width * step] for begin in range(0, len(picture.samples), picture.width * step))
    return [sum(abs(a - b) for row in rows for a, b in zip(row, row[step:])) / len(picture.samples)]


def letters(look):
    """A red, B green, C blue, D yellow; '?' for any other colour."""
    (half,), (x, y), picture = look.numbers("half", ""), look.numbers("middle", "0 0"), look.picture
    inner = half * (1 - 2 * 0.07 / 8)  # inside the edge by 7 % of a cell, of which there are eight: the letters begin at 12 %
    found = ""
    for down, left in itertools.product((-inner, inner), repeat=2):
        red, green, blue = picture.at(*(int((1 + place) * picture.height / 2) for place in (x + left, y + down)))
        found += {(True, False, False): "A", (False, True, False): "B", (False, False, True): "C", (True, True, False): "D"}.get(
            (red > 150, green > 130, blue > 150), "?")
    return found


def off_tangents(look):
    def off(vertex):
        tangent, normal = [vertex[name] for name in ("tx", "ty", "tz")], [vertex[name] for name in ("nx", "ny", "nz")]
        return max(abs(math.hypot(*tangent) - 1), abs(sum(a * b for a, b in zip(tangent, normal))))
    return [max(map(off, labs.vertices(look.file)))]


def vertex(look):
    found = labs.vertices(look.file)[int(look.words["number"])]
    return [found[name] for name in look.words["of"].split()]


OF_PICTURES = {
    "value": value, "apart": apart, "detail": detail, "letters": letters, "off_tangents": off_tangents, "vertex": vertex,
    "drawn": lambda look: labs.png_size(look.file),
    "picture": lambda look: look.file.read_bytes(),
    "off_unit": lambda look: [look.picture.farthest_from_unit()],
    "non_finite": lambda look: [look.picture.non_finite()],
}


def is_of_errors(what, words):
    """Whether a call asks for a figure of --measure. non_finite with a view is that picture's."""
    return what in FIGURES and (what != "non_finite" or words.get("view", "error") == "error")


class Lab:
    """A program, the files of its table, and what it drew and said."""

    def __init__(self, program, folder, files):
        self.program, self.folder, self.files, self.shots = program, pathlib.Path(folder), {}, []
        self.texts, self.locks, self.not_drawn = files, {}, ""
        for name, content in files.items():
            path = self.folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(labs.png(*content["size"], content["texels"])[:content.get("bytes")] if isinstance(content, dict) else self.whole(content).encode("latin-1"))

    def whole(self, content):
        if isinstance(content, str):
            return content
        return "".join(self.whole(self.texts[part[1:]]) if part.startswith("@") else part for part in content)

    def path(self, words):
        """With the path of the table's file for each @name."""
        return re.sub(r"@([\w./-]+)", lambda found: str(self.folder / found[1]), words)

    def calls(self, settings, line):
        """Each call of a line: its name, and what it asks for."""
        for what, of in CALL.findall(line):
            looks = []
            for group in of.split(";"):
                own = dict(part.split("=", 1) for part in re.split(r", *", group.strip()) if part)
                if what in ("vertex", "off_tangents"):
                    own["view"] = "mesh"
                elif is_of_errors(what, own):
                    own["view"] = "error"
                looks.append(Look(self, {**settings, **own}))
            yield what, looks

    def want(self, settings, line):
        for what, looks in self.calls(settings, line):
            for look in looks if what in OF_PICTURES or what in FIGURES else []:
                if look.key not in self.files:
                    ending = {"color": ".png", "error": ".png", "mesh": ".ply"}.get(look.shot["view"], ".pfm")
                    name = f"{len(self.shots)}{ending}"
                    self.files[look.key] = self.folder / "drawn" / name
                    self.shots.append({"name": name, **look.shot})

    def draw(self):
        """All pictures that are wanted, by as many processes as there are processors: what they said."""
        def part(number, shots):
            folder = self.folder / f"part{number}"
            folder.mkdir()
            said = ""
            try:
                said = labs.draw(self.program, shots, folder) if shots else ""
            except AssertionError as error:
                self.not_drawn += str(error)
            for shot in shots:
                if (folder / shot["name"]).exists():
                    (folder / shot["name"]).rename(self.folder / "drawn" / shot["name"])
                elif shot["view"] != "error":  # of which the line that asks for its figures says why
                    raise AssertionError(self.not_drawn)
            return said

        (self.folder / "drawn").mkdir()
        count = os.cpu_count()
        # Methods of one look follow each other: they have the same right answer.
        shots = sorted(self.shots, key=lambda shot: (shot["view"], shot["size"], sorted(pair for pair in shot["set"].items() if pair[0] != "method")))
        with concurrent.futures.ThreadPoolExecutor(count) as pool:
            return "".join(pool.map(part, range(count), (shots[len(shots) * i // count:len(shots) * (i + 1) // count] for i in range(count))))

    @functools.cache
    def picture(self, file):
        return labs.Picture(file)

    def said(self, *asked):
        with self.locks.setdefault(asked, threading.Lock()):  # two lines that want the same wait for one answer
            return self.answer(*asked)

    @functools.cache
    def answer(self, option, size, view, settings):
        return labs.run(self.program, option, "-", "--size", size, *(["--view", view] if view != "color" else []), *labs.flags(dict(settings)))

    def problem(self, settings, line, use):
        """Why a line does not hold, or None."""
        found = LINE.fullmatch(line)
        if not found:
            return "is no line that can be checked"
        calls = list(self.calls(settings, line))
        if found["what"] == "unknown":
            said = calls[0][1][0].said("--measure")
            return None if said.returncode == 3 and "no exact answer" in said.stderr and "choose" in said.stderr else said.stderr or said.stdout

        def result(what, looks):
            if is_of_errors(what, looks[0].words):
                return measured(what, *looks)
            if what in OF_PICTURES:
                return OF_PICTURES[what](*looks)
            if what in ("notes", "warnings"):
                return "\n".join(stats(what, *looks))
            if what not in ("vertices", "triangles"):
                raise KeyError(what)
            return [stats(what, *looks)]

        try:
            got = result(*calls[0])
            if found["other"]:
                limit = result(*calls[1])
            else:
                limit = found["word"] or [float(number) for number in found["numbers"].split()]
        except KeyError as error:
            return f"there is no {error}; the calls stand at the beginning of {pathlib.Path(__file__).name}"
        except (AssertionError, OSError) as error:
            return repr(error)
        if not isinstance(got, (list, tuple)):
            holds = {"has": lambda: limit in got, "lacks": lambda: limit not in got, "=": lambda: got == limit, "!=": lambda: got != limit}[found["sign"]]()
            return None if holds else f"it is {got if isinstance(got, str) else 'not so'}"
        if len(got) != len(limit):
            return f"it is {got}"
        for number, other in zip(got, limit):
            other *= float(found["times"] or 1)
            if found["sign"] == "=":
                share = abs(number - other) / float(found["tolerance"]) if found["tolerance"] else (0 if number == other else math.inf)
            elif number == other:
                share = 1
            else:
                over, under = (number, other) if found["sign"] == "<" else (other, number)
                share = over / under if under else math.inf
            # A count, and what must be equal or 0, is no limit that a renderer comes near to.
            if found["what"] not in ("pixels", "truth_pixels", "non_finite", "vertices", "triangles", "drawn") and (found["tolerance"] or found["sign"] != "=" and other != 0):
                use(line, share)
            if not (share < 1 or (found["sign"] == "=" and share <= 1)):
                return f"it is {', '.join(f'{x:.6g}' for x in got)} beside {', '.join(f'{x:.6g}' for x in limit)}"
        return None

    def refusal(self, one, words):
        """Why it was not refused as the table says, or None."""
        typed, *parts = words
        with tempfile.TemporaryDirectory() as folder:
            typed_words = shlex.split(self.path(typed).replace("OUT", folder))
            snapshot = [] if one.get("window") or "OUT" in typed else ["--snapshot", folder + "/a.png"]
            env = {name: value or None for name, value in one.get("env", {}).items()}
            said = labs.run(self.program, *snapshot, *typed_words, env=env)
            if said.returncode != one["exit"] or said.stdout or not re.fullmatch(rf"{pathlib.Path(self.program).name}: .*\n", said.stderr):
                return f"exit code {said.returncode}: {said.stdout}{said.stderr}"
            lacking = [part for part in parts + [name for name in re.findall(r"@[\w./-]+", typed) if name not in one.get("sound", [])] if self.path(part) not in said.stderr]
            if lacking:
                return f"{said.stderr.strip()} lacks {lacking}"
            return "it left a file" if os.listdir(folder) else None


KEYS = {"figure": {"name", "because", "set", "looks", "size", "lines"}, "refused": {"name", "because", "exit", "each", "env", "window", "sound"}}
KEYS["picture"] = KEYS["figure"]


def read(table):
    """The rows of a table. A key that nobody reads, and a figure without its reason, end the program."""
    try:
        rows = tomllib.loads(table.read_text(encoding="utf-8"))
    except tomllib.TOMLDecodeError as error:
        sys.exit(f"{table.name}: {error}")
    faults = [f"there is no key '{key}'" for key in rows.keys() - KEYS.keys() - {"labs", "says", "files"}]
    for kind in KEYS.keys() & rows.keys():
        faults += [f"'{one.get('name')}' has a key '{key}', which nobody reads" for one in rows[kind] for key in one.keys() - KEYS[kind]]
    faults += [f"'{one.get('name')}' has no 'because'" for one in rows.get("figure", []) if not one.get("because")]
    if faults:
        sys.exit(f"{table.name}: " + "; ".join(faults))
    return rows


def main():
    table, program = pathlib.Path(sys.argv[1]), sys.argv[2]
    rows = read(table)
    used, checks = {}, []
    with tempfile.TemporaryDirectory() as folder:
        lab = Lab(program, folder, rows.get("files", {}))
        for one in rows.get("figure", []) + rows.get("picture", []):
            for look in one.get("looks", [{}]):
                for settings in combinations({"size": one.get("size", "256x256"), **one.get("set", {}), **look}):
                    for line in one["lines"]:
                        each = labs.data_views(program) if "view=each" in line else [""]
                        checks += [(one, settings, line.replace("view=each", f"view={view}")) for view in each]
        for _, settings, line in checks:
            lab.want(settings, line)
        said = [line for line in lab.draw().splitlines() if not any(part in line for part in rows.get("says", []))]
        checks += [(one, None, words) for one in rows.get("refused", []) for words in one["each"]]

        def check(of):
            one, settings, line = of
            if settings is None:
                return lab.refusal(one, line)

            def use(said, share):
                key = f"Figures.{one['name'].replace(' ', '_')}\t{said}"
                used[key] = max(used.get(key, 0), share if share >= 0 else math.inf)  # NaN is beyond any limit

            return lab.problem(settings, line, use)

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            failed = [(of, why) for of, why in zip(checks, pool.map(check, checks)) if why]
        for (one, settings, line), why in failed:
            what = "the error " if one in rows.get("figure", []) else ""
            print(f"{table.name}: {what}{one['name']}: {line}{f' with {settings}' if settings else ''}: {why}\n  {one.get('because', '')}")
    for line in said:
        print(f"{table.name}: a batch said {line}")
    if out := os.environ.get("TEXEL_TOLERANCES"):
        lines = [f"{key}\t{share:.9g}\n" for key, share in sorted(used.items())]
        pathlib.Path(out, f"{os.getpid()}.tsv").write_text("".join(lines), encoding="utf-8")
    print(f"{len(checks) - len(failed)} of {len(checks)} lines hold")
    return 1 if failed or said or not checks else 0


sys.exit(main())
