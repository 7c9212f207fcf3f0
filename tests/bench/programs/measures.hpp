// SPDX-License-Identifier: MIT
// What `performance` measures; each part adds its rows to the report, and throws Error where a result is
// missing or wrong.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "report.hpp"

namespace texel::bench {

struct Options {
  std::filesystem::path bin = TEXEL_BIN, root = TEXEL_SOURCE;
  std::filesystem::path work;  ///< scratch
  /// Earlier commits' trees, built by their ./run build; or none: what the first ./run, and what saves and
  /// tests, are compared with.
  std::filesystem::path first_run_before, saves_before;
  int rounds = 11;

  [[nodiscard]] std::string program(const std::string& name) const { return (bin / name).string(); }
  [[nodiscard]] std::string assets() const { return (root / "assets").string(); }
  [[nodiscard]] std::string work_file(const std::string& name) const { return (work / name).string(); }
  /// Variables with which the driver keeps its shaders from one process to the next, as it does for users.
  [[nodiscard]] std::vector<std::string> kept_shaders() const {
    return {"MESA_SHADER_CACHE_DISABLE=false", "MESA_SHADER_CACHE_DIR=" + work_file("shaders")};
  }
  /// Of what takes a minute each time.
  [[nodiscard]] int long_rounds() const { return rounds < 8 ? 1 : rounds / 4; }
};

/// Labs beside their floors: a first picture, one more, many in a batch, in the window.
void measure_snapshots(const Options& options, Report& report);
void measure_one_more(const Options& options, Report& report);
void measure_batches(const Options& options, Report& report);
void measure_frames(const Options& options, Report& report);
void measure_window_start(const Options& options, Report& report);

/// The pages and a lab's program beside three.js' page.
void measure_peers(const Options& options, Report& report);

/// `texel grade` beside drawing alone.
void measure_grading(const Options& options, Report& report);

/// A student's first ./run, and from a save to the verdict, beside an earlier commit's; nothing without one.
void measure_waits(const Options& options, Report& report);

/// ./run test from nothing and of one lab, beside an earlier commit's from nothing; nothing without one.
void measure_tests(const Options& options, Report& report);

/// kernels_bench and obj_peak.
void measure_kernels(const Options& options, Report& report);

}  // namespace texel::bench
