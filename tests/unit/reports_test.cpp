// SPDX-License-Identifier: MIT
// The grader's reports: what each consumer reads, hostile text, limits of size. The pages' behaviour is
// tested in a browser (tests/web).
#include "reports/reports.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>

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

std::size_t times(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// The demo class with its pictures in a folder of its own.
class Reports : public testing::Test {
 protected:
  Reports() : temporary_("grade_reports"), folder_(temporary_ / "out"), results_(test::demo_class(folder_)) {}

  [[nodiscard]] const store::StudentResult& student(const std::string& id) const {
    return *std::find_if(results_.students.begin(), results_.students.end(),
                         [&](const store::StudentResult& each) { return each.id == id; });
  }
  [[nodiscard]] std::string page(const store::StudentResult& of) const {
    write_html(results_, folder_);
    return read_file(folder_ / "report" / page_name(of));
  }

  test::TemporaryFolder temporary_;
  fs::path folder_;
  store::ClassResult results_;
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
    step.id = fmt::format("1.{}", i + 1);
    step.points = 3;
    step.score = 1.0 / 3;
    for (int j = 0; j < 20; ++j) {
      judge::CaseResult result =
          test::demo_case("01_texture_quad", step.id, fmt::format("case_{}", j), "color", j % 2 == 1, false);
      result.message.clear();
      for (int k = 0; k < 1500; ++k) result.message += "ä€😀\"\n";  // characters of 2, 3 and 4 bytes
      step.cases.push_back(result);
    }
    step.message = step.cases.front().message;
    lab.steps.push_back(step);
  }
  student.labs = {lab};
  return student;
}

// Gradescope

/// The fields of a results.json with their types and values, from "Autograder Specifications",
/// https://gradescope-autograders.readthedocs.io/en/latest/specs/: of the top level score, execution_time,
/// output, output_format, test_output_format, test_name_format, visibility, stdout_visibility, extra_data,
/// tests, leaderboard; of a test score, max_score, status, name, name_format, number, output, output_format,
/// tags, visibility, extra_data.
void check_gradescope(const Json& results) {
  const std::set<std::string> top = {"score",
                                     "execution_time",
                                     "output",
                                     "output_format",
                                     "visibility",
                                     "test_output_format",
                                     "test_name_format",
                                     "stdout_visibility",
                                     "extra_data",
                                     "tests",
                                     "leaderboard"};
  const std::set<std::string> of_test = {"score",       "max_score",  "status",    "name",
                                         "name_format", "number",     "output",    "output_format",
                                         "tags",        "visibility", "extra_data"};
  const std::set<std::string> visibilities = {"hidden", "after_due_date", "after_published", "visible"};
  const std::set<std::string> formats = {"text", "html", "simple_format", "md", "ansi"};
  ASSERT_TRUE(results.is_object());
  for (const auto& [name, value] : results.items()) EXPECT_TRUE(top.contains(name)) << name;
  EXPECT_TRUE(results.at("score").is_number());
  EXPECT_TRUE(results.at("output").is_string());
  EXPECT_TRUE(formats.contains(results.at("output_format")));
  EXPECT_TRUE(visibilities.contains(results.at("visibility")));
  for (const Json& test : results.at("tests")) {
    for (const auto& [name, value] : test.items()) EXPECT_TRUE(of_test.contains(name)) << name;
    EXPECT_TRUE(test.at("score").is_number());
    EXPECT_TRUE(test.at("max_score").is_number());
    EXPECT_LE(test.at("score"), test.at("max_score"));
    EXPECT_TRUE(test.at("status") == "passed" || test.at("status") == "failed");
    for (const char* name : {"name", "number", "output"}) EXPECT_TRUE(test.at(name).is_string()) << name;
    EXPECT_TRUE(formats.contains(test.at("output_format")));
    EXPECT_TRUE(visibilities.contains(test.at("visibility")));
    for (const Json& tag : test.at("tags")) EXPECT_TRUE(tag.is_string());
    // "If test cases are hidden, students will not be able to see their total score", but for those hidden
    // for good, which should not have points.
    if (test.at("visibility") != "visible") {
      EXPECT_EQ(test.at("visibility"), "hidden");
      EXPECT_EQ(test.at("max_score"), 0);
    }
  }
}

TEST_F(Reports, for_gradescope_have_its_fields_for_every_student) {
  for (const store::StudentResult& each : results_.students)
    if (each.incident.empty()) check_gradescope(parse_json(gradescope(each)));
}

