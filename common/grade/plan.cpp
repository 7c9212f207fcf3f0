// SPDX-License-Identifier: MIT
#include "grade/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "core/error.hpp"
#include "core/files.hpp"
#include "fingerprint.hpp"
#include "grade/unseen_model.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

/// One of the values that a hidden parameter may take.
std::string drawn(const course::Hidden& hidden, std::uint64_t number) {
  if (!hidden.values.empty()) return hidden.values[number % hidden.values.size()];
  // Few digits, so that the value is the same as text and as a float.
  const double share = static_cast<double>(number >> 11U) / static_cast<double>(1ULL << 53U);
  return fmt::format("{:.4g}", hidden.least + share * (hidden.most - hidden.least));
}

/// Writes the model that stands for `unseen:kind` and returns its place.
std::string write_unseen(const std::string& kind, std::uint64_t number, const fs::path& models) {
  std::error_code error;
  fs::create_directories(models, error);
  if (error)
    throw Error::failed(fmt::format("cannot make the folder: {}", error.message()), {models.string()});
  const fs::path file = models / fmt::format("{}_{:016x}.obj", kind, number);
  write_file(file, unseen_model(kind, number));
  return file.string();
}

Shot shot_of(const course::Lab& lab, const course::GradedCase& graded, const std::string& seed,
             const fs::path& models) {
  Shot shot{graded, graded.settings, !graded.hidden.empty()};
  for (const course::Hidden& hidden : graded.hidden) {
    const auto known =
        std::find_if(shot.settings.begin(), shot.settings.end(),
                     [&](const course::Setting& s) { return s.parameter == hidden.parameter; });
    const std::string value = drawn(hidden, draw({seed, lab.folder, graded.name, hidden.parameter}));
    if (known != shot.settings.end())
      known->value = value;
    else
      shot.settings.push_back({hidden.parameter, value});
  }
  for (course::Setting& setting : shot.settings)
    if (setting.value.starts_with(kUnseen)) {
      shot.hidden = true;
      if (seed.empty()) continue;
      setting.value = write_unseen(setting.value.substr(std::string_view(kUnseen).size()),
                                   draw({seed, lab.folder, graded.name, setting.parameter}), models);
    }
  return shot;
}

nlohmann::ordered_json entry(const Shot& shot, const std::string& file, const std::string& view) {
  nlohmann::ordered_json json{{"name", file}};
  if (view != "mesh") json["view"] = view, json["size"] = shot.graded.size;
  for (const course::Setting& setting : shot.settings) json["set"][setting.parameter] = setting.value;
  return json;
}

}  // namespace

std::string Shot::file() const {
  return graded.name + (is_mesh() ? ".ply" : graded.view == "color" ? ".png" : ".pfm");
}

std::string LabPlan::batch(const std::vector<std::string>& only) const {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Shot& shot : shots)
    if (only.empty() || std::find(only.begin(), only.end(), shot.graded.name) != only.end())
      list.push_back(entry(shot, shot.file(), shot.graded.view));
  return list.dump(1);
}

std::string LabPlan::mask_batch() const {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Shot& shot : shots)
    if (!shot.is_mesh()) list.push_back(entry(shot, shot.graded.name + ".png", "mask"));
  return list.dump(1);
}

std::vector<LabPlan> plan(const std::vector<course::Lab>& labs, const std::string& seed,
                          const fs::path& models) {
  std::vector<LabPlan> plans;
  for (const course::Lab& lab : labs) {
    LabPlan plan{lab, {}};
    for (const course::GradedCase& graded : lab.cases) {
      Shot shot = shot_of(lab, graded, seed, models);
      if (!shot.hidden || !seed.empty()) plan.shots.push_back(std::move(shot));
    }
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

std::string command(const LabPlan& plan, const Shot& shot) {
  std::string text = fmt::format("./run lab {}", plan.lab.number);
  for (const course::Setting& setting : shot.settings) {
    // Where the grader's own files lie is nobody's business, and is not on the student's machine.
    const fs::path file(setting.value);
    text += course::flag({setting.parameter, file.is_absolute() ? file.filename().string() : setting.value});
  }
  if (shot.is_mesh()) return text + fmt::format(" --mesh {}", shot.file());
  text += shot.graded.view == "color" ? " --samples 1" : fmt::format(" --view {}", shot.graded.view);
  return text + fmt::format(" --size {} --snapshot {}", shot.graded.size, shot.file());
}

}  // namespace texel::grade
