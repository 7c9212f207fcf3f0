#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check_assets.py BIN ASSETS: whether make_assets makes what is there. A picture may be packed by another version of zlib, and differ by
one step where another library's sine rounds the other way. Exit codes: 0 it does, 1 one is missing or different, 3 it cannot be made."""
import pathlib
import subprocess
import sys
import tempfile

HEAD = 26  # bytes of a PNG, up to its size and its kind of color


def is_same(texel, there, made):
    return (there.exists() and there.read_bytes()[:HEAD] == made.read_bytes()[:HEAD] and
            subprocess.run([texel, "compare", there, made, "--max", "1"], stdout=subprocess.DEVNULL, check=False).returncode == 0)


def main(binaries, assets):
    with tempfile.TemporaryDirectory() as fresh:
        if subprocess.run([binaries / "make_assets", fresh], check=False).returncode != 0:
            return 3
        made = sorted(file for file in pathlib.Path(fresh).rglob("*") if file.is_file())
        different = [file for file in made if not is_same(binaries / "texel", assets / file.relative_to(fresh), file)]
        for file in different:
            print(f"missing or different: {assets / file.relative_to(fresh)}")
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
