// SPDX-License-Identifier: MIT
// `texel bench`: what it makes of raw times, and docs/accuracy.md.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>

#include "../labs/labs.hpp"
#include "bench/plot.hpp"
#include "bench/report.hpp"
#include "core/error.hpp"
#include "core/files.hpp"

namespace texel::commands {
namespace {

using test::has;
using test::Result;

const std::filesystem::path kRoot = test::kSource;

Result texel(const std::string& arguments) {
  return test::shell(fmt::format("{}/texel {}", test::kBin, arguments));
}

/// A lab whose program never runs: only its cases count.
course::Lab a_lab() {
  course::Lab lab;
  lab.number = 5;
  lab.folder = "05_normal_map";
  lab.title = "Normal map";
  const auto add = [&](const char* name, bool hard, std::vector<course::Variation> variations) {
    course::BenchCase& one = lab.bench.emplace_back();
    one.name = name, one.hard = hard, one.variations = std::move(variations);
  };
  add("flat", false, {{"method", {}}});
  add("round", true, {{"method", {}}});
  add("finer", false, {{"method", {"slow"}}, {"segments", {"8", "16", "32"}}});
  return lab;
}

/// One entry of a lab's --bench.
std::string entry(const std::string& name, const std::string& method, double mean, const std::string& times,
                  int non_finite = 0, const std::string& parameter = "method") {
  return fmt::format(
      R"({{"lab": "05_normal_map", "case": "{}", "parameter": "{}", "method": "{}", "truth": "relief",
          "unit": "degrees", "mean": {}, "rms": 0, "p99": 0, "max": 0, "pixels": 9, "non_finite": {}, "bytes": 7,
          "frame_ns": {}}})",
      name, parameter, method, mean, non_finite, times);
}

class LabOutput : public testing::Test {
 protected:
  BenchReport read(const std::vector<std::string>& entries) {
    const auto file = folder_ / "times.json";
    write_file(file, fmt::format(R"({{"renderer": "paper", "results": [{}]}})", fmt::join(entries, ",")));
    return read_lab_output(file, a_lab());
  }
  test::TemporaryFolder folder_{"bench_results"};
};

TEST_F(LabOutput, becomes_medians_and_ratios_within_each_round) {
  const BenchReport report =
      read({entry("flat", "quick", 4, "[10, 90, 20]"), entry("flat", "slow", 1, "[20, 180, 60]")});
  ASSERT_EQ(report.results.size(), 2U);
  EXPECT_EQ(report.renderer, "paper");
  EXPECT_EQ(report.results[0].cost->ns, 20);
  EXPECT_EQ(report.results[0].cost->ratio, 1);
  EXPECT_EQ(report.results[1].cost->ns, 60);
  EXPECT_EQ(report.results[1].cost->ratio, 2);  // of 2, 2 and 3: the slow round slowed both
}

TEST_F(LabOutput, has_a_front_of_what_nothing_beats) {
  const BenchReport report =
      read({entry("flat", "quick", 4, "[10]"), entry("flat", "worse", 5, "[20]"),
            entry("flat", "as_quick", 4.01, "[10.2]"), entry("flat", "best", 1, "[30]"),
            entry("flat", "broken", 0.1, "[9]", 1), entry("flat", "as_good", 1, "[40]")});
  const auto on_front = [&](std::size_t i) { return report.results[i].pareto; };
  EXPECT_TRUE(on_front(0));
  EXPECT_FALSE(on_front(1));  // dearer and worse than quick
  EXPECT_TRUE(on_front(2));   // 2 % and 0.25 %: no difference that can be measured
  EXPECT_TRUE(on_front(3));
  EXPECT_FALSE(on_front(4));  // not everywhere a number
  EXPECT_FALSE(on_front(5));  // as good as best, and dearer
}

