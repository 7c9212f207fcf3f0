// SPDX-License-Identifier: MIT
#include "course/markers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/files.hpp"
#include "core/pattern.hpp"
#include "core/plain_text.hpp"
#include "course/lab_file.hpp"

namespace texel::course {
namespace {

enum class Kind { begin, starter, end };

/// A line that is a marker.
struct Line {
  Kind kind;
  std::string step;  ///< of `begin`
};

std::string remedy() {
  return fmt::format("a step stands between the lines '{}' and '//@end'", begin_marker("5.1"));
}

/// What a line says as a marker, if it is one: the markers' own words and nothing else.
std::optional<Line> marker_of(std::string_view line) {
  static const Pattern kMarker(R"(//@(?:starter|end|step ([0-9]{1,2}\.[0-9]{1,2}) begin))");
  const std::string word(trimmed(line));
  const Pattern::Groups found = word.starts_with("//@") ? kMarker.match(word) : Pattern::Groups();
  if (found.empty()) return {};
  if (!found[1].empty()) return Line{Kind::begin, found[1]};
  return Line{word == "//@end" ? Kind::end : Kind::starter, {}};
}

/// Calls on_line(line, offset, number) for each line of a text, with its end.
template <class OnLine>
void each_line(std::string_view text, OnLine on_line) {
  int number = 0;
  for (std::size_t at = 0, end = 0; at < text.size(); at = end) {
    end = std::min(text.find('\n', at), text.size() - 1) + 1;
    on_line(text.substr(at, end - at), at, ++number);
  }
}

/// A step's places, as many as it should have. Throws Error (exit 3) where its markers are not whole.
std::vector<StepPart> whole_parts(const std::string& text, const std::string& file, const std::string& step,
                                  std::size_t expected) {
  std::vector<StepPart> parts = parts_of(text);
  std::erase_if(parts, [&](const StepPart& part) { return part.step != step; });
  for (const StepPart& part : parts)
    if (!part.is_whole())
      throw Error::failed(fmt::format("step {} has no '//@end' of its own", step), {file, part.line},
                          remedy());
  const std::string remedy = fmt::format("copy the lines with its markers from {}/{}", kFirstTexts, file);
  if (parts.empty())
    throw Error::failed(fmt::format("the marker '{}' is missing", begin_marker(step)), {file}, remedy);
  if (parts.size() != expected)
    throw Error::failed(fmt::format("step {} has its markers in {} places, but {} are expected", step,
                                    parts.size(), expected),
                        {file}, remedy);
  return parts;
}

std::map<std::string, std::vector<std::string>> texts_by_step(const std::string& text) {
  std::map<std::string, std::vector<std::string>> texts;
  for (const StepPart& part : parts_of(text))
    if (part.is_whole()) texts[part.step].push_back(part.of(text));
  return texts;
}

/// A line of the starter's part without the comment's sign; other lines as they are.
std::string uncommented(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  if (first == line.npos) return std::string(line);
  std::string_view rest = line.substr(first);
  if (rest.starts_with("//")) rest.remove_prefix(rest.starts_with("// ") ? 3 : 2);
  const bool is_blank = rest.find_first_not_of("\r\n") == rest.npos;
  return is_blank ? std::string(rest) : std::string(line.substr(0, first)) + std::string(rest);
}

}  // namespace

std::string begin_marker(const std::string& step) {
  return fmt::format("//@{} {} begin", "step", step);
}

bool is_marker(std::string_view line) {
  return marker_of(line).has_value();
}

std::vector<StepPart> parts_of(const std::string& text) {
  std::vector<StepPart> parts;
  each_line(text, [&](std::string_view line, std::size_t at, int number) {
    const std::optional<Line> marker = marker_of(line);
    if (!marker) return;
    if (marker->kind == Kind::begin)
      parts.push_back({marker->step, number, at, at + line.size()});
    else if (marker->kind == Kind::end && !parts.empty() && !parts.back().is_whole())
      parts.back().text_end = at, parts.back().end = at + line.size();
  });
  return parts;
}

std::map<std::string, std::string> marker_faults(const std::string& text, const std::string& first,
                                                 const std::string& file) {
  std::map<std::string, std::string> faults;
  for (const auto& [step, texts] : texts_by_step(first)) try {
      whole_parts(text, file, step, texts.size());
    } catch (const Error& error) {
      faults[step] = error.what();
    }
  return faults;
}

std::map<std::string, std::string> step_texts(const std::string& text) {
  std::map<std::string, std::string> joined;
  for (const auto& [step, texts] : texts_by_step(text))
    for (const std::string& part : texts) joined[step] += part;
  return joined;
}

std::set<std::string> untouched_steps(const std::string& text, const std::string& first) {
  std::map<std::string, std::vector<std::string>> own = texts_by_step(text);
  std::set<std::string> steps;
  for (const auto& [step, given] : texts_by_step(first))
    if (std::equal(given.begin(), given.end(), own[step].begin(), own[step].end(), is_same_code))
      steps.insert(step);
  return steps;
}

std::string with_steps(const std::string& text, const std::string& file,
                       const std::function<bool(const std::string&)>& solved) {
  std::string result;
  Kind part = Kind::end;  // as the marker above says; `end` outside of steps
  bool is_solved = false;
  Place begun;
  each_line(text, [&](std::string_view line, std::size_t, int number) {
    const Place place{file, number};
    const std::optional<Line> marker = marker_of(line);
    if (!marker) {
      // A misspelt marker would give a solution away.
      if (trimmed(line).starts_with("//@"))
        throw Error::failed(fmt::format("there is no marker '{}'", trimmed(line)), place, remedy());
      if (part == Kind::end || (part == Kind::begin && is_solved)) result += line;
      if (part == Kind::starter && !is_solved) result += uncommented(line);
      return;
    }
    if (marker->kind == Kind::begin && part != Kind::end)
      throw Error::failed("a step begins inside another step", place, remedy());
    if (marker->kind == Kind::starter && part != Kind::begin)
      throw Error::failed("'starter' does not follow 'begin'", place, remedy());
    if (marker->kind == Kind::end && part != Kind::starter)
      throw Error::failed(
          part == Kind::begin ? "this step has no '//@starter' part" : "'//@end' without a 'begin' before it",
          place, remedy());
    part = marker->kind;
    if (part == Kind::begin) begun = place, is_solved = solved(marker->step);
    if (part != Kind::starter) result += line;
  });
  if (part != Kind::end) throw Error::failed("this step has no end", begun, remedy());
  return result;
}

std::string with_step_from(const std::string& text, const std::string& file, const std::string& step,
                           const std::string& other) {
  const std::vector<std::string> others = texts_by_step(other)[step];
  std::string result;
  std::size_t at = 0, count = 0;
  for (const StepPart& part : whole_parts(text, file, step, others.size())) {
    result += text.substr(at, part.text - at) + others[count++];
    at = part.text_end;
  }
  return result + text.substr(at);
}

std::string first_text(const std::filesystem::path& tree, const std::string& file) {
  if (const std::filesystem::path first = tree / kFirstTexts / file; std::filesystem::exists(first))
    return read_file(first);
  const std::string text = read_file(tree / file);
  return text.find("//@starter") == text.npos
             ? text
             : with_steps(text, file, [](const std::string&) { return false; });
}

std::map<std::string, Place> step_places(const std::filesystem::path& tree) {
  std::map<std::string, Place> places;
  for (const std::string& file : step_files(tree))
    for (const std::string& text : {read_file(tree / file), first_text(tree, file)})
      for (const StepPart& part : parts_of(text)) places.emplace(part.step, Place{file, part.line});
  return places;
}

std::vector<std::string> step_files(const std::filesystem::path& tree) {
  const std::filesystem::path first = tree / kFirstTexts,
                              root = std::filesystem::exists(first) ? first : tree;
  std::vector<std::string> files;
  std::error_code missing;
  using Folders = std::filesystem::recursive_directory_iterator;
  for (const char* folder : {"labs", "shaders"})
    for (Folders at(root / folder, missing); at != Folders(); ++at) {
      const std::filesystem::directory_entry& entry = *at;
      if (entry.path().filename() == "expected") at.disable_recursion_pending();  // pictures
      if (at.depth() == 0 && !copied_from(entry.path()).empty()) at.disable_recursion_pending();
      if (!is_left_over(entry.path()) && entry.is_regular_file() && !entry.is_symlink() &&
          !parts_of(read_file(entry.path())).empty())
        files.push_back(entry.path().lexically_relative(root).generic_string());
    }
  if (files.empty())
    throw Error::failed("contains no file with a step's markers", {tree.string()},
                        "name the folder that contains labs and shaders");
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace texel::course
