// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "lms.hpp"
#include "pictures.hpp"
#include "reports/reports.hpp"

namespace texel::reports {
namespace {

/// How much of the file is kept for text, in bytes: pictures may have the rest.
constexpr std::size_t kForText = kLargestResults / 4;

Json not_gradable(const std::string& message) {
  return {{"gradable", false}, {"message", message}, {"format_errors", Json::array({message})}};
}

/// Adds pictures until one does not fit, which ends it: those of the first failing steps matter most.
class Images {
 public:
  Images(const std::filesystem::path& folder, std::size_t bytes) : pictures_(folder), left_(bytes) {}

  Json of(const judge::StepResult& step) {
    Json images = Json::array();
    for (const judge::CaseResult& result : step.cases) {
      if (result.passed() || result.is_mesh()) continue;
      add(images, result, result.picture, "yours");
      add(images, result, result.reference, "expected");
    }
    return images;
  }

 private:
  void add(Json& images, const judge::CaseResult& result, const std::string& path, const char* whose) {
    if (path.empty() || left_ == 0) return;
    const Picture picture = pictures_.read(path, name_of(result.view));
    if (picture.url.empty()) return;
    const std::size_t bytes = picture.url.size() + 200;  // with its label and the JSON around it
    if (bytes > left_) {
      left_ = 0;
      return;
    }
    left_ -= bytes;
    images.push_back({{"label", fmt::format("{}, {}", clean(result.name), whose)}, {"url", picture.url}});
  }

  Pictures pictures_;
  std::size_t left_;
};

}  // namespace

std::string prairielearn(const store::StudentResult& student, const std::filesystem::path& folder) {
  if (!student.incident.empty()) return fitted(not_gradable(kIncident));
  if (student.is_unfinished()) return fitted(not_gradable("Not graded yet: " + student.unmarked() + "."));
  if (!student.fault.empty()) return fitted(not_gradable("The submission " + clean(student.fault)));

  Json tests = Json::array();
  std::vector<const judge::StepResult*> steps;
  for (const judge::LabResult& lab : student.labs)
    for (const judge::StepResult& step : lab.steps) {
      steps.push_back(&step);
      const bool passed = step.status == judge::Status::passed;
      tests.push_back(
          {{"name", clean(step.id + " " + step.title)},
           {"points", rounded(step.points * step.score)},
           {"max_points", rounded(step.points)},
           {"message", passed ? passed_text(step) : clean(step.message)},
           {"output", passed ? "" : advice(step) + case_lines(step, false) + case_lines(step, true)}});
    }
  const double most = student.max_points();
  Json results = {{"gradable", true},
                  {"score", most > 0 ? std::clamp(rounded(student.points() / most), 0.0, 1.0) : 0},
                  {"message", fmt::format("{} of {} points.", number(student.points()), number(most))},
                  {"output", overview(student)},
                  {"images", Json::array()},
                  {"tests", tests}};

  const std::size_t text = std::max(fitted(results).size(), kForText);
  Images images(folder, kLargestResults - text);
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (Json found = images.of(*steps[i]); !found.empty()) results["tests"][i]["images"] = std::move(found);
  return fitted(results);
}

}  // namespace texel::reports
