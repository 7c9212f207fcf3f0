#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Random settings of a lab beside its truth: no error may be above its method's bound, which BOUNDS states.

sweep.py COUNT PROGRAM .. measures COUNT settings of each program. Exit code 1 where a bound does not hold. It prints how often each
bound was asked, how much of it was used at most, and how much of the exact object the pictures covered."""
import concurrent.futures
import dataclasses
import json
import math
import os
import pathlib
import random
import sys
import typing

sys.dont_write_bytecode = True
import labs

SIZE = "96x96"
FORMULAS = {"model": ("cube", "quad", "sphere", "torus", "cube_before", "cube_split"), "cube_map": ("labelled", "smooth"),
            "projection": ("from-file", "planar", "box", "cylindrical", "spherical")}


@dataclasses.dataclass(frozen=True, eq=False)
class Bound:
    when: dict  # the settings that it is for: a value, or several
    figure: str  # of --measure
    value: typing.Callable  # of all settings, in the lab's unit
    because: str
    non_finite: bool = False  # whether it may have pixels that are not finite


def facet(s):
    """The widest angle between neighbouring vertices of a ball, in degrees; of lab 5's own meshes, 0 segments, about 12."""
    return max(360 / (s["segments"] or 30), 180 / s.get("rings", math.inf))


def at_the_eye(s):
    """The angle at the eye between the ball's middle and its rim: 180 from inside."""
    return math.degrees(math.asin(min(1, max(1, s.get("stretch", 1)) / s["distance"]))) if s["distance"] > 1 else 180


def longer(s):
    return max(s.get("stretch", 1), 1 / s.get("stretch", 1))


def texels_a_pixel(s):
    """How many of the 512 texels around a unit ball a pixel in its middle covers."""
    return 512 / math.tau * 2 * math.tan(math.radians(s["field_of_view"]) / 2) * s["distance"] / int(SIZE.split("x")[0])


# Of black and white texels, p of them white in linear light, one texel is p (255 - l) + (1 - p) l levels from their average l in the mean:
# at most 137, where p is 0.35. Of a few pixels all may be the same texel.
COLOR = Bound({}, "mean", lambda s: 137.2 if s["pixels"] >= 100 else math.inf, "one texel in place of their average, or of another one")
# From nearer than 1.1 the near plane, at 0.1, may cut a model open, of which the truth sees the outside.
DIRECTION = Bound({}, "mean", lambda s: 120 if s["distance"] > 1.1 else math.inf,
                  "the opposite would be 60 off; directions that have nothing to do with each other, about 90")
ROUNDED = 1e-6  # what a float32 loses of a coordinate and of 1 / w, over a triangle
# The first one that fits counts.
BOUNDS = {
    "01_texture_quad": [
        dataclasses.replace(COLOR, when={"texture_offset": 0}),
        Bound({}, "max", lambda s: math.inf, "none: at an offset of a million float32 has no digit left for a place in the texture")],
    "02_multi_texture": [COLOR],
    "03_obj_texcoords": [
        dataclasses.replace(COLOR, when={"truth": "color"}),
        Bound({"truth": "normal", "model": ("quad", "cube_split"), "normals": "from-file"}, "max_aside", lambda s: 1e-4, "the file's normals, in float32"),
        Bound({"truth": "texcoord", "model": ("quad", "cube_split"), "projection": "from-file"}, "max_aside",
              lambda s: 512 * s["texture_scale"] * (ROUNDED * (1 + s["distance"]) + 1e-4), "float32; a pixel aside at an edge"),
        Bound({"truth": "texcoord"}, "max", lambda s: 1024 * s["texture_scale"], "a coordinate lies in the picture's square, or beside it"),
        DIRECTION],
    "04_cube_wrap": [
        Bound({"truth": "normal", "method": ("weld", "split"), "normals": ("by-method", "face"), "model": ("cube", "quad")}, "max_aside", lambda s: 1e-4,
              "one normal for a face"),
        Bound({"truth": "normal", "model": ("cube", "quad")}, "max", lambda s: 90, "the faces that one looks at"),
        Bound({"truth": "normal"}, "p99", lambda s: 12, "half of a facet"),
        Bound({"method": ("weld", "split"), "model": ("cube", "quad")}, "p99", lambda s: 512 * s["texture_scale"] * ROUNDED * (1 + s["distance"]),
              "float32, which loses where the cube is small beside its distance"),
        Bound({"method": ("weld", "split")}, "p99", lambda s: s["texture_scale"] * (4 + texels_a_pixel(s)),
              "linear between the vertices of a round model; at its rim a pixel"),
        Bound({}, "max", lambda s: 512 * math.sqrt(2) * s["texture_scale"], "the picture's diagonal")],
    "05_normal_map": [
        Bound({"normal_mapping": "off", "model": ("cube", "quad")}, "max_aside", lambda s: 1e-4, "one normal for a face"),
        Bound({"normal_mapping": "off"}, "p99", lambda s: longer(s) * facet(s), "a facet, stretched with the model"),
        Bound({"method": ("raw", "screen-axes")}, "max", lambda s: math.inf, "none: the model's turn is left out, or counted twice"),
        DIRECTION],
    "06_cube_map": [
        dataclasses.replace(COLOR, when={"truth": "color"}),
        Bound({"mapping": "sphere-2d", "seam_method": ("naive", "select")}, "max", lambda s: 13, "all levels of a picture, and what is left of one"),
        Bound({}, "p99", lambda s: 1 + facet(s) / 30, "differences over a pixel, and facets")],
    "07_environment": [
        Bound({"method": "unproject", "plane": "far"}, "max", lambda s: math.inf, "none: at the far plane w may be 0 in float32", non_finite=True),
        Bound({"method": "unproject"}, "max", lambda s: 4e-5 + 3e-5 * max(1, s["distance"] / 2.5) / s["near"],
              "five of the eye's last bits, seen from `near`; they grow with its distance"),
        Bound({}, "max", lambda s: 4e-5, "a unit vector in float32, interpolated")],
    "08_reflection": [
        dataclasses.replace(COLOR, when={"truth": "color"}),
        Bound({"method": "per-fragment", "evaluate": "fragment", "normal_method": "analytic", "normal_matrix": "inverse-transpose"}, "p99",
              lambda s: 0.01 * longer(s), "float32, of which the root at the rim leaves half of the digits"),
        Bound({"method": "per-fragment", "normal_matrix": "inverse-transpose"}, "p99", lambda s: min(180, 2 * facet(s) * longer(s) ** 2),
              "twice what a normal turns between vertices"),
        Bound({"method": "constant-eye", "normal_matrix": "inverse-transpose", "surface": ("mirror", "fresnel", "schlick")}, "p99",
              lambda s: min(180, at_the_eye(s) + 2 * facet(s) * longer(s) ** 2), "the angle at the eye as well"),
        DIRECTION],
    "09_bump": [
        dataclasses.replace(COLOR, when={"truth": "color"}),
        Bound({"normal_mapping": "off", "incident": "per-fragment"}, "p99", lambda s: min(180, 2 * facet(s)),
              "twice what a normal turns between vertices"),
        Bound({"normal_mapping": "off"}, "p99", lambda s: min(180, at_the_eye(s) + 2 * facet(s)), "the angle at the eye as well"),
        DIRECTION]}


