// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/files.hpp"
#include "course/markers.hpp"

namespace texel::course {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStudentsGuide = "docs/student.md";

/// What belongs to the course.
constexpr const char* kGiven[] = {
    "CMakeLists.txt", "CMakePresets.json", "LICENSE", "assets", "cmake",   "common",
    "docs/pictures",  kStudentsGuide,      "labs",    "run",    "shaders", "tools",
    "vcpkg.json"};

/// What of it the student does not get: the right answers, and what makes or proves the course.
constexpr const char* kWithheld[] = {"assets/make/", "common/app/include/app/colour_truth.hpp",
                                     "common/app/include/app/shape_truth.hpp",
                                     "common/app/include/app/truth_scene.hpp", "common/truth/"};

bool is_withheld(const std::string& path) {
  return std::any_of(std::begin(kWithheld), std::end(kWithheld),
                     [&](const char* withheld) { return path.starts_with(withheld); });
}

/// Whether markers may stand in it.
bool has_text(const fs::path& file) {
  static constexpr const char* kTexts[] = {".cpp", ".hpp", ".glsl", ".vert", ".frag"};
  return file.filename() == "CMakeLists.txt" || file.extension() == ".cmake" ||
         std::find(std::begin(kTexts), std::end(kTexts), file.extension()) != std::end(kTexts);
}

}  // namespace

void write_starter(const fs::path& root, const fs::path& to,
                   const std::function<bool(const std::string&)>& solved) {
  if (!fs::exists(root / "labs") || !fs::exists(root / "common"))
    throw Error::failed("is not the course's source tree", {root.string()},
                        "run this from the folder that holds labs, common and shaders");
  if (fs::exists(to) && !(fs::is_directory(to) && fs::is_empty(to)))
    throw Error::usage(fmt::format("'{}' holds something already", to.string()), "name a new folder");
  const auto give = [&](const fs::path& file) {
    const std::string path = file.lexically_relative(root).generic_string();
    if (is_withheld(path)) return;
    fs::create_directories((to / path).parent_path());
    if (!has_text(file)) {
      fs::copy_file(file, to / path);
      return;
    }
    const std::string text = read_file(file);
    write_file(to / path, with_steps(text, path, solved));
    fs::permissions(to / path, fs::status(file).permissions());
    if (step_texts(text, path).empty()) return;
    fs::create_directories((to / kFirstTexts / path).parent_path());
    write_file(to / kFirstTexts / path, with_steps(text, path, [](const std::string&) { return false; }));
  };
  try {
    for (const char* given : kGiven) {
      if (fs::is_regular_file(root / given)) give(root / given);
      if (!fs::is_directory(root / given)) continue;
      for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / given))
        if (entry.is_regular_file()) give(entry.path());
    }
    // What students read first.
    if (fs::exists(root / kStudentsGuide)) fs::copy_file(root / kStudentsGuide, to / "README.md");
  } catch (const fs::filesystem_error& error) {
    throw Error::failed(fmt::format("cannot write: {}", error.code().message()), {error.path1().string()},
                        "check that the disk has room and the folder can be written");
  }
}

}  // namespace texel::course
