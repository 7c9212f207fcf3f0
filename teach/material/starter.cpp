// SPDX-License-Identifier: MIT
#include "material/starter.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/files.hpp"
#include "course/lab_file.hpp"
#include "course/markers.hpp"

namespace texel::material {
namespace {

namespace fs = std::filesystem;

/// What students read first: the README of their tree.
constexpr const char* kReadme = "STARTER.md";

/// All but `teach` and `tests`, and what is about these.
constexpr const char* kGiven[] = {".devcontainer", ".gitattributes",  "CMakeLists.txt", "CMakePresets.json",
                                  "LICENSE",       "assets",          "cmake",          "common",
                                  "docs/pictures", "docs/student.md", "labs",           "run",
                                  "shaders",       "tools",           "vcpkg.json"};

/// Whether markers may stand in it.
bool has_text(const fs::path& file) {
  constexpr const char* kTexts[] = {".cpp", ".hpp", ".glsl", ".vert", ".frag"};
  return std::ranges::count(kTexts, file.extension()) > 0;
}

}  // namespace

std::vector<StarterFile> starter_files(const fs::path& root,
                                       const std::function<bool(const std::string&)>& solved) {
  if (!fs::exists(root / "labs") || !fs::exists(root / "common"))
    throw Error::failed("is not the course's source tree", {root.string()},
                        "name the folder with labs, common and shaders");
  std::vector<StarterFile> files;
  const auto give = [&](const fs::path& file) {
    const std::string path = file.lexically_relative(root).generic_string();
    // What was left over may have a solution.
    if (course::is_left_over(file)) return;
    if (!has_text(file)) {
      files.push_back({path, file, {}});
      return;
    }
    const std::string text = read_file(file);
    files.push_back({path, file, course::with_steps(text, path, solved)});
    if (!course::step_texts(text).empty())
      files.push_back({(course::kFirstTexts / fs::path(path)).generic_string(), file,
                       course::with_steps(text, path, [](const std::string&) { return false; })});
  };
  try {
    for (const char* given : kGiven) {
      if (fs::is_regular_file(root / given)) give(root / given);
      if (!fs::is_directory(root / given)) continue;
      for (fs::recursive_directory_iterator at(root / given), end; at != end; ++at) {
        if (at.depth() == 0 && !course::copied_from(at->path()).empty()) at.disable_recursion_pending();
        if (at->is_regular_file()) give(at->path());
      }
    }
  } catch (const fs::filesystem_error& error) {
    throw Error::failed(fmt::format("cannot read: {}", error.code().message()), {error.path1().string()});
  }
  if (fs::exists(root / kReadme)) files.push_back({"README.md", root / kReadme, {}});
  std::ranges::sort(files, {}, &StarterFile::path);
  return files;
}

void write_files(const std::vector<StarterFile>& files, const fs::path& to) {
  if (fs::exists(to) && !(fs::is_directory(to) && fs::is_empty(to)))
    throw Error::usage(fmt::format("'{}' is not empty", to.string()), "name a new folder");
  // Beside it first: a disk that becomes full leaves no half of a tree.
  const fs::path whole = to.has_filename() ? to : to.parent_path(), part = whole.string() + ".part";
  try {
    fs::remove_all(part);
    for (const StarterFile& file : files) {
      const fs::path place = part / file.path;
      fs::create_directories(place.parent_path());
      if (!file.text) {
        fs::copy_file(file.source, place);
        continue;
      }
      write_file(place, *file.text);
      fs::permissions(place, fs::status(file.source).permissions());
    }
    fs::rename(part, whole);
  } catch (const std::exception& error) {
    std::error_code ignored;
    fs::remove_all(part, ignored);
    const auto* system = dynamic_cast<const fs::filesystem_error*>(&error);
    if (system == nullptr) throw;
    throw Error::failed(fmt::format("cannot write: {}", system->code().message()), {system->path1().string()},
                        "check that the folder is writable and the disk has free space");
  }
}

std::map<std::string, Place> first_places(const fs::path& course) {
  std::map<std::string, Place> places;
  for (const std::string& file : course::step_files(course))
    for (const course::StepPart& part : course::parts_of(course::first_text(course, file)))
      places.emplace(part.step, Place{file, part.line});
  return places;
}

std::string with_step_alone(const std::string& text, const std::string& file, const std::string& step,
                            const std::string& solution) {
  if (!course::marker_faults(text, solution, file).empty())
    return course::with_step_from(solution, file, step, text);
  std::string result = text;
  for (const auto& [other, its_text] : course::step_texts(solution))
    if (other != step) result = course::with_step_from(result, file, other, solution);
  return result;
}

}  // namespace texel::material