def value_of(parameter, chance):
    """One that the parameter can have. A range of several powers of ten is even in its logarithm."""
    if parameter["choices"]:
        names = [choice["name"] for choice in parameter["choices"]]
        return chance.choice([name for name in names if name in FORMULAS.get(parameter["name"], names)] or names)
    if parameter["min"] is None:
        return chance.choice(["on", "off"])
    least, most = parameter["min"], parameter["max"]
    if least > 0 and most / least >= 100:
        value = math.exp(chance.uniform(math.log(least), math.log(most)))
    else:
        value = chance.uniform(least, most)
    return str(round(value)) if parameter["type"] == "integer" else f"{value:.6g}"


def settings_of(program, number):
    """Each parameter of the number-th setting has its default, or with even chance any other value; models and cube maps are such that have a
    formula."""
    chance = random.Random(f"{pathlib.Path(program).name} {number}")
    return {p["name"]: value_of(p, chance) for p in labs.parameters(program) if chance.random() < 0.5 or p["name"] in FORMULAS}


def whole(program, settings):
    """All settings, with the defaults, numbers as such."""
    words = {True: "on", False: "off"}
    defaults = {p["name"]: words[p["default"]] if p["type"] == "toggle" else p["default"] for p in labs.parameters(program)}
    numbers = {p["name"] for p in labs.parameters(program) if p["type"] in ("integer", "number")}
    return {name: float(value) if name in numbers else value for name, value in (defaults | settings).items()}


def bound_of(lab, values):
    """The first of the lab's bounds that is for these values, the settings and on how many pixels the object is, and its limit."""
    bound = next(bound for bound in BOUNDS[lab]
                 if all(values[name] in (allowed if isinstance(allowed, tuple) else (allowed,)) for name, allowed in bound.when.items()))
    return bound, bound.value(values)


def measured(program, number):
    settings = settings_of(program, number)
    said = labs.run(program, "--measure", "-", "--size", SIZE, *labs.flags(settings))
    if said.returncode != 0:
        return settings, None if "no exact answer" in said.stderr else said.stderr.strip()
    return settings, json.loads(said.stdout)


def sweep(program, count, pool):
    """The faults of a lab. Prints what was asked of it."""
    lab = pathlib.Path(program).name.removeprefix("lab")
    faults, used, unknown, nothing, coverage = [], {}, 0, 0, []
    for settings, found in pool.map(lambda number: measured(program, number), range(count)):
        typed = " ".join([lab, *labs.flags(settings)])
        if isinstance(found, str):
            faults.append(f"{typed}: {found}")
        elif found is None:
            unknown += 1
        elif found["mean"] is None:
            nothing += 1
        else:
            coverage.append(found["pixels"] / found["truth_pixels"])
            bound, limit = bound_of(lab, whole(program, settings) | {"pixels": found["pixels"]})
            share = found[bound.figure] / limit
            asked, most = used.get(bound, (0, 0))
            used[bound] = asked + 1, max(most, share)
            if share > 1:
                faults.append(f"{typed}: {bound.figure} {found[bound.figure]:.3g} {found['unit']} is above {limit:.3g}: {bound.because}")
            if found["non_finite"] > 0 and not bound.non_finite:
                faults.append(f"{typed}: {found['non_finite']} pixels are not finite")
    print(f"{lab}: {count} settings, {unknown} without an exact answer, {nothing} without the object; covered {100 * min(coverage, default=0):.1f} % of it "
          f"at least, {100 * sum(coverage) / max(len(coverage), 1):.2f} % in the mean")
    for bound, (asked, most) in used.items():
        print(f"  asked {asked:4}, used {100 * most:5.1f} %: {bound.figure} of {bound.when or 'all others'}; {bound.because}")
    return faults


def main():
    count, programs = int(sys.argv[1]), sys.argv[2:]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        faults = [fault for program in programs for fault in sweep(program, count, pool)]
    print("".join(f"{fault}\n" for fault in faults) + f"{len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
