// SPDX-License-Identifier: MIT
#include "student_files.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/files.hpp"
#include "core/plain_text.hpp"
#include "course/markers.hpp"

namespace texel::web {
namespace {

/// With one text between a step's markers.
std::string student_text(const std::string& text, const std::string& file) {
  return text.find("@starter") == std::string::npos
             ? text
             : course::with_steps(text, file, [](const std::string&) { return true; });
}

bool is_marker(const std::string& line, const std::string& marker) {
  return plain_text(line).find(marker) != std::string::npos &&
         line.find_first_not_of(" \t") == line.find(marker);
}

/// The texts between a step's markers, as one, and where the first begins.
std::string between_markers(const std::string& text, const std::string& step, int& first_line) {
  std::string result;
  bool inside = false;
  int number = 0, places = 0;
  for (const std::string& line : lines_of(text)) {
    ++number;
    if (is_marker(line, "//@step " + step + " begin")) {
      if (++places == 1)
        first_line = number + 1;
      else
        result.append(StudentFiles::kNextPlace).append("\n");
      inside = true;
    } else if (is_marker(line, "//@end")) {
      inside = false;
    } else if (inside) {
      result += line + "\n";
    }
  }
  return result;
}

}  // namespace

StudentFiles::StudentFiles(std::filesystem::path tree)
    : tree_(std::move(tree)), files_(course::step_files(tree_)) {
  for (const std::string& file : files_) {
    const std::string text = read_file(tree_ / file);
    if (text.find("@starter") == std::string::npos) continue;
    const std::filesystem::path first = tree_ / course::kFirstTexts / file;
    std::filesystem::create_directories(first.parent_path());
    write_file(first, course::with_steps(text, file, [](const std::string&) { return false; }));
    write_file(tree_ / file, student_text(text, file));
  }
  places_ = course::step_places(tree_);
}

StudentFiles::Text StudentFiles::text(const std::string& step) const {
  Text text;
  text.file = file_of(step);
  int ignored = 0;
  text.now = between_markers(read(text.file), step, text.line);
  text.first = between_markers(course::first_text(tree_, text.file), step, ignored);
  return text;
}

std::string StudentFiles::with(const std::string& step, const std::string& text) const {
  const std::string& file = file_of(step);
  if (!is_shader(file))
    throw Error::usage(fmt::format("step {} is written in C++: do it on the desktop", step));
  std::vector<std::string> parts(1);
  for (const std::string& line : lines_of(text)) {
    for (const char* marker : {"//@step", "//@end", "//@starter", "//@teacher"})
      if (is_marker(line, marker)) throw Error::usage(fmt::format("a step's text has no line '{}'", marker));
    if (is_marker(line, kNextPlace))
      parts.emplace_back();
    else
      parts.back() += line + "\n";
  }
  std::string result;
  std::size_t part = 0;
  bool inside = false;
  for (const std::string& line : lines_of(read(file))) {
    if (is_marker(line, "//@end")) inside = false;
    if (!inside) result += line + "\n";
    if (!is_marker(line, "//@step " + step + " begin")) continue;
    inside = true;
    if (part < parts.size()) result += parts[part];
    ++part;
  }
  if (part != parts.size())
    throw Error::usage(
        fmt::format("step {} is written in {} places, and this text has {}", step, part, parts.size()),
        fmt::format("put a line {} between them", kNextPlace));
  return result;
}

const Place* StudentFiles::place(const std::string& step) const {
  const auto found = places_.find(step);
  return found == places_.end() ? nullptr : &found->second;
}

const std::string& StudentFiles::file_of(const std::string& step) const {
  const Place* found = place(step);
  if (found == nullptr) throw Error::usage(fmt::format("there is no step '{}'", step));
  return found->file;
}

std::vector<std::string> StudentFiles::shaders() const {
  std::vector<std::string> list;
  std::copy_if(files_.begin(), files_.end(), std::back_inserter(list), is_shader);
  return list;
}

std::string StudentFiles::read(const std::string& path) const {
  return read_file(tree_ / known(path));
}

void StudentFiles::write(const std::string& path, const std::string& text) const {
  const std::string plain = student_text(text, known(path));
  const auto steps_of = [&](const std::string& of) {
    std::vector<std::string> steps;
    for (const course::Marker& marker : course::markers_of(of, path)) steps.push_back(marker.step);
    return steps;
  };
  if (steps_of(plain) != steps_of(course::first_text(tree_, path)))
    throw Error::failed("has other markers (//@step) than the course's file", {path}, "put them back");
  write_file(tree_ / path, plain);
}

const std::string& StudentFiles::known(const std::string& path) const {
  if (std::find(files_.begin(), files_.end(), path) == files_.end())
    throw Error::usage(fmt::format("'{}' is no file with steps", path));
  return path;
}

}  // namespace texel::web
