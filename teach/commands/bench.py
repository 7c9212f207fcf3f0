#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures every method's error and cost, and plots one against the other.

Exit codes: 0 holds, 1 an error differs from --against, 2 wrong usage, 3 could not measure."""
import argparse
import concurrent.futures
import json
import math
import os
import pathlib
import re
import shutil
import sys
import time

sys.dont_write_bytecode = True
from bench_plot import svg  # noqa: E402
from bench_report import (GOES, PICTURES, by_lab, lab_markdown, main_plot, markdown, page, pictures_of, plot_file, plots,  # noqa: E402
                          terminal_table)
from bench_results import are_apart, differences, read_lab_output, read_report, to_json  # noqa: E402
from course import ROOT, Failure, call, program_of, read_labs, reading, run, write  # noqa: E402
from renderers_table import read_renderers, renderers_markdown  # noqa: E402

# How long the frames of a case are timed in one go, and of a lab's cases together. Cases whose costs have not parted then are timed again,
# so often. With the truths to be computed this keeps a lab below 60 s on two cores.
SECONDS_A_CASE, SECONDS_A_LAB = 1, 6


def cameras_of(bench):
    """The case by each of its cameras, which lie evenly around what they look at: the first is its own."""
    count = bench.get("cameras", 1)
    for i in range(count):
        yaw, pitch = i * 137.508 % 360 - 180, math.degrees(math.asin(2 * i / count - 1))
        yield bench["set"] | ({"yaw": f"{yaw:.2f}", "pitch": f"{max(-85, min(85, pitch)):.2f}"} if i > 0 else {})


def run_lab(lab, folder, benches, what, *before, env=None):
    """What a lab's program measures of these cases. `what` says what: seconds, errors, counts."""
    cases, output = folder / f"{lab['lab']}-cases.json", folder / f"{lab['lab']}-times.json"
    asked = [{key: bench[key] for key in ("case", "size", "vary")} | {"set": settings}
             for bench in benches for settings in (cameras_of(bench) if what["errors"] else [bench["set"]])]
    write(cases, json.dumps(what | {"cases": asked}, indent=2) + "\n")
    if not call(*before, program_of(lab), "--bench", cases, "--report", output, env=env):
        raise Failure(f"could not measure lab{lab['lab']}; see its message above")
    with reading(output, "the lab's program wrote it"):
        return json.loads(output.read_text(encoding="utf-8"))


def measure_lab(lab, folder, errors_only):
    """Errors of all cases, and times of each in rounds, until their intervals part or it has had GOES goes."""
    raw = run_lab(lab, folder, lab["bench"], {"seconds": 0, "errors": True})
    seconds, unparted = min(SECONDS_A_CASE, SECONDS_A_LAB / len(lab["bench"])), lab["bench"]
    for _ in range(0 if errors_only else GOES):
        timed = run_lab(lab, folder, unparted, {"seconds": seconds, "errors": False})["results"]
        frames = {}
        for one in timed:
            # By several cameras a method has several results: the first is that of the case's own.
            known = next(other for other in raw["results"] if (other["case"], other["method"]) == (one["case"], one["method"]))
            known["frame_ns"] += one["frame_ns"]
            if "prepare_ns" in one:
                known["prepare_ns"] = known.get("prepare_ns", []) + one["prepare_ns"]
            frames.setdefault(one["case"], []).append(known["frame_ns"])
        unparted = [bench for bench in unparted if not are_apart(frames[bench["case"]])]
        if not unparted:
            break
    write(folder / f"{lab['lab']}-raw.json", json.dumps(raw, indent=1) + "\n")
    return raw["renderer"]


def counted(lab, folder):
    """How many instructions each frame of a lab executes: callgrind counts two frames of each. On a busy machine about one in eighty executes
    up to 8 % more than the same frame once more, so the lesser count is taken."""
    dumps = folder / f"{lab['lab']}-callgrind"
    for old in folder.glob(f"{dumps.name}*"):
        old.unlink()
    run_lab(lab, folder, lab["bench"], {"seconds": 0, "errors": False, "counts": True}, "valgrind", "--quiet", "--tool=callgrind",
            "--instr-atstart=no", f"--callgrind-out-file={dumps}", env=os.environ | {"LP_NUM_THREADS": "0"})
    totals = {int(file.suffix[1:]): int(re.search(r"^totals: (\d+)", file.read_text(encoding="utf-8"), re.MULTILINE)[1])
              for file in folder.glob(f"{dumps.name}.*")}
    in_order = [totals[number] for number in sorted(totals)]
    return [min(both) for both in zip(in_order[::2], in_order[1::2])]


def count(labs, folder):
    """The counts of all labs at the same time, {lab: counts}; nothing where nothing can count."""
    if not shutil.which("valgrind"):
        print("the instructions are not counted: there is no valgrind here. The times rank instead", file=sys.stderr)
        return {}
    print("counting the instructions of each frame", file=sys.stderr, flush=True)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        counts = dict(zip((lab["lab"] for lab in labs), pool.map(lambda lab: counted(lab, folder), labs)))
    if not all(counts.values()):
        raise Failure("the labs' programs do not know valgrind: they were built where it was not installed. Remove build/release and build again")
    return counts


