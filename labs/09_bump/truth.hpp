// SPDX-License-Identifier: MIT
#pragma once
//@teacher begin
// The right answer of lab 9: the direction that the bumpy mirror shows. In double precision, a ray meets the
// exact sphere, the relief's slope comes from the formula that the normal map was made from, by its exact
// derivatives, and the ray is reflected at the normal that follows. See common/truth/include/truth/relief.hpp
// for the two normals: as a height field (Blinn's, and Mikkelsen's surface gradient) or as a map read in the
// frame of u and v.
#include <glm/gtc/constants.hpp>

#include "app/relief_truth.hpp"
#include "app/truth_scene.hpp"
#include "parameters.hpp"
#include "truth/optics.hpp"

namespace texel {

/// Unit vectors in the world, as the view `direction` has them. Empty for a normal map from a file: its
/// formula is not known.
inline app::Truth bump_truth(const BumpParameters& p, glm::ivec2 size) {
  const auto gradient = app::height_gradient(p.normal_mapping ? p.normal_map : "flat");
  if (!gradient) return {};
  const truth::Camera camera = app::truth_camera(p.camera, size);
  const truth::Placement ball{.linear = app::about_x(p.tilt) * app::about_y(p.turn)};
  // The worksheet's coordinates run against those of truth::sphere, u = -s and v = 1 - t, `repeats` times
  // over.
  const double repeats = p.repeats;
  const truth::TexcoordMap worksheet{.linear = glm::dmat2(-repeats), .offset = {0, repeats}};
  const truth::Surface surface = truth::placed(truth::reparameterised(truth::sphere(), worksheet), ball);
  // The relief is as high as a map must be that fits the half meridian `repeats` times: no stretch along v.
  const app::Relief relief{p.truth, *gradient, p.bump_strength, glm::pi<double>() / repeats};

  return [=](glm::dvec2 window) -> std::optional<glm::dvec3> {
    const truth::PixelRay pixel = truth::pixel_ray(camera, window);
    const auto hit = truth::hit_sphere(truth::object_ray(pixel.ray, ball));
    if (!hit) return std::nullopt;
    const glm::dvec2 texcoord = worksheet.texcoord(hit->texcoord);
    const auto normal = relief.mean_normal(pixel, surface(texcoord), texcoord);
    if (!normal) return std::nullopt;
    return truth::reflected(pixel.ray.direction, *normal);
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
// inline app::Truth bump_truth(const BumpParameters&, glm::ivec2) { return {}; }
//
// }  // namespace texel
//@end
