// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include "app/canvas.hpp"
#include "course/batch.hpp"

namespace texel::bench {

/// Reads a list for --bench, as course::parse_bench does. Throws Error (usage) that names the file and case,
/// also where the lab has no such parameter.
course::BenchList read_bench(app::AnyLab& lab, const std::filesystem::path& file);

/// Nanoseconds of a frame with the lab's present parameters: draws once to load what it needs, and once by
/// the clock. On hardware a timer query measures it. On a software renderer queries only time the call: there
/// the clock measures from an idle driver to glFinish. Throws Error as Canvas::draw.
double frame_nanoseconds(app::Canvas& canvas, glm::ivec2 size);

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
std::string run_bench(app::Canvas& canvas, app::AnyLab& lab, const course::BenchList& list);

}  // namespace texel::bench
