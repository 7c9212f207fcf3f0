// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "course/lab_file.hpp"

namespace texel::commands {

/// What one method (or combination of values) costs and how wrong it is in one case.
struct BenchResult {
  std::string lab;        ///< "05_normal_map"
  std::string parameter;  ///< what varies: "method" or "method, segments"
  std::string method;     ///< its values: "averaged" or "averaged, 32"
  std::string case_name;
  std::string truth, unit;
  double mean = 0, rms = 0, p99 = 0, max = 0;  ///< error, in the unit, over the pixels that are finite
  long long pixels = 0, non_finite = 0, bytes = 0;

  struct Cost {
    double ns = 0;      ///< of a frame: median over the rounds
    double ratio = 1;   ///< to the cheapest of the case: median over the rounds of the ratio in each
    double spread = 0;  ///< of that ratio: half the distance of its quartiles, as a part of it
    std::optional<double> prepare_ns;  ///< for each element, before the first frame: median
    std::string prepare_of;            ///< "triangle"
  };
  std::optional<Cost> cost;  ///< nothing when only the errors were measured
  bool pareto =
      false;  ///< no other method of the case is better in one of error and cost and as good in the other

  /// The parameters that vary, and their values.
  [[nodiscard]] std::vector<std::string> parameters() const;
  [[nodiscard]] std::vector<std::string> values() const;

  /// The figure by which methods are ranked (app::ranks_by_rms).
  [[nodiscard]] double error() const;
  [[nodiscard]] const char* error_name() const;  ///< "rms" or "mean"
};

struct BenchReport {
  std::string renderer;
  std::vector<BenchResult> results;  ///< case by case
};

/// The name of the results that sum up all cases of one truth.
inline constexpr const char* kAllCases = "all cases";

/// The output of a lab's --bench: medians, ratios and the front of each case; in a case over a number, that
/// of each of its values. Throws Error (exit 3) when the file is none.
BenchReport read_lab_output(const std::filesystem::path& file, const course::Lab& lab);

/// For every truth of the lab that more than one case has: the methods that are in all of them, with the mean
/// over the cases of the errors and of the cost, and their front. Cases over a number are left out: they vary
/// something else.
std::vector<BenchResult> over_all_cases(const course::Lab& lab, const std::vector<BenchResult>& results);

/// One line through the points of a case over a number: how fast the error falls.
struct Slope {
  std::string series;  ///< the other values: "averaged"; or ""
  std::string number;  ///< the parameter: "segments"
  double exponent;     ///< error ~ number ^ exponent: least squares in the logarithms
};
/// Empty for a case over choices alone.
std::vector<Slope> slopes(const course::BenchCase& bench, const std::vector<BenchResult>& results);

/// Which of the case's variations is a number that takes three values or more; or -1.
int number_of(const course::BenchCase& bench);

/// The report as JSON and back. `texel bench --json` writes it.
std::string to_json(const BenchReport& report);
BenchReport read_report_json(const std::filesystem::path& file);

/// Why `now` is not what `then` says, one line for each error that differs by more than 5 % and by
/// more than 1e-5 of its unit, and each count that is not the same; empty when they agree. What a lab of
/// `labs` says is the driver's is compared only when both reports are of the same renderer.
std::vector<std::string> differences(const BenchReport& then, const BenchReport& now,
                                     const std::vector<course::Lab>& labs);

}  // namespace texel::commands
