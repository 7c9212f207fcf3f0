// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "app/canvas.hpp"

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

/// From texture coordinates in the 3x3 pixels around a pixel, alpha 0 where there are none; of a cube map
/// from directions, on the face that the middle one meets. Of the two neighbours in each direction the nearer
/// one counts: the other may lie beyond a seam or show another part of the model. Neighbours on other faces
/// do not count. Nothing where the pixel has no coordinate.
std::optional<Footprint> footprint_of(const image::ImageF& around, bool is_cube);

/// Where a wrap mode of OpenGL takes a coordinate: 0 to 1.
double wrapped(double coordinate, unsigned mode);

/// A texture that the lab reads, and what the clicked pixel covers of it.
struct TextureView : gl::Record::TextureUse {
  explicit TextureView(gl::Record::TextureUse use) : TextureUse(std::move(use)) {}

  bool is_mipmapped = false;  ///< its filter reads other levels than 0
  Footprint footprint;
  double level_of_detail = 0;         ///< for the footprint
  int first_read = 0, last_read = 0;  ///< the levels between which the filter mixes
  unsigned wrap_s = 0, wrap_t = 0;

  // Pictures: row 0 is at t = 0, the bottom of a 2D texture and the top of a face.
  std::vector<gl::Texture> whole;  ///< the texture, or the six faces: a small level
  gl::Texture read;                ///< the level `first_read`, of the footprint's face; wrapped as the lab's
  std::vector<gl::Texture> chain;  ///< each level, the larger ones as one of their smaller levels

  /// In texels.
  [[nodiscard]] glm::ivec2 size_of(int level) const;
};

/// The textures that the lab reads for its colours, with the footprint of a pixel, counted from the bottom
/// left, of a picture of `size` pixels: 2D textures by the view `texcoord`, cube maps by the view
/// `direction`. None where the lab has no such view, or the pixel shows the background, or several textures
/// are read by one sampler, one after the other. Throws Error as Canvas::draw.
std::vector<TextureView> textures_at(app::Canvas& canvas, app::AnyLab& lab, glm::ivec2 size,
                                     glm::ivec2 pixel);

}  // namespace texel::window
