// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include "canvas.hpp"

namespace texel::app {

/// Measures error and cost of a lab's methods, as a JSON file says:
///
///     {"seconds": 2,                        how long each case is timed; 0: the errors alone
///      "cases": [{"case": "tilted",         its name
///                 "size": "256x256",        of the picture
///                 "set": {"tilt": 75},      parameters of the whole case
///                 "vary": {"method": []}}]} each combination of these values is measured; []: all of a
///                 choice
///
/// The frames of a case are timed in rounds: in each, every combination draws once to load what it needs and
/// once by the clock, so that whatever else the machine does meets all alike. Returns JSON:
///
///     {"renderer", "results": [{"lab", "case", "parameter", "method", "truth", "unit", "mean", "rms", "p99",
///      "max", "pixels", "non_finite", "bytes", "frame_ns": [one a round],
///      "prepare_of": "triangle", "prepare_ns": [one a round, for each element]}]}
///
/// `parameter` and `method` name what varies and its values: "method, segments" and "averaged, 32". The last
/// two are there when the lab has something to prepare. The whole file is checked before the first is drawn.
/// Says on standard error which case it is at. Throws Error (usage) that names the file and case, and as
/// Canvas::draw.
std::string run_bench(Canvas& canvas, AnyLab& lab, const std::filesystem::path& file);

}  // namespace texel::app
