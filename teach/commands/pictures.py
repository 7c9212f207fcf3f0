#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the pictures of README and docs/pictures.md from those of out/gallery, and docs/pictures.md itself: the sources'
pictures, each with the command that draws it, from the labs' lab.toml."""
import shlex
import struct
import subprocess
import sys

sys.dont_write_bytecode = True
from course import ROOT, read_labs, run, text_of, write  # noqa: E402

HEAD = """# The sources' pictures

The labs implement three [sources](student.md#the-sources). Each picture that these show is drawn by one command,
typed in the project's root; the faulty ones too. `./run docs` writes this page from the labs' `lab.toml`,
and a test holds it to that.
"""


def save_small(drawn, file, is_hero):
    """A picture in half its size, averaged in linear light; of a hero its middle, as large as fits into 3:2."""
    whole = struct.unpack(">II", drawn.read_bytes()[16:24])  # in a PNG's header
    width, height = (min(whole[0], whole[1] * 3 // 2), min(whole[1], whole[0] * 2 // 3)) if is_hero else whole
    crop = f"{width}x{height}+{(whole[0] - width) // 2}+{(whole[1] - height + 1) // 2}"
    file.parent.mkdir(parents=True, exist_ok=True)
    subprocess.run(["convert", drawn, "-crop", crop, "+repage", "-colorspace", "RGB", "-scale", f"{width // 2}x{height // 2}!",
                    "-colorspace", "sRGB", "-depth", "8", "-strip", "-define", "png:exclude-chunks=date,time", f"png24:{file}"], check=True)


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


def page(labs):
    """docs/pictures.md."""
    tables = {}
    for lab in labs:
        for look in lab["look"]:
            if "source" in look:
                document, _, place = look["source"].partition(", ")
                tables.setdefault(document, []).append(f"| ![](source_pictures/{lab['lab']}_{look['name']}.png) | {cell(place)}: {cell(look['caption'])}"
                                                       f"<br>`{cell(command(lab, look))}` |\n")
    return HEAD + "".join(f"\n## {document}\n\n| picture | where, what it shows, and its command |\n|---|---|\n{''.join(rows)}"
                          for document, rows in sorted(tables.items()))


def main():
    labs = read_labs()
    for lab in labs:
        for look in lab["look"]:
            drawn = ROOT / f"out/gallery/{lab['lab']}/{look['name']}.png"
            if look.get("hero"):
                save_small(drawn, ROOT / f"docs/pictures/{lab['lab']}.png", True)
            if "source" in look:
                save_small(drawn, ROOT / f"docs/source_pictures/{lab['lab']}_{look['name']}.png", False)
    write(ROOT / "docs/pictures.md", page(labs))


if __name__ == "__main__":
    run("pictures", main)
