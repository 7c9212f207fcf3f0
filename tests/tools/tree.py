# SPDX-License-Identifier: MIT
"""What the tests of the tree's texts have in common. They run in the tree's root."""
import os
import pathlib
import re
import shlex
import tomllib

HOURS = "TEXEL_TEST_ALL" in os.environ  # ./run test --all
EXHAUSTIVE = HOURS or "CI" in os.environ  # on a build server, what takes minutes


def labs():
    """What each lab.toml says, by number, with its `folder` and `number`."""
    found = [(file.parent.name, tomllib.loads(file.read_text(encoding="utf-8"))) for file in sorted(pathlib.Path("labs").glob("[0-9]*/lab.toml"))]
    return [{"folder": folder, "number": int(folder[:2]), **lab} for folder, lab in found if lab["lab"] == folder]


def some(things):
    """Each third, or all."""
    return things if EXHAUSTIVE else things[::3]


def as_text(value):
    """A setting's value as the command line takes it."""
    if isinstance(value, bool):
        return "on" if value else "off"
    return f"{value:g}" if isinstance(value, float) else str(value)


def flags(settings):
    """Settings as the labs' command line takes them: " --turn 50"."""
    return "".join(f" --{name.replace('_', '-')} {shlex.quote(as_text(value))}" for name, value in settings.items())


def section(text, heading):
    """A section of Markdown from its heading, which is on a line of its own, to the next one; None if there is none."""
    found = re.search(rf"^{re.escape(heading)}.*?(?=^##|\Z)", text, re.MULTILINE | re.DOTALL)
    return found and found[0]


def catalogue(folder, kind):
    """The entries of a kind in a catalogue, each with its `place`."""
    return [{"place": str(file), "step": "", **one} for file in sorted(pathlib.Path("tests", folder).glob("*.toml"))
            for one in tomllib.loads(file.read_text(encoding="utf-8")).get(kind, [])]


# ---- The places in the sources where a student writes, as course/markers.hpp explains them.

def with_steps(text, solved):
    """A text of the course as a student has it who solved the steps of which `solved` says so."""
    lines, step, part = [], "", None
    for line in text.splitlines(keepends=True):
        marker = line.strip()
        if found := re.fullmatch(r"//@step (\S+) begin", marker):
            step, part = found[1], "solution"
        elif part and marker == "//@starter":
            part = "starter"
            continue
        elif part and marker == "//@end":
            part = None
        elif part == "solution" and not solved(step) or part == "starter" and solved(step):
            continue
        elif part == "starter":
            line = re.sub("// ?", "", line, count=1)
        lines.append(line)
    return "".join(lines)


def step_parts(text):
    """The parts of all steps in a student's text, with their markers: (step, what stands between)."""
    return [(found[1], found[2]) for found in re.finditer(r"^ *//@step (\S+) begin\n(.*?)^ *//@end$", text, re.MULTILINE | re.DOTALL)]


def with_step_from(text, step, other):
    """A student's text with the parts of one step as another text has them."""
    parts = iter([part for one, part in step_parts(other) if one == step])
    return re.sub(rf"(^ *//@step {re.escape(step)} begin\n)(.*?)(^ *//@end$)", lambda found: found[1] + next(parts) + found[3], text,
                  flags=re.MULTILINE | re.DOTALL)
