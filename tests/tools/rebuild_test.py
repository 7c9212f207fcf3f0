#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What an edit builds anew, as ninja would: an edit in one lab that lab, an edit in a shader nothing. rebuild_test.py BUILD"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

BUILD = pathlib.Path(sys.argv.pop())


class Rebuild(unittest.TestCase):
    def setUp(self):
        # Under another name the file is not made anew before anything else.
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.ninja = shutil.copy(BUILD / "build.ninja", pathlib.Path(folder.name) / "copy.ninja")
        self.assertEqual(self.built(), set(), "there is something to build before any edit")

    def built(self):
        """What a build would make now, by the names of its outputs."""
        said = subprocess.run(["ninja", "-n", "-v", "-C", BUILD, "-f", self.ninja], capture_output=True, text=True, check=True).stdout
        words = said.split()
        outputs = {word for before, word in zip(words, words[1:]) if before == "-o"}
        self.assertEqual(not outputs, "no work to do" in said, said)
        return outputs

    def built_after_saving(self, file):
        """The same while a file seems to be saved this moment; then it is as old as it was."""
        before = file.stat()
        os.utime(file)
        try:
            return self.built()
        finally:
            os.utime(file, ns=(before.st_atime_ns, before.st_mtime_ns))

    def test_of_one_lab_when_a_file_of_it_is_saved(self):
        edits = 0
        for lab in pathlib.Path("labs").glob("*/lab.cpp"):
            name = lab.parent.name
            steps = {file: f"labs/CMakeFiles/steps{name}.dir/{name}/{file.name}.o" for file in lab.parent.glob("*.cpp") if file != lab}
            for file in (file for file in lab.parent.rglob("*") if file.suffix in (".cpp", ".hpp")):
                wanted = {f"bin/lab{name}.new", steps.get(file, f"labs/CMakeFiles/lab{name}.dir/{name}/lab.cpp.o")}
                wanted.update(output for source, output in steps.items()
                              if file.name == "steps.hpp" or f'#include "{file.name}"' in source.read_text(encoding="utf-8"))
                if file in steps and name == "03_obj_texcoords":  # the reader of labs 4 and 5 is lab 3's
                    wanted.update(("bin/lab04_cube_wrap.new", "bin/lab05_normal_map.new"))
                # Tests and the command line link what students write, too.
                built = {output for output in self.built_after_saving(file) if output.startswith(("labs/", "bin/lab"))}
                self.assertEqual(built, wanted, file)
                edits += 1
        self.assertGreaterEqual(edits, 2 * 9)

    def test_of_nothing_when_a_shader_is_saved(self):
        shaders = [file for file in pathlib.Path("shaders").rglob("*") if file.is_file()]
        self.assertGreaterEqual(len(shaders), 3 * 9)
        for file in shaders:
            self.assertEqual(self.built_after_saving(file), set(), file)


if __name__ == "__main__":
    unittest.main()