TEST_F(LabOutput, has_a_front_for_each_number_and_a_slope_over_them) {
  const std::string both = "method, segments";
  const BenchReport report =
      read({entry("finer", "slow, 8", 16, "[10]", 0, both), entry("finer", "slow, 16", 4, "[20]", 0, both),
            entry("finer", "slow, 32", 1, "[40]", 0, both)});
  for (const BenchResult& result : report.results) EXPECT_TRUE(result.pareto) << result.method;
  const std::vector<Slope> lines = slopes(a_lab().bench[2], report.results);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].series, "slow");
  EXPECT_EQ(lines[0].number, "segments");
  EXPECT_NEAR(lines[0].exponent, -2, 1e-12);  // a quarter for twice as many
  EXPECT_TRUE(slopes(a_lab().bench[0], report.results).empty());
}

TEST_F(LabOutput, is_summed_over_the_cases_of_a_truth) {
  const BenchReport report = read({entry("flat", "quick", 4, "[10]"), entry("flat", "slow", 1, "[20]"),
                                   entry("round", "quick", 8, "[10]"), entry("round", "slow", 3, "[80]")});
  const std::vector<BenchResult> sums = over_all_cases(a_lab(), report.results);
  ASSERT_EQ(sums.size(), 2U);
  EXPECT_EQ(sums[0].case_name, kAllCases);
  EXPECT_EQ(sums[0].mean, 6);
  EXPECT_EQ(sums[1].mean, 2);
  EXPECT_EQ(sums[1].pixels, 18);
  EXPECT_NEAR(sums[1].cost->ratio, 4, 1e-12);  // the geometric mean of 2 and 8
  EXPECT_TRUE(sums[0].pareto && sums[1].pareto);
}

TEST_F(LabOutput, survives_our_own_json) {
  BenchReport report =
      read({entry("flat", "quick", 4, "[10]"), entry("round", "slow", 1, "[]")});  // the second without times
  const auto file = folder_ / "report.json";
  report.results[0].cost->prepare_ns = 12.5;
  report.results[0].cost->prepare_of = "triangle";
  write_file(file, to_json(report));
  const BenchReport again = read_report_json(file);
  EXPECT_EQ(to_json(again), to_json(report));
  EXPECT_EQ(again.results[0].cost->prepare_of, "triangle");
}

TEST_F(LabOutput, is_compared_with_an_earlier_report) {
  const BenchReport then = read({entry("flat", "quick", 4, "[10]"), entry("flat", "slow", 1, "[20]")});
  EXPECT_TRUE(differences(then, then, {}).empty());
  const BenchReport now = read({entry("flat", "quick", 4.1, "[99]"), entry("flat", "slow", 1.2, "[20]"),
                                entry("round", "slow", 1, "[20]")});
  const std::vector<std::string> lines =
      differences(then, now, {});  // 2.5 % are borne, times are not compared
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0], "lab 05_normal_map, flat, slow: mean error 1.2, not 1 degrees");
  EXPECT_EQ(lines[1], "lab 05_normal_map, round, slow: is missing in the report");
}

TEST_F(LabOutput, is_compared_where_the_driver_decides_with_the_same_renderer_only) {
  course::Lab lab;
  lab.folder = "05_normal_map";
  lab.driver_methods = {"slow"};
  const BenchReport then = read({entry("flat", "quick", 4, "[10]"), entry("flat", "slow", 1, "[20]")});
  BenchReport now = read({entry("flat", "quick", 5, "[10]"), entry("flat", "slow", 2, "[20]")});
  EXPECT_EQ(differences(then, now, {lab}).size(), 2U);
  now.renderer = "another";
  const std::vector<std::string> lines = differences(then, now, {lab});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_TRUE(has(lines[0], "quick"));
}

TEST_F(LabOutput, that_is_none_is_an_error_of_its_file) {
  EXPECT_THROW(read({"5"}), Error);
  EXPECT_THROW(read({entry("flat", "quick", 4, "[10]"), entry("flat", "slow", 1, "[]")}), Error);
  EXPECT_THROW(read_report_json(folder_ / "missing.json"), Error);
}

TEST(Plot, escapes_its_texts_and_draws_an_error_of_nothing) {
  const Plot plot{
      "x", "y", {{"a <b>", {{1, 1, 0, true, "one", "first"}, {9, 0, 1, false, "two", "second"}}, {}}}};
  const std::string picture = svg(plot);
  EXPECT_TRUE(has(picture, "a &lt;b&gt;"));
  EXPECT_TRUE(has(picture, ">one</text>"));
  EXPECT_TRUE(has(picture, ">two</text>"));  // on the lower edge
  EXPECT_FALSE(has(picture, "nan"));
  EXPECT_FALSE(has(picture, "inf"));
}

