# SPDX-License-Identifier: MIT
"""What a lab's methods cost and how wrong they are: from raw figures to medians, ratios and the front of those that nothing beats.

A result is a dictionary as `texel bench --json` writes it. Its `parameter` and `method` name what varies and its values, as
"method, segments" and "averaged, 32". What was not measured is None: `cost_*` without times, `instructions` where none were counted,
`pareto` without both, `error_*` for one camera.

What a method costs is said twice. Its time is what one waits for, and no two runs measure the same: `cost_ratio` lies in an interval,
and methods whose intervals overlap cost the same. The instructions that a software renderer executes for a frame are the same each
time: they count the vertices, the rasterising, the shader and the texels that a filter reads, with no model and no weights in
between. They know nothing of a cache that misses or of a processor that waits, and one of them may work on eight pixels. So they
rank, and the time stands beside them. A graphics card counts none: there the intervals rank."""
import itertools
import json
import math
import pathlib

from course import Failure, reading

ALL_CASES = "all cases"  # the name of the results that sum up all cases of one truth
ERRORS = ("lab", "parameter", "method", "case", "truth", "truth_error", "unit", "mean", "rms", "median", "p99", "max", "max_aside", "outline_pixels", "pixels",
          "truth_pixels", "non_finite")
OTHERS = ("cameras", "error_low", "error_high", "error_from", "error_to", "instructions", "cost_ns", "cost_ratio", "cost_spread",
          "rounds", "prepare_ns", "prepare_of", "bytes", "pareto", "pareto_bytes")
# What counts as equal: times and errors so close to each other, or with intervals that overlap; and counts so close: two runs
# differed by 0.006 % at most.
LEAST_SPREAD, SAME_ERROR, SAME_COUNT = 0.03, 0.02, 0.01
# Errors of two reports that are closer are the same. float32 rounds directions to a few 1e-6 degrees.
SAME_PART, SAME_UNITS = 0.05, 1e-5


def error_name(result):
    """The figure by which methods are ranked: as the labs' panel, for colours the one in which few pixels far off weigh as one sees them."""
    return "rms" if result["unit"] == "8-bit steps" else "mean"


def error(result):
    return result[error_name(result)]


def values_of(result):
    return result["method"].split(", ")


def is_number(text):
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False


def number_of(bench):
    """Which of the case's variations is a number that takes three values or more; or None."""
    return next((i for i, values in enumerate(bench["vary"].values()) if len(values) >= 3 and all(map(is_number, values))), None)


def without(values, number):
    """The values beside the number: they name a series."""
    return ", ".join(values[:number] + values[number + 1:])


def quantile(values, q):
    """Nearest rank."""
    return sorted(values)[math.floor(q * (len(values) - 1) + 0.5)]


def median(values):
    return quantile(values, 0.5)


def median_interval(values):
    """In which the median lies with 95 %, whatever the distribution: ranks half of 1.96 sqrt(n) to both sides (H. A. David and H. N. Nagaraja,
    "Order Statistics", 2003, section 7.1)."""
    rank = max(math.floor(len(values) / 2 - 0.98 * math.sqrt(len(values))), 0)
    return sorted(values)[rank], sorted(values)[len(values) - 1 - rank]


def around(value, spread):
    """The interval of a value whose half is this part of it: low, the value, high."""
    return value * (1 - spread), value, value * (1 + spread)


def is_less(a, b, least):
    """Whether the interval of a lies below that of b, and a by this part of b."""
    return a[2] < b[0] and a[1] < b[1] * (1 - least)


def mark_front(results):
    """Marks those that no other one beats: cheaper and no worse, or better and no dearer. Once for what a frame costs, and once for the
    bytes that it reads."""

    def work(one):
        return around(one["instructions"], SAME_COUNT / 2) if one["instructions"] else around(one["cost_ratio"], one["cost_spread"])

    def of_error(one):
        return (one["error_from"], error(one), one["error_to"]) if one["cameras"] else around(error(one), SAME_ERROR / 2)

    def beats(a, b, cost):
        if a["truth"] != b["truth"] or a["non_finite"]:
            return False
        cheaper, dearer = is_less(cost(a), cost(b), least), is_less(cost(b), cost(a), least)
        better, worse = is_less(of_error(a), of_error(b), SAME_ERROR), is_less(of_error(b), of_error(a), SAME_ERROR)
        return (cheaper and not worse) or (better and not dearer)

    def front(cost):
        return [not one["non_finite"] and not any(beats(other, one, cost) for other in results) for one in results]

    counted = all(one["instructions"] for one in results)
    if counted or all(one["cost_ratio"] for one in results):
        least = SAME_COUNT if counted else LEAST_SPREAD
        for one, of_work, of_bytes in zip(results, front(work), front(lambda one: around(one["bytes"], 0))):
            one.update(pareto=of_work, pareto_bytes=of_bytes)


