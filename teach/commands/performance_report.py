# SPDX-License-Identifier: MIT
"""Two commands side by side: whole processes, in turn, so that whatever else the machine does meets both. And the report on them."""
import dataclasses
import json
import os
import pathlib
import subprocess
import time

from course import BIN, ROOT, Failure

HEAD = """# How fast

Made by `./run performance`, which takes about an hour. All figures are of one machine with {} processors, taken in turn with \
what they stand beside in {} rounds (batches, grading and the first `./run` in {}); the ratio is the median of the rounds, with \
the quarters below and above it. The driver's cache of compiled shaders is off (`MESA_SHADER_CACHE_DISABLE=true`) where nothing \
else is said. Speed against *error* is in [accuracy.md](accuracy.md).
"""
# What users gain and lose, as the page begins: the row's section and name, and what is said of its ratio.
GAINS = (
    ("A snapshot beside its floor", "lab 5, time", "A snapshot of lab 5 takes {:.2f} of the time of the same program written by hand."),
    ("A batch beside a process each", "lab 5, a turning camera", "36 pictures by one `--batch` come {:.1f} times as fast as by 36 processes."),
    ("Beside three.js", "page, something to see", "Lab 9's page shows what it opens with after {:.2f} of the time of three.js' first picture."),
    ("Beside three.js", "page, first picture", "Its own first picture comes after {:.2f} of three.js' time."),
    ("Beside three.js", "page, antialiased", "Then a frame takes {:.2f} of three.js'."),
    ("Kernels", "obj/triangles_2m: texel beside tinyobjloader", "An OBJ file of 2 million triangles is read {:.1f} times as fast as by tinyobjloader."),
    ("Grading beside drawing", "lab 5, 24 students, 10 with a mistake each, 576 cases", "A class with mistakes is graded in {:.2f} of the time of drawing its pictures."),
    ("The first ./run", "the course's", "The first `./run` takes {:.2f} of an earlier commit's time."),
    ("The first ./run", "a student's", "A student's first `./run` takes {:.2f} of an earlier commit's."),
    ("From a save to the verdict", "labs/05_normal_map/lab.cpp", "From a saved `lab.cpp` to the verdict: {:.2f} of an earlier commit's time."),
)
STAGES = """
## Where a snapshot's milliseconds go
`labNN --snapshot FILE --stats -`, once. `start` is the program's own loading, `loader` the renderer's, `first_draw` mostly the \
driver's translation of the shaders into machine code: `draw` is the same picture once more, when all is there, and not part of \
`total`; its shaders are those of a single picture, which `--frames` optimises.

"""


