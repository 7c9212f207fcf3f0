// SPDX-License-Identifier: MIT
// Two commands side by side: whole processes, in turn, so that whatever else the machine does meets both.
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace texel::bench {

/// What one run of a process took.
struct Run {
  double milliseconds = 0;  ///< from its start to its end
  double mebibytes = 0;     ///< of resident memory at most
};

/// Runs a program to its end; its output is thrown away. `environment` is added to the present one:
/// "NAME=value". Throws Error (exit 3) when it fails.
Run run_process(const std::vector<std::string>& command, const std::vector<std::string>& environment = {});

/// The middle of many figures, and the quarters below and above it.
struct Spread {
  double median = 0, lower = 0, upper = 0;
};
Spread spread_of(std::vector<double> figures);

/// One figure of this project beside the same of something else.
struct Pair {
  double ours = 0, theirs = 0;
};

/// Calls both in turn, `rounds` times and once before to warm up.
std::vector<Pair> interleaved(int rounds, const std::function<double()>& ours,
                              const std::function<double()>& theirs);

/// A line of the report.
struct Row {
  std::string what, ours_is, theirs_is, unit;
  Spread ours, theirs, ratio;
  std::string target;  ///< in words; empty: reported alone
  bool reached = true;
  std::string why;  ///< where the time goes and what was tried: told where the target is missed
};

enum class Target { at_most, at_least };

/// The ratio ours / theirs, of which at most so much is wanted; or, for what is to be faster, theirs / ours,
/// of which at least so much. A target of 0 is none.
Row row_of(const std::string& what, const std::string& ours_is, const std::string& theirs_is,
           const std::string& unit, const std::vector<Pair>& pairs, Target kind, double target,
           const std::string& why = {});

}  // namespace texel::bench