TEST_F(Reports, for_gradescope_have_a_test_a_step_that_sum_up_to_the_score) {
  const Json results = parse_json(gradescope(student("ada-half")));
  EXPECT_DOUBLE_EQ(results["score"], student("ada-half").points());
  double score = 0, most = 0;
  std::vector<std::string> numbers;
  for (const Json& test : results["tests"]) {
    score += double(test["score"]);
    most += double(test["max_score"]);
    if (test["visibility"] == "visible") numbers.push_back(test["number"]);
  }
  EXPECT_DOUBLE_EQ(score, results["score"]);
  EXPECT_DOUBLE_EQ(most, student("ada-half").max_points());
  EXPECT_EQ(numbers, (std::vector<std::string>{"3.1", "5.1", "5.2", "5.3", "9.1"}));
  EXPECT_EQ(results["tests"][0]["status"], "passed");
  EXPECT_EQ(results["tests"][4]["status"], "failed");
  EXPECT_EQ(results["tests"][4]["tags"], (Json{"failed", "normal-green-flipped"}));
  EXPECT_TRUE(has(results["tests"][4]["output"], "This looks like: Green is inverted"));
  EXPECT_TRUE(has(results["tests"][4]["output"], "shaders/05_normal_map/tangent_frame.glsl:42"));
}

TEST_F(Reports, for_gradescope_tell_students_of_hidden_cases_only_how_many_failed) {
  const Json results = parse_json(gradescope(student("ada-half")));
  ASSERT_EQ(results["tests"].size(), 10U);
  for (const Json& test : results["tests"]) {
    const bool is_secret = test["visibility"] == "hidden";
    EXPECT_EQ(has(test["output"], "unseen_"), is_secret) << test;
  }
  EXPECT_TRUE(has(gradescope(student("ada-half")), "1 of 1 hidden case failed."));
}

TEST_F(Reports, for_gradescope_give_no_mark_after_an_incident) {
  const fs::path file = folder_ / "gradescope/dora-incident/results.json";
  write_format("gradescope", results_, folder_);
  EXPECT_FALSE(fs::exists(file));
  EXPECT_THROW(gradescope(student("dora-incident")), Error);
  fs::create_directories(file.parent_path());
  write_file(file, "an earlier one");
  write_format("gradescope", results_, folder_);
  EXPECT_EQ(read_file(file), "an earlier one");
}

TEST_F(Reports, for_gradescope_are_shortened_to_a_megabyte_without_losing_a_score) {
  const std::string text = gradescope(talkative());
  EXPECT_LE(text.size(), kLargest);
  EXPECT_GT(text.size(), kLargest / 4);  // no more was cut than had to be
  const Json results = parse_json(text);
  check_gradescope(results);
  EXPECT_NEAR(results["score"], 60, 1e-9);
  ASSERT_EQ(results["tests"].size(), 120U);
  for (std::size_t i = 0; i < 120; i += 2) EXPECT_NEAR(results["tests"][i]["score"], 1, 1e-5);
  EXPECT_TRUE(has(results["output"], "(shortened)"));
  EXPECT_FALSE(has(text, "\xEF\xBF\xBD"));  // no character was cut in two
}

// PrairieLearn

/// The fields of a results.json, from "Grading results", https://docs.prairielearn.com/externalGrading/ (in
/// the repository docs/externalGrading.md): score is 0 to 1 and mandatory where gradable, format_errors
/// belongs to what is not gradable, an image is an object of url and label.
void check_prairielearn(const Json& results) {
  const std::set<std::string> top = {"gradable", "score", "message",      "output",
                                     "images",   "tests", "format_errors"};
  const std::set<std::string> of_test = {"name",    "description", "points", "max_points",
                                         "message", "output",      "images"};
  const auto check_images = [](const Json& images) {
    for (const Json& image : images) {
      EXPECT_EQ(image.size(), 2U);
      EXPECT_TRUE(image.at("label").is_string());
      EXPECT_TRUE(std::string(image.at("url")).starts_with("data:image/png;base64,"));
    }
  };
  for (const auto& [name, value] : results.items()) EXPECT_TRUE(top.contains(name)) << name;
  EXPECT_TRUE(results.at("message").is_string());
  if (!results.at("gradable")) {
    EXPECT_FALSE(results.contains("score"));
    EXPECT_TRUE(results.at("format_errors").is_array());
    return;
  }
  EXPECT_FALSE(results.contains("format_errors"));
  EXPECT_GE(results.at("score"), 0);
  EXPECT_LE(results.at("score"), 1);
  EXPECT_TRUE(results.at("output").is_string());
  check_images(results.at("images"));
  for (const Json& test : results.at("tests")) {
    for (const auto& [name, value] : test.items()) EXPECT_TRUE(of_test.contains(name)) << name;
    for (const char* name : {"name", "message", "output"}) EXPECT_TRUE(test.at(name).is_string()) << name;
    EXPECT_TRUE(test.at("points").is_number());
    EXPECT_LE(test.at("points"), test.at("max_points"));
    if (test.contains("images")) check_images(test["images"]);
  }
}

TEST_F(Reports, for_prairielearn_have_its_fields_for_every_student) {
  for (const store::StudentResult& each : results_.students)
    check_prairielearn(parse_json(prairielearn(each, folder_)));
}

