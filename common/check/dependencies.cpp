// SPDX-License-Identifier: MIT
#include "dependencies.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/json.hpp"

namespace texel::check {
namespace {

namespace fs = std::filesystem;

/// What is remembered of a step. Saves are counted, from 1.
struct Remembered {
  std::string text;  ///< a hash
  int changed = 0;   ///< the save that changed it last
  int passed = 0;    ///< the last save with which it passed; 0 for none
};

struct Memory {
  int saves = 0;
  std::map<std::string, Remembered> steps;
};

Memory read_memory(const fs::path& file) {
  Memory memory;
  if (!fs::exists(file)) return memory;
  try {
    const Json json = parse_json(read_file(file));
    for (const auto& [id, step] : json.at("steps").items())
      memory.steps[id] = {step.at("text"), step.at("changed"), step.at("passed")};
    memory.saves = json.at("saves");
  } catch (const Json::exception&) {  // a file of another version, or spoilt
    return {};
  }
  return memory;
}

void write_memory(const fs::path& file, const Memory& memory) {
  Json json = {{"saves", memory.saves}, {"steps", Json::object()}};
  for (const auto& [id, step] : memory.steps)
    json["steps"][id] = {{"text", step.text}, {"changed", step.changed}, {"passed", step.passed}};
  fs::create_directories(file.parent_path());
  write_file(file, to_text(json, 1) + "\n");
}

/// What those that need a step have to know of it.
struct Before {
  bool is_passed = false;
  bool is_explained = false;  ///< it failed by a known mistake, or nothing of it was written
};

void skip(judge::StepResult& step, const std::vector<std::string>& because_of, const std::string& message) {
  step.status = judge::Status::skipped;
  step.spoilt_by = because_of;
  step.message = message;
  step.mistake.clear(), step.mistake_says.clear();
}

}  // namespace

std::map<std::string, Changed> changed_since_it_passed(const fs::path& file,
                                                       const std::map<std::string, std::string>& texts,
                                                       const std::vector<judge::LabResult>& labs) {
  Memory memory = read_memory(file);
  bool is_saved = false;
  for (const auto& [id, text] : texts) {
    Remembered& step = memory.steps[id];
    const std::string now = fmt::format("{:016x}", std::hash<std::string>()(text));
    if (step.text == now) continue;
    step.text = now, step.changed = memory.saves + 1;
    is_saved = true;
  }
  if (is_saved) ++memory.saves;

  std::map<std::string, Changed> changed;
  for (const judge::LabResult& lab : labs)
    for (const judge::StepResult& step : lab.steps) {
      Remembered& own = memory.steps[step.id];
      if (step.status == judge::Status::passed) own.passed = memory.saves;
      if (own.passed == memory.saves || own.passed < own.changed) continue;
      Changed found{{}, true};
      for (const auto& [id, text] : texts) {
        if (std::stoi(id) != lab.lab.number || memory.steps[id].changed <= own.passed) continue;
        found.steps.push_back(id);
        found.by_last_save &= memory.steps[id].changed == memory.saves;
      }
      if (!found.steps.empty()) changed[step.id] = std::move(found);
    }
  write_memory(file, memory);
  return changed;
}

void skip_those_that_wait(std::vector<judge::LabResult>& labs,
                          const std::map<std::string, Changed>& changed) {
  std::vector<course::Lab> known;
  for (const judge::LabResult& lab : labs) known.push_back(lab.lab);
  const judge::Needs needs(known);
  std::map<std::string, Before> before;
  for (judge::LabResult& lab : labs)
    for (judge::StepResult& step : lab.steps) {
      Before& own = before[step.id];
      own.is_passed = step.status == judge::Status::passed;
      if (own.is_passed) continue;
      if (const auto found = changed.find(step.id); found != changed.end()) {
        const std::string steps = judge::listed(found->second.steps);
        skip(step, found->second.steps,
             found->second.by_last_save
                 ? fmt::format("Your last save changed {}; this step passed before it.", steps)
                 : fmt::format("You changed {}; this step passed before that.", steps));
        own.is_passed = true;  // its text is right: the steps that need it do not wait for it
        continue;
      }
      std::vector<std::string> missing;  // the needs that did not pass
      bool is_explained = false;
      for (const std::string& need : needs.of(step.id)) {
        const auto found = before.find(need);
        if (found == before.end() || found->second.is_passed) continue;
        missing.push_back(need);
        is_explained |= found->second.is_explained;
      }
      own.is_explained = !step.mistake.empty() || step.is_untouched();
      if (missing.empty() || (!is_explained && !step.mistake.empty())) continue;
      own.is_explained = false;
      skip(step, missing, fmt::format("It needs {} first.", judge::listed(missing)));
    }
}

}  // namespace texel::check
