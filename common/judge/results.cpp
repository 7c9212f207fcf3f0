// SPDX-License-Identifier: MIT
#include "judge/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <tuple>
#include <utility>

#include "core/error.hpp"

namespace texel::grade {
namespace {

constexpr std::array kStatusNames = {"passed", "failed", "skipped"};
constexpr std::array kCaseStatusNames = {"passed", "failed", "untouched"};

/// The place of a name among those.
template <class Enum>
Enum find(const std::array<const char*, 3>& names, const std::string& name) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (name == names[i]) return static_cast<Enum>(i);
  throw Error::failed(fmt::format("there is no status '{}'", name), {},
                      fmt::format("the statuses are {}, {} and {}", names[0], names[1], names[2]));
}

/// The lower of the means over the public and the hidden cases; 0 without a case.
double score_of(const std::vector<CaseResult>& cases) {
  std::array<double, 2> sum = {0, 0};
  std::array<int, 2> count = {0, 0};
  for (const CaseResult& result : cases) {
    sum[result.hidden] += result.score;
    ++count[result.hidden];
  }
  const auto mean = [&](std::size_t hidden) { return sum[hidden] / count[hidden]; };
  if (cases.empty()) return 0;
  if (count[0] == 0 || count[1] == 0) return mean(count[0] == 0 ? 1 : 0);
  return std::min(mean(0), mean(1));
}

/// What each step needs, directly and through others, in the course's order.
class Needs {
 public:
  explicit Needs(const std::vector<course::Lab>& labs) {
    for (const course::Lab& lab : labs)
      for (const course::Step& step : lab.steps) {
        order_.push_back(step.id);
        // The needs come earlier in the course, so that theirs are known.
        std::set<std::string>& all = all_[step.id];
        for (const std::string& need : step.needs) {
          all.insert(need);
          if (const auto known = all_.find(need); known != all_.end() && need != step.id)
            all.insert(known->second.begin(), known->second.end());
        }
      }
  }

  [[nodiscard]] std::vector<std::string> of(const std::string& step) const {
    std::vector<std::string> needs;
    for (const std::string& id : order_)
      if (all_.at(step).contains(id)) needs.push_back(id);
    return needs;
  }

 private:
  std::vector<std::string> order_;
  std::map<std::string, std::set<std::string>> all_;
};

/// Public cases first, then in the lab file's order, then by name.
void sort_cases(const course::Lab& lab, std::vector<CaseResult>& cases) {
  std::map<std::string, std::size_t> place;
  for (const course::GradedCase& graded : lab.cases) place.emplace(graded.name, place.size());
  const auto key = [&](const CaseResult& result) {
    const auto found = place.find(result.name);
    return std::tuple(result.hidden, found == place.end() ? place.size() : found->second, result.name);
  };
  std::sort(cases.begin(), cases.end(),
            [&](const CaseResult& a, const CaseResult& b) { return key(a) < key(b); });
}

bool is_explained(const StepResult& step) {
  const auto is_untouched = [](const CaseResult& one) { return one.status == CaseStatus::untouched; };
  return step.status == Status::failed &&
         (!step.mistake.empty() || std::any_of(step.cases.begin(), step.cases.end(), is_untouched));
}

/// A step that needs this one, and failed by a mistake of its own, may have spoilt this one's pictures.
void point_to_cause(StepResult& step, const std::vector<LabResult>& results, const Needs& needs) {
  for (const LabResult& lab : results)
    for (const StepResult& later : lab.steps) {
      const std::vector<std::string> needed = needs.of(later.id);
      if (later.status != Status::failed || later.mistake.empty() ||
          std::find(needed.begin(), needed.end(), step.id) == needed.end())
        continue;
      step.message +=
          fmt::format(" The cause may be in step {}: its pictures show a known mistake.", later.id);
      return;
    }
}

}  // namespace

const char* name_of(Status status) {
  return kStatusNames.at(static_cast<std::size_t>(status));
}

Status status_of(const std::string& name) {
  return find<Status>(kStatusNames, name);
}

const char* name_of(CaseStatus status) {
  return kCaseStatusNames.at(static_cast<std::size_t>(status));
}

