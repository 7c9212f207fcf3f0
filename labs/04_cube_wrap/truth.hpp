// SPDX-License-Identifier: MIT
#pragma once
//@teacher begin
// The right answer of lab 4. In double precision, a ray meets the exact surface. On a cube's face lies a copy
// of the picture of its own, upright seen from outside, and the light falls on the face and not on a ball;
// sphere, torus and quad have the coordinates and normals of their formulas.
#include "app/shape_truth.hpp"
#include "app/truth_scene.hpp"
#include "parameters.hpp"

namespace texel {

/// Texels or degrees, as the parameter `truth` says.
inline app::Measure cube_wrap_measure(const CubeWrapParameters& p) {
  constexpr double texels = 512;  // in the width and height of each bundled picture
  const bool closes = p.model == "sphere" || p.model == "torus";
  if (p.truth == Quantity::texcoord)
    return {app::View::texcoord, app::Unit::texels, "a copy of the picture on each face", texels, closes};
  return {app::View::normal, app::Unit::degrees, "the normal of the exact surface"};
}

/// What the measure's view should show. Empty for models from files: their formulas are not known.
inline app::Truth cube_wrap_truth(const CubeWrapParameters& p, glm::ivec2 size) {
  const auto shape = app::model_shape(p.model);
  if (!shape) return {};
  const truth::Camera camera = app::truth_camera(p.camera, size);
  const truth::Placement place{.linear = app::about_y(p.turn)};
  return [=, truth = p.truth, repeats = p.texture_scale](glm::dvec2 window) -> std::optional<glm::dvec3> {
    const auto hit = shape->hit(truth::object_ray(truth::pixel_ray(camera, window).ray, place));
    if (!hit) return std::nullopt;
    if (truth == Quantity::normal) return place.linear * shape->at(*hit).normal;
    return glm::dvec3(double{repeats} * hit->texcoord, 0);
  };
}

}  // namespace texel
//@starter
// // A student's tree does not contain the right answer.
// #include "app/measure.hpp"
// #include "parameters.hpp"
//
// namespace texel {
//
// inline app::Measure cube_wrap_measure(const CubeWrapParameters&) {
//   return {app::View::color, app::Unit::steps, "nothing"};
// }
// inline app::Truth cube_wrap_truth(const CubeWrapParameters&, glm::ivec2) { return {}; }
//
// }  // namespace texel
//@end
