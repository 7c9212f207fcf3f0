// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "core/plain_text.hpp"
#include "mesh/obj.hpp"
#include "text.hpp"

namespace texel::mesh {
namespace {

/// The words that may follow a texture option, as they ask for the picture as without it, which is how
/// pictures are drawn; none where any word is fine. Fewer numbers may follow: the first word that is none
/// ends them.
std::vector<float> neutral_arguments(std::string_view option) {
  if (option == "-s") return {1.0F, 1.0F, 1.0F};
  if (option == "-o" || option == "-t") return {0.0F, 0.0F, 0.0F};
  if (option == "-mm") return {0.0F, 1.0F};
  return {};
}

/// The file's name after the options of a map_ line, to the line's end. `unfollowed` gets an option that asks
/// for something that is not done.
std::string map_file(std::string_view line, std::string& unfollowed) {
  std::string_view rest = trimmed(line);
  while (rest.size() > 1 && rest[0] == '-') {
    std::string_view after = rest;
    const std::string_view option = take_word(after);
    const std::vector<float> neutral = neutral_arguments(option);
    for (std::size_t i = 0; i < std::max<std::size_t>(neutral.size(), 1); ++i) {
      std::string_view peek = after;
      float number = 0.0F;
      const std::string_view word = take_word(peek);
      if (parse_float(word, number) != NumberStatus::ok && i > 0) break;
      if (neutral.empty() ? option == "-clamp" && lower_case(word) != "off" : number != neutral[i])
        unfollowed = option;
      after = peek;
    }
    rest = trimmed(after);
  }
  std::string file(rest);
  std::replace(file.begin(), file.end(), '\\', '/');
  return file;
}

bool is_number(std::string_view word, float& value) {
  const NumberStatus status = parse_float(word, value);
  return status == NumberStatus::ok || status == NumberStatus::repaired;
}

/// `r g b`, or one number for all three.
bool parse_color(std::string_view line, glm::vec3& color) {
  std::string_view word = take_word(line);
  glm::vec3 rgb(0.0F);
  if (!is_number(word, rgb.r)) return false;
  rgb = glm::vec3(rgb.r);
  if (word = take_word(line); !word.empty())
    if (!is_number(word, rgb.g) || !is_number(take_word(line), rgb.b)) return false;
  color = rgb;
  return true;
}

}  // namespace

std::vector<Material> parse_mtl(std::string_view text, const std::string& name,
                                std::vector<std::string>& warnings) {
  std::vector<Material> materials;
  LineReader lines(text);
  std::size_t lost = 0, changed = 0;
  std::string first_lost, first_changed;
  const auto lose_line = [&](const std::string& why) {
    if (lost++ == 0) first_lost = fmt::format("line {}: {}", lines.line_number(), why);
  };
  std::string_view line;
  while (lines.next(line)) {
    const std::string keyword = lower_case(take_word(line));
    if (keyword == "newmtl") {
      materials.push_back({.name = std::string(trimmed(line))});
    } else if (keyword != "kd" && keyword != "map_kd") {
      continue;
    } else if (materials.empty()) {
      lose_line(for_message(keyword) + " before any newmtl");
    } else if (keyword == "kd") {
      if (!parse_color(line, materials.back().diffuse)) lose_line("Kd needs one or three finite numbers");
    } else {
      std::string option;
      materials.back().color_map = map_file(line, option);
      if (!option.empty() && changed++ == 0)
        first_changed = fmt::format("{} of material {}", option, for_message(materials.back().name));
    }
  }
  if (lost > 0)
    warnings.push_back(fmt::format("{}: {} lines ignored; the first is {}", name, lost, first_lost));
  if (changed > 0)
    warnings.push_back(fmt::format(
        "{}: options of {} pictures not followed, these are drawn as without them; the first is {}", name,
        changed, first_changed));
  return materials;
}

}  // namespace texel::mesh
