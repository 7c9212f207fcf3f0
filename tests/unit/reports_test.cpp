// SPDX-License-Identifier: MIT
// Reports of classes that are not as usual: limits of size, runs that are not finished, broken pictures. What
// readers find in the files of a usual class is tested in tests/reports, the pages in a browser in tests/web.
#include "reports/reports.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "../../teach/reports/pictures.hpp"
#include "../../teach/reports/wording.hpp"
#include "../support/demo_class.hpp"
#include "../support/picture_files.hpp"
#include "../support/said.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/json.hpp"

namespace texel::reports {
namespace {

namespace fs = std::filesystem;
using test::has;

constexpr std::size_t kLargest = 1'000'000;

/// The demo class with its pictures in a folder of its own.
class Reports : public testing::Test {
 protected:
  [[nodiscard]] store::StudentResult& student(const std::string& id) {
    return *std::ranges::find(results_.students, id, &store::StudentResult::id);
  }
  /// A page of the report, written anew.
  [[nodiscard]] std::string page(const std::string& name) const {
    write_html(results_, folder_);
    return read_file(folder_ / "report" / name);
  }
  /// What a student's page shows.
  [[nodiscard]] Json shown(const store::StudentResult& of) const {
    const std::string html = page(page_name(of));
    const std::size_t begin = html.find("id=\"data\">") + 10;
    return parse_json(html.substr(begin, html.find("</script>", begin) - begin));
  }
  /// The row of the class's table with that number, the first of which is the head.
  [[nodiscard]] std::string csv_row(std::size_t number) const {
    std::string text = csv(results_);
    while (number-- > 0) text.erase(0, text.find("\r\n") + 2);
    return text.substr(0, text.find("\r\n"));
  }
  [[nodiscard]] std::string in_all_formats(const store::StudentResult& of) const {
    return to_text(shown(of)) + gradescope(of) + prairielearn(of, folder_) + junit(of, folder_) +
           csv(results_);
  }

