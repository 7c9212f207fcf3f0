#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares each case's limit with the spread between renderers: those of this machine, and those of others whose folders lie in --out.

Exit codes: 0 every limit is three times the spread, 1 one is not or a mutant passes, 2 wrong usage, 3 could not draw."""
import argparse
import dataclasses
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from bench_results import ALL_CASES, read_report  # noqa: E402
from course import BIN, ROOT, Failure, captured, labs_option, read_labs, run, texel, write  # noqa: E402
from renderers_table import ROOM, group_of, limits_of, renderers_markdown, room_of, to_json  # noqa: E402

NAME, FILTERS, TOLERANCES = "renderer.txt", "filters.json", "tolerances"  # what a renderer's folder has beside the pictures
BUILD = BIN.parent
SOFTWARE = re.compile("llvmpipe|softpipe|lavapipe|swrast|Software Rasterizer")


@dataclasses.dataclass
class Renderer:
    """A way to draw that a machine may have."""
    name: str
    context: str  # a lab's --context
    says: str  # what its own name begins with; another driver stood in for it otherwise. Of hardware it is ""
    variables: dict = dataclasses.field(default_factory=dict)

    @property
    def environment(self):
        return os.environ | self.variables | {"TEXEL_CONTEXT": self.context}

    def ask(self):
        """What draws; "" where this machine has no such renderer."""
        if not pathlib.Path(self.variables.get("LD_PRELOAD", ROOT)).exists():
            return ""
        ran = captured(BIN / "texel", "cases", "renderer", "--context", self.context, env=self.environment, errors=subprocess.DEVNULL)
        said = ran.stdout.strip()
        is_wanted = said.startswith(self.says) if self.says else not SOFTWARE.search(said)
        return said if is_wanted and ran.returncode == 0 else ""


def rsqrt(how):
    """llvmpipe's 1/sqrt as other processors round it."""
    here = pathlib.Path(__file__).parent.relative_to(ROOT)
    return {"LD_PRELOAD": str(BUILD / here / "librsqrt.so"), "TEXEL_RSQRT": how}


RENDERERS = [
    Renderer("llvmpipe_osmesa", "osmesa", "llvmpipe"),
    Renderer("llvmpipe_egl", "egl", "llvmpipe"),
    # Registers of other sizes, and the instructions of older processors.
    Renderer("llvmpipe_128", "egl", "llvmpipe", {"LP_NATIVE_VECTOR_WIDTH": "128"}),
    Renderer("llvmpipe_256", "egl", "llvmpipe", {"LP_NATIVE_VECTOR_WIDTH": "256"}),
    Renderer("llvmpipe_sse2", "egl", "llvmpipe", {"GALLIUM_OVERRIDE_CPU_CAPS": "sse2"}),
    Renderer("llvmpipe_sse41", "egl", "llvmpipe", {"GALLIUM_OVERRIDE_CPU_CAPS": "sse4.1"}),
    Renderer("llvmpipe_avx", "egl", "llvmpipe", {"GALLIUM_OVERRIDE_CPU_CAPS": "avx"}),
    Renderer("llvmpipe_rsqrt_exact", "egl", "llvmpipe", rsqrt("exact")),
    Renderer("llvmpipe_rsqrt_high", "egl", "llvmpipe", rsqrt("high")),
    Renderer("llvmpipe_rsqrt_low", "egl", "llvmpipe", rsqrt("low")),
    Renderer("softpipe_osmesa", "osmesa", "softpipe", {"GALLIUM_DRIVER": "softpipe"}),
    Renderer("softpipe_egl", "egl", "softpipe", {"GALLIUM_DRIVER": "softpipe"}),
    # It complains on standard error where the last variable is missing.
    Renderer("zink_egl", "egl", "zink", {"MESA_LOADER_DRIVER_OVERRIDE": "zink", "XDG_RUNTIME_DIR": "/tmp"}),
    # The drivers that EGL asks, in its own order; the labs would be told Mesa's alone.
    Renderer("hardware_egl", "egl", "", {"LIBGL_ALWAYS_SOFTWARE": "0", "__EGL_VENDOR_LIBRARY_FILENAMES":
             "/usr/share/glvnd/egl_vendor.d/10_nvidia.json:/usr/share/glvnd/egl_vendor.d/50_mesa.json"})]


def version_of(says):
    """mesa22 of … Mesa 22.3.6, nvidia580 of … NVIDIA 580.95.05, else gpu"""
    found = re.search(r".*(Mesa|NVIDIA) ([^.]*)", says)
    return found[1].lower() + found[2] if found else "gpu"


def is_hardware(folder):
    return folder.endswith("_hardware_egl")


def say(text):
    print(text, flush=True)


def asked(what, *arguments, env=None):
    """The JSON that `texel cases` writes."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "answer.json"
        texel("cases", what, "--out", file, *arguments, env=env)
        return json.loads(file.read_text(encoding="utf-8"))


def draw(renderer, says, out):
    """Draws all cases into out/<version>_<name>, and measures lab 1's filters by the drivers that have their own."""
    folder = out / f"{version_of(says)}_{renderer.name}"
    shutil.rmtree(folder, ignore_errors=True)
    texel("cases", "draw", "--out", folder, "--context", renderer.context, env=renderer.environment)
    write(folder / NAME, says + "\n")
    say(f"{renderer.name}: drawn")
    if renderer.name in ("llvmpipe_egl", "hardware_egl"):
        texel("bench", "1", "--errors-only", "--out", out / "bench", "--json", folder / FILTERS, env=renderer.environment)
    return folder


