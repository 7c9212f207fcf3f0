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
#include "course/same_code.hpp"

namespace texel::course {
namespace {

enum class Kind { begin, starter, end };

/// A line that is a marker.
struct Line {
  Kind kind;
  std::string step;  ///< of `begin`
};

bool is_step(std::string_view id) {
  const std::size_t point = id.find('.');
  return point != std::string_view::npos && point > 0 && point + 1 < id.size() &&
         id.find_first_not_of("0123456789.") == std::string_view::npos && id.find('.', point + 1) == id.npos;
}

std::string remedy() {
  return fmt::format("a step stands between the lines '{}' and '//@end'", begin_marker("5.1"));
}

/// What a line says as a marker, if it is one: the markers' own words and nothing else.
std::optional<Line> marker_of(std::string_view line) {
  const std::size_t first = std::min(line.find_first_not_of(" \t"), line.size());
  std::string_view word = line.substr(first, line.find_last_not_of(" \t\r\n") + 1 - first);
  if (!word.starts_with("//@")) return {};
  word.remove_prefix(3);
  if (word == "starter") return Line{Kind::starter, {}};
  if (word == "end") return Line{Kind::end, {}};
  if (word.starts_with("step ") && word.ends_with(" begin") && word.size() > 11) {
    const std::string_view id = word.substr(5, word.size() - 11);
    if (is_step(id)) return Line{Kind::begin, std::string(id)};
  }
  return {};
}

/// The same in a text of the course, where a misspelt marker would give a solution away.
std::optional<Line> strict_marker_of(std::string_view line, const Place& place) {
  std::optional<Line> marker = marker_of(line);
  const std::string_view rest = line.substr(std::min(line.find_first_not_of(" \t"), line.size()));
  if (!marker && rest.starts_with("//@"))
    throw Error::failed(fmt::format("there is no marker '{}'", rest.substr(0, rest.find_first_of("\r\n"))),
                        place, remedy());
  return marker;
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

/// The texts of a step's places, as many as it should have. Throws Error (exit 3) where its markers are not
/// whole.
std::vector<std::string> whole_texts(const std::string& text, const std::string& file,
                                     const std::string& step, std::size_t expected) {
  std::vector<std::string> texts;
  for (const StepPart& part : parts_of(text)) {
    if (part.step != step) continue;
    if (!part.is_whole())
      throw Error::failed(fmt::format("step {} has no '//@end' of its own", step), {file, part.line},
                          remedy());
    texts.push_back(part.of(text));
  }
  const std::string remedy = fmt::format("copy the lines with its markers from {}/{}", kFirstTexts, file);
  if (texts.empty())
    throw Error::failed(fmt::format("the marker '{}' is missing", begin_marker(step)), {file}, remedy);
  if (texts.size() != expected)
    throw Error::failed(fmt::format("step {} has its markers in {} places, but {} are expected", step,
                                    texts.size(), expected),
                        {file}, remedy);
  return texts;
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
  const bool is_comment = rest.starts_with("//");
  if (is_comment) rest.remove_prefix(rest.starts_with("// ") ? 3 : 2);
  const bool is_blank = rest.find_first_not_of("\r\n") == rest.npos;
  return is_blank ? std::string(rest) : std::string(line.substr(0, first)) + std::string(rest);
}

/// Goes through a text of the course. `marker(line, marker)` gets each marker's line, `between(part, line)`
/// each other one with the kind of the marker above it, which is `end` outside.
template <class MarkerLine, class OtherLine>
void walk(const std::string& text, const std::string& file, MarkerLine on_marker, OtherLine on_other) {
  Kind part = Kind::end;
  Place begun;
  each_line(text, [&](std::string_view line, std::size_t, int number) {
    const Place place{file, number};
    const std::optional<Line> marker = strict_marker_of(line, place);
    if (!marker) {
      on_other(part, line);
      return;
    }
    // In a starter nothing stands between the two parts, since there is one only.
    const bool fits = marker->kind == Kind::begin     ? part == Kind::end
                      : marker->kind == Kind::starter ? part == Kind::begin
                                                      : part != Kind::end;
    if (!fits)
      throw Error::failed(marker->kind == Kind::begin     ? "a step begins inside another step"
                          : marker->kind == Kind::starter ? "'starter' does not follow 'begin'"
                                                          : "'//@end' without a 'begin' before it",
                          place, remedy());
    part = marker->kind;
    if (part == Kind::begin) begun = place;
    on_marker(line, *marker, number);
  });
  if (part != Kind::end) throw Error::failed("this step has no end", begun, remedy());
}

bool has_marker(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin != std::string_view::npos && line.substr(begin).starts_with("//@") &&
        line.substr(begin + 3).starts_with("step"))
      return true;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return false;
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

std::map<std::string, std::string> marker_faults(const std::string& text, const std::string& first,
                                                 const std::string& file) {
  std::map<std::string, std::string> faults;
  for (const auto& [step, texts] : texts_by_step(first)) try {
      whole_texts(text, file, step, texts.size());
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
  bool is_solved = false, has_starter = false;
  walk(
      text, file,
      [&](std::string_view line, const Line& marker, int number) {
        if (marker.kind == Kind::begin) {
          is_solved = solved(marker.step);
          has_starter = false;
        }
        has_starter = has_starter || marker.kind == Kind::starter;
        if (marker.kind == Kind::end && !has_starter)
          throw Error::failed("this step has no '//@starter' part", {file, number}, remedy());
        if (marker.kind != Kind::starter) result += line;
      },
      [&](Kind part, std::string_view line) {
        if (part == Kind::end || (part == Kind::begin && is_solved)) result += line;
        if (part == Kind::starter && !is_solved) result += uncommented(line);
      });
  return result;
}

std::string with_step_from(const std::string& text, const std::string& file, const std::string& step,
                           const std::string& other) {
  std::map<std::string, std::vector<std::string>> others = texts_by_step(other);
  whole_texts(text, file, step, others[step].size());
  std::string result;
  std::size_t at = 0, count = 0;
  for (const StepPart& part : parts_of(text)) {
    if (part.step != step) continue;
    result += text.substr(at, part.text - at) + others[step][count++];
    at = part.text_end;
  }
  return result + text.substr(at);
}

std::string with_step_alone(const std::string& text, const std::string& file, const std::string& step,
                            const std::string& solution) {
  const std::vector<StepPart> given = parts_of(solution);
  std::map<std::string, std::vector<std::size_t>> places;  // in `given`
  for (std::size_t i = 0; i < given.size(); ++i) places[given[i].step].push_back(i);
  whole_texts(text, file, step, places[step].size());
  const std::map<std::string, std::string> lost = marker_faults(text, solution, file);
  std::string result;
  std::size_t at = 0, next = 0;  // the text up to here is done, and so are the places before the next one
  const auto copy_up_to = [&](std::size_t place, std::size_t end, std::size_t end_in_solution) {
    bool is_lost = next < place;
    for (std::size_t i = next; i < place; ++i) is_lost = is_lost && lost.contains(given[i].step);
    if (!is_lost) {
      result += text.substr(at, end - at);
      return;
    }
    if (!result.empty() && result.back() != '\n') result += '\n';
    const std::size_t begin = next == 0 ? 0 : given[next - 1].end;
    result += solution.substr(begin, end_in_solution - begin);
  };
  std::map<std::string, std::size_t> count;
  for (const StepPart& part : parts_of(text)) {
    if (!part.is_whole() || !places.contains(part.step) || lost.contains(part.step)) continue;
    const std::size_t place = places[part.step][count[part.step]++];
    copy_up_to(place, part.begin, given[place].begin);
    result += text.substr(part.begin, part.text - part.begin);
    result += part.step == step ? part.of(text) : given[place].of(solution);
    result += text.substr(part.text_end, part.end - part.text_end);
    at = part.end, next = place + 1;
  }
  copy_up_to(given.size(), text.size(), solution.size());
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
      places.emplace(marker.step, Place{file, marker.line});
  return places;
}

std::map<std::string, Place> step_places(const std::filesystem::path& tree) {
  std::map<std::string, Place> places;
  // Without markers_of: a marker that was spoilt must not hide the others.
  for (const std::string& file : step_files(tree)) {
    int number = 0;
    for (const std::string& line : lines_of(read_file(tree / file))) {
      ++number;
      constexpr std::string_view kStep = "step ";
      const std::size_t begin = line.find('@') + 1, end = line.find(" begin", begin);
      if (begin > 0 && end != std::string::npos && line.substr(begin).starts_with(kStep))
        places.emplace(line.substr(begin + kStep.size(), end - begin - kStep.size()), Place{file, number});
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
  for (const char* folder : {"labs", "shaders"})
    for (Folders at(root / folder, missing); at != Folders(); ++at) {
      const std::filesystem::directory_entry& entry = *at;
      if (entry.path().filename() == "expected") at.disable_recursion_pending();  // pictures
      if (at.depth() == 0 && !copied_from(entry.path()).empty()) at.disable_recursion_pending();
      if (!is_left_over(entry.path()) && entry.is_regular_file() && !entry.is_symlink() &&
          has_marker(read_file(entry.path())))
        files.push_back(entry.path().lexically_relative(root).generic_string());
    }
  if (files.empty())
    throw Error::failed("contains no file with a step's markers", {tree.string()},
                        "name the folder that contains labs and shaders");
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace texel::course
