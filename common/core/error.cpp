// SPDX-License-Identifier: MIT
#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace texel {
namespace {

std::string message(const std::string& what, const Place& place, const std::string& remedy) {
  std::string text;
  if (!place.file.empty()) text += place.file + ":";
  if (place.line > 0) text += fmt::format("{}:", place.line);
  if (place.column > 0) text += fmt::format("{}:", place.column);
  if (!text.empty()) text += " ";
  text += what;
  if (!remedy.empty()) text += "; " + remedy;
  return text;
}

/// Levenshtein distance: the fewest insertions, deletions and replacements.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, replaced});
    }
  }
  return row[b.size()];
}

}  // namespace

Error::Error(Exit exit, const std::string& text, Place place)
    : std::runtime_error(text), exit_(exit), place_(std::move(place)) {}

Error Error::usage(const std::string& what, const std::string& remedy) {
  return Error(Exit::usage, message(what, {}, remedy), {});
}

Error Error::failed(const std::string& what, const Place& place, const std::string& remedy) {
  return Error(Exit::failed, message(what, place, remedy), place);
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& choices,
                         const std::string& otherwise) {
  std::string best;
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& choice : choices)
    if (const std::size_t distance = edit_distance(word, choice); distance < least) {
      least = distance;
      best = choice;
    }
  return best.empty() ? otherwise : fmt::format("did you mean '{}'?", best);
}

}  // namespace texel