def run_tests(renderer, folder):
    """Runs the tests that draw, and has them write into the folder what share of their limits they used. What failed."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    ran = captured("ctest", "--test-dir", BUILD, "--label-regex", "limits", "--parallel", os.cpu_count(), "--no-tests=error",
                   env=renderer.environment | {"TEXEL_TOLERANCES": str(folder)})
    failed = [f"{renderer.name}: {line}" for line in ran.stdout.splitlines() if "***" in line]
    if ran.returncode and not failed:
        raise Failure(f"the tests did not run: {ran.stdout}")
    say(f"{renderer.name}: tested, {len(failed)} failed")
    return failed


def case_rows(out, reference):
    rows = []
    for one in asked("spreads", "--drawn", out, "--reference", reference):
        row = {"lab": one["lab"], "case": one["case"], "unit": one["unit"], "by": {}}
        for folder, error in one["by"].items():
            if one["in_pages"] or not is_hardware(folder):
                # Where nothing could be compared it is further than anything.
                row["by"][group_of(folder)] = max(row["by"].get(group_of(folder), 0.0), float("inf") if error is None else error)
        rows.append(row)
    return rows


def test_rows(folders):
    """What run_tests left: a line has test, assertion and share."""
    rows = {}
    for folder in folders:
        own = {}
        for file in (folder / TOLERANCES).glob("*"):
            for line in file.read_text(encoding="utf-8").splitlines():
                test, assertion, share = line.split("\t")
                own[test, assertion] = max(own.get((test, assertion), 0.0), float(share))
        for (test, assertion), share in own.items():
            row = rows.setdefault((test, assertion), {"lab": 0, "case": test, "unit": assertion, "by": {}})
            row["least"] = min(row.get("least", share), share)
            row["by"][group_of(folder.name)] = max(row["by"].get(group_of(folder.name), 0.0), share)
    return [row for _, row in sorted(rows.items())]


def filter_rows(folders):
    rows = {}
    for folder in folders:
        for one in read_report(folder / FILTERS)["results"] if (folder / FILTERS).exists() else ():
            if one["method"] in ("anisotropic", "supersampled") and one["case"] != ALL_CASES:
                row = rows.setdefault(one["case"], {"lab": 1, "case": one["case"], "unit": "rms", "by": {}})
                row["by"][f"{one['method']}, {folder.name.split('_')[0]}"] = one["rms"]
    return [row for _, row in sorted(rows.items())]


def report_on(out, reference):
    """What the renderers' folders show."""
    folders = [file.parent for file in sorted(out.glob(f"*/{NAME}"))]
    drawn_by = {folder.name: (folder / NAME).read_text(encoding="utf-8").splitlines()[0] for folder in folders}
    return {"drawn_by": drawn_by, "cases": case_rows(out, reference), "tests": test_rows(folders), "filters": filter_rows(folders)}


def faults_of(report, labs):
    """Limits that leave too little room."""
    limits = limits_of(labs)
    faults = []
    for row in report["cases"]:
        limit = limits[row["lab"], row["case"]]
        faults += [f"lab {row['lab']}, {row['case']}: the limit {limit:g} is too small for the difference {error:.3g} of {group}"
                   for group, error in sorted(row["by"].items()) if limit < ROOM * error]
    return faults + [f"{row['case']}: {row['unit']} leaves room for {room_of(row, 1):.2g} times the spread between renderers, not for {ROOM}"
                     for row in report["tests"] if room_of(row, 1) < ROOM]


def main():
    parser = argparse.ArgumentParser(prog="texel renderers", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("labs", metavar="LAB", nargs="*", type=int, help="numbers of labs, with --mutants [all]")
    parser.add_argument("--out", type=pathlib.Path, default="out/renderers", help="folder of the pictures, one for each renderer [out/renderers]")
    parser.add_argument("--only", type=lambda text: text.split(","), help="names of renderers separated by commas [all]")
    parser.add_argument("--json", type=pathlib.Path, help="write the figures as JSON, as in docs/renderers.json")
    parser.add_argument("--markdown", type=pathlib.Path, help="write the tables into this file, as docs/accuracy/renderers.md")
    parser.add_argument("--reference", default="mesa22_llvmpipe_osmesa",
                        help="folder with which hidden cases are compared [mesa22_llvmpipe_osmesa]")
    parser.add_argument("--judge-only", action="store_true", help="draw nothing: judge the pictures that are there")
    parser.add_argument("--mutants", action="store_true", help="check that mutants and starters fail on each renderer")
    parser.add_argument("--cache", help="folder for starter, references and programs [build/grade]")
    given = parser.parse_intermixed_args()
    if given.labs and not given.mutants:
        parser.error("numbers of labs need --mutants")
    labs, faults = read_labs(), []
    read_labs(given.labs)
    for renderer in RENDERERS:
        if given.judge_only or (given.only and renderer.name not in given.only):
            continue
        if not (says := renderer.ask()):
            say(f"{renderer.name}: not on this machine")
        elif given.mutants:
            say(f"{renderer.name}:")
            passed = asked("mutants", "--context", renderer.context, *labs_option(given.labs), *(["--cache", given.cache] if given.cache else []),
                           env=renderer.environment)
            faults += [f"{renderer.name}: {fault}" for fault in passed]
        else:
            folder = draw(renderer, says, given.out)
            # The tests that draw hold what software reaches, which does not round a vertex's place as a GPU does.
            if not is_hardware(folder.name):
                faults += run_tests(renderer, (folder / TOLERANCES).resolve())
    if not given.mutants:
        report = report_on(given.out, given.reference)
        section = renderers_markdown(report, labs)
        if given.json:
            write(given.json, to_json(report))
        if given.markdown:
            write(given.markdown, section)
        if not given.json and not given.markdown:
            say(section)
        faults += faults_of(report, labs)
    print("".join(f"{fault}\n" for fault in faults), end="")
    return 1 if faults else 0


if __name__ == "__main__":
    run("texel renderers", main)
