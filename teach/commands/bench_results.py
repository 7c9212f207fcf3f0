# SPDX-License-Identifier: MIT
"""What a lab's methods cost and how wrong they are: from raw times to medians, ratios and the front of those that nothing beats.

A result is a dictionary as `texel bench --json` writes it. Its `parameter` and `method` name what varies and its values, as
"method, segments" and "averaged, 32". Without times, `cost_ns`, `cost_ratio`, `cost_spread` and `pareto` are None."""
import itertools
import json
import math
import pathlib

from course import Failure, reading

ALL_CASES = "all cases"  # the name of the results that sum up all cases of one truth
ERRORS = ("lab", "parameter", "method", "case", "truth", "unit", "mean", "rms", "p99", "max", "pixels", "truth_pixels", "non_finite")
LEAST_SPREAD, SAME_ERROR = 0.03, 0.02  # costs and errors this close to each other count as equal
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


def mark_front(results):
    """Marks those that no other one beats: cheaper and no worse, or better and no dearer."""

    def beats(a, b):
        if a["truth"] != b["truth"] or a["non_finite"]:
            return False
        same_cost = max(LEAST_SPREAD, a["cost_spread"] + b["cost_spread"])  # their intervals overlap
        cheaper, dearer = (a["cost_ratio"] < b["cost_ratio"] * (1 - same_cost), a["cost_ratio"] > b["cost_ratio"] * (1 + same_cost))
        better, worse = (error(a) < (1 - SAME_ERROR) * error(b), error(a) > (1 + SAME_ERROR) * error(b))
        return (cheaper and not worse) or (better and not dearer)

    for one in results:
        one["pareto"] = not one["non_finite"] and not any(beats(other, one) for other in results)


def add_costs(results, raw):
    """The costs of one case's results, from the lab's raw times in rounds."""
    frames = [one["frame_ns"] for one in raw]
    if len({len(times) for times in frames}) > 1:
        raise Failure(f"case '{results[0]['case']}' has not the same number of rounds for each method")
    # What slows a round down slows all its methods: each time counts beside the geometric mean of its round.
    rounds = [math.exp(sum(map(math.log, times)) / len(times)) for times in zip(*frames)]
    shares = [[time / of_round for time, of_round in zip(times, rounds)] for times in frames]
    cheapest = min(map(median, shares))
    for result, one, times, share in zip(results, raw, frames, shares):
        low, high = median_interval(share)
        result.update(cost_ns=float(median(times)), cost_ratio=median(share) / cheapest, cost_spread=(high - low) / (2 * median(share)),
                      rounds=len(times))
        if "prepare_ns" in one:
            result.update(prepare_ns=float(median(one["prepare_ns"])), prepare_of=one["prepare_of"])


def read_lab_output(file, lab):
    """The report on a lab that its program's --bench wrote. A case over a number has a front for each of its values."""
    with reading(file, "the lab's program wrote it"):
        output = json.loads(pathlib.Path(file).read_text(encoding="utf-8"))
        report = {"renderer": output["renderer"], "results": []}
        numbers = {bench["case"]: number_of(bench) for bench in lab["bench"]}
        for case, raw in itertools.groupby(output["results"], key=lambda one: one["case"]):
            raw = list(raw)
            results = [{key: one[key] for key in ERRORS} | {"cost_ns": None, "cost_ratio": None, "cost_spread": None, "bytes": one["bytes"],
                                                            "pareto": None} for one in raw]
            report["results"] += results
            if not any(one["frame_ns"] for one in raw):
                continue
            add_costs(results, raw)
            number = numbers.get(case)
            rivals = {}
            for result in results:
                rivals.setdefault(None if number is None else values_of(result)[number], []).append(result)
            for group in rivals.values():
                mark_front(group)
        return report


def read_report(file):
    """What `texel bench --json` wrote."""
    remedy = "write the file with texel bench --json"
    with reading(file, remedy):
        report = json.loads(pathlib.Path(file).read_text(encoding="utf-8"))
        for result in report["results"]:
            result.setdefault("truth_pixels", result.get("pixels"))  # a report from before they were counted
            if missing := {*ERRORS, "bytes", "cost_ns", "cost_ratio", "cost_spread", "pareto"} - set(result):
                raise Failure(f"{file}: a result has no {sorted(missing)[0]}; {remedy}")
        return report | {"renderer": str(report["renderer"])}


def to_json(report):
    return json.dumps(report, indent=1, ensure_ascii=False) + "\n"


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
    """One method in several cases."""

    def mean(key):
        return sum(one[key] / len(same) for one in same)

    def most(key):
        return max(one[key] for one in same)

    result = {key: value for key, value in same[0].items() if not key.startswith("prepare_")}
    return result | {"case": ALL_CASES, "mean": mean("mean"), "rms": math.sqrt(sum(one["rms"] * one["rms"] / len(same) for one in same)),
                     "p99": most("p99"), "max": most("max"), "pixels": sum(one["pixels"] for one in same),
                     "truth_pixels": sum(one["truth_pixels"] for one in same),
                     "non_finite": sum(one["non_finite"] for one in same), "bytes": most("bytes"), "cost_ns": mean("cost_ns"),
                     "cost_ratio": math.exp(sum(math.log(one["cost_ratio"]) / len(same) for one in same)), "cost_spread": most("cost_spread")}


def slopes(bench, results):
    """How fast the error falls in a case over a number: {the other values: exponent} by least squares in the logarithms."""
    number = number_of(bench)
    if number is None:
        return {}
    series = {}
    for one in results:
        values = values_of(one)
        if one["case"] == bench["case"] and error(one) > 0 and float(values[number]) > 0:
            series.setdefault(without(values, number), []).append((math.log(float(values[number])), math.log(error(one))))
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
