// SPDX-License-Identifier: MIT
// Which picture and which colour each part of a model has.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

#include "image/color.hpp"
#include "import.hpp"

namespace texel::obj_texcoords {

/// The material of part `i`; null for none.
inline const mesh::Material* material_of(const Imported& imported, std::size_t i) {
  const std::size_t index = imported.material_of_part[i];
  return index < imported.materials.size() ? &imported.materials[index] : nullptr;
}

/// The name or path of the picture of part `i`; "" for none.
inline std::string picture_of(const std::string& texture, const Imported& imported, std::size_t i) {
  if (texture != "material") return texture;
  if (!imported.names_pictures) return "label_grid";
  const mesh::Material* material = material_of(imported, i);
  return material != nullptr ? material->color_map : "";
}

/// The sRGB colour of part `i`: hues a golden section apart, so neighbours in the list
/// look different.
inline glm::vec3 part_color(std::size_t i) {
  const auto hue = static_cast<float>(std::fmod(0.618034 * static_cast<double>(i), 1.0));
  const glm::vec3 phase = 2 * std::numbers::pi_v<float> * (hue + glm::vec3(0, 1, 2) / 3.0F);
  return 0.6F + 0.4F * glm::cos(phase);
}

/// The sRGB colour by which the picture of part `i` is multiplied.
inline glm::vec3 tint_of(Tint tint, const std::string& texture, const Imported& imported, std::size_t i) {
  if (tint == Tint::materials || tint == Tint::groups) return part_color(i);
  const mesh::Material* material = texture == "material" ? material_of(imported, i) : nullptr;
  return material != nullptr ? material->diffuse : glm::vec3(1);
}

/// The texel at a coordinate, repeating; linear or encoded.
inline glm::vec3 pixel_color(const image::Image8& picture, const glm::vec2& texcoord, bool linear) {
  const glm::vec2 tile = glm::fract(texcoord);
  const int x = std::min(static_cast<int>(tile.x * static_cast<float>(picture.width)), picture.width - 1);
  const int y = std::min(static_cast<int>(tile.y * static_cast<float>(picture.height)), picture.height - 1);
  const image::Encoding encoding = linear ? image::Encoding::srgb : image::Encoding::linear;
  glm::vec3 color;
  for (int c = 0; c < 3; ++c) color[c] = image::from_encoding8(picture.at(x, y, c), encoding);
  return color;
}

}  // namespace texel::obj_texcoords