@dataclasses.dataclass
class Setting:
    """What all measurements are told."""
    work: pathlib.Path  # scratch
    rounds: int
    # Earlier commits' trees, built by their ./run build; or None: what the first ./run, and what saves and tests, are compared with.
    first_run_before: pathlib.Path = None
    saves_before: pathlib.Path = None

    @property
    def long_rounds(self):
        """Of what takes a minute each time."""
        return max(1, self.rounds // 4)

    @property
    def kept_shaders(self):
        """Variables with which the driver keeps its shaders from one process to the next, as it does for users."""
        return {"MESA_SHADER_CACHE_DISABLE": "false", "MESA_SHADER_CACHE_DIR": str(self.work / "shaders")}

    def write_json(self, name, value):
        file = self.work / name
        file.write_text(json.dumps(value), encoding="utf-8")
        return file


def words(command):
    """The first word of a command is a program of ours, or its path, or one in PATH."""
    own = BIN / str(command[0])
    return [str(own if own.exists() else command[0]), *map(str, command[1:])]


def run_process(*command, variables=None):
    """(milliseconds from start to end, mebibytes of resident memory at most) of a program whose output is thrown away."""
    command, begin = words(command), time.perf_counter()
    try:
        process = os.posix_spawnp(command[0], command, os.environ | (variables or {}),
                                  file_actions=[(os.POSIX_SPAWN_OPEN, 1, os.devnull, os.O_WRONLY, 0)])
    except FileNotFoundError as error:
        raise Failure(f"{command[0]}: cannot be started; ./run performance builds it") from error
    _, status, usage = os.wait4(process, 0)
    milliseconds = 1e3 * (time.perf_counter() - begin)
    if status:
        raise Failure(f"failed: {' '.join(command)}")
    return milliseconds, usage.ru_maxrss / 1024


def time_of(*command, variables=None):
    return run_process(*command, variables=variables)[0]


def output_of(*command, variables=None, most_code=0):
    """What a program prints."""
    ran = subprocess.run(words(command), env=os.environ | (variables or {}), stdout=subprocess.PIPE, text=True, check=False)
    if ran.returncode > most_code:
        raise Failure(f"failed: {' '.join(words(command))}; see its message above")
    return ran.stdout


def quantile(figures, q):
    """Between two figures as far as q lies between them."""
    figures, place = sorted(figures), q * (len(figures) - 1)
    below = int(place)
    above = min(below + 1, len(figures) - 1)
    return figures[below] + (place - below) * (figures[above] - figures[below])


def spread_of(figures):
    return {"median": quantile(figures, 0.5), "lower": quantile(figures, 0.25), "upper": quantile(figures, 0.75)}


def interleaved(rounds, ours, theirs):
    """[(ours, theirs)]: calls both in turn, once before to warm up. Who comes second finds the caches as the first left them: they change
    places."""
    theirs(), ours()
    pairs = []
    for i in range(rounds):
        first = ours() if i % 2 == 0 else None
        other = theirs()
        pairs.append((ours() if first is None else first, other))
    return pairs


def number(value):
    """Four digits, and no exponent where there are more before the point."""
    return f"{value:.4g}" if value < 1000 else f"{value:.0f}"


class Report:
    """The report as it grows: each line is printed when it is known."""

    def __init__(self):
        self.sections, self.stages = [], {}

    def begin(self, title, text, ours, theirs):
        """A section, and what its two columns are called."""
        print(f"\n{title}", flush=True)
        self.sections.append({"title": title, "text": " ".join(text.split()), "ours": ours, "theirs": theirs, "rows": [], "whys": [],
                              "notes": []})

    def add(self, what, unit, pairs, at_most=None, at_least=None, why="", names=None):
        """The ratio ours / theirs, of which at most so much is wanted; or, for what is to be faster, theirs / ours, of which at least so much.
        `why` says where the time goes and what was tried: told where the target is missed. `names` are others than the section's."""
        section, is_faster = self.sections[-1], at_least is not None
        ours, theirs = names or (section["ours"], section["theirs"])
        ratio = spread_of([other / own if is_faster else own / other for own, other in pairs])
        target = at_least or at_most
        reached = not target or (ratio["median"] >= target if is_faster else ratio["median"] <= target)
        wanted = f"{'at least' if is_faster else 'at most'} {target}" if target else ""
        print(f"  {what:<44} {ratio['median']:8.2f} ({ratio['lower']:.2f} to {ratio['upper']:.2f})  {wanted}"
              f"{'' if reached else '  MISSED'}", flush=True)
        section["rows"].append({"section": section["title"], "what": what, "unit": unit, ours: spread_of([own for own, _ in pairs]),
                                theirs: spread_of([other for _, other in pairs]), "ratio": ratio, "target": wanted,
                                "reached": reached})
        if not reached and why:
            section["whys"].append(f"**{what}**: {' '.join(why.split())}")

    def note(self, text):
        """A sentence below the table."""
        text = " ".join(text.split())
        print(f"  {text}", flush=True)
        self.sections[-1]["notes"].append(text)

    def as_json(self):
        results = {"notes": [note for section in self.sections for note in section["notes"]],
                   "results": [row for section in self.sections for row in section["rows"]], "stages": self.stages}
        return json.dumps({key: value for key, value in results.items() if value}, indent=2, ensure_ascii=False) + "\n"

    def as_markdown(self, setting):
        ratios = {(row["section"], row["what"]): row["ratio"]["median"] for section in self.sections for row in section["rows"]}
        said = "".join(f"- {text.format(ratios[section, what])}\n" for section, what, text in GAINS if (section, what) in ratios)
        text = HEAD.format(os.cpu_count(), setting.rounds, setting.long_rounds)
        if said:
            text += f"\n**What a user gains and loses**\n{said}"
        for section in self.sections:
            if not section["rows"]:
                continue
            text += f"\n## {section['title']}\n{section['text']}\n\n"
            text += f"| | {section['ours']} | {section['theirs']} | ratio | target |\n|---|---|---|---|---|\n"
            for row in section["rows"]:
                (_, ours), (_, theirs), (_, ratio) = list(row.items())[3:6]
                text += (f"| {row['what']} | {number(ours['median'])} {row['unit']} | {number(theirs['median'])} {row['unit']} | "
                         f"**{ratio['median']:.3g}** ({ratio['lower']:.3g} to {ratio['upper']:.3g}) | {row['target']}"
                         f"{'' if row['reached'] else ', **missed**'} |\n")
            text += "".join(f"\n{note}\n" for note in section["whys"] + section["notes"])
        return text + (self.stage_table() if self.stages else "")

    def stage_table(self):
        """Where each millisecond of a snapshot goes, as --stats says it."""
        names = list(dict.fromkeys(name for stages in self.stages.values() for name in stages))
        names.sort(key=lambda name: name in ("other", "total", "draw"))  # these close the list
        rows = [[name, *(f"{stages.get(name, 0):.1f}" for stages in self.stages.values())] for name in names]
        head = f"| stage | {' | '.join(self.stages)} |\n|---|{'---|' * len(self.stages)}\n"
        return STAGES + head + "".join(f"| {' | '.join(row)} |\n" for row in rows)


def compared(first, second):
    """How far two pictures are apart, as `texel compare --json` says it."""
    return json.loads(output_of("texel", "compare", first, second, "--json", most_code=1))


def check_same(first, second):
    if compared(first, second)["max"] > 0:
        raise Failure(f"{second}: draws another picture than {first}; what is not the same cannot be compared")


def bench_file(name):
    return ROOT / "tests/bench" / name