  test::TemporaryFolder temporary_;
  fs::path folder_ = temporary_ / "out";
  store::ClassResult results_ = test::demo_class(folder_);
  store::StudentResult& ada_ = student("ada-half");
};

/// One student with 60 steps of 20 failed cases and far too much text.
store::StudentResult talkative() {
  store::StudentResult student;
  student.id = "talkative";
  student.logs = {{"lab.cpp", std::string(3'000'000, 'e')}};
  judge::LabResult lab;
  lab.lab = test::lab(1, "01_texture_quad", "Texture", {});
  for (int i = 0; i < 60; ++i) {
    judge::StepResult step;
    step.id = fmt::format("1.{}", i + 1), step.points = 3, step.score = 1.0 / 3;
    for (int k = 0; k < 1500; ++k) step.message += "ä€😀\"\n";  // characters of 2, 3 and 4 bytes
    for (int j = 0; j < 20; ++j) {
      step.cases.push_back(
          test::demo_case("01_texture_quad", step.id, fmt::format("case_{}", j), "color", j % 2 == 1, false));
      step.cases.back().message = step.message;
    }
    lab.steps.push_back(step);
  }
  student.labs = {lab};
  return student;
}

TEST_F(Reports, are_shortened_to_a_megabyte_without_losing_a_score) {
  for (const bool for_gradescope : {true, false}) {
    const std::string text = for_gradescope ? gradescope(talkative()) : prairielearn(talkative(), folder_);
    EXPECT_LE(text.size(), kLargest);
    EXPECT_GT(text.size(), kLargest / 4);     // no more was cut than had to be
    EXPECT_FALSE(has(text, "\xEF\xBF\xBD"));  // no character was cut in two
    const Json results = parse_json(text);
    EXPECT_NEAR(results["score"], for_gradescope ? 60 : 1.0 / 3, 1e-6);
    EXPECT_TRUE(has(results["output"], "(shortened)"));
    ASSERT_EQ(results["tests"].size(), for_gradescope ? 120U : 60U);
    for (const Json& test : results["tests"])
      EXPECT_NEAR(test[for_gradescope ? "score" : "points"], test.value("visibility", "") == "hidden" ? 0 : 1,
                  1e-5);
  }
}

TEST_F(Reports, for_prairielearn_leave_out_pictures_beyond_a_megabyte) {
  image::Image8 noise(256, 256, 3);
  std::mt19937 random(1);
  for (std::uint8_t& sample : noise.samples) sample = static_cast<std::uint8_t>(random());
  image::save_png(folder_ / "pictures/wrong.png", noise);  // 260 kB as a data URL
  const std::string text = prairielearn(ada_, folder_);
  EXPECT_LE(text.size(), kLargest);
  std::size_t images = 0;
  const Json results = parse_json(text);
  for (const Json& test : results["tests"]) images += test.value("images", Json::array()).size();
  EXPECT_GE(images, 2U);
  EXPECT_LT(images, 8U);
}

TEST_F(Reports, for_gradescope_leave_an_earlier_mark_after_an_incident) {
  EXPECT_THROW(gradescope(student("dora-incident")), Error);
  const std::string file = "gradescope/dora-incident/results.json";
  test::put(folder_, {{file, "an earlier one"}});
  write_format("gradescope", results_, folder_);
  EXPECT_EQ(read_file(folder_ / file), "an earlier one");
}

TEST_F(Reports, give_no_mark_in_any_format_while_the_run_is_not_finished) {
  ada_.judged = 29, ada_.planned = 44;
  const std::string why = "29 of 44 cases";
  EXPECT_TRUE(has(shown(ada_)["unmarked"], why));
  EXPECT_TRUE(has(page("index.html"), why));
  EXPECT_TRUE(has(page("index.html"), "2 not graded."));
  EXPECT_TRUE(csv_row(2).starts_with("Ada Half,ada-half,10232,,,,,,,,,,,not graded: ")) << csv_row(2);
  EXPECT_TRUE(has(csv_row(2), why));
  EXPECT_THROW(gradescope(ada_), Error);
  write_format("gradescope", results_, folder_);
  EXPECT_FALSE(fs::exists(folder_ / "gradescope/ada-half/results.json"));
  EXPECT_EQ(parse_json(prairielearn(ada_, folder_))["gradable"], false);
  EXPECT_TRUE(has(junit(ada_, folder_), "errors=\"1\""));
  ada_.judged = 44;
  EXPECT_EQ(shown(ada_)["unmarked"], "");
}

TEST_F(Reports, say_which_step_is_right_once_another_is_mended) {
  judge::StepResult& right = ada_.labs[1].steps[1];  // 5.2
  right.status = judge::Status::passed, right.score = 1, right.message = "", right.spoilt_by = {"5.1"};
  for (judge::CaseResult& one : right.cases)
    if (!one.passed()) one.judged = judge::Judged::alone, one.status = judge::Status::passed, one.score = 1;
  judge::StepResult& wrong = ada_.labs[1].steps[2];  // 5.3
  wrong.spoilt_by = {"5.1", "5.2"};
  wrong.cases.back().judged = judge::Judged::alone;
  ada_.labs[0].steps[0].cases[0].judged = judge::Judged::markers_lost;  // 3.1
  const std::string page = to_text(shown(ada_));
  for (const std::string& report :
       {page, gradescope(ada_), prairielearn(ada_, folder_), junit(ada_, folder_), csv(results_)}) {
    EXPECT_TRUE(has(report, "5.2 is right: with 5.1 mended it has full marks.")) << report;
    EXPECT_FALSE(has(report, "5.2 was")) << report;
  }
  for (const std::string& report : {page, gradescope(ada_), csv(results_)}) {
    EXPECT_TRUE(has(report, "5.3 was judged with 5.1 and 5.2 mended")) << report;
    EXPECT_TRUE(has(report, "3.1 was not judged alone, since its line //@step 3.1 begin")) << report;
  }
  EXPECT_EQ(shown(ada_)["labs"][1]["steps"][1]["spoilt"].size(), 2U);
  EXPECT_TRUE(has(page, "judged alone, "));
}

TEST_F(Reports, keep_a_hidden_command_until_its_reference_is_shown) {
  judge::CaseResult& hidden = ada_.labs[1].steps[1].cases[2];
  ASSERT_TRUE(hidden.hidden);
  hidden.command = "./run lab 5 --turn 123.456";
  EXPECT_FALSE(has(in_all_formats(ada_), "123.456"));
  hidden.reference = "pictures/right.pfm";
  EXPECT_TRUE(has(to_text(shown(ada_)), "123.456"));
}

TEST_F(Reports, as_csv_name_the_labs_of_which_steps_were_handed_in) {
  store::StudentResult& one = results_.students[0];
  for (judge::StepResult& step : one.labs[0].steps)
    for (judge::CaseResult& result : step.cases) result.status = judge::Status::untouched;
  EXPECT_TRUE(csv_row(1).ends_with(",5 9,"));
  one.fault = "is broken";
  EXPECT_TRUE(csv_row(1).ends_with(",,the submission is broken"));
  one.labs[1].steps[0].overridden = "seen on paper";
  EXPECT_TRUE(csv_row(1).ends_with(",5,the submission is broken"));
}

TEST_F(Reports, as_csv_quote_names_and_defuse_formulas) {
  results_.students.resize(1);
  for (const auto& [name, cell] : std::vector<std::pair<std::string, std::string>>{
           {"+1", "'+1"},
           {"-1", "'-1"},
           {"=1+1", "'=1+1"},
           {"@SUM(A1)", "'@SUM(A1)"},
           {"＝1", "'＝1"},
           {"＠x", "'＠x"},
           {"=HYPERLINK(\"http://x\",\"y\")", "\"'=HYPERLINK(\"\"http://x\"\",\"\"y\"\")\""},
           {"\t=1", "  =1"},  // a tab is shown as two spaces, which no spreadsheet skips
           {"two\r\nlines", "two lines"},
           {"Doe, \"Jane\"", "\"Doe, \"\"Jane\"\"\""},
           {"a;b", "\"a;b\""},
           {"1=2", "1=2"},
           {"O'Neil", "O'Neil"},
           {"名前", "名前"},
           {"", ""}}) {
    results_.students[0].name = name;
    EXPECT_TRUE(csv_row(1).starts_with(cell + ",index,")) << csv_row(1);
  }
}

TEST_F(Reports, say_once_what_is_true_of_many_cases) {
  const std::string fault = "contains no file of the labs.", broken = "lab.cpp does not compile";
  store::StudentResult& ben = student("ben-nothing");
  const auto fail_all = [&](const std::string& message) {
    for (judge::LabResult& lab : ben.labs)
      for (judge::StepResult& step : lab.steps) {
        for (judge::CaseResult& each : step.cases)
          each.status = judge::Status::failed, each.message = message, each.error = NAN, each.picture = "";
        step =
            judge::step_result(lab.lab.steps[static_cast<std::size_t>(&step - lab.steps.data())], step.cases);
      }
  };
  fail_all(broken);
  const Json once_a_step = shown(ben);
  for (const Json& lab : once_a_step["labs"])
    for (const Json& step : lab["steps"]) {
      EXPECT_EQ(step["message"], "");  // which the case has
      EXPECT_EQ(step["wrong"].size(), 1U);
      EXPECT_EQ(step["same"].size(), 2U);
    }
  ben.labs[0].steps[0].cases[1].message = "is stopped after 10 s";
  EXPECT_EQ(shown(ben)["labs"][0]["steps"][0]["wrong"][1]["message"], "is stopped after 10 s");
  fail_all(ben.fault = fault);
  const Json once = shown(ben);
  for (const Json& lab : once["labs"])
    for (const Json& step : lab["steps"]) {
      EXPECT_EQ(step["isExplained"], false);
      EXPECT_TRUE(step["wrong"].empty());
    }
}

/// Up to 42 steps of 6 cases, all wrong, with pictures that a PNG cannot make smaller.
TEST_F(Reports, keep_a_students_page_below_a_megabyte_and_a_half) {
  judge::StepResult wrong = ada_.labs[1].steps[1];
  wrong.cases.clear();
  for (int i = 0; i < 6; ++i)
    wrong.cases.push_back(
        test::demo_case("05_normal_map", wrong.id, fmt::format("case_{}", i), "normal", false, false));
  image::ImageF noise = test::ball(64, false);
  for (std::size_t i = 0; i < noise.samples.size(); ++i)
    noise.samples[i] = static_cast<float>(i * 2654435761U % 1000) / 500 - 1;
  image::save_pfm(folder_ / "pictures/wrong.pfm", noise);
  for (const std::size_t count : {1U, 42U}) {
    ada_.labs[1].steps.assign(count, wrong);
    EXPECT_LE(page(page_name(ada_)).size(), 1'500'000U);
    const Json data = shown(ada_);
    EXPECT_EQ(data["isReduced"], count > 1);
    const Json& first = data["labs"][1]["steps"][0]["wrong"];
    EXPECT_EQ(first[0]["panes"].size(), 2U);
    EXPECT_TRUE(has(first[0]["panes"][0]["url"], "data:image/png"));
    EXPECT_EQ(first[1]["isCompared"], count == 1) << "the numbers of the others are left out first";
  }
}

TEST_F(Reports, say_so_where_a_picture_is_missing_broken_or_too_large) {
  write_file(folder_ / "pictures/broken.png", read_file(folder_ / "pictures/right.png").substr(0, 200));
  write_file(folder_ / "pictures/broken.pfm", "PF\n64 64\n-1\nshort");
  image::save_png(folder_ / "pictures/wide.png", image::Image8(1025, 1, 1));
  image::save_pfm(folder_ / "pictures/high.pfm", image::ImageF(1, 1025, 3));
  fs::create_symlink(folder_ / "pictures/right.png", folder_ / "pictures/link.png");
  for (const auto& [path, problem] : std::vector<std::pair<std::string, std::string>>{
           {"pictures/right.png", ""},
           {"pictures/none.png", "The picture's file is missing."},
           {"pictures", "The picture's file is missing."},
           {"pictures/link.png", "The picture's file is missing."},
           {"pictures/broken.png", "The picture cannot be read."},
           {"pictures/broken.pfm", "The picture cannot be read."},
           {"pictures/wide.png", "The picture has 1025x1 pixels, too many to show here."},
           {"pictures/high.pfm", "The picture has 1x1025 pixels, too many to show here."}})
    EXPECT_EQ(Pictures(folder_).read(path, "color").problem, problem) << path;
  fs::remove(folder_ / "pictures/wrong.png");
  EXPECT_TRUE(has(to_text(shown(ada_)), "The picture's file is missing."));
}

TEST_F(Reports, hand_on_no_byte_of_a_students_png_but_its_pixels_and_are_the_same_bytes_each_time) {
  EXPECT_EQ(page(page_name(ada_)), page(page_name(ada_)));
  const image::Text secret[] = {{"Comment", "fingerprint of the file"}};
  image::save_png(folder_ / "pictures/wrong.png", test::lit(test::ball(64, true)), secret);
  const std::string url = Pictures(folder_).read("pictures/wrong.png", "color").url;
  fs::remove(folder_ / "pictures/wrong.png");
  test::write_pictures(folder_);  // the same without the text
  EXPECT_EQ(Pictures(folder_).read("pictures/wrong.png", "color").url, url);
}

TEST_F(Reports, refuse_an_id_that_leaves_the_folder) {
  results_.students[0].id = "../../x";
  for (const char* name : {"gradescope", "prairielearn", "junit"})
    EXPECT_THROW(write_format(name, results_, folder_), Error) << name;
  EXPECT_THROW(write_html(results_, folder_), Error);
}

TEST(ReportHint, is_plainer_the_nearer_a_step_is_or_that_of_its_wrong_case) {
  judge::StepResult step;
  step.hints = {"vague", "nearer", "plain"};
  step.cases.resize(2);
  EXPECT_EQ(hint(step), "nearer");
  step.cases[1].status = judge::Status::passed;
  EXPECT_EQ(hint(step), "plain");
  step.cases[0].name = "decode_flat";
  step.hint_of = {{"decode", 1}, {"decode_flat", 2}};
  EXPECT_EQ(hint(step), "nearer") << "of the case that is wrong";
  step.cases[0].status = judge::Status::untouched;
  EXPECT_EQ(hint(step), "vague");
}

TEST(ReportNumbers, keep_24_bits_of_a_float_to_2_to_the_power_of_minus_16) {
  const auto back = [](float value) { return std::bit_cast<float>(upper24(value) << 8U); };
  std::mt19937 random(7);
  std::uniform_real_distribution<float> exponent(-30, 30), mantissa(-1, 1);
  for (int i = 0; i < 100'000; ++i) {
    const float value = std::ldexp(mantissa(random), static_cast<int>(exponent(random)));
    EXPECT_LE(std::abs(back(value) - value), std::ldexp(std::abs(value), -16));
  }
  for (const float exact : {0.0F, 1.0F, -0.5F, 180.0F, std::numeric_limits<float>::infinity()})
    EXPECT_EQ(back(exact), exact);
  EXPECT_TRUE(std::isnan(back(std::numeric_limits<float>::quiet_NaN())));
  EXPECT_TRUE(std::isnan(back(std::bit_cast<float>(0x7f800001U))));  // whose upper bits are infinity's
}

TEST(ReportNumbers, are_written_without_needless_digits) {
  for (const auto& [value, text] :
       {std::pair(2.0, "2"), {2.5, "2.5"}, {1.0 / 3, "0.33"}, {-0.001, "0"}, {100.0, "100"}})
    EXPECT_EQ(number(value), text);
  EXPECT_EQ(number(100, 0), "100");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
}

}  // namespace
}  // namespace texel::reports
