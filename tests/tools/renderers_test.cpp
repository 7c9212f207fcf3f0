// SPDX-License-Identifier: MIT
// `texel renderers`: each limit is three times what docs/renderers.json says, and that is whole.
#include "renderers/table.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <regex>
#include <set>

#include "../support/picture_files.hpp"
#include "../support/places.hpp"
#include "core/files.hpp"
#include "course/markers.hpp"

namespace texel::commands {
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

/// "measured(lab).mean < 0.4" of each EXPECT_BELOW(measured(lab).mean, 0.4) in the source and of its like.
std::vector<std::string> assertions(const std::string& source) {
  static const std::regex kMacro("(EXPECT|ASSERT)_(BELOW|ABOVE|WITHIN)\\("), kSpace("\\s+");
  std::vector<std::string> all;
  for (std::sregex_iterator macro(source.begin(), source.end(), kMacro), end; macro != end; ++macro) {
    std::vector<std::string> arguments(1);
    int depth = 1;
    for (const char* c = source.data() + macro->position() + macro->length(); depth > 0; ++c) {
      if (std::string_view("({[").find(*c) != std::string_view::npos) ++depth;
      if (std::string_view(")}]").find(*c) != std::string_view::npos) --depth;
      if (*c == ',' && depth == 1)
        arguments.emplace_back();
      else if (depth > 0)
        arguments.back() += *c;
    }
    for (std::string& argument : arguments)
      argument = std::regex_replace(std::regex_replace(argument, kSpace, " "), std::regex("^ | $"), "");
    if ((*macro)[2] == "WITHIN")
      all.push_back(fmt::format("{} within {} of {}", arguments.at(0), arguments.at(2), arguments.at(1)));
    else
      all.push_back(
          fmt::format("{} {} {}", arguments.at(0), (*macro)[2] == "BELOW" ? "<" : ">", arguments.at(1)));
  }
  return all;
}

TEST(Renderers, have_a_row_for_each_limit_of_a_test_and_room_below_it) {
  const RendererReport report = kept();
  std::set<std::string> written, measured;
  for (const char* folder : {"tests/labs", "tests/gl"})
    for (const std::filesystem::directory_entry& file : std::filesystem::directory_iterator(kRoot / folder))
      for (const std::string& assertion : assertions(read_file(file.path()))) written.insert(assertion);
  // Of the tables those that figures/check.py holds to a limit.
  static const std::regex kLine("\"((mean|p99|max)\\([^\"]* ([<>] (?!0\")|[^\"]*\\+-)[^\"]*)\"");
  for (const std::filesystem::directory_entry& file :
       std::filesystem::directory_iterator(kRoot / "tests/figures")) {
    const std::string text = file.path().extension() == ".toml" ? read_file(file.path()) : "";
    for (std::sregex_iterator line(text.begin(), text.end(), kLine), end; line != end; ++line)
      written.insert((*line)[1]);
  }
  for (const RendererReport::Row& row : report.tests) {
    measured.insert(row.unit);
    EXPECT_GE(row.room(1), 3) << row.name << ": " << row.unit;
  }
  EXPECT_GT(written.size(), 100U);
  std::vector<std::string> differ;
  std::set_symmetric_difference(measured.begin(), measured.end(), written.begin(), written.end(),
                                std::back_inserter(differ));
  EXPECT_EQ(differ, std::vector<std::string>()) << "after a change of a test's limit type ./run renderers";
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

TEST(Renderers, have_a_graphics_card_for_the_cases_that_pages_judge_by_one) {
  const RendererReport report = kept();
  const std::map<std::string, Place> places = course::first_places(kRoot);
  for (const course::Lab& lab : course::read_labs(kRoot / "labs"))
    for (const course::GradedCase& one : lab.cases)
      for (const RendererReport::Row& row : report.cases)
        if (row.lab == lab.number && row.name == one.name) {
          const bool is_of_a_page = !one.hidden && places.at(one.step).file.starts_with("shaders/");
          EXPECT_EQ(row.by.contains("hardware, nvidia580"), is_of_a_page) << row.lab << " " << row.name;
        }
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
  report.cases.push_back({1, "a", "steps", {{"softpipe, mesa22", 2.5}, {"zink, mesa22", INFINITY}}, 0});
  report.tests.push_back({0, "Views.depth", "most < 2", {{"zink, mesa22", 0.5}}, 0.25});
  report.filters.push_back({1, "wall", "rms", {{"anisotropic, mesa22", 9.0}}, 0});
  const test::TemporaryFolder folder("renderers");
  write_file(folder / "renderers.json", to_json(report));
  const RendererReport read = read_renderers(folder / "renderers.json");
  EXPECT_EQ(read.drawn_by, report.drawn_by);
  ASSERT_EQ(read.cases.size(), 1U);
  EXPECT_EQ(read.cases[0].by, report.cases[0].by);
  ASSERT_EQ(read.tests.size(), 1U);
  EXPECT_EQ(read.tests[0].unit, "most < 2");
  EXPECT_EQ(read.tests[0].room(1), 3);
  EXPECT_EQ(read.filters.at(0).by, report.filters[0].by);
}

TEST(Renderers, are_grouped_by_driver_and_version) {
  EXPECT_EQ(group_of("mesa22_llvmpipe_sse2"), "llvmpipe, mesa22");
  EXPECT_EQ(group_of("mesa25_zink_egl"), "zink, mesa25");
  EXPECT_EQ(group_of("nvidia580_hardware_egl"), "hardware, nvidia580");
}

}  // namespace
}  // namespace texel::commands
