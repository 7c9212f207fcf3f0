// SPDX-License-Identifier: MIT
#pragma once
//@teacher begin
// The right answer of lab 8: where the light that a pixel shows comes from. In double precision, a ray goes
// from the eye through the middle of the pixel, meets the ball itself and not its triangles (a quadratic
// equation), and is reflected, or refracted by Snell's law, at the ball's exact normal. See
// common/truth/include/truth/optics.hpp.
#include "app/truth_scene.hpp"
#include "parameters.hpp"
#include "truth/optics.hpp"

namespace texel {

/// Unit vectors in the world, as the view `direction` has them: the refracted rays of surface "refraction",
/// where there is one, and else the reflected ones.
inline app::Truth reflection_truth(const ReflectionParameters& p, glm::ivec2 size) {
  const truth::Camera camera = app::truth_camera(p.camera, size);
  const truth::Placement ball{.linear = app::about_y(p.turn) * app::about_x(p.tilt) *
                                        glm::dmat3(1, 0, 0, 0, p.stretch, 0, 0, 0, 1)};
  return [=](glm::dvec2 window) -> std::optional<glm::dvec3> {
    const auto seen = truth::mirror_point(truth::pixel_ray(camera, window), ball);
    if (!seen) return std::nullopt;
    if (p.surface != Surface::refraction) return seen->reflected;
    const bool leaves = glm::dot(seen->incident, seen->surface.normal) > 0;  // the eye is inside
    const double index = p.index, here = leaves ? index : 1, beyond = leaves ? 1 : index;
    return truth::refracted(seen->incident, seen->surface.normal, here, beyond).value_or(seen->reflected);
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
// inline app::Truth reflection_truth(const ReflectionParameters&, glm::ivec2) { return {}; }
//
// }  // namespace texel
//@end