TEST_F(Reports, for_prairielearn_give_a_score_of_0_to_1_and_pictures_of_failed_cases) {
  const Json results = parse_json(prairielearn(student("ada-half"), folder_));
  EXPECT_NEAR(results["score"], student("ada-half").points() / student("ada-half").max_points(), 1e-6);
  EXPECT_FALSE(results["tests"][0].contains("images"));  // 3.1 passed
  EXPECT_EQ(results["tests"][2]["images"].size(), 3U);   // 5.2: a public case's two, a hidden one's own
  EXPECT_EQ(results["tests"][2]["images"][0]["label"], "turned_normal, yours");
  EXPECT_EQ(parse_json(prairielearn(student("index"), folder_))["score"], 1);
}

TEST_F(Reports, for_prairielearn_call_what_has_no_mark_not_gradable) {
  for (const char* id : {"dora-incident", "emil-bomb"})
    EXPECT_EQ(parse_json(prairielearn(student(id), folder_))["gradable"], false) << id;
}

TEST_F(Reports, for_prairielearn_leave_out_pictures_and_text_beyond_a_megabyte) {
  image::Image8 noise(256, 256, 3);
  std::mt19937 random(1);
  for (std::uint8_t& sample : noise.samples) sample = static_cast<std::uint8_t>(random());
  image::save_png(folder_ / "pictures/wrong.png", noise);  // 260 kB as a data URL
  const Json results = parse_json(prairielearn(student("ada-half"), folder_));
  std::size_t images = 0;
  for (const Json& test : results["tests"])
    if (test.contains("images")) images += test["images"].size();
  EXPECT_GE(images, 2U);
  EXPECT_LT(images, 8U);
  EXPECT_LE(prairielearn(student("ada-half"), folder_).size(), kLargest);

  const std::string text = prairielearn(talkative(), folder_);
  EXPECT_LE(text.size(), kLargest);
  check_prairielearn(parse_json(text));
  EXPECT_NEAR(parse_json(text)["score"], 1.0 / 3, 1e-6);
}

// JUnit

struct Element {
  std::string name, text;
  std::map<std::string, std::string> attributes;
  std::vector<Element> children;
};

