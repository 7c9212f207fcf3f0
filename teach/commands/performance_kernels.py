# SPDX-License-Identifier: MIT
"""kernels_bench and obj_peak (tests/bench/kernels): Google Benchmark takes the rounds in random order."""
import json

from course import Failure
from performance_report import output_of, run_process

MILLISECONDS = {"ns": 1e-6, "us": 1e-3, "ms": 1, "s": 1e3}
# Ours, what it stands beside, and whether that is a target.
COMPARISONS = (("texel", "tinyobjloader", True), ("texel_mesh", "tinyobjloader", False), ("texel", "plain", True))


def target_of(stem):
    """How many times as fast as the other: small files are to be no slower. A heap of identical triangles has none: it has three distinct
    vertices, so that the plain version's maps stay in the nearest cache, and what is left is the same arithmetic."""
    if stem == "tangents/heap":
        return 0
    if stem.startswith("flip/"):
        return 5
    return 1 if stem.startswith("obj/") and not stem.endswith("2m") else 3


def measure_kernels(setting, report):
    report.begin("Kernels", """
        Google Benchmark, repetitions in random order. The plain versions of tangents and FLIP are in `tests/support`, and tests
        hold ours to their results; tinyobjloader is the packaged one.""", "texel", "the other")
    out = setting.work / "kernels.json"
    run_process("kernels_bench", f"--benchmark_repetitions={setting.rounds}", "--benchmark_enable_random_interleaving=true",
                "--benchmark_min_time=0.05", "--benchmark_out_format=json", f"--benchmark_out={out}")
    figures, triangles = {}, {}  # by name: milliseconds of all repetitions
    for one in json.loads(out.read_text(encoding="utf-8"))["benchmarks"]:
        if one["run_type"] == "iteration":
            if one.get("error_occurred"):
                raise Failure(f"{one['run_name']}: {one.get('error_message', 'failed')}")
            figures.setdefault(one["run_name"], []).append(one["real_time"] * MILLISECONDS[one["time_unit"]])
            triangles[one["run_name"]] = one.get("triangles", 0)
    for name, times in sorted(figures.items()):
        for ours, theirs, has_target in COMPARISONS:
            stem, found, rest = name.partition(f"/{ours}/")
            if found and (others := figures.get(f"{stem}/{theirs}/{rest}")):
                report.add(f"{stem}: {ours} beside {theirs}", "ms", list(zip(times, others)), at_least=target_of(stem) if has_target else 0)
    peak = json.loads(output_of("obj_peak"))["meshes_beside_the_file"]
    report.add("obj/quads_2m: memory beside the mapped file", "meshes", [(peak, 1)], at_most=2, names=("peak", "finished mesh"))

    report.begin("More triangles", """
        What one triangle costs in a large mesh and in a small one, in nanoseconds: an OBJ file of 10 and of 2 million triangles
        to its mesh, tangents of 4 million triangles and of 500 thousand. Caches hold less of the larger; a quadratic method would
        have the sizes' own ratio, 5 and 8.""",
                 "large", "small")
    for name, large in sorted(figures.items()):
        stem, found, rest = name.partition("/large/")
        if found:
            small = f"{stem}/small/{rest}"
            report.add(stem.partition("/")[2], "ns", [(1e6 * one / triangles[name], 1e6 * other / triangles[small])
                                                      for one, other in zip(large, figures[small])], at_most=1.5)