def shares_of(frames, case):
    """Of each method's times in rounds, how large each is beside the geometric mean of its round: what slows a round down slows all its
    methods."""
    if len({len(times) for times in frames}) > 1:
        raise Failure(f"case '{case}' has not the same number of rounds for each method")
    rounds = [math.exp(sum(map(math.log, times)) / len(times)) for times in zip(*frames)]
    return [[time / of_round for time, of_round in zip(times, rounds)] for times in frames]


def are_apart(frames, case=""):
    """Whether the intervals of all these methods' costs have parted, so that more rounds say nothing new."""
    intervals = sorted(map(median_interval, shares_of(frames, case)))
    return all(low > high for (_, high), (low, _) in itertools.pairwise(intervals))


def add_costs(results, raw):
    """The costs of one case's results, from the lab's raw times in rounds."""
    frames = [one["frame_ns"] for one in raw]
    shares = shares_of(frames, results[0]["case"])
    cheapest = min(map(median, shares))
    for result, one, times, share in zip(results, raw, frames, shares):
        low, high = median_interval(share)
        result.update(cost_ns=float(median(times)), cost_ratio=median(share) / cheapest, cost_spread=(high - low) / (2 * median(share)),
                      rounds=len(times))
        if "prepare_ns" in one:
            result.update(prepare_ns=float(median(one["prepare_ns"])), prepare_of=one["prepare_of"])


def over_cameras(same):
    """One method's errors by several cameras: the means over all, the largest, the least and the largest of the cameras' errors (`error_low`,
    `error_high`), and in which interval their median lies with 95 % (`error_from`, `error_to`)."""
    if len(same) == 1:
        return same[0]
    errors = [error(one) for one in same]
    low, high = median_interval(errors)
    return sum_of(same) | {"case": same[0]["case"], "cameras": len(same), "error_low": min(errors), "error_high": max(errors), "error_from": low,
                           "error_to": high}


def read_lab_output(file, lab, counts=None):
    """The report on a lab that its program's --bench wrote. `counts` has the instructions of each frame, in the same order. A case over a number has a front for each of its values."""
    with reading(file, "the lab's program wrote it"):
        output = json.loads(pathlib.Path(file).read_text(encoding="utf-8"))
        report, counts = {"renderer": output["renderer"], "results": []}, iter(counts or ())
        numbers = {bench["case"]: number_of(bench) for bench in lab["bench"]}
        for case, raw in itertools.groupby(output["results"], key=lambda one: one["case"]):
            by_method = {}
            for one in raw:
                by_method.setdefault(one["method"], []).append(one)
            results = []
            for same in by_method.values():
                plain = [{key: one[key] for key in ERRORS} | dict.fromkeys(OTHERS) | {"bytes": one["bytes"]} for one in same]
                result = over_cameras(plain) | {"instructions": next(counts, None)}
                if "prepare_of" in same[0]:
                    result["prepare_of"] = same[0]["prepare_of"]
                results.append(result)
            report["results"] += results
            raw = [same[0] for same in by_method.values()]
            if any(one["frame_ns"] for one in raw):
                add_costs(results, raw)
            number = numbers.get(case)
            rivals = {}
            for result in results:
                rivals.setdefault(None if number is None else values_of(result)[number], []).append(result)
            for group in rivals.values():
                mark_front(group)
        if next(counts, None) is not None:
            raise Failure(f"{file}: there are more counts than results")
        return report


def read_report(file):
    """What `texel bench --json` wrote."""
    remedy = "write the file with texel bench --json"
    with reading(file, remedy):
        report = json.loads(pathlib.Path(file).read_text(encoding="utf-8"))
        for result in report["results"]:
            for key in ("truth_error", "median", "max_aside", "outline_pixels", *OTHERS):  # a report from before they were measured
                result.setdefault(key, None)
            result.setdefault("truth_pixels", result.get("pixels"))
            if missing := {*ERRORS, *OTHERS} - set(result):
                raise Failure(f"{file}: a result has no {sorted(missing)[0]}; {remedy}")
        return report | {"renderer": str(report["renderer"])}


