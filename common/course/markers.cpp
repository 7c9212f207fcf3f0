// SPDX-License-Identifier: MIT
#include "course/markers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/plain_text.hpp"
#include "course/lab_file.hpp"

namespace texel::course {
namespace {

enum class Kind { begin, starter, end };

/// A line that is a marker.
struct Line {
  Kind kind;
  std::string step;  ///< of `begin`; "" for the teacher's
};

bool is_step(std::string_view id) {
  const std::size_t point = id.find('.');
  return point != std::string_view::npos && point > 0 && point + 1 < id.size() &&
         id.find_first_not_of("0123456789.") == std::string_view::npos && id.find('.', point + 1) == id.npos;
}

constexpr const char* kRemedy = "a step stands between the lines '//@step 5.1 begin' and '//@end'";

/// What the line says as a marker, if it is one.
std::optional<Line> read_marker(std::string_view line, const Place& place) {
  const std::size_t first = line.find_first_not_of(" \t");
  if (first == line.npos) return {};
  const bool is_code = line.substr(first).starts_with("//@"),
             is_script = line.substr(first).starts_with("#@");
  if (!is_code && !is_script) return {};
  std::string_view word = line.substr(first + (is_code ? 3 : 2));
  if (const std::size_t last = word.find_last_not_of(" \t\r"); last != word.npos)
    word = word.substr(0, last + 1);
  if (word == "starter") return Line{Kind::starter, {}};
  if (word == "end") return Line{Kind::end, {}};
  if (word == "teacher begin") return Line{Kind::begin, {}};
  if (word.starts_with("step ") && word.ends_with(" begin") && word.size() > 11) {
    const std::string_view id = word.substr(5, word.size() - 11);
    if (is_step(id)) return Line{Kind::begin, std::string(id)};
  }
  throw Error::failed(fmt::format("there is no marker '{}'", line.substr(first)), place, kRemedy);
}

/// A line of the starter's part without the comment's sign; other lines as they are.
std::string uncommented(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  if (first == line.npos) return std::string(line);
  std::string_view rest = line.substr(first);
  const std::size_t sign = rest.starts_with("//") ? 2 : rest.starts_with("#") ? 1 : 0;
  rest.remove_prefix(sign);
  if (sign > 0 && rest.starts_with(" ")) rest.remove_prefix(1);
  const bool is_blank = rest.find_first_not_of("\r\n") == rest.npos;
  return is_blank ? std::string(rest) : std::string(line.substr(0, first)) + std::string(rest);
}

/// Goes through a text. `marker(line, marker)` gets each marker's line, `between(part, line)` each other one
/// with the kind of the marker above it, which is `end` outside.
template <class MarkerLine, class OtherLine>
void walk(const std::string& text, const std::string& file, MarkerLine on_marker, OtherLine on_other) {
  Kind part = Kind::end;
  Place begun, place{file};
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    const std::string_view line = std::string_view(text).substr(at, end - at);
    at = end;
    ++place.line;
    const std::optional<Line> marker = read_marker(line.substr(0, line.find('\n')), place);
    if (!marker) {
      on_other(part, line);
      continue;
    }
    // In a student's tree nothing stands between the two parts, since there is one only.
    const bool fits = marker->kind == Kind::begin     ? part == Kind::end
                      : marker->kind == Kind::starter ? part == Kind::begin
                                                      : part != Kind::end;
    if (!fits)
      throw Error::failed(marker->kind == Kind::begin     ? "a step begins inside another step"
                          : marker->kind == Kind::starter ? "'starter' does not follow 'begin'"
                                                          : "'//@end' without a 'begin' before it",
                          place, kRemedy);
    part = marker->kind;
    if (part == Kind::begin) begun = place;
    on_marker(line, *marker, place.line);
  }
  if (part != Kind::end) throw Error::failed("this step has no end", begun, kRemedy);
}

constexpr std::string_view kMarker = "//@step";

bool has_marker(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin != std::string_view::npos && line.substr(begin).starts_with(kMarker)) return true;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return false;
}

}  // namespace

std::vector<Marker> markers_of(const std::string& text, const std::string& file) {
  std::vector<Marker> markers;
  walk(
      text, file,
      [&](std::string_view, const Line& marker, int line) {
        if (marker.kind == Kind::begin) markers.push_back({marker.step, line});
      },
      [](Kind, std::string_view) {});
  return markers;
}

void require_markers(const std::string& text, const std::string& first, const std::string& file) {
  std::map<std::string, int> counts;
  for (const Marker& marker : markers_of(text, file)) ++counts[marker.step];
  for (const Marker& marker : markers_of(first, file))
    if (!marker.step.empty() && --counts[marker.step] < 0)
      throw Error::failed(fmt::format("the marker '{} {} begin' is missing", kMarker, marker.step), {file},
                          fmt::format("put it back with its //@end: {}/{} has them", kFirstTexts, file));
}

std::map<std::string, std::string> step_texts(const std::string& text, const std::string& file) {
  std::map<std::string, std::string> texts;
  std::string step;
  walk(
      text, file,
      [&](std::string_view, const Line& marker, int) {
        if (marker.kind == Kind::begin) step = marker.step;
        if (!step.empty()) texts[step];  // one without a text is there too
      },
      [&](Kind part, std::string_view line) {
        if (part != Kind::end && !step.empty()) texts[step] += line;
      });
  return texts;
}

