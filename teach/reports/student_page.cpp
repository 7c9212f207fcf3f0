// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "image/color.hpp"
#include "page.hpp"
#include "wording.hpp"

namespace texel::reports {
namespace {

/// How the pictures of a step's first wrong case are shown, and those of its others.
struct Detail {
  Shown first, others;
};

/// From all that there is to the least. A page takes the first with which it is small enough.
constexpr Detail kDetails[] = {{Shown::with_numbers, Shown::with_numbers},
                               {Shown::with_numbers, Shown::plain},
                               {Shown::with_numbers, Shown::small},
                               {Shown::plain, Shown::small},
                               {Shown::small, Shown::small},
                               {Shown::small, Shown::not_at_all}};
constexpr std::size_t kLargestPage = 1'500'000;

/// A student's page with its pictures in one of the details.
class StudentPage {
 public:
  StudentPage(const store::StudentResult& student, Pictures& pictures, const Detail& detail)
      : student_(student), pictures_(pictures), detail_(detail) {}

  Json data() {
    Json labs = Json::array(), logs = Json::array(), ignored = Json::array();
    for (const judge::LabResult& lab : student_.labs) labs.push_back(lab_data(lab));
    for (const store::CompilerLog& log : student_.logs)
      logs.push_back({{"file", log.file}, {"text", log.text}});
    for (const store::Ignored& one : student_.ignored)
      ignored.push_back({{"path", one.path}, {"reason", one.reason}});
    Json heat = Json::array();  // its colours, between which the page goes evenly
    for (int i = 0; i <= 8; ++i) heat.push_back(image::heat(static_cast<float>(i) / 8));
    return {{"name", student_.name},
            {"heat", heat},
            {"number", student_.number},
            {"points", number(student_.points())},
            {"maxPoints", number(student_.max_points())},
            {"unmarked", student_.unmarked()},
            {"incident", student_.incident},
            {"incidentSays", kIncident},
            {"fault", student_.fault},
            {"logs", logs},
            {"ignored", ignored},
            {"labs", labs},
            {"isReduced", detail_.others != Shown::with_numbers}};
  }

 private:
  Json lab_data(const judge::LabResult& lab) {
    Json steps = Json::array();
    for (const bool begun : {true, false})  // what is not begun comes last
      for (const judge::StepResult& step : lab.steps)
        if (step.is_untouched() != begun) {
          steps.push_back(details(step));
          steps.back()["judging"] = judging(step) + only_hidden(lab, step);
        }
    return {{"number", lab.lab.number},
            {"title", lab.lab.title},
            {"points", number(lab.points())},
            {"maxPoints", number(lab.max_points())},
            {"notes", lab.notes},
            {"steps", steps}};
  }

  /// Which parameters the hidden cases change that fail while all public ones pass, or "".
  static std::string only_hidden(const judge::LabResult& lab, const judge::StepResult& step) {
    if (step.is_untouched() || count(step.cases, false, false) == 0 || count(step.cases, false, true) > 0 ||
        count(step.cases, true, true) == 0)
      return "";
    std::set<std::string> names;
    for (const judge::CaseResult& result : step.cases) {
      const auto graded = std::ranges::find(lab.lab.cases, result.name, &course::Case::name);
      if (result.passed() || graded == lab.lab.cases.end()) continue;
      for (const course::Setting& setting : graded->settings) names.insert(setting.parameter);
      for (const course::Hidden& hidden : graded->hidden_settings) names.insert(hidden.parameter);
    }
    return fmt::format(" It is right in the cases that you can check, and wrong with other settings of {}.",
                       judge::listed({names.begin(), names.end()}));
  }