def measure(labs, folder, given):
    begin, renderer = time.monotonic(), ""
    for lab in labs:
        print(f"lab {lab['number']} {lab['title']}: {len(lab['bench'])} cases", file=sys.stderr, flush=True)
        begin_of_lab, renderer = time.monotonic(), measure_lab(lab, folder, given.errors_only)
        print(f"  {time.monotonic() - begin_of_lab:.0f} s, {time.monotonic() - begin:.0f} s in all", file=sys.stderr, flush=True)
    counts = {} if given.errors_only or "llvmpipe" not in renderer else count(labs, folder)
    return {"renderer": renderer, "results": [one for lab in labs for one in read_lab_output(
        folder / f"{lab['lab']}-raw.json", lab, counts.get(lab["lab"]))["results"]]}


def write_markdown(labs, report, gpu, file):
    """The page, and in a folder of its name beside it each lab's tables and plots, and the table of renderers."""
    folder = file.with_suffix("")
    for of in labs:
        write(folder / f"{of.lab['lab']}.svg", svg(main_plot(of), 1.5))
        for i, plot in enumerate(plots(of)):
            write(folder / plot_file(of.lab, i), svg(plot))
        write(folder / f"{of.lab['lab']}.md", lab_markdown(of, report["renderer"], gpu["renderer"]))
    write(folder / "renderers.md", renderers_markdown(read_renderers(ROOT / "docs/renderers.json"), read_labs()))
    write(file, markdown(labs, report["renderer"], gpu["renderer"], folder.name))


def draw_pictures(labs, out):
    """Draws what the page shows of each result, all labs at the same time."""
    print("drawing the page's pictures", file=sys.stderr, flush=True)

    def draw(of):
        folder = out / PICTURES / of.lab["lab"]
        write(folder / "batch.json", json.dumps([picture for section in of.sections() if section.bench for one in section.results
                                                 for picture in pictures_of(section.bench, one)], indent=1) + "\n")
        if not call(program_of(of.lab), "--batch", folder / "batch.json", "--out", folder):
            raise Failure(f"could not draw the pictures of lab{of.lab['lab']}; see its message above")

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(draw, labs))


def compare(then, report, labs, file):
    if then["renderer"] != report["renderer"]:
        for lab in labs:
            for method in lab.get("driver_methods", []):
                print(f"lab {lab['number']}, {method}: not compared, it depends on the driver, which was {then['renderer']}")
    lines = differences(then, report, labs)
    print("".join(f"{line}\n" for line in lines) + f"{len(lines)} of {len(report['results'])} errors differ from {file}")
    return 1 if lines else 0


def main():
    parser = argparse.ArgumentParser(prog="texel bench", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("labs", metavar="LAB", nargs="*", type=int, help="numbers of labs [all]")
    parser.add_argument("--out", type=pathlib.Path, default="out/bench", help="folder for the page with the plots, which --json and --markdown leave out [out/bench]")
    parser.add_argument("--json", type=pathlib.Path, help="write all figures as JSON")
    parser.add_argument("--markdown", type=pathlib.Path,
                        help="write the page as Markdown, and tables and plots into a folder with the file's name beside it")
    parser.add_argument("--from", dest="earlier", type=pathlib.Path, help="measure nothing: read the figures of an earlier --json")
    parser.add_argument("--gpu", type=pathlib.Path, help="show the ratios of this --json too, which a graphics card measured")
    parser.add_argument("--against", type=pathlib.Path, help="compare the errors with those of an earlier --json")
    parser.add_argument("--errors-only", action="store_true", help="measure errors, but no costs")
    parser.add_argument("--every", type=int, default=1, help="each so many-th case of a lab, as a sample")
    given = parser.parse_intermixed_args()
    if given.every < 1:
        parser.error("--every takes a number from 1")
    labs = [lab | {"bench": lab["bench"][::given.every]} for lab in read_labs(given.labs) if lab.get("bench")]
    report = read_report(given.earlier) if given.earlier else measure(labs, given.out, given)
    gpu = read_report(given.gpu) if given.gpu else {"renderer": "", "results": []}
    results = by_lab(labs, report, gpu)
    if given.json:
        write(given.json, to_json(report))
    if given.markdown:
        write_markdown(results, report, gpu, given.markdown)
    if given.against:
        return compare(read_report(given.against), report, labs, given.against)
    if not given.markdown and not given.json:
        print("".join(map(terminal_table, results)), end="", flush=True)
        draw_pictures(results, given.out)
        write(given.out / "index.html", page(results, report["renderer"]))
        print(f"\nplots: {given.out / 'index.html'}")
    return 0


if __name__ == "__main__":
    run("texel bench", main)
