// SPDX-License-Identifier: MIT
#include "older_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <regex>
#include <set>

#include "core/error.hpp"
#include "course/markers.hpp"

namespace texel::grade {
namespace {

const std::vector<MovedStep>& all_moved() {
  static const std::vector<MovedStep> moved = {
      {"3.1", "common/mesh/obj.cpp", "labs/03_obj_texcoords/line_numbers.cpp"},
      {"3.2", "common/mesh/obj.cpp", "labs/03_obj_texcoords/face_index.cpp"},
      {"3.3", "common/mesh/polygon.cpp", "labs/03_obj_texcoords/clip_ears.cpp"},
      {"3.4", "common/mesh/weld.cpp", "labs/03_obj_texcoords/corner_numbers.cpp"},
      {"3.5", "common/mesh/texcoords.cpp", "labs/03_obj_texcoords/spherical_texcoord.cpp"},
      {"4.1", "common/mesh/cube.cpp", "labs/04_cube_wrap/cube_texcoords.cpp"},
      {"4.2", "common/mesh/weld.cpp", "labs/04_cube_wrap/weld.cpp"},
      {"4.3", "common/mesh/normals.cpp", "labs/04_cube_wrap/face_normal.cpp"},
      {"5.2", "common/mesh/tangents.cpp", "labs/05_normal_map/triangle_frame.cpp"},
      {"5.3", "common/mesh/tangents.cpp", "labs/05_normal_map/add_to_corners.cpp"},
      {"5.4", "common/mesh/tangents.cpp", "labs/05_normal_map/orthonormalize.cpp"},
      {"6.1", "shaders/lib/sphere_coordinates.glsl", "shaders/06_cube_map/sphere_texcoord.glsl"}};
  return moved;
}

/// A file of today, and what only its older text includes.
struct OlderText {
  const char* file;
  const char* include;
};
constexpr OlderText kOlderTexts[] = {
    {"labs/04_cube_wrap/lab.cpp", "#include \"mesh/cube.hpp\""},
    {"shaders/06_cube_map/seam.glsl", "#include \"lib/sphere_coordinates.glsl\""}};

/// Lab 4's cube was the library's.
std::string with_names_of_today(const std::string& text) {
  static const std::regex older("mesh::(cube_(by_face|shared|before|stretched))\\b");
  return std::regex_replace(text, older, "$1");
}

/// The starter's text with the steps of an older one.
void renew(Submission& submission, const FirstText& first_text, const OlderText& older) {
  const auto found = submission.files.find(older.file);
  if (found == submission.files.end() || found->second.find(older.include) == std::string::npos) return;
  const std::string text = with_names_of_today(found->second);
  std::vector<std::string> taken;
  std::string fresh = first_text(older.file);
  for (const auto& [step, ignored] : course::step_texts(text)) try {
      fresh = course::with_step_from(fresh, older.file, step, text);
      taken.push_back("step " + step);
    } catch (const Error&) {  // damaged markers: the step stays as it is in the starter
    }
  submission.sizes[submission.root + older.file] = found->second.size();
  submission.ignored.insert(
      submission.ignored.begin(),
      {submission.root + older.file,
       fmt::format("is of an older starter; taken out of it: {}", fmt::join(taken, ", "))});
  found->second = fresh;
}

/// What became of an older file.
std::string told(const std::vector<std::string>& taken, const std::vector<std::string>& lost) {
  std::string text = "is a file of an older starter";
  if (taken.empty() && lost.empty()) return text + " without a step that is begun";
  if (!taken.empty()) text += fmt::format("; taken out of it: {}", fmt::join(taken, ", "));
  if (!lost.empty()) text += fmt::format("; not taken: {}", fmt::join(lost, ", "));
  return text;
}

}  // namespace

std::vector<MovedStep> moved_steps(const std::string& older_file) {
  std::vector<MovedStep> moved;
  std::copy_if(all_moved().begin(), all_moved().end(), std::back_inserter(moved),
               [&](const MovedStep& one) { return one.from == older_file; });
  return moved;
}

std::vector<std::string> older_files(const std::vector<std::string>& allowed) {
  std::set<std::string> files;
  for (const MovedStep& one : all_moved())
    if (std::find(allowed.begin(), allowed.end(), one.to) != allowed.end()) files.insert(one.from);
  return {files.begin(), files.end()};
}

void take_older_steps(Submission& submission, const FirstText& first_text) {
  for (const OlderText& older : kOlderTexts) renew(submission, first_text, older);
  const BegunSteps begun = begun_since(first_text);
  std::vector<store::Ignored> notes;
  for (auto file = submission.files.begin(); file != submission.files.end();) {
    const auto& [path, text] = *file;
    const std::vector<MovedStep> moved = moved_steps(path);
    if (moved.empty()) {
      ++file;
      continue;
    }
    std::vector<std::string> taken, lost;
    const std::map<std::string, std::string> texts = course::step_texts(text);
    const bool has_steps = std::any_of(moved.begin(), moved.end(),
                                       [&](const MovedStep& one) { return texts.contains(one.step); });
    const std::set<std::string> steps = begun(path, text);
    for (const MovedStep& one : moved) {
      if (!steps.contains(one.step)) continue;
      const auto now = submission.files.find(one.to);
      const std::string own = now == submission.files.end() ? first_text(one.to) : now->second;
      if (begun(one.to, own).contains(one.step)) {
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
    const std::string handed_in = submission.root + path;
    submission.sizes[handed_in] = text.size();
    notes.push_back({handed_in, has_steps ? told(taken, lost) : "is not a file with steps"});
    file = submission.files.erase(file);
  }
  submission.ignored.insert(submission.ignored.begin(), notes.begin(), notes.end());
}

}  // namespace texel::grade
