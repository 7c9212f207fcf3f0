// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <regex>
#include <set>

#include "core/error.hpp"
#include "course/markers.hpp"
#include "unpack.hpp"

namespace texel::grade {
namespace {

/// A step that an older starter had in another file.
constexpr struct MovedStep {
  const char *step, *from, *to;
} kMovedSteps[] = {
    {"3.1", "common/mesh/obj.cpp", "labs/03_obj_texcoords/line_numbers.cpp"},
    {"3.2", "common/mesh/obj.cpp", "labs/03_obj_texcoords/face_index.cpp"},
    {"3.3", "common/mesh/polygon.cpp", "labs/03_obj_texcoords/clip_ears.cpp"},
    {"3.4", "common/mesh/weld.cpp", "labs/03_obj_texcoords/corner_numbers.cpp"},
    {"3.5", "common/mesh/texcoords.cpp", "labs/03_obj_texcoords/spherical_texcoord.cpp"},
    {"4.1", "common/mesh/cube.cpp", "labs/04_cube_wrap/cube_texcoords.cpp"},
    {"4.2", "common/mesh/weld.cpp", "labs/04_cube_wrap/weld.cpp"},
    {"4.3", "common/mesh/normals.cpp", "labs/04_cube_wrap/face_normal.cpp"},
    {"4.4", "labs/04_cube_wrap/lab.cpp", "labs/04_cube_wrap/split_cube.cpp"},
    {"5.2", "common/mesh/tangents.cpp", "labs/05_normal_map/triangle_frame.cpp"},
    {"5.3", "common/mesh/tangents.cpp", "labs/05_normal_map/add_to_corners.cpp"},
    {"5.4", "common/mesh/tangents.cpp", "labs/05_normal_map/orthonormalize.cpp"},
    {"5.7", "labs/05_normal_map/lab.cpp", "labs/05_normal_map/normal_matrix.cpp"},
    {"6.3", "labs/06_cube_map/lab.cpp", "labs/06_cube_map/upload_faces.cpp"},
    {"6.1", "shaders/lib/sphere_coordinates.glsl", "shaders/06_cube_map/sphere_texcoord.glsl"}};

/// A file of today, and what only its older text includes.
constexpr const char *kSeam = "shaders/06_cube_map/seam.glsl",
                     *kSeamIncluded = "#include \"lib/sphere_coordinates.glsl\"";

/// Lab 4's cube was the library's.
std::string with_names_of_today(const std::string& text) {
  static const std::regex older("mesh::(cube_(by_face|shared|before|stretched))\\b");
  return std::regex_replace(text, older, "$1");
}

/// The starter's text with the steps of an older one.
void renew_seam(Submission& submission, const FirstText& first_text) {
  const auto found = submission.files.find(kSeam);
  if (found == submission.files.end() || found->second.find(kSeamIncluded) == std::string::npos) return;
  std::vector<std::string> taken;
  std::string fresh = first_text(kSeam);
  for (const auto& [step, ignored] : course::step_texts(found->second)) try {
      fresh = course::with_step_from(fresh, kSeam, step, found->second);
      taken.push_back("step " + step);
    } catch (const Error&) {  // damaged markers: the step stays as it is in the starter
    }
  submission.sizes[submission.root + kSeam] = found->second.size();
  submission.ignored.insert(
      submission.ignored.begin(),
      {submission.root + kSeam,
       fmt::format("is of an older starter; taken out of it: {}", fmt::join(taken, ", "))});
  found->second = fresh;
}

/// What became of an older file with steps.
std::string told(const std::vector<std::string>& taken, const std::vector<std::string>& lost) {
  std::string text = "is a file of an older starter";
  if (taken.empty() && lost.empty()) return text + " without a step that is begun";
  if (!taken.empty()) text += fmt::format("; taken out of it: {}", fmt::join(taken, ", "));
  if (!lost.empty()) text += fmt::format("; not taken: {}", fmt::join(lost, ", "));
  return text;
}

/// Takes the steps out of an older file's text, and says what became of it.
std::string take_steps(Submission& submission, const FirstText& first_text, const std::string& file,
                       const std::string& given) {
  const std::string text = with_names_of_today(given);
  const std::map<std::string, std::string> texts = course::step_texts(text);
  const std::set<std::string> begun = begun_steps(file, text, first_text);
  std::vector<std::string> taken, lost;
  bool has_steps = false;
  for (const MovedStep& one : kMovedSteps) {
    if (file != one.from) continue;
    has_steps = has_steps || texts.contains(one.step);
    if (!begun.contains(one.step)) continue;
    const auto now = submission.files.find(one.to);
    const std::string own = now == submission.files.end() ? first_text(one.to) : now->second;
    if (begun_steps(one.to, own, first_text).contains(one.step)) {
      lost.push_back(fmt::format("step {}, since it is begun in {}", one.step, one.to));
      continue;
    }
    try {
      submission.files[one.to] = course::with_step_from(own, one.to, one.step, text);
      taken.push_back(fmt::format("step {}, now in {}", one.step, one.to));
    } catch (const Error&) {
      lost.push_back(fmt::format("step {}, since its markers are damaged", one.step));
    }
  }
  return has_steps ? told(taken, lost) : "is not a file with steps";
}

}  // namespace

std::set<std::string> older_files(const std::vector<std::string>& allowed) {
  std::set<std::string> files;
  for (const MovedStep& one : kMovedSteps)
    if (std::ranges::count(allowed, one.to) > 0) files.insert(one.from);
  return files;
}

std::set<std::string> begun_steps(const std::string& file, const std::string& text,
                                  const FirstText& first_text) {
  std::string first;
  for (const MovedStep& one : kMovedSteps)
    if (file == one.from) first += first_text(one.to);
  if (first.empty()) first = first_text(file);
  const std::set<std::string> untouched = course::untouched_steps(text, first);
  const std::map<std::string, std::string> given = course::step_texts(first);
  std::set<std::string> steps;
  for (const auto& [step, own] : course::step_texts(text))
    if (given.contains(step) && !untouched.contains(step)) steps.insert(step);
  return steps;
}

void take_older_steps(Submission& submission, const std::vector<std::string>& allowed,
                      const FirstText& first_text) {
  renew_seam(submission, first_text);
  std::vector<store::Ignored> notes;
  for (const std::string& file : older_files(allowed)) {
    const auto older = submission.files.extract(file);
    if (older.empty()) continue;
    submission.sizes[submission.root + file] = older.mapped().size();
    notes.push_back({submission.root + file, take_steps(submission, first_text, file, older.mapped())});
  }
  submission.ignored.insert(submission.ignored.begin(), notes.begin(), notes.end());
}

}  // namespace texel::grade
