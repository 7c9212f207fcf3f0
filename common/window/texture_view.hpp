// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/canvas.hpp"
#include "footprint.hpp"

namespace texel::window {

/// A texture that the lab reads, and what the clicked pixel covers of it.
struct TextureView {
  std::string name;    ///< of the sampler: "color_map"
  std::string format;  ///< "SRGB8"
  glm::ivec2 size{0};  ///< of level 0, in texels
  int levels = 1;
  bool is_cube = false;
  bool is_mipmapped = false;  ///< its filter reads other levels than 0
  Footprint footprint;
  double level = 0;                   ///< of detail, for the footprint
  int first_read = 0, last_read = 0;  ///< the levels between which the filter mixes
  unsigned wrap_s = 0, wrap_t = 0;

  // Pictures: row 0 is at t = 0, the bottom of a 2D texture and the top of a face.
  std::vector<gl::Texture> whole;  ///< the texture, or the six faces: a small level
  gl::Texture read;                ///< the level `first_read`, of the footprint's face; wrapped as the lab's
  std::vector<gl::Texture> chain;  ///< each level, the larger ones as one of their smaller levels

  [[nodiscard]] glm::ivec2 size_of(int of_level) const;
};

/// The textures that the lab reads for its colours, with the footprint of a pixel, counted from the bottom
/// left, of a picture of `size` pixels: 2D textures by the view `texcoord`, cube maps by the view
/// `direction`. None where the lab has no such view, or the pixel shows the background, or several textures
/// are read by one sampler, one after the other. Throws Error as Canvas::draw.
std::vector<TextureView> textures_at(app::Canvas& canvas, app::AnyLab& lab, glm::ivec2 size,
                                     glm::ivec2 pixel);

}  // namespace texel::window
