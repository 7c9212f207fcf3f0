#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The C++ of docs/adding_a_lab.md compiles: each block under the path in its heading, with the flags of lab 6. guide_test.py BUILD"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path.cwd()
KNOWN = {"labs/10_gradient/lab.cpp": "labs/06_cube_map/lab.cpp", "teach/answers/10_gradient.cpp": "teach/answers/06_cube_map.cpp"}


def main():
    guide = (ROOT / "docs/adding_a_lab.md").read_text(encoding="utf-8")
    blocks = dict(re.findall(r"^## [^`\n]*`(\S+\.[ch]pp)`\n(?:(?!^## ).)*?```cpp\n(.*?)```", guide, re.M | re.S))
    assert set(blocks) == {"labs/10_gradient/parameters.hpp", *KNOWN}, blocks.keys()
    commands = {one["file"]: one["command"] for one in json.loads((pathlib.Path(sys.argv[1]) / "compile_commands.json").read_text())}
    with tempfile.TemporaryDirectory(prefix="texel_guide_") as folder:
        for path, text in blocks.items():
            file = pathlib.Path(folder, path)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
        for path, like in KNOWN.items():
            flags = re.findall(r" -(?:I|D|isystem |std=)\S+", commands[str(ROOT / like)])
            line = f"c++ -fsyntax-only -Wall -Werror -I{folder}/labs -I{folder}/labs/10_gradient {' '.join(flags)} {folder}/{path}"
            subprocess.run(line, shell=True, check=True)


main()