std::set<std::string> untouched_steps(const std::string& text, const std::string& first,
                                      const std::string& file) {
  const std::map<std::string, std::string> given = step_texts(first, file);
  std::map<std::string, std::string> own;
  try {
    own = step_texts(text, file);
  } catch (const Error&) {  // what is spoilt was touched
  }
  std::set<std::string> steps;
  for (const auto& [step, what] : given)
    if (const auto found = own.find(step); found != own.end() && found->second == what) steps.insert(step);
  return steps;
}

std::string with_steps(const std::string& text, const std::string& file,
                       const std::function<bool(const std::string&)>& solved) {
  std::string result;
  bool is_step = false, is_solved = false, has_starter = false;
  walk(
      text, file,
      [&](std::string_view line, const Line& marker, int number) {
        if (marker.kind == Kind::begin) {
          is_step = !marker.step.empty();
          is_solved = is_step && solved(marker.step);
          has_starter = false;
        }
        has_starter = has_starter || marker.kind == Kind::starter;
        if (marker.kind == Kind::end && !has_starter)
          throw Error::failed("this step has no '//@starter' part", {file, number}, kRemedy);
        if (is_step && marker.kind != Kind::starter) result += line;
      },
      [&](Kind part, std::string_view line) {
        if (part == Kind::end || (part == Kind::begin && is_solved)) result += line;
        if (part == Kind::starter && !is_solved) result += uncommented(line);
      });
  return result;
}

std::string with_step_from(const std::string& text, const std::string& file, const std::string& step,
                           const std::string& other) {
  std::vector<std::string> parts;
  bool is_step = false;
  walk(
      other, file,
      [&](std::string_view, const Line& marker, int) {
        if (marker.kind == Kind::begin) is_step = marker.step == step;
        if (marker.kind == Kind::begin && is_step) parts.emplace_back();
      },
      [&](Kind part, std::string_view line) {
        if (part != Kind::end && is_step) parts.back() += line;
      });
  std::string result;
  std::size_t count = 0;
  is_step = false;
  walk(
      text, file,
      [&](std::string_view line, const Line& marker, int) {
        result += line;
        if (marker.kind != Kind::begin) return;
        is_step = marker.step == step;
        if (is_step && count < parts.size()) result += parts[count];
        count += is_step ? 1 : 0;
      },
      [&](Kind part, std::string_view line) {
        if (part == Kind::end || !is_step) result += line;
      });
  if (count != parts.size() || count == 0)
    throw Error::failed(
        fmt::format("has {} parts of step {}, but {} are expected", count, step, parts.size()), {file},
        fmt::format("put its markers back; copy them from {}/{}", kFirstTexts, file));
  return result;
}

std::string with_step_alone(const std::string& text, const std::string& file, const std::string& step,
                            const std::string& solution) {
  std::string result = text;
  for (const auto& [other, part] : step_texts(solution, file))
    if (other != step) result = with_step_from(result, file, other, solution);
  return result;
}

std::string first_text(const std::filesystem::path& tree, const std::string& file) {
  if (const std::filesystem::path first = tree / kFirstTexts / file; std::filesystem::exists(first))
    return read_file(first);
  const std::string text = read_file(tree / file);
  return text.find("//@starter") == text.npos
             ? text
             : with_steps(text, file, [](const std::string&) { return false; });
}

std::map<std::string, Place> first_places(const std::filesystem::path& tree) {
  std::map<std::string, Place> places;
  for (const std::string& file : step_files(tree))
    for (const Marker& marker : markers_of(first_text(tree, file), file))
      if (!marker.step.empty()) places.emplace(marker.step, Place{file, marker.line});
  return places;
}

std::map<std::string, Place> step_places(const std::filesystem::path& tree) {
  std::map<std::string, Place> places;
  // Without markers_of: a marker that was spoilt must not hide the others.
  for (const std::string& file : step_files(tree)) {
    int number = 0;
    for (const std::string& line : lines_of(read_file(tree / file))) {
      ++number;
      constexpr std::string_view kBegin = "@step ";
      const std::size_t begin = line.find(kBegin), end = line.find(" begin", begin);
      if (end != std::string::npos)
        places.emplace(line.substr(begin + kBegin.size(), end - begin - kBegin.size()), Place{file, number});
    }
  }
  places.merge(first_places(tree));
  return places;
}

std::vector<std::string> step_files(const std::filesystem::path& tree) {
  const std::filesystem::path first = tree / kFirstTexts,
                              root = std::filesystem::exists(first) ? first : tree;
  std::vector<std::string> files;
  std::error_code missing;
  using Folders = std::filesystem::recursive_directory_iterator;
  for (const char* folder : {"common", "labs", "shaders"})
    for (Folders at(root / folder, missing); at != Folders(); ++at) {
      const std::filesystem::directory_entry& entry = *at;
      if (entry.path().filename() == "expected") at.disable_recursion_pending();  // pictures
      if (at.depth() == 0 && !copied_from(entry.path()).empty()) at.disable_recursion_pending();
      if (!is_left_over(entry.path()) && entry.is_regular_file() && !entry.is_symlink() &&
          has_marker(read_file(entry.path())))
        files.push_back(entry.path().lexically_relative(root).generic_string());
    }
  if (files.empty())
    throw Error::failed("contains no file with steps (//@step)", {tree.string()},
                        "name the folder that contains labs and shaders");
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace texel::course
