#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Figures that documents name: what a lab measures, beside tests/support/plain_figures.py. named_figures.py PROGRAM"""
import json
import pathlib
import statistics
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "tests/support"))
import labs
import plain_figures

PROGRAM = pathlib.Path(sys.argv[1])


def measured_each(looks, size=256):
    """What the lab measures of each look, by one process."""
    with tempfile.TemporaryDirectory() as folder:
        shots = [{"name": f"{i}.png", "view": "error", "size": f"{size}x{size}", "set": look} for i, look in enumerate(looks)]
        labs.draw(PROGRAM, shots, folder)
        return [json.loads(labs.texts(pathlib.Path(folder, shot["name"]).read_bytes())["Error"]) for shot in shots]


def measured(size=256, **settings):
    return measured_each([settings], size)[0]


def errors(**settings):
    """Of all compared pixels that are not exactly right."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "error.pfm"
        said = labs.run(PROGRAM, "--view", "error", "--size", "256x256", "--snapshot", file, *labs.flags(settings))
        assert said.returncode == 0, said.stderr
        return [pixel[0] for pixel in labs.Picture(file).pixels() if pixel[0] > 0]


def near(found, right, tolerance, what):
    assert abs(found - right) <= tolerance, f"{what}: {found:.4g}, not {right:.4g} +- {tolerance:g}"


def texture(name):
    return labs.Picture(ROOT / f"assets/textures/{name}.png")


def far_checkers_and_badges():
    """Lab 2. The right picture's levels are floats there: 0.001. Of a badge's mean light the smallest level keeps 8 bits: one level."""
    far = {"distance": "10", "field_of_view": "23.4", "texture_scale": "100"}
    for method, shown in (("encoded", 128), ("linear", 188), ("premultiplied", 188)):
        found = measured(texture0="checker", unit1_on="off", method=method, **far)
        mean, rms = plain_figures.far_checkers(256, shown)
        near(found["mean"], mean, 0.001, f"{method}, mean")
        near(found["rms"], rms, 0.001, f"{method}, rms")
    straight, premultiplied = plain_figures.badges(256, texture("brick"), texture("decal"))
    badges = {"texture0": "brick", "texture1": "decal", "combine": "decal"} | far
    near(measured(method="linear", **badges)["mean"], straight, 1, "straight")
    near(measured(method="premultiplied", **badges)["mean"], premultiplied, 1, "premultiplied")


def normals_of_a_torus_but_for_its_outline():
    """Lab 3. On 19 pixels at an outline the mesh ends where the exact torus does not, and one sees the sheet behind it, about 100 degrees off: they
    make the maximum, and two thirds of the rms. Measured 4.9 to 5.0 without them; the rest is half a degree of facets, more at the rim."""
    for normals in ("from-file", "smooth-angle"):
        found, (rms, most) = measured(model="torus", truth="normal", normals=normals), plain_figures.without_worst(
            errors(model="torus", truth="normal", normals=normals), 19)
        assert found["max"] > 100 and found["rms"] > 1.2, found
        near(rms, 0.445, 0.02, "rms but for 19 pixels")
        near(most, 5, 0.5, "maximum but for 19 pixels")
        assert most < found["max_aside"] < 15, found  # what a move by a pixel explains is told apart in each picture


def one_edge_of_a_cube():
    """Lab 4. One pixel at an edge belongs to the other face by rounding and is half a picture off: its 512 texels are all of the mean, and the
    others are float32's rounding."""
    found = measured(method="split")
    assert found["outline_pixels"] == 1 and found["p99"] < 1e-3, found
    near(found["mean"] - found["max"] / found["pixels"], found["median"], found["median"], "mean but for one pixel")


