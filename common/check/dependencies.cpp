// SPDX-License-Identifier: MIT
#include "dependencies.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/files.hpp"
#include "core/json.hpp"

namespace texel::check {
namespace {

namespace fs = std::filesystem;

using Texts = std::map<std::string, std::string>;  // by step

/// By each step that passed once, the hashes of its lab's texts at that time.
std::map<std::string, Texts> read_memory(const fs::path& file) {
  try {
    if (fs::exists(file)) return parse_json(read_file(file)).get<std::map<std::string, Texts>>();
  } catch (const Json::exception&) {  // a file of another version, or spoilt
  }
  return {};
}

/// What those that need a step have to know of it.
struct Before {
  bool is_passed = false;
  bool is_explained = false;  ///< it failed by a known mistake, or nothing of it was written
};

/// Its cases keep what is wrong with them: students may write steps in any order.
void skip(judge::StepResult& step, const std::vector<std::string>& because_of, const std::string& message) {
  step.status = judge::Status::skipped;
  step.spoilt_by = because_of;
  step.message = message;
  step.mistake.clear(), step.mistake_says.clear();
}

}  // namespace

std::map<std::string, std::vector<std::string>> changed_since_it_passed(
    const fs::path& file, const Texts& texts, const std::vector<judge::LabResult>& labs) {
  std::map<std::string, Texts> memory = read_memory(file);
  std::map<std::string, std::vector<std::string>> changed;
  for (const judge::LabResult& lab : labs) {
    Texts now;
    for (const auto& [id, text] : texts)
      if (std::stoi(id) == lab.lab.number) now[id] = fmt::format("{:016x}", std::hash<std::string>()(text));
    for (const judge::StepResult& step : lab.steps) {
      if (step.passed()) memory[step.id] = now;
      const auto then = memory.find(step.id);
      if (then == memory.end() || then->second[step.id] != now[step.id]) continue;
      for (const auto& [id, hash] : now)
        if (then->second[id] != hash) changed[step.id].push_back(id);
    }
  }
  fs::create_directories(file.parent_path());
  write_file(file, to_text(memory, 1) + "\n");
  return changed;
}

void skip_those_that_wait(judge::LabResult& lab,
                          const std::map<std::string, std::vector<std::string>>& changed) {
  std::map<std::string, Before> before;
  std::vector<std::string> wrong;  // what was begun and is not right: a program ends by one of these
  for (const judge::StepResult& step : lab.steps)
    if (step.status == judge::Status::failed && !step.is_untouched()) wrong.push_back(step.id);
  for (judge::StepResult& step : lab.steps) {
    Before& own = before[step.id];
    own.is_passed = step.passed();
    if (own.is_passed) continue;
    if (const auto found = changed.find(step.id); found != changed.end()) {
      step.was_right = true;
      skip(step, found->second, fmt::format("It passed until you changed {}.", judge::listed(found->second)));
      own.is_passed = true;  // its text is right: the steps that need it do not wait for it
      continue;
    }
    const auto died = std::find_if(step.cases.begin(), step.cases.end(), [](auto& one) { return one.died; });
    if (died != step.cases.end() && !died->crashed_in.empty() && died->crashed_in != step.id) {
      skip(step, {died->crashed_in}, fmt::format("In step {}: {}", died->crashed_in, died->message));
      own.is_passed = true;  // nothing is known of it: the step that crashed does not wait for it
      continue;
    }
    if (died != step.cases.end() && died->crashed_in.empty() && step.is_untouched() && !wrong.empty()) {
      skip(step, wrong,
           fmt::format("The program ended before its pictures were drawn, by what you wrote for {}.",
                       judge::listed(wrong)));
      continue;
    }
    std::vector<std::string> missing;  // the needs that did not pass
    bool is_explained = false;
    for (const std::string& need : step.needs) {
      if (before[need].is_passed) continue;
      missing.push_back(need);
      is_explained |= before[need].is_explained;
    }
    own.is_explained = !step.mistake.empty() || step.is_untouched();
    if (missing.empty() || (!is_explained && !step.mistake.empty())) continue;
    own.is_explained = false;
    skip(step, missing, fmt::format("It needs {} first.", judge::listed(missing)));
  }
}

}  // namespace texel::check