/// A strict reader of the XML that a report may have: elements, attributes, text and the five entities.
class Xml {
 public:
  static Element parse(const std::string& text) {
    Xml xml(text);
    xml.expect("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    Element root = xml.element();
    xml.expect("\n");
    if (xml.at_ != text.size()) xml.fail("more after the root");
    return root;
  }

 private:
  explicit Xml(const std::string& text) : text_(text) {
    // XML 1.0, production 2: no control characters but tab and line ends, no U+FFFE and U+FFFF.
    for (std::size_t i = 0; i < text.size(); ++i) {
      const auto c = static_cast<unsigned char>(text[i]);
      if ((c < 0x20 && c != '\t' && c != '\n' && c != '\r') || text.compare(i, 3, "\xEF\xBF\xBE") == 0 ||
          text.compare(i, 3, "\xEF\xBF\xBF") == 0)
        fail("a character that XML has not");
    }
    Json(text).dump();  // throws for what is no UTF-8
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(what + " at: " + text_.substr(at_, 60));
  }
  void expect(const std::string& word) {
    if (text_.compare(at_, word.size(), word) != 0) fail("no " + word);
    at_ += word.size();
  }
  bool next(const std::string& word) {
    if (text_.compare(at_, word.size(), word) != 0) return false;
    at_ += word.size();
    return true;
  }
  std::string name() {
    const std::size_t end = text_.find_first_not_of("abcdefghijklmnopqrstuvwxyz-", at_);
    if (end == at_) fail("no name");
    const std::string result = text_.substr(at_, end - at_);
    at_ = end;
    return result;
  }
  std::string characters(char end) {
    std::string result;
    while (text_.at(at_) != end) {
      if (text_[at_] == '<' || text_[at_] == '>') fail("a bare bracket");
      if (text_[at_] != '&') {
        result += text_[at_++];
        continue;
      }
      bool known = false;
      for (const auto& [entity, means] :
           {std::pair("&amp;", '&'), std::pair("&lt;", '<'), std::pair("&gt;", '>'), std::pair("&quot;", '"'),
            std::pair("&#39;", '\'')})
        if (!known && next(entity)) {
          result += means;
          known = true;
        }
      if (!known) fail("an unknown entity");
    }
    return result;
  }
  Element element() {
    expect("<");
    Element result;
    result.name = name();
    while (next(" ")) {
      const std::string attribute = name();
      expect("=\"");
      if (!result.attributes.emplace(attribute, characters('"')).second) fail("an attribute twice");
      expect("\"");
    }
    if (next("/>")) return result;
    expect(">");
    while (true) {
      result.text += characters('<');
      if (next("</")) break;
      result.children.push_back(element());
    }
    expect(result.name + ">");
    return result;
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

/// Elements with their attributes and children, of what Jenkins (junit-10.xsd of its xUnit plugin,
/// https://github.com/jenkinsci/xunit-plugin) and GitLab ("JUnit XML format specification",
/// https://docs.gitlab.com/ci/testing/unit_test_reports/) both read.
void check_junit(const Element& element) {
  struct Rule {
    std::set<std::string> required, optional, children;
  };
  static const std::map<std::string, Rule> rules = {
      {"testsuites", {{}, {"name", "tests", "failures", "errors", "skipped"}, {"testsuite"}}},
      {"testsuite",
       {{"name", "tests", "failures", "errors"}, {"skipped"}, {"testcase", "system-out", "system-err"}}},
      {"testcase", {{"name", "classname"}, {}, {"failure", "error", "skipped", "system-out", "system-err"}}},
      {"failure", {{"message"}, {"type"}, {}}},
      {"error", {{"message"}, {"type"}, {}}},
      {"skipped", {{}, {"message"}, {}}},
      {"system-out", {}},
      {"system-err", {}}};
  ASSERT_TRUE(rules.contains(element.name)) << element.name;
  const Rule& rule = rules.at(element.name);
  for (const std::string& name : rule.required) EXPECT_TRUE(element.attributes.contains(name)) << name;
  for (const auto& [name, value] : element.attributes)
    EXPECT_TRUE(rule.required.contains(name) || rule.optional.contains(name)) << element.name << ' ' << name;
  for (const Element& child : element.children) {
    EXPECT_TRUE(rule.children.contains(child.name)) << element.name << ' ' << child.name;
    check_junit(child);
  }
  if (element.name != "testsuite") return;
  std::map<std::string, std::size_t> found;
  std::set<std::string> names;
  for (const Element& test : element.children) {
    if (test.name != "testcase") continue;
    ++found["tests"];
    for (const Element& state : test.children) ++found[state.name];
    // GitLab takes only the first of two tests of one name.
    EXPECT_TRUE(names.insert(test.attributes.at("classname") + "/" + test.attributes.at("name")).second);
  }
  EXPECT_EQ(element.attributes.at("tests"), std::to_string(found["tests"]));
  EXPECT_EQ(element.attributes.at("failures"), std::to_string(found["failure"]));
  EXPECT_EQ(element.attributes.at("errors"), std::to_string(found["error"]));
  EXPECT_EQ(element.attributes.at("skipped"), std::to_string(found["skipped"]));
}

TEST_F(Reports, as_junit_are_sound_xml_with_the_known_elements_for_every_student) {
  for (const store::StudentResult& each : results_.students) {
    const Element root = Xml::parse(junit(each, folder_));
    EXPECT_EQ(root.name, "testsuites");
    check_junit(root);
  }
}

TEST_F(Reports, as_junit_say_what_failed_and_what_the_grader_could_not_do) {
  const Element ben = Xml::parse(junit(student("ben-nothing"), folder_));
  EXPECT_EQ(ben.attributes.at("tests"), "15");
  EXPECT_EQ(ben.attributes.at("failures"), "15");
  const Element dora = Xml::parse(junit(student("dora-incident"), folder_));
  EXPECT_EQ(dora.attributes.at("errors"), "1");
  const Element emil = Xml::parse(junit(student("emil-bomb"), folder_));
  EXPECT_EQ(emil.attributes.at("failures"), "1");
}

TEST_F(Reports, say_which_step_is_right_once_another_is_mended) {
  store::StudentResult ada = student("ada-half");
  judge::StepResult& right = ada.labs[1].steps[1];  // 5.2
  right.status = judge::Status::passed, right.score = 1, right.message = "", right.spoilt_by = {"5.1"};
  for (judge::CaseResult& one : right.cases)
    if (!one.passed())
      one.judged = judge::Judged::alone, one.status = judge::CaseStatus::passed, one.score = 1;
  judge::StepResult& wrong = ada.labs[1].steps[2];  // 5.3
  wrong.spoilt_by = {"5.1", "5.2"};
  wrong.cases.back().judged = judge::Judged::alone;
  ada.labs[0].steps[0].cases[0].judged = judge::Judged::markers_lost;  // 3.1
  store::ClassResult results;
  results.students = {ada};
  write_html(results, folder_);
  const std::string page = read_file(folder_ / "report" / page_name(ada));
  for (const std::string& shown :
       {page, gradescope(ada), prairielearn(ada, folder_), junit(ada, folder_), csv(results)}) {
    EXPECT_TRUE(has(shown, "5.2 is right: with 5.1 mended it has full marks.")) << shown;
    EXPECT_FALSE(has(shown, "5.2 was")) << shown;
  }
  for (const std::string& shown : {page, gradescope(ada), csv(results)}) {
    EXPECT_TRUE(has(shown, "5.3 was judged with 5.1 and 5.2 mended")) << shown;
    EXPECT_TRUE(has(shown, "3.1 was not judged alone, since its line //@step 3.1 begin")) << shown;
  }
  EXPECT_TRUE(has(page, "right, only other steps spoil it"));
  EXPECT_TRUE(has(page, "judged alone, "));
}

TEST_F(Reports, as_junit_attach_pictures_and_nothing_that_a_student_names) {
  const std::string ada = junit(student("ada-half"), folder_);
  EXPECT_TRUE(has(ada, "\n[[ATTACHMENT|" + (folder_ / "pictures/wrong.png").string() + "]]\n"));
  for (const store::StudentResult& each : results_.students) {
    const std::string text = junit(each, folder_);
    EXPECT_EQ(times(text, "[[ATTACHMENT|"), times(text, "[[ATTACHMENT|" + folder_.string() + "/pictures/"));
    EXPECT_FALSE(has(text, "[[ATTACHMENT|/etc"));
  }
}

TEST_F(Reports, as_junit_have_no_character_that_xml_has_not) {
  store::StudentResult odd = student("index");
  odd.fault = "a\x01\x1b\x7f\xff b\xEF\xBF\xBE c\xEF\xBF\xBF d\xC2\x85 e\xE2\x80\xA8 f";
  const Element root = Xml::parse(junit(odd, folder_));
  EXPECT_TRUE(has(root.children[0].children[0].children[0].attributes.at("message"), " f"));
}

// CSV

/// Rows and cells of RFC 4180, strictly: CRLF, quotes doubled, no bare quote.
std::vector<std::vector<std::string>> parse_csv(const std::string& text) {
  std::vector<std::vector<std::string>> rows(1);
  std::size_t at = 0;
  while (at < text.size()) {
    std::string cell;
    if (text[at] == '"') {
      for (++at;; ++at) {
        if (text.at(at) == '"' && text.at(at + 1) != '"') break;
        if (text[at] == '"') ++at;
        cell += text[at];
      }
      ++at;
    } else {
      const std::size_t end = text.find_first_of(",\r\"", at);
      cell = text.substr(at, end - at);
      at = end;
    }
    rows.back().push_back(cell);
    if (text.compare(at, 2, "\r\n") == 0) {
      at += 2;
      rows.emplace_back();
    } else if (text.at(at++) != ',') {
      throw std::runtime_error("no comma");
    }
  }
  rows.pop_back();
  return rows;
}

TEST_F(Reports, as_csv_have_a_row_a_student_and_a_column_a_step) {
  const auto rows = parse_csv(csv(results_));
  ASSERT_EQ(rows.size(), 9U);
  EXPECT_EQ(rows[0],
            (std::vector<std::string>{"name", "id", "number", "total", "lab 3", "lab 5", "lab 9", "step 3.1",
                                      "step 5.1", "step 5.2", "step 5.3", "step 9.1", "begun", "note"}));
  for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
  EXPECT_EQ(rows[1], (std::vector<std::string>{"Index Page", "index", "10231", "12", "2", "7", "3", "2", "2",
                                               "4", "1", "3", "3 5 9", ""}));
  EXPECT_EQ(rows[7][3], "");  // an incident is no zero
  EXPECT_EQ(rows[7][8], "");
  EXPECT_TRUE(has(rows[7].back(), "not graded"));
  EXPECT_EQ(rows[8][3], "0");  // a submission that cannot be read is
}

TEST_F(Reports, as_csv_name_the_labs_of_which_steps_were_handed_in) {
  store::StudentResult& one = results_.students[0];
  const auto begun = [&] { return parse_csv(csv(results_))[1][12]; };
  for (judge::StepResult& step : one.labs[0].steps)
    for (judge::CaseResult& result : step.cases) result.status = judge::CaseStatus::untouched;
  EXPECT_EQ(begun(), "5 9");
  one.fault = "is broken";
  EXPECT_EQ(begun(), "");
  one.labs[1].steps[0].overridden = "seen on paper";
  EXPECT_EQ(begun(), "5");
}

TEST_F(Reports, as_csv_quote_names_and_defuse_formulas) {
  store::ClassResult one;
  const auto first_cell = [&](const std::string& name) {
    one.students.resize(1);
    one.students[0].name = name;
    return parse_csv(csv(one))[1][0];
  };
  for (const std::string formula :
       {"=1+1", "+1", "-1", "@SUM(A1)", "=HYPERLINK(\"http://x\",\"y\")", "＝1", "＠x"})
    EXPECT_EQ(first_cell(formula), "'" + formula);
  for (const std::string harmless : {"Doe, \"Jane\"", "a;b", "1=2", "O'Neil", "名前", ""})
    EXPECT_EQ(first_cell(harmless), harmless);
  EXPECT_EQ(first_cell("two\r\nlines"), "two lines");
  EXPECT_EQ(first_cell("\t=1"), "  =1");  // a tab is shown as two spaces, which no spreadsheet skips
  EXPECT_EQ(parse_csv(csv(results_))[5][2], "'=HYPERLINK(\"http://x\")");
}

// Pages

/// The names and values of all attributes of a page, whose values stand in double quotes.
std::vector<std::pair<std::string, std::string>> attributes(const std::string& html) {
  std::vector<std::pair<std::string, std::string>> all;
  for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at)) {
    const std::size_t name_end = html.find_first_of(" >", at);
    const std::string name = html.substr(at + 1, name_end - at - 1);
    for (at = name_end; html.at(at) == ' ';) {
      const std::size_t end = html.find_first_of(" />=", at + 1);
      const std::string attribute = html.substr(at + 1, end - at - 1);
      at = end;
      std::string value;
      if (html.at(at) == '=') {
        if (html.at(at + 1) != '"') throw std::runtime_error("no quotes: " + attribute);
        at = html.find('"', at + 2);
        value = html.substr(end + 2, at - end - 2);
        ++at;
      }
      all.emplace_back(attribute, value);
    }
    if (html.at(at) == '/') ++at;
    if (html.at(at) != '>') throw std::runtime_error("no end of <" + name);
    if (name == "style" || name == "script") at = html.find("</" + name, at);
  }
  return all;
}

TEST_F(Reports, escape_everything_of_a_student) {
  write_html(results_, folder_);
  for (const auto& file : fs::directory_iterator(folder_ / "report")) {
    const std::string html = read_file(file.path());
    EXPECT_EQ(times(html, "<script"), 1U) << file.path();
    EXPECT_EQ(times(html, "</script"), 1U) << file.path();
    EXPECT_EQ(times(html, "<!--"), 0U) << file.path();
    EXPECT_FALSE(has(html, "\x1b")) << file.path();
    Json(html).dump();  // throws for what is no UTF-8
    std::string policy;
    for (const auto& [name, value] : attributes(html)) {
      EXPECT_FALSE(name.starts_with("on")) << file.path() << ' ' << name;
      EXPECT_NE(name, "style") << file.path();
      if (name == "src" || name == "href") {  // nothing is loaded, and only pages beside this one are linked
        EXPECT_TRUE(value.starts_with("data:") || value.starts_with("#") ||
                    (value.find('/') == value.npos && has(value, ".html")))
            << file.path() << ' ' << value;
      }
      if (name == "content" && value.starts_with("default-src")) policy = value;
    }
    // Only the page's own style and script may be used.
    EXPECT_TRUE(policy.starts_with("default-src 'none'; img-src data:; style-src 'sha256-")) << policy;
    EXPECT_TRUE(has(policy, "; script-src 'sha256-")) << policy;
    EXPECT_FALSE(has(policy, "unsafe")) << policy;
  }
  EXPECT_TRUE(has(page(student("script-1a2b3c4d")), "&lt;/script&gt;&lt;!--&lt;script&gt;"));
}

TEST_F(Reports, keep_the_class_page_from_a_student_named_index) {
  EXPECT_EQ(page_name(student("index")), "index.student.html");
  EXPECT_TRUE(has(page(student("index")), "Every step passed."));
  EXPECT_TRUE(has(read_file(folder_ / "report/index.html"), "Class report"));
}

TEST_F(Reports, show_no_mark_where_the_grader_was_at_fault) {
  EXPECT_TRUE(has(page(student("dora-incident")), "<p class=\"mark\">Not graded</p>"));
  EXPECT_TRUE(has(read_file(folder_ / "report/index.html"), "no space left on the disk"));
}

TEST_F(Reports, give_no_mark_in_any_format_while_the_run_is_not_finished) {
  store::StudentResult& ada =
      *std::find_if(results_.students.begin(), results_.students.end(),
                    [](const store::StudentResult& each) { return each.id == "ada-half"; });
  ada.judged = 29, ada.planned = 44;
  const std::string why = "29 of 44 cases";
  EXPECT_TRUE(has(page(ada), "<p class=\"mark\">Not graded</p>"));
  EXPECT_TRUE(has(page(ada), why));
  EXPECT_TRUE(has(read_file(folder_ / "report/index.html"), why));
  EXPECT_TRUE(has(read_file(folder_ / "report/index.html"), "2 not graded."));
  const auto rows = parse_csv(csv(results_));
  for (std::size_t i = 3; i + 1 < rows[2].size(); ++i) EXPECT_EQ(rows[2][i], "") << rows[0][i];
  EXPECT_TRUE(has(rows[2].back(), why));
  EXPECT_THROW(gradescope(ada), Error);
  write_format("gradescope", results_, folder_);
  EXPECT_FALSE(fs::exists(folder_ / "gradescope/ada-half/results.json"));
  EXPECT_EQ(parse_json(prairielearn(ada, folder_))["gradable"], false);
  EXPECT_EQ(Xml::parse(junit(ada, folder_)).attributes.at("errors"), "1");
  ada.judged = 44;
  EXPECT_FALSE(has(page(ada), "Not graded"));
}

TEST_F(Reports, name_the_first_failing_step_its_cause_place_and_hint) {
  const std::string html = page(student("ada-half"));
  EXPECT_TRUE(has(html, "Correct this first: <a href=\"#step-5.2\">step 5.2: Build the tangent frame</a>"));
  EXPECT_TRUE(has(html, "This looks like: <b>Green is inverted</b>"));
  EXPECT_TRUE(has(html, "<code>shaders/05_normal_map/tangent_frame.glsl:42</code>"));
  EXPECT_TRUE(has(html, "<details class=\"hint\"><summary>Hint</summary><p>T, B and N are"));
  EXPECT_TRUE(
      has(page(student("wolfeschlegelsteinhausenbergerdorff")), "The teacher set these points: right idea"));
}

TEST_F(Reports, say_once_what_is_true_of_many_cases) {
  const std::string fault = "contains no file of the labs.", broken = "lab.cpp does not compile";
  const auto count = [](const std::string& html, const std::string& part) {
    int times = 0;
    for (std::size_t at = html.find(part); at != html.npos; at = html.find(part, at + 1)) ++times;
    return times;
  };
  store::StudentResult& ben = results_.students[2];
  const auto fail_all = [&](const std::string& message) {
    for (judge::LabResult& lab : ben.labs)
      for (judge::StepResult& step : lab.steps) {
        for (judge::CaseResult& each : step.cases)
          each.status = judge::CaseStatus::failed, each.message = message, each.error = NAN,
          each.picture = "";
        step =
            judge::step_result(lab.lab.steps[static_cast<std::size_t>(&step - lab.steps.data())], step.cases);
      }
  };
  fail_all(broken);
  const std::string once_a_step = page(ben);
  EXPECT_EQ(count(once_a_step, broken), 5);  // of 15 cases
  EXPECT_TRUE(has(once_a_step, "The same is true of: turned_mesh, unseen_mesh (hidden)</p>"));
  ben.labs[0].steps[0].cases[1].message = "is stopped after 10 s";
  EXPECT_TRUE(has(page(ben), "is stopped after 10 s</p>"));
  fail_all(ben.fault = fault);
  const std::string html = page(ben);
  EXPECT_EQ(count(html, fault), 1);
  EXPECT_FALSE(has(html, "<img"));
  EXPECT_TRUE(has(html, "id=\"step-5.2\""));  // its points
}

TEST_F(Reports, keep_a_hidden_command_until_its_reference_is_shown) {
  store::StudentResult& ada = results_.students[1];
  judge::CaseResult& hidden = ada.labs[1].steps[1].cases[2];
  ASSERT_TRUE(hidden.hidden);
  hidden.command = "./run lab 5 --turn 123.456";
  EXPECT_FALSE(
      has(page(ada) + junit(ada, folder_) + prairielearn(ada, folder_) + gradescope(ada), "123.456"));
  hidden.reference = "pictures/right.pfm";
  EXPECT_TRUE(has(page(ada), "123.456"));
}

TEST_F(Reports, count_a_mistake_once_a_student) {
  write_html(results_, folder_);
  const std::string html = read_file(folder_ / "report/index.html");
  const auto counted_as = [&](const std::string& mistake) {
    const std::size_t at = html.rfind("<span class=\"count\">", html.find("data-mistake=\"" + mistake));
    return html.substr(at + 20, html.find('<', at + 20) - at - 20);
  };
  // Ada, Cleo and the hostile student, though each of them shows it in several steps.
  EXPECT_EQ(counted_as("normal-green-flipped"), "3");
  EXPECT_EQ(counted_as("tangent-not-orthogonal"), "1");
  EXPECT_TRUE(has(html, "Changed since the last grading"));
  EXPECT_TRUE(has(html, "<td class=\"number\">25 %</td>"));
}

TEST_F(Reports, count_those_who_tried_and_begin_with_the_step_that_most_fail) {
  write_html(results_, folder_);
  const std::string html = read_file(folder_ / "report/index.html");
  std::map<std::string, std::pair<int, int>> steps;  // begun and failed
  for (const store::StudentResult& each : results_.students)
    for (const judge::LabResult& lab : each.labs)
      for (const judge::StepResult& step : lab.steps) {
        if (!each.fault.empty() || step.cases.empty() || step.is_untouched()) continue;
        ++steps[step.id].first;
        if (step.status != judge::Status::passed) ++steps[step.id].second;
      }
  const std::size_t section = html.find("<section id=\"steps\">");
  ASSERT_NE(section, html.npos);
  const std::string text = html.substr(section, html.find("</section>", section) - section);
  int before = 1000, lines = 0;
  for (std::size_t at = text.find("<div>"); at != text.npos; at = text.find("<div>", at + 1), ++lines) {
    const auto& [begun, failed] = steps.at(text.substr(at + 5, 3));
    EXPECT_LE(failed, before);
    EXPECT_GT(failed, 0);
    before = failed;
    EXPECT_TRUE(has(text.substr(at, 300), fmt::format("% of {} student", begun))) << text.substr(at, 300);
  }
  EXPECT_GE(lines, 2);
}

TEST_F(Reports, show_code_as_code) {
  store::StudentResult& ada = results_.students[1];
  judge::StepResult& step = ada.labs[1].steps[1];
  step.mistake = "repeats", step.mistake_says = "`repeats` <b> is inverted: use `clamp`";
  step.hints = {"Read `texcoord`"};
  const std::string html = page(ada), all = read_file(folder_ / "report/index.html");
  EXPECT_TRUE(has(html, "<b><code>repeats</code> &lt;b&gt; is inverted</b>: use <code>clamp</code>"));
  EXPECT_TRUE(has(html, "Read <code>texcoord</code>"));
  EXPECT_TRUE(has(all, "><code>repeats</code> &lt;b&gt; is inverted</button>"));
  EXPECT_EQ(with_code("one ` alone"), "one ` alone");
}

/// Up to 42 steps of 6 cases, all wrong, with pictures that a PNG cannot make smaller.
TEST_F(Reports, keep_a_students_page_below_a_megabyte_and_a_half) {
  store::StudentResult& ada = results_.students[1];
  EXPECT_TRUE(has(page(ada), "data-values"));
  EXPECT_TRUE(has(page(ada), "The command below a picture draws it again"));
  judge::StepResult wrong = ada.labs[1].steps[1];
  wrong.cases.clear();
  for (int i = 0; i < 6; ++i)
    wrong.cases.push_back(
        test::demo_case("05_normal_map", wrong.id, fmt::format("case_{}", i), "normal", false, false));
  image::ImageF noise = test::ball(64, false);
  for (std::size_t i = 0; i < noise.samples.size(); ++i)
    noise.samples[i] = static_cast<float>(i * 2654435761U % 1000) / 500 - 1;
  image::save_pfm(folder_ / "pictures/wrong.pfm", noise);
  for (const std::size_t count : {1U, 42U}) {
    ada.labs[1].steps.assign(count, wrong);
    const std::string html = page(ada);
    EXPECT_LE(html.size(), 1'500'000U);
    EXPECT_TRUE(has(html, "<img src="));
    EXPECT_EQ(has(html, "To keep this page small"), count > 1) << count;
  }
  for (judge::CaseResult& result : wrong.cases) result.picture = result.reference = "";
  ada.labs = {ada.labs[1]};
  ada.labs[0].steps.assign(1, wrong);
  EXPECT_FALSE(has(page(ada), "The command below"));
}

TEST_F(Reports, say_so_where_a_picture_is_missing_broken_or_too_large) {
  const auto problem = [&](const std::string& path) { return Pictures(folder_).read(path, "color").problem; };
  EXPECT_EQ(problem("pictures/right.png"), "");
  EXPECT_EQ(problem("pictures/none.png"), "The picture's file is missing.");
  EXPECT_EQ(problem("pictures"), "The picture's file is missing.");
  write_file(folder_ / "pictures/broken.png", read_file(folder_ / "pictures/right.png").substr(0, 200));
  EXPECT_EQ(problem("pictures/broken.png"), "The picture cannot be read.");
  write_file(folder_ / "pictures/broken.pfm", "PF\n64 64\n-1\nshort");
  EXPECT_EQ(problem("pictures/broken.pfm"), "The picture cannot be read.");
  image::save_png(folder_ / "pictures/wide.png", image::Image8(1025, 1, 1));
  EXPECT_TRUE(has(problem("pictures/wide.png"), "1025x1 pixels"));
  image::save_pfm(folder_ / "pictures/high.pfm", image::ImageF(1, 1025, 3));
  EXPECT_TRUE(has(problem("pictures/high.pfm"), "1x1025 pixels"));
  fs::create_symlink(folder_ / "pictures/right.png", folder_ / "pictures/link.png");
  EXPECT_EQ(problem("pictures/link.png"), "The picture's file is missing.");

  fs::remove(folder_ / "pictures/wrong.png");
  EXPECT_TRUE(has(page(student("ada-half")), "The picture&#39;s file is missing."));
}

TEST_F(Reports, hand_on_no_byte_of_a_students_png_but_its_pixels) {
  const image::Text secret[] = {{"Comment", "fingerprint of the file"}};
  image::save_png(folder_ / "pictures/wrong.png", test::lit(test::ball(64, true)), secret);
  const std::string url = Pictures(folder_).read("pictures/wrong.png", "color").url;
  EXPECT_FALSE(has(url, base64("tEXt")));
  fs::remove(folder_ / "pictures/wrong.png");
  test::write_pictures(folder_);  // the same without the text
  EXPECT_EQ(Pictures(folder_).read("pictures/wrong.png", "color").url, url);
}

TEST_F(Reports, are_the_same_bytes_each_time) {
  const std::string first = page(student("ada-half"));
  EXPECT_EQ(page(student("ada-half")), first);
}

TEST_F(Reports, refuse_a_format_that_there_is_not_and_an_id_that_leaves_the_folder) {
  try {
    write_format("html", results_, folder_);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), Exit::usage);
  }
  results_.students[0].id = "../../x";
  for (const char* name : {"gradescope", "prairielearn", "junit"})
    EXPECT_THROW(write_format(name, results_, folder_), Error) << name;
  EXPECT_THROW(write_html(results_, folder_), Error);
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
  EXPECT_EQ(number(2), "2");
  EXPECT_EQ(number(2.5), "2.5");
  EXPECT_EQ(number(1.0 / 3), "0.33");
  EXPECT_EQ(number(-0.001), "0");
  EXPECT_EQ(number(100, 0), "100");
  EXPECT_EQ(base64("Man"), "TWFu");  // RFC 4648, section 10 has the others
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64(""), "");
}

}  // namespace
}  // namespace texel::reports
