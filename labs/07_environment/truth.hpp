// SPDX-License-Identifier: MIT
#pragma once
//@teacher begin
// The right answer of lab 7: the direction in which each pixel of the background looks. In double precision,
// from the field of view and the camera's angles alone: there is no matrix in it to be inverted, and near and
// far do not matter. See common/truth/include/truth/environment.hpp.
#include <algorithm>

#include "app/truth_scene.hpp"
#include "parameters.hpp"
#include "scene.hpp"
#include "truth/environment.hpp"

namespace texel {

/// Unit vectors in the world, as the view `direction` has them. Where a sphere stands there is no answer:
/// one sees its triangles' normals, which are tested in labs 6 and 8.
inline app::Truth environment_truth(const EnvironmentParameters& p, glm::ivec2 size) {
  const truth::Camera camera = app::truth_camera(p.camera, size);
  return [=](glm::dvec2 window) -> std::optional<glm::dvec3> {
    const truth::Ray ray = truth::pixel_ray(camera, window).ray;
    // The triangles lie inside of the true sphere, so whatever passes the sphere passes them too.
    const bool hidden = std::any_of(std::begin(kSpheres), std::end(kSpheres), [&](const glm::dvec4& sphere) {
      return truth::hit_sphere({ray.origin - glm::dvec3(sphere), ray.direction}, sphere.w).has_value();
    });
    if (hidden) return std::nullopt;
    return truth::background_direction(camera, window);
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
// inline app::Truth environment_truth(const EnvironmentParameters&, glm::ivec2) { return {}; }
//
// }  // namespace texel
//@end
