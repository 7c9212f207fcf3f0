#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures every method's error and cost, and plots one against the other.

Exit codes: 0 holds, 1 an error differs from --against, 2 wrong usage, 3 could not measure."""
import argparse
import concurrent.futures
import json
import os
import pathlib
import sys
import time

sys.dont_write_bytecode = True
from bench_plot import svg  # noqa: E402
from bench_report import PICTURES, by_lab, markdown, page, pictures_of, plot_file, plots, terminal_table  # noqa: E402
from bench_results import differences, read_lab_output, read_report, to_json  # noqa: E402
from course import ROOT, Failure, call, program_of, read_labs, run, write  # noqa: E402
from renderers_table import read_renderers, renderers_markdown  # noqa: E402

# How long the frames of a lab are timed in all, and of one case at most. With the truths to be computed this keeps a lab below 40 s on
# two cores.
SECONDS_A_LAB, SECONDS_A_CASE = 12, 2


def measure_lab(lab, folder, errors_only):
    cases, output = folder / f"{lab['lab']}-cases.json", folder / f"{lab['lab']}-times.json"
    seconds = 0 if errors_only else min(SECONDS_A_CASE, SECONDS_A_LAB / len(lab["bench"]))
    asked = [{key: bench[key] for key in ("case", "size", "set", "vary")} for bench in lab["bench"]]
    write(cases, json.dumps({"seconds": seconds, "cases": asked}, indent=2) + "\n")
    if not call(program_of(lab), "--bench", cases, "--report", output):
        raise Failure(f"could not measure lab{lab['lab']}; see its message above")
    return read_lab_output(output, lab)


def measure(labs, folder, errors_only):
    report, begin = {"renderer": "", "results": []}, time.monotonic()
    for lab in labs:
        print(f"lab {lab['number']} {lab['title']}: {len(lab['bench'])} cases", file=sys.stderr, flush=True)
        begin_of_lab, own = time.monotonic(), measure_lab(lab, folder, errors_only)
        report = {"renderer": own["renderer"], "results": report["results"] + own["results"]}
        print(f"  {time.monotonic() - begin_of_lab:.0f} s, {time.monotonic() - begin:.0f} s in all", file=sys.stderr, flush=True)
    return report


def write_markdown(labs, renderer, gpu, file):
    for of in labs:
        for i, plot in enumerate(plots(of)):
            write(file.with_suffix("") / plot_file(of.lab, i), svg(plot))
    write(file, markdown(labs, renderer, gpu, file.stem) + renderers_markdown(read_renderers(ROOT / "docs/renderers.json"), read_labs()))


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
    parser.add_argument("--out", type=pathlib.Path, default="out/bench", help="folder for the page with the plots [out/bench]")
    parser.add_argument("--json", type=pathlib.Path, help="write all figures as JSON")
    parser.add_argument("--markdown", type=pathlib.Path,
                        help="write the tables as Markdown, and the plots into a folder with the file's name beside it")
    parser.add_argument("--from", dest="earlier", type=pathlib.Path, help="measure nothing: read the figures of an earlier --json")
    parser.add_argument("--gpu", type=pathlib.Path, help="show the ratios of this --json too, which a graphics card measured")
    parser.add_argument("--against", type=pathlib.Path, help="compare the errors with those of an earlier --json")
    parser.add_argument("--errors-only", action="store_true", help="measure errors, but no times")
    given = parser.parse_intermixed_args()
    labs = [lab for lab in read_labs(given.labs) if lab.get("bench")]
    report = read_report(given.earlier) if given.earlier else measure(labs, given.out, given.errors_only)
    gpu = read_report(given.gpu) if given.gpu else {"renderer": "", "results": []}
    results = by_lab(labs, report, gpu)
    if given.json:
        write(given.json, to_json(report))
    if given.markdown:
        write_markdown(results, report["renderer"], gpu["renderer"], given.markdown)
    if given.against:
        return compare(read_report(given.against), report, labs, given.against)
    if not given.earlier or not (given.markdown or given.json):
        print("".join(map(terminal_table, results)), end="", flush=True)
        draw_pictures(results, given.out)
        write(given.out / "index.html", page(results, report["renderer"]))
        print(f"\nplots: {given.out / 'index.html'}")
    return 0


if __name__ == "__main__":
    run("texel bench", main)