CaseStatus case_status_of(const std::string& name) {
  return find<CaseStatus>(kCaseStatusNames, name);
}

double LabResult::points() const {
  double sum = 0;
  for (const StepResult& step : steps) sum += step.points * step.score;
  return sum;
}

double LabResult::max_points() const {
  double sum = 0;
  for (const StepResult& step : steps) sum += step.points;
  return sum;
}

void settle(CaseResult& result, const Verdict& verdict, const std::string& fault, bool is_untouched) {
  result.status = verdict.passed ? CaseStatus::passed
                  : is_untouched ? CaseStatus::untouched
                                 : CaseStatus::failed;
  result.error = verdict.error;
  result.message = fault.empty() ? verdict.message : fault;
  if (result.status == CaseStatus::untouched)
    result.message = "This step is still as the starter has it. " + result.message;
}

void put_places(std::vector<LabResult>& labs, const std::map<std::string, Place>& places) {
  for (LabResult& lab : labs)
    for (StepResult& step : lab.steps)
      if (const auto place = places.find(step.id); place != places.end())
        step.file = place->second.file, step.line = place->second.line;
}

const CaseResult* telling_case(const StepResult& step) {
  const auto share = [](const CaseResult& one) {
    return std::isnan(one.error) ? HUGE_VAL : one.error / std::max(one.limit, 1e-12);
  };
  const CaseResult* worst = nullptr;
  for (const CaseResult& one : step.cases)
    if (worst == nullptr || (worst->passed() && !one.passed()) ||
        (worst->passed() == one.passed() && share(one) > share(*worst)))
      worst = &one;
  return worst;
}

StepResult step_result(const course::Step& step, std::vector<CaseResult> cases,
                       const std::map<std::string, Before>& before) {
  StepResult result;
  result.id = step.id;
  result.title = step.title;
  result.points = step.points;
  result.hints = step.hints;
  result.score = score_of(cases);
  result.cases = std::move(cases);

  const auto failed = [](const CaseResult& one) { return !one.passed(); };
  const auto first = std::find_if(result.cases.begin(), result.cases.end(), failed);
  if (!result.cases.empty() && first == result.cases.end()) {
    result.status = Status::passed;
    return result;
  }

  const auto known = std::find_if(first, result.cases.end(),
                                  [&](const CaseResult& one) { return failed(one) && !one.mistake.empty(); });
  std::string missing;  // the first need that did not pass
  bool is_explained = false;
  for (const std::string& need : step.needs) {
    const auto found = before.find(need);
    if (found == before.end() || found->second.status == Status::passed) continue;
    if (missing.empty()) missing = need;
    is_explained |= found->second.is_explained;
  }
  if (!missing.empty() && (is_explained || known == result.cases.end())) {
    result.status = Status::skipped;
    result.message = fmt::format("This step needs step {}, which has not passed yet.", missing);
    return result;
  }

  result.status = Status::failed;
  result.message = result.cases.empty() ? "No case of this step was judged." : first->message;
  if (known != result.cases.end()) {
    result.mistake = known->mistake;
    result.mistake_says = known->mistake_says;
  }
  return result;
}

std::vector<LabResult> lab_results(const std::vector<course::Lab>& labs, std::vector<CaseResult> cases) {
  std::map<std::pair<std::string, std::string>, std::vector<CaseResult>> by_step;
  for (CaseResult& result : cases) by_step[{result.lab, result.step}].push_back(std::move(result));

  const Needs needs(labs);
  std::map<std::string, Before> before;
  std::vector<LabResult> results;
  for (const course::Lab& lab : labs) {
    LabResult result;
    result.lab = lab;
    for (course::Step step : lab.steps) {
      std::vector<CaseResult>& its_cases = by_step[{lab.folder, step.id}];
      sort_cases(lab, its_cases);
      step.needs = needs.of(step.id);
      result.steps.push_back(step_result(step, std::move(its_cases), before));
      before[step.id] = {result.steps.back().status, is_explained(result.steps.back())};
    }
    results.push_back(std::move(result));
  }
  for (LabResult& lab : results)
    for (StepResult& step : lab.steps)
      if (step.status == Status::failed && !is_explained(step)) point_to_cause(step, results, needs);
  return results;
}

}  // namespace texel::grade
