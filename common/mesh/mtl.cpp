// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "mesh/obj.hpp"
#include "text.hpp"

namespace texel::mesh {
namespace {

std::string lower(std::string_view word) {
  std::string text(word);
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// How many words may follow a texture option. Those with fewer than this are numbers, so the first word that
/// is none ends them.
std::size_t option_arguments(std::string_view option) {
  if (option == "-s" || option == "-o" || option == "-t") return 3;
  return option == "-mm" ? 2 : 1;
}

/// The file's name after the options of a map_ line; it may hold blanks.
std::string map_file(std::string_view line) {
  std::string_view rest = rest_of_line(line);
  while (rest.size() > 1 && rest[0] == '-') {
    std::string_view after = rest;
    const std::size_t arguments = option_arguments(take_word(after));
    for (std::size_t i = 0; i < arguments; ++i) {
      std::string_view peek = after;
      float ignored = 0.0f;
      const std::string_view word = take_word(peek);
      // -clamp on and the like have one word of any kind; numbers may be fewer than the most.
      if (i > 0 && parse_float(word, ignored) != NumberStatus::ok) break;
      after = peek;
    }
    rest = rest_of_line(after);
  }
  std::string file(rest);
  std::replace(file.begin(), file.end(), '\\', '/');
  return file;
}

/// `r g b`, or one number for all three. A colour as a spectral curve or in CIE XYZ is left as it is.
bool parse_color(std::string_view line, glm::vec3& color) {
  std::string_view word = take_word(line);
  if (word == "spectral" || word == "xyz") return true;
  glm::vec3 rgb(0.0f);
  if (parse_float(word, rgb.r) != NumberStatus::ok) return false;
  rgb = glm::vec3(rgb.r);
  if (word = take_word(line); !word.empty())
    if (parse_float(word, rgb.g) != NumberStatus::ok ||
        parse_float(take_word(line), rgb.b) != NumberStatus::ok)
      return false;
  color = rgb;
  return true;
}

}  // namespace

std::vector<Material> parse_mtl(std::string_view text, const std::string& name) {
  std::vector<Material> materials;
  bool has_norm = false;  // `norm` is a normal map for certain, `bump` may be a height map: it yields
  LineReader lines(text);
  const auto fail = [&](const std::string& what, const std::string& remedy) {
    return Error::failed(what, {name, static_cast<int>(lines.line_number())}, remedy);
  };
  std::string_view line;
  while (lines.next(line)) {
    const std::string keyword = lower(take_word(line));
    if (keyword == "newmtl") {
      materials.push_back({std::string(rest_of_line(line)), glm::vec3(1.0f), {}, {}});
      has_norm = false;
      continue;
    }
    const bool bump = keyword == "map_bump" || keyword == "bump", norm = keyword == "norm";
    if (keyword != "kd" && keyword != "map_kd" && !bump && !norm) continue;
    if (materials.empty())
      throw fail(for_message(keyword) + " before any newmtl", "start with a line newmtl NAME");
    Material& material = materials.back();
    if (keyword == "kd") {
      if (!parse_color(line, material.diffuse))
        throw fail("Kd needs one or three finite numbers", "write Kd r g b, each 0 to 1");
    } else if (keyword == "map_kd") {
      material.color_map = map_file(line);
    } else if (norm || !has_norm) {
      material.normal_map = map_file(line);
      has_norm = has_norm || norm;
    }
  }
  return materials;
}

}  // namespace texel::mesh
