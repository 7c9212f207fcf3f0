# SPDX-License-Identifier: MIT
"""Holds a results.json against Gradescope's documented format, and against what make_class says must come out:
check_gradescope.py RESULTS.json CLASS.json ENTRY. Source: https://gradescope-autograders.readthedocs.io/en/latest/specs/"""
import json
import os
import sys

results_file, class_file, entry = sys.argv[1:]
assert os.path.getsize(results_file) <= 1_000_000
results = json.load(open(results_file))
formats = {"text", "html", "simple_format", "md", "ansi"}
visibilities = {"hidden", "after_due_date", "after_published", "visible"}
of_all = {"score": (int, float), "execution_time": (int, float), "output": str, "output_format": str, "test_output_format": str,
          "test_name_format": str, "visibility": str, "stdout_visibility": str, "extra_data": dict, "tests": list,
          "leaderboard": list}
of_test = {"score": (int, float), "max_score": (int, float), "status": str, "name": str, "name_format": str, "number": str,
           "output": str, "output_format": str, "tags": list, "visibility": str, "extra_data": dict}
for thing, known in [(results, of_all)] + [(test, of_test) for test in results["tests"]]:
    for key, value in thing.items():
        assert isinstance(value, known[key]), (key, value)
        assert not key.endswith("format") or value in formats, (key, value)
        assert not key.endswith("visibility") or value in visibilities, (key, value)
        assert key != "status" or value in {"passed", "failed"}, value
assert abs(results["score"] - sum(test["score"] for test in results["tests"])) < 1e-6
assert "a seed that no student reads" not in json.dumps(results)

# The ids of make_class are those of the class; each is known by its entry.
expected = [one for one in json.load(open(class_file))["students"].values() if one["entry"] == entry]
assert len(expected) == 1, entry
steps = {test["number"]: test for test in results["tests"] if test["max_score"] > 0}
passed = {step for step, test in steps.items() if test["status"] == "passed"}
if "passes" in expected[0]:
    assert passed == set(expected[0]["passes"]), (passed, expected[0]["passes"])
for step in expected[0].get("zero", []):
    assert steps[step]["score"] == 0, steps[step]