  Json details(const judge::StepResult& step) {
    Json data = step_data(step);
    data["isUntouched"] = step.is_untouched();
    // Of a submission with a fault no step has more to say.
    data["isExplained"] =
        step.status != judge::Status::passed && (student_.fault.empty() || step.message != student_.fault);
    data["place"] = place(step);
    data["hint"] = hint(step);
    // The message is the first failed case's, which has it again with its picture.
    const bool said_below = !std::ranges::all_of(step.cases, &judge::CaseResult::passed);
    data["message"] = said_below ? "" : step.message;
    for (const char* list : {"wrong", "same", "passed", "spoilt"}) data[list] = Json::array();
    const judge::CaseResult* nothing = nullptr;  // the first of which nothing can be compared
    for (const judge::CaseResult& result : step.cases) {
      if (result.passed() && result.is_alone()) {
        data["spoilt"].push_back(case_data(result, step, detail_.others));
        continue;
      }
      if (step.is_untouched() || !data["isExplained"]) continue;  // its pictures say nothing of the student
      // A file that does not compile fails all its cases with one sentence: once is enough.
      const bool has_nothing = !result.passed() && std::isnan(result.error) && !result.message.empty();
      const bool is_same = has_nothing && nothing != nullptr && result.message == nothing->message &&
                           result.mistake_says == nothing->mistake_says;
      if (has_nothing && nothing == nullptr) nothing = &result;
      const Json name = {{"name", result.name}, {"hidden", result.hidden}};
      if (result.passed())
        data["passed"].push_back(name);
      else if (is_same)
        data["same"].push_back(name);
      else
        data["wrong"].push_back(
            case_data(result, step, data["wrong"].empty() ? detail_.first : detail_.others));
    }
    return data;
  }

  /// A case with a wrong picture; it is right itself where only other steps spoil the picture.
  Json case_data(const judge::CaseResult& result, const judge::StepResult& step, Shown shown) {
    // The message of a picture that was not judged alone has its distance.
    std::string figures = result.is_alone() && !result.passed() ? distance(result) : "";
    if (result.score > 0 && !result.passed())
      figures += fmt::format("{}{} % of the case's marks", figures.empty() ? "" : "; ",
                             number(100 * result.score, 0));
    Json data = {{"name", result.name},
                 {"hidden", result.hidden},
                 {"view", name_of(result.view)},
                 {"unit", name_of(result.unit())},
                 {"limit", number(result.limit, 9)},
                 {"isRight", result.passed()},
                 {"message", result.message},
                 {"figures", figures},
                 {"command", command(result)},
                 {"isCompared", shown == Shown::with_numbers && !result.is_mesh()},
                 {"panes", Json::array()}};
    if (result.mistake_says != step.mistake_says)
      data["mistake"] = mistake_data(result.mistake, result.mistake_says);
    if (shown == Shown::not_at_all) return data;
    const std::string &own = result.picture, &expected = result.reference;
    if (result.is_mesh()) {
      if (!own.empty() && !expected.empty())
        data["panes"] = {pane("yours", "Yours. Red: not expected", pictures_.stream(own, expected)),
                         pane("expected", "Expected. Red: not in yours", pictures_.stream(expected, own))};
      return data;
    }
    if (!own.empty())
      data["panes"].push_back(pane("yours", "Yours", pictures_.read(own, name_of(result.view), shown)));
    if (!expected.empty())
      data["panes"].push_back(
          pane("expected", "Expected", pictures_.reference(expected, name_of(result.view), shown)));
    return data;
  }

  static Json pane(const char* name, const char* label, const Picture& picture) {
    if (!picture.problem.empty()) return {{"label", label}, {"problem", picture.problem}};
    return {{"name", name},
            {"label", label},
            {"url", picture.url},
            {"width", picture.width},
            {"height", picture.height},
            {"values", picture.values},
            {"channels", picture.channels}};
  }

  const store::StudentResult& student_;
  Pictures& pictures_;
  const Detail& detail_;
};

}  // namespace

std::string student_page(const store::StudentResult& student, const std::map<std::string, std::string>& facts,
                         Pictures& pictures) {
  std::string html;
  for (const Detail& detail : kDetails) {
    Json data = StudentPage(student, pictures, detail).data();
    data["facts"] = facts;
    data["facts"].erase("command");
    html = page(student.name, data, kStudentScript);
    if (html.size() <= kLargestPage) break;
  }
  return html;
}

}  // namespace texel::reports
