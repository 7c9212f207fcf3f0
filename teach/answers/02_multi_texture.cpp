// SPDX-License-Identifier: MIT
// The right answer of lab 2: a pixel should show the mean, over the pixel's area, of the two pictures' light
// combined. The pictures are taken as the functions that the files were made from, without texels, and many
// rays through each pixel look them up, in double precision. No method does that: each filters the two
// pictures apart and combines the means, and the mean of a product is not the product of the means.
#include "02_multi_texture/parameters.hpp"
#include "answers/answer.hpp"
#include "answers/camera.hpp"
#include "answers/color.hpp"
#include "truth/texture.hpp"

namespace texel::multi_texture {
namespace {

/// A picture as a function: linear light and straight alpha. Nothing for other files.
std::optional<truth::TextureFunction> picture_function(const std::string& name) {
  const auto texture = answers::texture_of(name);
  if (!texture) return std::nullopt;
  return [texture = *texture](glm::dvec2 texcoord) {
    const glm::dvec4 color = procedural::color(texture, texcoord.s, texcoord.t);
    return color.a > 0 ? color : glm::dvec4(0);  // the decal's file is black where it is not seen
  };
}

/// Light of the first picture, already multiplied by the colour, and of the second as the README has it.
glm::dvec3 combined(const MultiTextureParameters& p, glm::dvec3 first, glm::dvec4 second) {
  const glm::dvec3 light(second);
  switch (p.combine) {
    case Combine::multiply:
      return first * light;
    case Combine::mix:
      return (1.0 - p.mix_factor) * first + double{p.mix_factor} * light;
    case Combine::add:
      return first + light;
    case Combine::decal:
      break;
  }
  return (1.0 - second.a) * first + second.a * light;
}

struct Answer final : answers::Answer<MultiTextureParameters> {
  [[nodiscard]] std::vector<std::string_view> methods() const override {
    return {"method", "minify", "magnify", "mipmaps", "second_unit"};
  }
  [[nodiscard]] app::Measure measure(const MultiTextureParameters& /*parameters*/) const override {
    return {app::View::color, app::Unit::steps, "the mean of the combined light over the pixel"};
  }
  /// Colours in 8-bit levels, as in the view `color` with one sample in each pixel. `method`, filters and
  /// mipmaps do not matter.
  [[nodiscard]] answers::Truth truth(const MultiTextureParameters& p, glm::ivec2 size) const override {
    const truth::TextureFunction white = [](glm::dvec2) { return glm::dvec4(1); };
    const auto first = p.unit0_on ? picture_function(p.texture0) : white;
    const auto second = p.unit1_on ? picture_function(p.texture1) : white;
    if (!first || !second) return {};
    const auto look_up = [p, first = *first, second = *second](glm::dvec2 texcoord) {
      const glm::dvec3 color = glm::dvec3(p.red, p.green, p.blue) * glm::dvec3(first(texcoord));
      return glm::dvec4(p.unit1_on ? combined(p, color, second(texcoord)) : color, 1);
    };
    const truth::QuadPicture picture{.camera = answers::camera_of(p.camera, size),
                                     .world_from_object = truth::tilted(p.tilt),
                                     .texcoord_map = {.linear = glm::dmat2(p.texture_scale)},
                                     .texture = look_up};
    return answers::mean_in_steps(picture, std::make_shared<truth::RepeatedTexture>(look_up));
  }
};

const bool known = answers::know<MultiTextureParameters, Answer>();

}  // namespace
}  // namespace texel::multi_texture
