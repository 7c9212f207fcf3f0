// SPDX-License-Identifier: MIT
#include "judge/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>

namespace texel::judge {
namespace {

constexpr std::array kStatusNames = {"passed", "failed", "skipped", "untouched"};

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

/// Public cases first, then in the lab file's order, then by name.
void sort_cases(const course::Lab& lab, std::vector<CaseResult>& cases) {
  std::map<std::string, std::size_t> place;
  for (const course::Case& graded : lab.cases) place.emplace(graded.name, place.size());
  const auto key = [&](const CaseResult& result) {
    const auto found = place.find(result.name);
    return std::tuple(result.hidden, found == place.end() ? place.size() : found->second, result.name);
  };
  std::ranges::sort(cases, {}, key);
}

}  // namespace

const char* name_of(Status status) {
  return kStatusNames.at(static_cast<std::size_t>(status));
}

Status status_called(const std::string& name) {
  const auto found = std::find(kStatusNames.begin(), kStatusNames.end(), name);
  if (found == kStatusNames.end()) throw Error::failed(fmt::format("there is no status '{}'", name));
  return static_cast<Status>(found - kStatusNames.begin());
}

bool StepResult::is_untouched() const {
  return std::ranges::count(cases, Status::untouched, &CaseResult::status) > 0;
}

const char* word_of(const StepResult& step, bool is_next) {
  if (step.passed()) return "done";
  if (step.status == Status::failed && !step.is_untouched()) return "wrong";
  if (is_next) return "next";
  return step.status == Status::skipped ? "waits" : "to do";
}

const StepResult* next_step(const std::vector<StepResult>& steps) {
  const StepResult* next = nullptr;
  const auto rank = [](const StepResult& step) {
    const bool failed = step.status == Status::failed, is_wrong = failed && step.is_wrong();
    return std::tuple(is_wrong, is_wrong ? step.saved : 0, failed);
  };
  for (const StepResult& step : steps)
    if (!step.passed() && (next == nullptr || rank(step) > rank(*next))) next = &step;
  return next;
}

double hours_left(const std::vector<StepResult>& steps) {
  std::set<int> labs;
  double points = 0;
  for (const StepResult& step : steps)
    if (!step.passed()) labs.insert(std::stoi(step.id)), points += step.points;
  return 0.5 * static_cast<double>(labs.size()) + 0.25 * points;
}

std::string listed(const std::vector<std::string>& steps) {
  std::string text;
  for (std::size_t i = 0; i < steps.size(); ++i)
    text += (i == 0 ? "" : i + 1 == steps.size() ? " and " : ", ") + steps[i];
  return text;
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

void resolve(CaseResult& result, const Verdict& verdict, const std::string& fault, bool is_untouched) {
  result.status = verdict.passed ? Status::passed : is_untouched ? Status::untouched : Status::failed;
  result.score = is_untouched && !verdict.passed ? 0 : verdict.score;
  result.error = verdict.error;
  result.message = fault.empty() ? verdict.message : fault;
  if (result.status == Status::untouched)
    result.message = "This step is still as the starter has it. " + result.message;
}

void put_places(std::vector<LabResult>& labs, const std::map<std::string, Place>& places) {
  for (LabResult& lab : labs)
    for (StepResult& step : lab.steps)
      if (const auto place = places.find(step.id); place != places.end())
        step.file = place->second.file, step.line = place->second.line;
}

const CaseResult* clearest_case(const StepResult& step) {
  const auto key = [](const CaseResult& one) {
    const double share = std::isnan(one.error) ? HUGE_VAL : one.error / std::max(one.limit, 1e-12);
    return std::pair(!one.passed(), share);
  };
  const auto worst = std::ranges::max_element(step.cases, {}, key);
  return worst == step.cases.end() ? nullptr : &*worst;
}

StepResult step_result(const course::Step& step, std::vector<CaseResult> cases) {
  StepResult result{step};
  result.score = score_of(cases);
  result.cases = std::move(cases);

  const auto failed = [](const CaseResult& one) { return !one.passed(); };
  const auto first = std::find_if(result.cases.begin(), result.cases.end(), failed);
  if (!result.cases.empty() && first == result.cases.end()) {
    result.status = Status::passed;
    return result;
  }
  result.message = result.cases.empty() ? "No case of this step was judged." : first->message;
  const auto known = std::find_if(first, result.cases.end(), [&](const CaseResult& one) {
    return failed(one) && !one.mistake_says.empty();
  });
  if (known != result.cases.end()) result.mistake = known->mistake, result.mistake_says = known->mistake_says;
  return result;
}

std::vector<LabResult> lab_results(const std::vector<course::Lab>& labs, std::vector<CaseResult> cases) {
  std::map<std::pair<std::string, std::string>, std::vector<CaseResult>> by_step;
  for (CaseResult& result : cases) by_step[{result.lab, result.step}].push_back(std::move(result));

  std::vector<LabResult> results;
  for (const course::Lab& lab : labs) {
    LabResult& result = results.emplace_back(LabResult{lab, {}, {}});
    for (const course::Step& step : lab.steps) {
      std::vector<CaseResult>& its_cases = by_step[{lab.folder, step.id}];
      sort_cases(lab, its_cases);
      result.steps.push_back(step_result(step, std::move(its_cases)));
    }
  }
  return results;
}

}  // namespace texel::judge
