// SPDX-License-Identifier: MIT
// The right answer of lab 4. In double precision, a ray meets the exact surface. On a cube's face lies a copy
// of the picture of its own, upright seen from outside, and the light falls on the face and not on a ball;
// sphere, torus and quad have the coordinates and normals of their formulas.
#include "04_cube_wrap/parameters.hpp"
#include "answers/answer.hpp"
#include "answers/camera.hpp"
#include "answers/shape.hpp"

namespace texel::cube_wrap {
namespace {

enum class Quantity { texcoord, normal };
constexpr params::Item kQuantities[] = {
    {"texcoord", "The texture coordinate, in texels; right means a copy of the picture on each face"},
    {"normal", "The normal, in degrees from the face's normal"}};

struct Answer final : answers::ChosenAnswer<CubeWrapParameters, Quantity> {
  Answer()
      : ChosenAnswer({"truth", Quantity::texcoord, kQuantities,
                      "What the view error compares with the exact answer"}) {}
  [[nodiscard]] std::vector<std::string_view> methods() const override { return {"method", "normals"}; }
  /// Texels or degrees, as the parameter `truth` says.
  [[nodiscard]] app::Measure measure(const CubeWrapParameters& p) const override {
    constexpr double texels = 512;  // in the width and height of each bundled picture
    const bool closes = p.model == "sphere" || p.model == "torus";
    if (chosen_ == Quantity::texcoord)
      return {app::View::texcoord, app::Unit::texels, "a copy of the picture on each face", texels, closes};
    return {app::View::normal, app::Unit::degrees, "the normal of the exact surface"};
  }
  /// What the measure's view should show. Empty for models from files: their formulas are not known.
  [[nodiscard]] answers::Truth truth(const CubeWrapParameters& p, glm::ivec2 size) const override {
    const Quantity quantity = chosen_;
    const auto shape = answers::model_shape(p.model);
    if (!shape) return {};
    const truth::Camera camera = answers::camera_of(p.camera, size);
    const truth::Placement place{.linear = answers::about_y(p.turn)};
    return [=, repeats = p.texture_scale](glm::dvec2 window) -> std::optional<glm::dvec3> {
      const auto hit = shape->hit(truth::object_ray(truth::ray_through(camera, window), place));
      if (!hit) return std::nullopt;
      if (quantity == Quantity::normal) return place.linear * shape->at(*hit).normal;
      return glm::dvec3(double{repeats} * hit->texcoord, 0);
    };
  }
};

const bool known = answers::know<CubeWrapParameters, Answer>();

}  // namespace
}  // namespace texel::cube_wrap
