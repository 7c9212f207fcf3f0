#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures the course's programs beside others: what docs/performance.md says.

No figure fails. Exit codes: 0 all is measured, 2 wrong usage, 3 a result is missing or wrong."""
import argparse
import os
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True
from course import run, write  # noqa: E402
from performance_grading import measure_grading  # noqa: E402
from performance_kernels import measure_kernels  # noqa: E402
from performance_labs import measure_batches, measure_one_more, measure_peers, measure_snapshots  # noqa: E402
from performance_report import Report, Setting  # noqa: E402
from performance_waits import measure_tests, measure_waits  # noqa: E402

PARTS = {"snapshots": measure_snapshots, "warm": measure_one_more, "batch": measure_batches, "grading": measure_grading,
         "kernels": measure_kernels, "peers": measure_peers, "waits": measure_waits, "tests": measure_tests}


def main():
    parser = argparse.ArgumentParser(prog="./run performance", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=11, choices=range(1, 1001), metavar="N", help="rounds of each pair [11]")
    parser.add_argument("--only", choices=PARTS, help="one part alone")
    parser.add_argument("--first-run-before", type=pathlib.Path, metavar="TREE",
                        help="an earlier commit's tree, in which ./run build was typed: a student's first ./run beside it")
    parser.add_argument("--saves-before", type=pathlib.Path, metavar="TREE",
                        help="the same: from a save to the verdict, and ./run test, beside it")
    parser.add_argument("--json", type=pathlib.Path, help="write all figures into this file")
    parser.add_argument("--markdown", type=pathlib.Path, help="write the report into this file")
    given = parser.parse_args()
    # With the driver's cache of compiled shaders the second start would be another one than the first.
    os.environ["MESA_SHADER_CACHE_DISABLE"] = "true"
    report = Report()
    with tempfile.TemporaryDirectory(prefix="texel_performance_") as folder:
        setting = Setting(pathlib.Path(folder), given.rounds, given.first_run_before, given.saves_before)
        for name, measure in PARTS.items():
            if given.only in (None, name):
                measure(setting, report)
                # Now, so that a fault in a later part loses nothing.
                if given.json:
                    write(given.json, report.as_json())
                if given.markdown:
                    write(given.markdown, report.as_markdown(setting))
    return 0


if __name__ == "__main__":
    run("performance", main)
