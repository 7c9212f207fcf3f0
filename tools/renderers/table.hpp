// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "course/lab_file.hpp"

namespace texel::tools {

/// What docs/renderers.json keeps of many renderers.
struct RendererReport {
  struct Row {
    int lab = 0;
    std::string name, unit;            ///< of a case, and of its spread; or of a bench case, and "rms"
    std::map<std::string, double> by;  ///< the largest distance from what is expected, by group_of
  };
  std::map<std::string, std::string>
      drawn_by;              ///< "mesa22_llvmpipe_sse2": "llvmpipe (LLVM 15.0.6), Mesa 22.3.6"
  std::vector<Row> cases;    ///< the graded ones
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

}  // namespace texel::tools
