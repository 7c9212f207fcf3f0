// SPDX-License-Identifier: MIT
#include "grade/hidden_cases.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cache.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "material/unseen_model.hpp"
#include "mesh/bounds.hpp"
#include "mesh/obj.hpp"
#include "mesh/ply.hpp"
#include "mesh/weld.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;
using course::Case;

/// One of the values that a hidden parameter may take.
std::string drawn(const course::Hidden& hidden, std::uint64_t number) {
  if (!hidden.values.empty()) return hidden.values[number % hidden.values.size()];
  // Few digits, so that the value is the same as text and as a float.
  const double share = static_cast<double>(number >> 11U) / static_cast<double>(1ULL << 53U);
  return fmt::format("{:.4g}", hidden.least + share * (hidden.most - hidden.least));
}

/// An OBJ text as the bundled models' meshes are: read by the course, so that the student's reader does not
/// matter.
std::string mesh_of(const std::string& obj, const std::string& name) {
  mesh::Mesh mesh = mesh::weld(mesh::parse_obj(obj, name));
  mesh::normalize_to_unit(mesh);
  return mesh::to_ply(mesh);
}

/// Writes the model that stands for `unseen:kind`, or its mesh for `unseen:kind.ply`, and returns its place.
std::string write_unseen(const std::string& kind, std::uint64_t number, const fs::path& models) {
  make_folder(models);
  const fs::path named(kind);
  const std::string shape = named.stem().string(), obj = material::unseen_model(shape, number);
  const bool is_mesh = named.extension() == ".ply";
  const fs::path file = models / fmt::format("{}_{:016x}.{}", shape, number, is_mesh ? "ply" : "obj");
  write_file(file, is_mesh ? mesh_of(obj, file.string()) : obj);
  return file.string();
}

Case settled(const course::Lab& lab, const course::GradedCase& graded, const std::string& seed,
             const fs::path& models) {
  Case one = graded;
  for (const course::Hidden& hidden : graded.hidden_settings) {
    const auto known = std::ranges::find(one.settings, hidden.parameter, &course::Setting::parameter);
    const std::string value = drawn(hidden, draw({seed, lab.folder, graded.name, hidden.parameter}));
    if (known != one.settings.end())
      known->value = value;
    else
      one.settings.push_back({hidden.parameter, value});
  }
  for (course::Setting& setting : one.settings)
    if (setting.value.starts_with(course::kUnseen))
      setting.value = write_unseen(setting.value.substr(std::string_view(course::kUnseen).size()),
                                   draw({seed, lab.folder, graded.name, setting.parameter}), models);
  return one;
}

}  // namespace

std::vector<judge::LabPlan> full_plan(const std::vector<course::Lab>& labs, const std::string& seed,
                                      const fs::path& models) {
  std::vector<judge::LabPlan> plans;
  for (const course::Lab& lab : labs) {
    judge::LabPlan plan{lab, {}};
    for (const course::GradedCase& graded : lab.cases)
      plan.cases.push_back(settled(lab, graded, seed, models));
    plans.push_back(std::move(plan));
  }
  return plans;
}

std::vector<course::Case> masks_of(const judge::LabPlan& plan) {
  std::vector<course::Case> masks;
  for (course::Case one : plan.cases) {
    if (one.is_mesh()) continue;
    one.view = course::View::mask, one.file = one.name + ".png";
    masks.push_back(std::move(one));
  }
  return masks;
}

}  // namespace texel::grade
