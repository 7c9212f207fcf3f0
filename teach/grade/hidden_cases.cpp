// SPDX-License-Identifier: MIT
#include "grade/hidden_cases.hpp"

#include <fmt/format.h>

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

/// One of the values that a hidden parameter of the case may take.
std::string drawn(const course::Hidden& hidden, const Case& of, std::uint64_t number) {
  const std::vector<std::string>& values = hidden.values;
  const bool is_range = values.size() == 2 && hidden.are_numbers;
  const double least = is_range ? std::stod(values[0]) : 0, most = is_range ? std::stod(values[1]) : 1;
  if (values.size() < 2 || !(least < most))
    throw Error::failed(
        fmt::format("'{}' must be a range [least, most] of numbers, or a list of two texts or more",
                    hidden.parameter),
        {fmt::format("the case {} of {}", of.name, of.lab)});
  if (!is_range) return values[number % values.size()];
  // Few digits, so that the value is the same as text and as a float.
  const double share = static_cast<double>(number >> 11U) / static_cast<double>(1ULL << 53U);
  return fmt::format("{:.4g}", least + share * (most - least));
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
  const std::string text = is_mesh ? mesh_of(obj, kind) : obj;
  // Named after what it holds, so references are those of another model when a course makes another one.
  const fs::path file =
      models / fmt::format("{}_{:.16}.{}", shape, fingerprint({text}), is_mesh ? "ply" : "obj");
  write_file(file, text);
  return file.string();
}

void resolve(const course::Lab& lab, Case& one, const std::string& seed, const fs::path& models) {
  for (const course::Hidden& hidden : one.hidden_settings) {
    const std::string value = drawn(hidden, one, draw({seed, lab.folder, one.name, hidden.parameter}));
    std::erase_if(one.settings, [&](const auto& setting) { return setting.parameter == hidden.parameter; });
    one.settings.push_back({hidden.parameter, value});
  }
  for (course::Setting& setting : one.settings)
    if (setting.value.starts_with(course::kUnseen))
      setting.value = write_unseen(setting.value.substr(course::kUnseen.size()),
                                   draw({seed, lab.folder, one.name, setting.parameter}), models);
}

}  // namespace

std::vector<course::Lab> full_plan(std::vector<course::Lab> labs, const std::string& seed,
                                   const fs::path& models) {
  for (course::Lab& lab : labs)
    for (Case& one : lab.cases) resolve(lab, one, seed, models);
  return labs;
}

std::vector<course::Case> masks_of(const course::Lab& plan) {
  std::vector<course::Case> masks;
  for (course::Case one : plan.cases) {
    if (one.is_mesh()) continue;
    one.view = course::View::mask, one.file = one.name + ".png";
    masks.push_back(std::move(one));
  }
  return masks;
}

}  // namespace texel::grade
