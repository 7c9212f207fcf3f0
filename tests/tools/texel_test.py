#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The program `texel` and the installed labs, run as a user runs them. texel_test.py BUILD [unittest's arguments]"""
import array
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import tree

ROOT = pathlib.Path.cwd()
BIN = pathlib.Path(sys.argv[1]).resolve() / "bin"
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "tests/figures"))
import labs  # noqa: E402

GREY = [100, 100, 100]


def texel(*arguments, cwd=None):
    """The exit code and all that it prints."""
    done = subprocess.run([BIN / "texel", *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, cwd=cwd)
    return done.returncode, done.stdout


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)


class Compare(InFolder):
    """Of pictures of 10x10: b differs from a by 60 steps of red in one pixel, and is 15 steps of green off in another."""

    def setUp(self):
        super().setUp()
        self.picture("a.png")
        self.picture("b.png", {(3, 4): [160, 100, 100], (5, 5): [100, 85, 100]})
        self.picture("mask.png", {(5, 5): [255], (0, 0): [255]}, [0])

    def picture(self, name, pixels=None, ground=GREY, size=10):
        """A square of one colour but for some pixels; y counts from below."""
        rows = [(pixels or {}).get((x, size - 1 - y), ground) for y in range(size) for x in range(size)]
        (self.folder / name).write_bytes(labs.png(size, size, rows))

    def vectors(self, name, *vector):
        """A picture of one vector everywhere."""
        (self.folder / name).write_bytes(b"PF\n4 4\n-1.0\n" + array.array("f", vector * 16).tobytes())

    def compare(self, *arguments):
        return texel("compare", *arguments, cwd=self.folder)

    def json_of(self, *arguments):
        return json.loads(self.compare("a.png", "b.png", "--json", *arguments)[1])

    def test_says_how_far_pictures_are_apart_and_whether_that_is_within_the_limits(self):
        self.vectors("x.pfm", 1, 0, 0)
        self.vectors("y.pfm", 0, 1, 0)
        self.vectors("long.pfm", 3, 0, 0)
        self.vectors("nan.pfm", 1, math.nan, 0)
        (self.folder / "small.png").write_bytes(labs.png(5, 10, GREY))
        (self.folder / "cut.png").write_bytes((self.folder / "a.png").read_bytes()[:40])
        (self.folder / "empty.png").touch()
        same = ('{"width": 10, "height": 10, "max": 0, "mean": 0, "p99": 0, "flip_mean": 0, "flip_p99": 0, "ssim": 1, "non_finite": 0, '
                '"unit": "8-bit steps"}\n')
        rows = [("a.png a.png --json", 0, same),
                # (60 + 15) steps over 300 samples; the pixel of rank 99 of 100 is the one of 15 steps.
                ("a.png b.png --json", 1, '"max": 60, "mean": 0.25, "p99": 15,'),
                ("a.png b.png --max 60 --mean 0.25 --p99 15", 0, ""),
                ("a.png b.png --mean 0.25", 0, ""),
                ("a.png b.png --max 59", 1, "max is 60, over the limit 59"),
                ("a.png b.png --mean 0.24", 1, ""),
                ("a.png b.png --p99 14", 1, ""),
                ("a.png b.png --max 60 --p99 14", 1, ""),
                ("a.png b.png --flip 1", 0, ""),
                ("a.png b.png --flip 1 --max 59", 1, ""),
                ("a.png b.png --flip 0.001", 1, "texel: flip is "),
                ("a.png b.png --flip 0.001", 1, ", over the limit 0.001"),
                ("a.png b.png --json --mask mask.png", 1, '"max": 15,'),
                ("x.pfm y.pfm --json", 1, '"max": 90, "mean": 90, "p99": 90, '),
                ("long.pfm y.pfm --json", 1, '"max": 3, '),
                # Whatever the limit.
                ("x.pfm nan.pfm --json --max 180", 1, '"non_finite": 16'),
                ("x.pfm x.pfm --json", 0, '"flip_mean": null, "flip_p99": null, "ssim": null,'),
                ("a.png a.png --mask small.png", 3, ""),
                ("a.png b.png --heatmap none/heat.png", 3, ""),
                ("x.pfm x.pfm --flip 1", 2, ""),
                ("", 2, "")]
        rows += [(f"a.png {other}", 3, "texel: ") for other in ("small.png", "cut.png", "empty.png", "none.png", "x.pfm", ".")]
        rows += [(f"a.png a.png {usage}", 2, "") for usage in ("--max", "--max red", "--maximum 3", "--heatmap a.jpg", "--flip", "third")]
        for arguments, exit_code, says in rows:
            with self.subTest(arguments):
                code, said = self.compare(*arguments.split())
                self.assertEqual(code, exit_code, said)
                self.assertIn(says, said)
                if code == 3:
                    self.assertEqual(said.count("\n"), 1, said)
        self.assertNotIn("FLIP", self.compare("x.pfm", "x.pfm")[1])

    def test_prints_and_draws_flip_and_ssim(self):
        said = self.compare("a.png", "b.png")[1]
        found = self.json_of()
        # These figures are the library's, which tests/unit/image_flip_test.cpp and image_ssim_test.cpp hold to plain versions of both.
        for name, key, value in (("FLIP mean", "flip_mean", 0.0185401952), ("FLIP p99", "flip_p99", 0.0978744030), ("SSIM", "ssim", 0.9443814566)):
            self.assertRegex(said, rf"{name} +{found[key]:.6g}\n")
            self.assertAlmostEqual(found[key], value, delta=1e-7)
        # Within a mask of one pixel, 6 from the nearest difference: the filters still reach it.
        self.picture("corner.png", {(0, 9): [255]}, [0])
        masked = self.json_of("--mask", "corner.png")
        self.assertGreater(masked["flip_mean"], 0)
        self.assertLess(masked["flip_mean"], found["flip_mean"])
        self.assertEqual(masked["flip_mean"], masked["flip_p99"])
        self.assertGreater(masked["ssim"], found["ssim"])
        self.compare("a.png", "b.png", "--heatmap", "heat.png")
        heat = labs.Picture(self.folder / "heat.png")
        self.assertEqual(heat.width, 10)
        self.assertNotEqual(heat.at(3, 4), heat.at(0, 0))


