// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include "params/set.hpp"

#include "answers/camera.hpp"
#include "procedural/height_fields.hpp"
#include "truth/ray.hpp"
#include "truth/relief.hpp"

/// The exact normals of the bundled normal maps' reliefs. There are two (truth/relief.hpp), which differ by
/// design wherever the texture is not as long along s as along t.
namespace texel::answers {

/// For a parameter `truth`.
enum class ReliefTruth { height_field, baked_map };
inline constexpr params::Item kReliefTruths[] = {
    {"height-field", "The relief is a height on the surface: its slope is per length in the world"},
    {"baked-map",
     "The relief's slope is per texture width, of any length: the convention of baking programs"}};

/// What the error is counted from, in a few words.
inline const char* name_of(ReliefTruth truth) {
  return truth == ReliefTruth::height_field ? "the exact relief as a height field"
                                            : "the exact relief as a baked map";
}

/// (dh/ds, dh/dt) of a bundled normal map's relief at a texture coordinate; both h and (s, t) in texture
/// widths. Nothing for other files: only their pixels are known.
using HeightGradient = std::function<glm::dvec2(glm::dvec2 texcoord)>;
inline std::optional<HeightGradient> height_gradient(const std::string& normal_map) {
  if (normal_map == "flat") return [](glm::dvec2) { return glm::dvec2(0); };
  for (const auto& [name, relief] : procedural::height_fields)
    if (name == normal_map)
      return [field = relief](glm::dvec2 texcoord) {
        const procedural::Dual height = procedural::height(field, texcoord.s, texcoord.t);
        return glm::dvec2(height.du, height.dv);
      };
  return std::nullopt;
}

/// A relief over a surface.
struct Relief {
  static constexpr std::uint32_t kSamples = 8;
  ReliefTruth truth;
  HeightGradient gradient;
  double strength;  ///< multiplies its slopes
  double width;     ///< for a height field: world units in a texture width

  /// Its unit normal at a point of the surface whose slope there is that of the relief at `texcoord`.
  [[nodiscard]] glm::dvec3 normal(const truth::SurfacePoint& point, glm::dvec2 texcoord) const {
    const glm::dvec2 slope = strength * gradient(texcoord);
    if (truth == ReliefTruth::height_field) return truth::relief_normal(point, width * slope);
    return truth::mapped_normal(truth::orthonormal_frame(point), {-slope.s, -slope.t, 1});
  }

  /// The mean of the normals that a pixel covers, at unit length: a texture filter gives no more than that.
  /// The pixel sees the parallelogram around `texcoord` that the derivatives at the middle span; `point` is
  /// what the ray meets there. Nothing where the parallelogram is infinite, as at a sphere's poles.
  [[nodiscard]] std::optional<glm::dvec3> mean_normal(const truth::PixelRay& pixel,
                                                      const truth::SurfacePoint& point,
                                                      glm::dvec2 texcoord) const {
    constexpr double most = 1e3;  // texture widths
    const truth::TexcoordGradient step = truth::texcoord_gradient(pixel, point);
    if (!(glm::length(step.dx) + glm::length(step.dy) < most)) return std::nullopt;
    glm::dvec3 sum(0);
    for (std::uint32_t i = 0; i < kSamples; ++i) {
      const glm::dvec2 place = place_in_pixel(i, kSamples);
      sum += normal(point, texcoord + place.x * step.dx + place.y * step.dy);
    }
    return glm::normalize(sum);
  }
};

}  // namespace texel::answers
