// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "image/image.hpp"

namespace texel::window {

/// What a pixel covers of a texture: the parallelogram with the corners `place` ± dx/2 ± dy/2.
struct Footprint {
  glm::dvec2 place{0};      ///< (s, t) at the pixel's middle
  glm::dvec2 dx{0}, dy{0};  ///< how far (s, t) moves to the next pixel on the right, and to the one above
  int face = 0;             ///< of a cube map: +X -X +Y -Y +Z -Z
  [[nodiscard]] glm::dvec2 at(double x, double y) const { return place + x * dx + y * dy; }
  /// Its longer and its shorter side in texels of a texture of `size` texels.
  [[nodiscard]] glm::dvec2 sides(glm::dvec2 size) const;
  /// The level of detail: log2 of the longer side. A filter that takes up to `anisotropy` samples along it
  /// needs only the level of a part (EXT_texture_filter_anisotropic). Negative: magnified.
  [[nodiscard]] double level(glm::dvec2 size, double anisotropy) const;
};

/// From texture coordinates in the 3x3 pixels around a pixel, alpha 0 where there are none. Of the two
/// neighbours in each direction the nearer one counts: the other may lie beyond a seam or show another part
/// of the model. Nothing where the pixel has no coordinate.
std::optional<Footprint> footprint_of_texcoords(const image::ImageF& around);

/// The same from directions, on the face of the cube map that the middle one meets; neighbours on other faces
/// do not count.
std::optional<Footprint> footprint_of_directions(const image::ImageF& around);

/// Where a wrap mode of OpenGL takes a coordinate: 0 to 1.
double wrapped(double coordinate, unsigned mode);

}  // namespace texel::window
