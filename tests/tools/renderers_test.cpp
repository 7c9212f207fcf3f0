// SPDX-License-Identifier: MIT
// `texel renderers`: each limit is three times what docs/renderers.json says, and that is whole.
#include "renderers/table.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support/picture_files.hpp"
#include "../support/places.hpp"
#include "core/files.hpp"

namespace texel::tools {
namespace {

const std::filesystem::path kRoot = test::kSource;

RendererReport kept() {
  return read_renderers(kRoot / "docs/renderers.json");
}

TEST(Renderers, have_a_row_for_each_case_and_no_limit_is_below_three_times_the_spread) {
  const RendererReport report = kept();
  std::size_t cases = 0;
  for (const course::Lab& lab : course::read_labs(kRoot / "labs"))
    for (const course::GradedCase& one : lab.cases) {
      SCOPED_TRACE(
          fmt::format("lab {}, {}: after a change of its case type ./run renderers", lab.number, one.name));
      ++cases;
      const auto row = std::find_if(
          report.cases.begin(), report.cases.end(),
          [&](const RendererReport::Row& r) { return r.lab == lab.number && r.name == one.name; });
      ASSERT_NE(row, report.cases.end());
      for (const auto& [group, spread] : row->by) EXPECT_GE(one.limit, 3 * spread) << group;
    }
  EXPECT_EQ(report.cases.size(), cases) << "a row without a case";
}

TEST(Renderers, are_those_of_three_versions_of_mesa) {
  const RendererReport report = kept();
  for (const char* mesa : {"mesa22", "mesa25", "mesa26"})
    for (const char* way :
         {"llvmpipe_egl", "llvmpipe_128", "llvmpipe_256", "llvmpipe_sse2", "llvmpipe_sse41", "llvmpipe_avx",
          "llvmpipe_rsqrt_exact", "llvmpipe_rsqrt_high", "llvmpipe_rsqrt_low", "softpipe_egl", "zink_egl"}) {
      const std::string name = fmt::format("{}_{}", mesa, way);
      EXPECT_TRUE(report.drawn_by.contains(name)) << name;
      // Each case was drawn by it.
      for (const RendererReport::Row& row : report.cases)
        EXPECT_TRUE(row.by.contains(group_of(name))) << row.lab << " " << row.name << ", " << group_of(name);
    }
  for (const char* way : {"mesa22_llvmpipe_osmesa", "mesa22_softpipe_osmesa"})
    EXPECT_TRUE(report.drawn_by.contains(way)) << way;
}

TEST(Renderers, have_their_section_in_the_document) {
  const std::string text = read_file(kRoot / "docs/accuracy.md");
  const std::size_t begin = text.find(fmt::format("\n{}", kRenderersTitle));
  ASSERT_NE(begin, text.npos);
  EXPECT_EQ(text.substr(begin), renderers_markdown(kept(), course::read_labs(kRoot / "labs")))
      << "./run renderers --judge-only renews it";
}

TEST(Renderers, are_kept_with_what_was_infinitely_far) {
  RendererReport report;
  report.drawn_by["mesa22_softpipe_egl"] = "softpipe, Mesa 22.3.6";
  report.cases.push_back({1, "a", "steps", {{"softpipe, mesa22", 2.5}, {"zink, mesa22", INFINITY}}});
  report.filters.push_back({1, "wall", "rms", {{"anisotropic, mesa22", 9.0}}});
  const test::TemporaryFolder folder("renderers");
  write_file(folder / "renderers.json", to_json(report));
  const RendererReport read = read_renderers(folder / "renderers.json");
  EXPECT_EQ(read.drawn_by, report.drawn_by);
  ASSERT_EQ(read.cases.size(), 1U);
  EXPECT_EQ(read.cases[0].by, report.cases[0].by);
  EXPECT_EQ(read.filters.at(0).by, report.filters[0].by);
}

TEST(Renderers, are_grouped_by_driver_and_version) {
  EXPECT_EQ(group_of("mesa22_llvmpipe_sse2"), "llvmpipe, mesa22");
  EXPECT_EQ(group_of("mesa25_zink_egl"), "zink, mesa25");
}

}  // namespace
}  // namespace texel::tools
