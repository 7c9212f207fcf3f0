// SPDX-License-Identifier: MIT
// The right answer of lab 1: a pixel should show the mean of the picture over the pixel's area. The
// picture is taken as the function that the file was made from, without texels, and many rays through each
// pixel look it up, in double precision and linear light. See teach/truth/include/truth/texture.hpp.
#include <algorithm>

#include "01_texture_quad/parameters.hpp"
#include "answers/answer.hpp"
#include "answers/camera.hpp"
#include "answers/color.hpp"
#include "truth/texture.hpp"

namespace texel::texture_quad {
namespace {

/// A coordinate as the wrap mode takes it back to 0..1.
double wrapped(double s, Wrap wrap) {
  if (wrap == Wrap::clamp) return std::clamp(s, 1e-9, 1 - 1e-9);  // at 1 itself the next tile begins
  const double tile = std::floor(s), within = s - tile;
  return wrap == Wrap::mirrored && std::fmod(tile, 2) != 0 ? 1 - within : within;
}

struct Answer final : answers::Answer<TextureQuadParameters> {
  [[nodiscard]] std::vector<std::string_view> methods() const override {
    return {"method", "minify", "magnify", "linear_light"};
  }
  [[nodiscard]] app::Measure measure(const TextureQuadParameters& /*parameters*/) const override {
    return {app::View::color, app::Unit::steps, "the mean of the picture's function over the pixel"};
  }
  /// Colours in 8-bit levels, as in the view `color` with one sample in each pixel. Empty for other pictures.
  [[nodiscard]] answers::Truth truth(const TextureQuadParameters& p, glm::ivec2 size) const override {
    const auto texture = answers::texture_of(p.texture);
    if (!texture) return {};
    const auto look_up = [texture, wrap = p.wrap, flip_v = p.flip_v](glm::dvec2 texcoord) {
      const double s = wrapped(texcoord.s, wrap), t = wrapped(texcoord.t, wrap);
      return procedural::color(*texture, s, flip_v ? 1 - t : t);
    };
    const truth::QuadPicture picture{
        .camera = answers::camera_of(p.camera, size),
        .world_from_object = truth::tilted(p.tilt),
        .texcoord_map = {.linear = glm::dmat2(p.texture_scale), .offset = glm::dvec2(p.texture_offset)},
        .texture = look_up};
    if (p.wrap == Wrap::clamp) return answers::mean_in_steps(picture, nullptr);
    const double period = p.wrap == Wrap::mirrored ? 2 : 1;
    return answers::mean_in_steps(picture, std::make_shared<truth::RepeatedTexture>(look_up, period));
  }
};

const bool known = answers::know<TextureQuadParameters, Answer>();

}  // namespace
}  // namespace texel::texture_quad