/// Where each label of a panel begins, from the left and from above.
std::vector<std::pair<double, double>> places(const std::string& panel, const std::string& label) {
  std::vector<std::pair<double, double>> all;
  const std::regex text("<text x=\"([0-9.-]+)\" y=\"([0-9.-]+)\"[^>]*>" + label + "</text>");
  for (std::sregex_iterator found(panel.begin(), panel.end(), text), end; found != end; ++found)
    all.emplace_back(std::stod((*found)[1]), std::stod((*found)[2]));
  return all;
}

TEST(Plot, has_no_label_upon_another_one) {
  Plot plot{"x", "y", {{"a", {}, {}}}};
  for (int i = 0; i < 9; ++i)  // nine methods that cost the same, and are equally wrong
    plot.panels[0].points.push_back({1 + 1e-3 * i, 1, 0, i < 3, "method", "title"});
  const auto found = places(panel_svgs(plot)[0], "method");
  EXPECT_EQ(found.size(), 9U);
  for (std::size_t i = 0; i < found.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)  // six letters of 6.3 units, and the height of a line
      EXPECT_TRUE(std::abs(found[i].first - found[j].first) > 37 ||
                  std::abs(found[i].second - found[j].second) > 11)
          << i << " and " << j;
}

TEST(TexelBench, refuses_a_lab_that_there_is_not_and_a_file_that_is_none) {
  EXPECT_EQ(texel("bench 42").exit_code, 2);
  EXPECT_EQ(texel("bench --from no/such.json").exit_code, 3);
}

TEST(AccuracyReport, is_what_its_figures_make) {
  const test::TemporaryFolder folder("accuracy");
  const std::filesystem::path made = folder / "accuracy.md";
  const Result result = texel("bench --from " + (kRoot / "docs/accuracy.json").string() + " --gpu " +
                              (kRoot / "docs/accuracy_gpu.json").string() + " --markdown " + made.string());
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(read_file(made), read_file(kRoot / "docs/accuracy.md")) << "./run accuracy renews it";
}

/// Whether a result is of the values that the lab has by default.
bool is_default(const BenchResult& result, const std::vector<test::Parameter>& parameters) {
  const std::vector<std::string> names = result.parameters(), values = result.values();
  for (std::size_t i = 0; i < names.size(); ++i)
    for (const test::Parameter& p : parameters)
      if (p.name == names[i] && p.initial != values[i]) return false;
  return true;
}

// What the labs take by default: finite in every case; and on the front over all cases of its stated truth,
// which is that of the first case over the same parameters.
TEST(AccuracyReport, has_every_default_on_the_front_and_finite) {
  const BenchReport report = read_report_json(kRoot / "docs/accuracy.json");
  const std::vector<LabResults> labs = by_lab(course::read_labs(kRoot / "labs"), report);
  ASSERT_EQ(labs.size(), std::size(test::kLabs));
  for (const LabResults& lab : labs) {
    const std::vector<test::Parameter> parameters = test::parameters_of(lab.lab.program());
    std::map<std::string, const BenchResult*>
        stated;  // by what varies: the default in the first case, or in all
    for (const BenchResult& result : lab.results) {
      if (!is_default(result, parameters)) continue;
      EXPECT_EQ(result.non_finite, 0) << lab.lab.title << ": " << result.case_name;
      const BenchResult*& known = stated[result.parameter];
      if (known == nullptr || (result.case_name == kAllCases && result.truth == known->truth))
        known = &result;
    }
    ASSERT_FALSE(stated.empty()) << lab.lab.title;
    for (const auto& entry : stated) {
      const BenchResult& result = *entry.second;
      const bool over_numbers = std::any_of(
          lab.lab.bench.begin(), lab.lab.bench.end(),
          [&](const course::BenchCase& b) { return b.name == result.case_name && number_of(b) >= 0; });
      EXPECT_TRUE(result.pareto || over_numbers) << lab.lab.title << ": " << result.method;
    }
  }
}

}  // namespace
}  // namespace texel::commands
