// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/canvas.hpp"
#include "course/case.hpp"

namespace texel::bench {

/// A parameter and the values that it takes one after the other; none for all of a choice.
struct Variation {
  std::string parameter;
  std::vector<std::string> values;

  bool operator==(const Variation&) const = default;
};

/// A scene on which methods are measured against the truth and against the clock.
struct BenchCase : course::Case {
  std::vector<Variation> variations;  ///< at least one: every combination is measured
};

/// What a lab's methods are measured on.
struct BenchList {
  double seconds = 2;   ///< how long each case is timed; 0: not
  bool errors = true;   ///< whether the errors are measured
  bool counts = false;  ///< neither: callgrind counts what frames execute
  std::vector<BenchCase> cases;
};

/// Reads `{"seconds", "errors", "counts", "cases": [{"case", "size", "set": {parameter: value}, "vary":
/// {parameter: [values]}}]}`. Throws Error (exit 2) that names the case that is wrong.
BenchList parse_bench(const std::string& list);

/// Reads such a file. Throws Error (usage) that names the file and case,
/// also where the lab has no such parameter.
BenchList read_bench(app::AnyLab& lab, const std::filesystem::path& file);

/// Nanoseconds of a frame with the lab's present parameters: draws once to load what it needs, and once by
/// the clock. On hardware a timer query measures it. On a software renderer queries only time the call: there
/// the clock measures from an idle driver to glFinish. Throws Error as Canvas::draw.
double frame_nanoseconds(app::Canvas& canvas, glm::ivec2 size);

/// Measures error and cost of a lab's methods. What a frame costs is said twice: the times, which nobody
/// measures again, and with `counts` and under `valgrind --tool=callgrind --instr-atstart=no` the
/// instructions that it executes, which are the same each time: callgrind writes a dump for each frame,
/// and there are no results. The frames of a case are timed in
/// rounds: in each, every combination draws once to load what it needs and once by the clock, so that
/// whatever else the machine does meets all alike. Returns JSON:
///
///     {"renderer", "results": [{"lab", "case", "parameter", "method", "truth", "unit", what --measure
///      says of its error, "bytes", "frame_ns": [one a round],
///      "prepare_of": "triangle", "prepare_ns": [one a round, for each element]}]}
///
/// `parameter` and `method` name what varies and its values: "method, segments" and "averaged, 32". The last
/// two are there when the lab has something to prepare. Says on standard error which case it is at. Throws
/// Error as Canvas::draw.
std::string run_bench(app::Canvas& canvas, app::AnyLab& lab, const BenchList& list);

}  // namespace texel::bench
