# SPDX-License-Identifier: MIT
"""A lab's program, and the pictures and meshes that it writes. y counts from below."""
import array
import functools
import json
import math
import os
import pathlib
import re
import struct
import subprocess
import zlib


def run(program, *arguments, env=None, cwd=None):
    """Runs a lab. `env`: variables, None to take one away.
    An endless loop in the driver ends after ten times what the longest batch takes on a slow machine."""
    variables = {**os.environ, **(env or {})}
    said = subprocess.run([program, *map(str, arguments)], capture_output=True, check=False, timeout=600, cwd=cwd,
                          env={name: value for name, value in variables.items() if value is not None})
    said.stdout = said.stdout.decode(errors="replace")
    said.stderr = re.sub(r"\r[^\n]*\n?", "", said.stderr.decode(errors="replace"))  # a slow machine shows progress, in one line that is written again and again
    return said


def flags(settings):
    return [word for name, value in settings.items() for word in (f"--{name.replace('_', '-')}", value)]


def draw(program, shots, folder, *arguments, env=None):
    """Draws {name, view, size, set} by one process into `folder`: what it said."""
    batch = pathlib.Path(folder, "batch.json")
    batch.write_text(json.dumps(shots), encoding="utf-8")
    said = run(program, "--batch", batch, "--out", folder, *arguments, env=env)
    if said.returncode != 0:
        raise AssertionError(said.stderr)
    return said.stdout + said.stderr


@functools.cache
def parameters(program):
    return json.loads(run(program, "--list-parameters", "--json").stdout)


@functools.cache
def views(program):
    return run(program, "--list-views").stdout.split()


def data_views(program):
    return [view for view in views(program) if view not in ("color", "error")]


def png_size(path):
    """Width and height, from the header alone."""
    return struct.unpack(">II", pathlib.Path(path).read_bytes()[16:24])


class Picture:
    """A .png of 8 bits or a .pfm."""

    def __init__(self, path):
        data = pathlib.Path(path).read_bytes()
        if data.startswith(b"\x89PNG"):
            self.width, self.height, _, kind = struct.unpack(">IIBB", data[16:26])
            self.channels, raw = {0: (1, "gray"), 2: (3, "rgb"), 6: (4, "rgba")}[kind]
            self.samples = subprocess.run(["convert", path, "-flip", "-depth", "8", f"{raw}:-"], stdout=subprocess.PIPE, check=True).stdout
        else:
            kind, size, scale, floats = data.split(b"\n", 3)
            self.width, self.height = map(int, size.split())
            self.channels = 3 if kind == b"PF" else 1
            self.samples = array.array("f", floats)
            if float(scale) > 0:
                self.samples.byteswap()

    def at(self, x, y):
        begin = (y * self.width + x) * self.channels
        return tuple(self.samples[begin:begin + self.channels])

    def pixels(self):
        """All pixels, each a tuple of its channels."""
        return list(zip(*[iter(self.samples)] * self.channels))

    def non_finite(self):
        return 0 if all(map(math.isfinite, self.samples)) else sum(not all(map(math.isfinite, pixel)) for pixel in self.pixels())

    def farthest_from_unit(self):
        """How far the vectors are from length 1 at most; background, which is 0, does not count."""
        lengths = [math.hypot(*pixel) for pixel in self.pixels()]
        return max((abs(length - 1) for length in lengths if length != 0), default=math.inf)


def png(width, height, texels):
    """A picture as a file of 8 bits, from one texel for all, or the texels of all rows from the uppermost. Without any it has no pixels."""
    texels = texels if texels and isinstance(texels[0], list) else [texels or [0, 0, 0]] * (width * height if texels else 1)
    rows = b"".join(b"\0" + bytes(sum(texels[begin:begin + width], [])) for begin in range(0, len(texels), width or 1))
    kind = {1: 0, 2: 4, 3: 2, 4: 6}[len(texels[0])]
    chunks = (b"IHDR", struct.pack(">IIBBBBB", width, height, 8, kind, 0, 0, 0)), (b"IDAT", zlib.compress(rows)), (b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + b"".join(struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
                                           for name, data in chunks)


def texts(data):
    """The tEXt and iTXt chunks of a .png, without compression."""
    found, at = {}, 8
    while at < len(data):
        size = int.from_bytes(data[at:at + 4], "big")
        if data[at + 4:at + 8] in (b"tEXt", b"iTXt"):
            parts = data[at + 8:at + 8 + size].split(b"\0")
            found[parts[0].decode()] = parts[-1].decode()
        at += size + 12
    return found


def vertices(path):
    """The vertices of a binary .ply as --mesh writes it, each a dictionary of its numbers."""
    head, data = pathlib.Path(path).read_bytes().split(b"end_header\n", 1)
    count = int(re.search(rb"element vertex (\d+)", head)[1])
    names = re.findall(r"property float (\w+)", head.decode())
    return [dict(zip(names, numbers)) for numbers in struct.iter_unpack(f"<{len(names)}f", data[:4 * len(names) * count])]