class Commands(InFolder):
    def test_say_what_is_wrong_with_them(self):
        self.assertEqual(texel("galery"), (2, "texel: there is no command 'galery'; did you mean 'gallery'?\n"))
        for line, exit_code in (("", 2), ("--help", 0), ("gallery --lab 1 --out /dev/null/page", 3), ("gallery --lab 12", 2), ("gallery --lab one", 2)):
            self.assertEqual(texel(*line.split())[0], exit_code, line)

    def test_list_names_each_lab_as_its_program_does_from_any_folder(self):
        code, said = texel("list", cwd="/")
        self.assertEqual(code, 0)
        self.assertEqual(len(tree.labs()), len(list(BIN.glob("lab[0-9]*"))))
        for lab in tree.labs():
            self.assertIn(lab["title"], said)
            # CLI11 breaks long lines since 2.5.
            help_text = " ".join(labs.run(BIN / f"lab{lab['lab']}", "--help").stdout.split())
            self.assertTrue(help_text.startswith(f"Lab {lab['number']}: {lab['title']}. {lab['lesson']}"), (lab["folder"], help_text[:200]))

    def test_the_legend_of_the_mask_has_the_two_colors_of_its_picture(self):
        drawn = self.folder / "mask.png"
        labs.run(BIN / "lab04_cube_wrap", "--view", "mask", "--size", "64x64", "--snapshot", drawn)
        colors = json.loads(labs.texts(drawn.read_bytes())["Legend"])["colors"]
        self.assertEqual({colors[at:at + 6] for at in range(0, len(colors), 6)}, {"333840", "ffffff"})

    def test_gallery_draws_a_lab_once_and_again_only_when_it_changed(self):
        out = self.folder / "page"
        command = ("gallery", "--lab", 1, "--out", out)
        code, said = texel(*command)
        self.assertEqual(code, 0, said)
        self.assertIn("pictures drawn", said)
        page, lab = (out / "index.html").read_text(encoding="utf-8"), tree.labs()[0]
        for look in lab["look"]:
            self.assertRegex(page, rf'"file":"[^"]*{look["name"]}.png"')
            self.assertGreater(labs.png_size(out / lab["folder"] / f"{look['name']}.png")[0], 0)
        self.assertNotIn("http", page, "the page asks nobody")
        self.assertIn("unchanged", texel(*command)[1])
        (out / lab["folder"] / f"{lab['look'][0]['name']}.png").unlink()
        self.assertIn("pictures drawn", texel(*command)[1])


class Installed(InFolder):
    def test_labs_draw_the_same_after_the_prefix_is_moved(self):
        first, moved = self.folder / "first", self.folder / "moved place"
        subprocess.run(["cmake", "--install", BIN.parent, "--prefix", first], stdout=subprocess.DEVNULL, check=True)
        first.rename(moved)
        for lab in ("lab01_texture_quad", "lab03_obj_texcoords", "lab05_normal_map", "lab09_bump"):
            here, there = self.folder / "here.png", self.folder / "there.png"
            self.assertEqual(labs.run(BIN / lab, "--size", "160x120", "--snapshot", here).returncode, 0)
            # Neither a variable nor the working directory leads back to the source tree.
            said = labs.run(moved / "bin" / lab, "--size", "160x120", "--snapshot", there, env={"TEXEL_ROOT": None}, cwd="/")
            self.assertEqual(said.returncode, 0, said.stderr)
            self.assertEqual(here.read_bytes(), there.read_bytes(), lab)
        # A broken shader in the moved prefix is the one that is read.
        (moved / "share/texel-labs/shaders/01_texture_quad/texture_quad.frag").write_text("broken\n", encoding="utf-8")
        said = labs.run(moved / "bin/lab01_texture_quad", "--snapshot", moved / "a.png", env={"TEXEL_ROOT": None})
        self.assertEqual(said.returncode, 3, said.stderr)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
