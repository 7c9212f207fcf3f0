// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "course/lab_file.hpp"

namespace texel::commands {

/// What docs/renderers.json keeps of many renderers.
struct RendererReport {
  struct Row {
    int lab = 0;
    /// Of a case, and of its spread; of a test, and what it asserts; of a bench case, and "rms".
    std::string name, unit;
    /// By group_of: the largest distance from what is expected, share of a test's limit that was used, or
    /// error.
    std::map<std::string, double> by;
    double least =
        0;  ///< share of a test's limit that some renderer used; 0 for a case, which is one of them
    [[nodiscard]] double most() const;
    /// The way to the limit, by how far the renderers are from each other: 3 at least. Infinite for one
    /// renderer.
    [[nodiscard]] double room(double limit) const;
  };
  std::map<std::string, std::string>
      drawn_by;              ///< "mesa22_llvmpipe_sse2": "llvmpipe (LLVM 15.0.6), Mesa 22.3.6"
  std::vector<Row> cases;    ///< the graded ones
  std::vector<Row> tests;    ///< assertions of tests that draw, in shares of their limits
  std::vector<Row> filters;  ///< lab 1's errors, by "anisotropic, mesa22"
};

/// "llvmpipe, mesa22" of "mesa22_llvmpipe_sse2".
std::string group_of(const std::string& renderer);

std::string to_json(const RendererReport& report);
/// Throws Error (exit 3) when the file is none.
RendererReport read_renderers(const std::filesystem::path& file);

/// The section of docs/accuracy.md, beginning with an empty line and kRenderersTitle.
inline constexpr const char* kRenderersTitle = "## Renderers, and the room that limits leave them";
std::string renderers_markdown(const RendererReport& report, const std::vector<course::Lab>& labs);

}  // namespace texel::commands
