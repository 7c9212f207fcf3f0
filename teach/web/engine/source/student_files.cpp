// SPDX-License-Identifier: MIT
#include "student_files.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/files.hpp"
#include "core/plain_text.hpp"
#include "course/markers.hpp"

namespace texel::web {
namespace {

/// The texts between a step's markers, as one, and the line where the first begins.
std::pair<std::string, int> between_markers(const std::string& text, const std::string& step) {
  std::string result;
  int first_line = 0;
  for (const course::StepPart& part : course::parts_of(text)) {
    if (part.step != step || !part.is_whole()) continue;
    if (first_line > 0) result.append(StudentFiles::kNextPlace).append("\n");
    if (first_line == 0) first_line = part.line + 1;
    for (const std::string& line : lines_of(part.of(text))) result += line + "\n";
  }
  return {result, first_line};
}

}  // namespace

StudentFiles::StudentFiles(std::filesystem::path tree)
    : tree_(std::move(tree)), files_(course::step_files(tree_)) {
  for (const std::string& file : files_) {
    const std::string text = read_file(tree_ / file);
    if (text.find("//@starter") == std::string::npos) continue;
    const std::filesystem::path first = tree_ / course::kFirstTexts / file;
    std::filesystem::create_directories(first.parent_path());
    write_file(first, course::with_steps(text, file, [](const std::string&) { return false; }));
    write_file(tree_ / file, course::with_steps(text, file, [](const std::string&) { return true; }));
  }
  places_ = course::step_places(tree_);
}

StudentFiles::Text StudentFiles::text(const std::string& step) const {
  const std::string& file = place(step).file;
  const auto [now, line] = between_markers(read(file), step);
  return {now, between_markers(course::first_text(tree_, file), step).first, file, line};
}

std::string StudentFiles::with(const std::string& step, const std::string& text) const {
  const std::string& file = place(step).file;
  if (!is_shader(file))
    throw Error::usage(fmt::format("step {} is written in C++: do it on the desktop", step));
  std::vector<std::string> parts(1);
  for (const std::string& line : lines_of(text)) {
    if (course::is_marker(line))
      throw Error::usage(fmt::format("a step's text has no line '{}'", plain_text(line)));
    if (const std::size_t next = line.find(kNextPlace);
        next != line.npos && next == line.find_first_not_of(" \t"))
      parts.emplace_back();
    else
      parts.back() += line + "\n";
  }
  const std::string own = read(file);
  const std::vector<course::StepPart> places = course::parts_of(own);
  const auto count = static_cast<std::size_t>(std::count_if(
      places.begin(), places.end(), [&](const course::StepPart& place) { return place.step == step; }));
  if (count != parts.size())
    throw Error::usage(
        fmt::format("step {} is written in {} places, and this text has {}", step, count, parts.size()),
        fmt::format("put a line {} between them", kNextPlace));
  std::string marked;
  for (const std::string& part : parts) marked += fmt::format("//@step {} begin\n{}//@end\n", step, part);
  return course::with_step_from(own, file, step, marked);
}

const Place& StudentFiles::place(const std::string& step) const {
  const auto found = places_.find(step);
  if (found == places_.end()) throw Error::usage(fmt::format("there is no step '{}'", step));
  return found->second;
}

std::string StudentFiles::read(const std::string& path) const {
  return read_file(tree_ / known(path));
}

void StudentFiles::write(const std::string& path, const std::string& text) const {
  const auto faults = course::marker_faults(text, course::first_text(tree_, known(path)), path);
  if (!faults.empty()) throw Error::failed(faults.begin()->second);
  write_file(tree_ / path, text);
}

const std::string& StudentFiles::known(const std::string& path) const {
  if (std::count(files_.begin(), files_.end(), path) == 0)
    throw Error::usage(fmt::format("'{}' is no file with steps", path));
  return path;
}

}  // namespace texel::web