def to_json(report):
    """Each result is one line, which a difference of two files shows."""
    results = ",\n".join(json.dumps(one, ensure_ascii=False) for one in report["results"])
    return f'{{"renderer": {json.dumps(report["renderer"])}, "results": [\n{results}\n]}}\n'


def over_all_cases(lab, results):
    """For every truth that more than one case has: the methods that are in all of them, with the mean over the cases of errors and cost.
    Cases over a number are left out: they vary something else."""
    groups = {}
    for bench in lab["bench"]:
        for one in results:
            if number_of(bench) is None and one["case"] == bench["case"] and one["lab"] == lab["lab"] and one["cost_ns"] is not None:
                groups.setdefault((one["truth"], one["parameter"]), []).append(one)
    sums = []
    for members in groups.values():
        cases, methods = {one["case"] for one in members}, {}
        for one in members:
            methods.setdefault(one["method"], []).append(one)
        group = [sum_of(same) for same in methods.values() if len(same) == len(cases) > 1]
        least = min((one["cost_ratio"] for one in group), default=1)  # the measure of the others
        for one in group:
            one["cost_ratio"] /= least
        mark_front(group)
        sums += group
    return sums


def sum_of(same):
    """One method in several cases, or by several cameras."""

    def known(key, what, values=same):
        return what([one[key] for one in values]) if all(one.get(key) is not None for one in values) else None

    def mean(values):
        return sum(values) / len(values)

    def square_mean(values):
        return math.sqrt(mean([value * value for value in values]))

    def geometric_mean(values):
        return math.exp(mean(list(map(math.log, values))))

    sums = {"mean": mean, "median": mean, "rms": square_mean, "truth_error": max, "p99": max, "max": max, "max_aside": max, "outline_pixels": sum, "pixels": sum,
            "truth_pixels": sum, "non_finite": sum, "bytes": max, "cameras": min, "error_from": mean, "error_to": mean, "instructions": mean, "rounds": min, "cost_ns": mean,
            "cost_ratio": geometric_mean, "cost_spread": max}
    identity = {key: same[0][key] for key in ("lab", "parameter", "method", "truth", "unit")}
    return dict.fromkeys((*ERRORS, *OTHERS)) | identity | {"case": ALL_CASES} | {key: known(key, what) for key, what in sums.items()}


def slopes(bench, results, figure=error):
    """How fast a figure of the error falls in a case over a number: {the other values: exponent} by least squares in the logarithms."""
    number = number_of(bench)
    if number is None:
        return {}
    series = {}
    for one in results:
        values = values_of(one)
        if one["case"] == bench["case"] and (figure(one) or 0) > 0 and float(values[number]) > 0:
            series.setdefault(without(values, number), []).append((math.log(float(values[number])), math.log(figure(one))))
    lines = {}
    for name, points in series.items():
        if len(points) >= 3:
            x, y, count = sum(px for px, _ in points), sum(py for _, py in points), len(points)
            xx, xy = sum(px * px for px, _ in points), sum(px * py for px, py in points)
            lines[name] = (count * xy - x * y) / (count * xx - x * x)
    return lines


def differences(then, now, labs):
    """Why `now` is not what `then` says, a line for each error. What a lab leaves to the driver is compared for one renderer only."""
    drivers = {(lab["lab"], method) for lab in labs for method in lab.get("driver_methods", [])} if then["renderer"] != now["renderer"] else ()
    olds = {(one["lab"], one["case"], one["method"]): one for one in reversed(then["results"])}
    lines = []
    for one in now["results"]:
        name, old = f"lab {one['lab']}, {one['case']}, {one['method']}", olds.get((one["lab"], one["case"], one["method"]))
        if (one["lab"], one["method"]) in drivers:
            continue
        if old is None:
            lines.append(f"{name}: is missing in the report")
        elif abs(error(one) - error(old)) > max(SAME_UNITS, SAME_PART * error(old)):
            lines.append(f"{name}: {error_name(one)} error {error(one):.4g}, not {error(old):.4g} {one['unit']}")
        elif (one["non_finite"] > 0) != (old["non_finite"] > 0):
            lines.append(f"{name}: {one['non_finite']} pixels are not finite, not {old['non_finite']}")
    return lines
