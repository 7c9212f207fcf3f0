// SPDX-License-Identifier: MIT
#include "judge/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace texel::judge {

using course::Case;
using course::View;

std::vector<Case> LabPlan::named(const std::vector<std::string>& names) const {
  std::vector<Case> chosen;
  for (const Case& one : cases)
    if (std::find(names.begin(), names.end(), one.name) != names.end()) chosen.push_back(one);
  return chosen;
}

std::vector<Case> LabPlan::masks() const {
  std::vector<Case> masks;
  for (Case one : cases) {
    if (one.is_mesh()) continue;
    one.view = View::mask, one.file = one.name + ".png";
    masks.push_back(std::move(one));
  }
  return masks;
}

std::vector<LabPlan> public_plan(const std::vector<course::Lab>& labs) {
  std::vector<LabPlan> plans;
  for (const course::Lab& lab : labs) {
    LabPlan plan{lab, {}};
    for (const course::GradedCase& graded : lab.cases)
      if (!graded.hidden) plan.cases.push_back(graded);
    plans.push_back(std::move(plan));
  }
  return plans;
}

std::vector<course::Lab> with_needed(const std::vector<course::Lab>& chosen,
                                     const std::vector<course::Lab>& all) {
  std::set<int> numbers;
  std::vector<int> open;
  for (const course::Lab& lab : chosen) open.push_back(lab.number);
  while (!open.empty()) {
    const int number = open.back();
    open.pop_back();
    if (!numbers.insert(number).second) continue;
    for (const course::Lab& lab : all)
      if (lab.number == number)
        for (const course::Step& step : lab.steps)
          for (const std::string& need : step.needs) open.push_back(std::stoi(need));
  }
  std::vector<course::Lab> result;
  for (const course::Lab& lab : all)
    if (numbers.count(lab.number) > 0) result.push_back(lab);
  return result;
}

std::string command(const course::Lab& lab, const Case& of) {
  std::string text = fmt::format("./run lab {}", lab.number);
  for (const course::Setting& setting : of.settings) {
    // Where the grader's own files lie is nobody's business, and is not on the student's machine.
    const bool is_absolute = setting.value.starts_with('/');
    text += course::flag({setting.parameter,
                          is_absolute ? setting.value.substr(setting.value.rfind('/') + 1) : setting.value});
  }
  if (of.is_mesh()) return text + fmt::format(" --mesh {}", of.file);
  text += of.view == View::color ? " --samples 1" : fmt::format(" --view {}", name_of(of.view));
  return text + fmt::format(" --size {} --snapshot {}", as_text(of.size), of.file);
}

}  // namespace texel::judge
