// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "params/set.hpp"
#include "procedural/height_fields.hpp"
#include "truth/relief.hpp"

/// The exact normals of the bundled normal maps' reliefs. There are two (truth/relief.hpp), which differ by
/// design wherever the texture is not as long along s as along t.
namespace texel::app {

/// For a parameter `truth`.
enum class ReliefTruth { height_field, baked_map };
inline constexpr params::Item kReliefTruths[] = {
    {"height-field", "The relief as a height on the surface: its slope is taken per length in the world"},
    {"baked-map",
     "The relief's slope per texture width, however long that is: what baking programs agreed on"}};

/// (dh/ds, dh/dt) of a bundled normal map's relief at a texture coordinate; both h and (s, t) in texture
/// widths. Nothing for a file of the user's, of which only the pixels are known.
using HeightGradient = std::function<glm::dvec2(glm::dvec2 texcoord)>;
inline std::optional<HeightGradient> height_gradient(const std::string& normal_map) {
  using procedural::HeightField;
  if (normal_map == "flat") return [](glm::dvec2) { return glm::dvec2(0); };
  for (const auto& [name, field] : {std::pair("brick", HeightField::brick),
                                    {"wood", HeightField::wood},
                                    {"scales", HeightField::scales},
                                    {"bump", HeightField::bump}})
    if (name == normal_map)
      return [field = field](glm::dvec2 texcoord) {
        const procedural::Dual height = procedural::height(field, texcoord.s, texcoord.t);
        return glm::dvec2(height.du, height.dv);
      };
  return std::nullopt;
}

/// The relief's unit normal at a point of a surface. `slope`: as above, times the bump strength. As a height
/// field the relief is as high as if a texture width were `width` world units long.
inline glm::dvec3 relief_normal(ReliefTruth truth, const truth::SurfacePoint& point, glm::dvec2 slope,
                                double width) {
  if (truth == ReliefTruth::height_field) return truth::relief_normal(point, width * slope);
  return truth::mapped_normal(truth::orthonormal_frame(point), {-slope.s, -slope.t, 1});
}

}  // namespace texel::app
