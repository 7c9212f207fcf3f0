// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "core/json.hpp"
#include "wording.hpp"

/// What the files for systems that keep marks have in common: plain text, and a limit of size.
namespace texel::reports {

/// Both systems say "1 MB"; this is its smaller reading.
inline constexpr std::size_t kLargestResults = 1'000'000;

/// A number of points without the noise of sums: to 6 decimals.
double rounded(double points);

/// Of the whole submission: the points, what the compiler refused, what was not taken.
std::string overview(const store::StudentResult& student);

/// "Passed.", and how the step was judged where its pictures are wrong all the same.
std::string passed_text(const judge::StepResult& step);

/// How the step was judged, the likely cause, the hint and the place of a step.
std::string advice(const judge::StepResult& step);

/// A line or more for each of the step's public or hidden cases.
std::string case_lines(const judge::StepResult& step, bool hidden);

/// The results as text of at most kLargestResults bytes: every "output" and "message" is cut to the same
/// length, as long as fits.
std::string fitted(const Json& results);

}  // namespace texel::reports
