// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "canvas.hpp"
#include "settings.hpp"

namespace texel::app {

/// Pictures of one look by several methods.
struct BenchCase {
  std::string name;
  glm::ivec2 size;
  Settings set;                    ///< parameters of the whole case
  std::vector<Settings> variants;  ///< each combination of the values that vary
};

struct BenchPlan {
  double seconds = 2;  ///< how long each case is timed; 0: the errors alone
  std::vector<BenchCase> cases;
};

/// Reads what to measure:
///
///     {"seconds": 2,                        how long each case is timed; 0: the errors alone
///      "cases": [{"case": "tilted",         its name
///                 "size": "256x256",        of the picture
///                 "set": {"tilt": 75},      parameters of the whole case
///                 "vary": {"method": []}}]} each combination of these values is measured; []: all of a
///                 choice
///
/// Throws Error (usage) that names the file and case.
BenchPlan read_bench(AnyLab& lab, const std::filesystem::path& file);

/// Measures error and cost of a lab's methods. The frames of a case are timed in rounds: in each, every
/// combination draws once to load what it needs and once by the clock, so that whatever else the machine does
/// meets all alike. Returns JSON:
///
///     {"renderer", "results": [{"lab", "case", "parameter", "method", "truth", "unit", "mean", "rms", "p99",
///      "max", "pixels", "non_finite", "bytes", "frame_ns": [one a round],
///      "prepare_of": "triangle", "prepare_ns": [one a round, for each element]}]}
///
/// `parameter` and `method` name what varies and its values: "method, segments" and "averaged, 32". The last
/// two are there when the lab has something to prepare. Says on standard error which case it is at. Throws
/// Error as Canvas::draw.
std::string run_bench(Canvas& canvas, AnyLab& lab, const BenchPlan& plan);

}  // namespace texel::app
