#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints docs/pictures.md: the sources' pictures, each with the command that draws it, from the labs' lab.toml."""
import shlex
import sys

sys.dont_write_bytecode = True
from course import read_labs, run, text_of  # noqa: E402

HEAD = """# The sources' pictures

The labs implement three [sources](student.md#the-sources). Each picture that these show is drawn by one command,
typed in the project's root; the faulty ones too. `./run docs` writes this page from the labs' `lab.toml`,
and a test holds it to that.
"""


def command(lab, look):
    """What draws a look, typed in the project's root."""
    words = ["./run", "lab", str(lab["number"])]
    for name, value in look.get("set", {}).items():
        words += ["--" + name.replace("_", "-"), text_of(value)]
    for option in ("view", "size"):
        words += [f"--{option}", look[option]] if option in look else []
    return shlex.join([*words, "--snapshot", f"{look['name']}.png"])


def cell(text):
    """Of a table: a '|' would end it, also inside of code."""
    return text.replace("|", "\\|")


def main():
    tables = {}
    for lab in read_labs():
        for look in lab["look"]:
            if "source" in look:
                document, _, place = look["source"].partition(", ")
                tables.setdefault(document, []).append(f"| ![](source_pictures/{lab['lab']}_{look['name']}.png) | {cell(place)}: {cell(look['caption'])}"
                                                       f"<br>`{cell(command(lab, look))}` |\n")
    print(HEAD + "".join(f"\n## {document}\n\n| picture | where, what it shows, and its command |\n|---|---|\n{''.join(rows)}"
                         for document, rows in sorted(tables.items())), end="")


run("source_pictures", main)
