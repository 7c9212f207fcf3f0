// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "core/plain_text.hpp"
#include "course/markers.hpp"

/// What stands between the markers of a step.
namespace texel::web {

/// Between the parts of a step that is written in several places.
inline constexpr const char* kNextPlace = "//@next";

/// A file of the tree as the student has it: with one text between a step's markers.
inline std::string student_text(const std::string& text, const std::string& file) {
  return text.find("@starter") == std::string::npos
             ? text
             : course::with_steps(text, file, [](const std::string&) { return true; });
}

inline bool is_marker(const std::string& line, const std::string& marker) {
  return plain_text(line).find(marker) != std::string::npos &&
         line.find_first_not_of(" \t") == line.find(marker);
}

/// The texts between a step's markers, and where the first begins.
inline std::vector<std::string> places_of(const std::string& text, const std::string& step, int& first_line) {
  std::vector<std::string> places;
  bool inside = false;
  int number = 0;
  for (const std::string& line : lines_of(text)) {
    ++number;
    if (is_marker(line, "//@step " + step + " begin")) {
      if (places.empty()) first_line = number + 1;
      inside = true, places.emplace_back();
    } else if (is_marker(line, "//@end")) {
      inside = false;
    } else if (inside) {
      places.back() += line + "\n";
    }
  }
  return places;
}

inline std::string joined(const std::vector<std::string>& places) {
  std::string text;
  for (std::size_t i = 0; i < places.size(); ++i)
    text += (i > 0 ? std::string(kNextPlace) + "\n" : "") + places[i];
  return text;
}

}  // namespace texel::web
