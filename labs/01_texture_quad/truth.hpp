// SPDX-License-Identifier: MIT
#pragma once
//@teacher begin
// The right answer of lab 1: a pixel should show the mean of the picture over the pixel's area. The
// picture is taken as the function that the file was made from, without texels, and many rays through each
// pixel look it up, in double precision and linear light. See common/truth/include/truth/texture.hpp.
#include <algorithm>

#include "app/colour_truth.hpp"
#include "app/truth_scene.hpp"
#include "parameters.hpp"
#include "truth/texture.hpp"

namespace texel {

/// A coordinate as the wrap mode takes it back to 0..1.
inline double wrapped(double s, Wrap wrap) {
  if (wrap == Wrap::clamp) return std::clamp(s, 1e-9, 1 - 1e-9);  // at 1 itself the next tile begins
  const double tile = std::floor(s), within = s - tile;
  return wrap == Wrap::mirrored && std::fmod(tile, 2) != 0 ? 1 - within : within;
}

/// Colours in 8-bit levels, as in the view `color` with one sample in each pixel. Empty for other
/// pictures.
inline app::Truth texture_quad_truth(const TextureQuadParameters& p, glm::ivec2 size) {
  const auto texture = app::texture_of(p.texture);
  if (!texture) return {};
  const auto look_up = [texture, wrap = p.wrap, flip_v = p.flip_v](glm::dvec2 texcoord) {
    const double s = wrapped(texcoord.s, wrap), t = wrapped(texcoord.t, wrap);
    return procedural::colour(*texture, s, flip_v ? 1 - t : t);
  };
  const truth::QuadPicture picture{
      .camera = app::truth_camera(p.camera, size),
      .world_from_object = truth::tilted(p.tilt),
      .texcoord_map = {.linear = glm::dmat2(p.texture_scale), .offset = glm::dvec2(p.texture_offset)},
      .texture = look_up};
  return app::mean_in_steps([picture](glm::dvec2 window) { return picture.at(window); });
}

}  // namespace texel
//@starter
// // A student's tree does not contain the right answer.
// #include "app/measure.hpp"
// #include "parameters.hpp"
//
// namespace texel {
//
// inline app::Truth texture_quad_truth(const TextureQuadParameters&, glm::ivec2) { return {}; }
//
// }  // namespace texel
//@end
