// SPDX-License-Identifier: MIT
#include "judge/plan.hpp"

#include <fmt/format.h>

namespace texel::judge {

using course::Case;
using course::View;

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