def a_torus_but_for_its_outline():
    """Lab 5. Five pixels, as the labs' own figure tells them apart."""
    look = {"model": "torus", "normal_map": "bump", "filter": "bilinear"}
    found, (rms, most) = measured(**look), plain_figures.without_worst(errors(**look), 5)
    assert found["max"] > 100 and found["outline_pixels"] == 5, found
    near(rms, 0.36, 0.07, "rms but for five pixels")
    near(most, found["max_aside"], 1e-3, "maximum but for five pixels")


def levels_at_a_seam():
    """Lab 6. By differences of angles in floats, and by those in doubles: .00005 measured between both. No lab measures the rim."""
    look = {"mapping": "sphere-2d", "truth": "level", "turn": "180", "tilt": "50", "yaw": "10"}
    plain, with_rim = plain_figures.levels_at_a_seam(50, 180, 10), plain_figures.levels_at_a_seam(50, 180, 10, rim=0)
    for method, most, with_its_rim in (("naive", 8.91, 8.91), ("wrapped", 2.91, 3.50), ("analytic", 1.40, 3.12)):
        found, (mean, largest) = measured(seam_method=method, **look), plain[method]
        near(found["mean"], mean, 0.0002, f"{method}, mean")
        near(found["max"], largest, 0.0002, f"{method}, the largest")
        near(largest, most, 0.005, f"{method}, the largest that documents name")
        near(with_rim[method][1], with_its_rim, 0.005, f"{method}, with the rim")


def points_minus_the_eye():
    """Lab 7. What is left of a float's digits: one camera's error hangs on their last bits, so the middle one of ten counts. 3 to 25 % measured
    between the lab and plain arithmetic; the documents' are of 30 cameras."""
    for near_plane, named in ((1e-3, 0.007), (1e-4, 0.06), (1e-5, 0.7)):
        yaws = [30 + 36 * camera for camera in range(10)]
        right = statistics.median(plain_figures.unprojected(near_plane, yaw)[1] for yaw in yaws)
        looks = [{"method": "unproject", "near": str(near_plane), "far": "100", "yaw": str(yaw), "pitch": "20"} for yaw in yaws]
        found = statistics.median(one["max"] for one in measured_each(looks))
        near(found, right, 0.5 * right, f"near {near_plane}")
        near(right, named, 0.35 * named, f"near {near_plane}, as documents name it")


def rays_and_shares():
    """Lab 8. Over pixels: their middles lie evenly, and at the rim they are on the ball or not; measured 9.722 of 9.735."""
    over_pixels, over_surface, rim = plain_figures.one_ray(4)
    near(over_surface, 11.797, 0.001, "over the visible surface")
    found = measured(method="constant-eye", distance="4")
    near(found["mean"], over_pixels, 0.02, "over pixels")
    near(found["max"], rim, 0.05, "at the rim")
    for rings, size, mean, most in ((32, 128, 0.267, 6.6), (32, 512, 0.268, 10.6), (64, 512, 0.068, 3.9)):
        ball = plain_figures.ball_of_triangles(rings, 2 * rings, size)
        near(ball[0], mean, 0.001, "rays at triangles, mean")
        near(ball[1], most, 0.05, "rays at triangles, largest")
        found = measured(size, normal_method="renormalised", rings=str(rings), segments=str(2 * rings))
        near(found["mean"], ball[0], 0.001, "rays at triangles")  # .0001 measured
        near(found["max"], ball[1], 0.02, "the largest")  # .003 measured: in that pixel the triangle is nearly seen from its side
    for index, most in ((1.33, 0.060), (1.5, 0.036), (3, 0.125)):
        near(plain_figures.schlick(index), most, 0.0005, f"Schlick's share, index {index}")


TESTS = {"02": far_checkers_and_badges, "03": normals_of_a_torus_but_for_its_outline, "04": one_edge_of_a_cube, "05": a_torus_but_for_its_outline,
         "06": levels_at_a_seam, "07": points_minus_the_eye, "08": rays_and_shares}

if __name__ == "__main__":
    TESTS[PROGRAM.name.removeprefix("lab")[:2]]()
