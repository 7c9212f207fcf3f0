// SPDX-License-Identifier: MIT
// The right answer of lab 6: what a pixel should show is the mean, over the pixel's area, of what the sphere
// wears. That is taken as the function that the files were made from, without texels: of the direction for a
// cube map, of the worksheet's two angles for one picture. Many rays through each pixel meet the exact
// sphere, in double precision and linear light. See common/truth/include/truth/cube_map.hpp.
#pragma once
#include "app/colour_truth.hpp"
#include "app/truth_scene.hpp"
#include "parameters.hpp"
#include "procedural/textures.hpp"
#include "truth/cube_map.hpp"

namespace texel {

/// The colour that the sphere has in a direction of its own space, linear light. Nothing for the landscape
/// and for files of the user's: their formulas are not known.
using SphereColour = std::function<glm::dvec3(glm::dvec3 direction)>;
inline std::optional<SphereColour> sphere_colour(const CubeMapParameters& p) {
  if (p.mapping == Mapping::cube) {
    if (p.cube_map == "labelled") return procedural::labelled_colour;
    if (p.cube_map == "smooth") return procedural::smooth_colour;
    return std::nullopt;
  }
  for (const procedural::Texture texture : procedural::textures)
    if (procedural::name(texture) == p.picture)
      return [texture](glm::dvec3 direction) {
        const glm::dvec2 texcoord = truth::worksheet_texcoord(direction);
        return glm::dvec3(procedural::colour(texture, texcoord.s, texcoord.t));
      };
  return std::nullopt;
}

/// Colours in 8-bit steps, as the view `color` has them with one sample in each pixel.
inline app::Truth cube_map_truth(const CubeMapParameters& p, glm::ivec2 size) {
  const auto wears = sphere_colour(p);
  if (!wears) return {};
  const truth::Camera camera = app::truth_camera(p.camera, size);
  const truth::Placement place{.linear = app::about_x(p.tilt) * app::about_y(p.turn)};
  return app::mean_in_steps([=](glm::dvec2 window) {
    const truth::Ray ray = truth::object_ray(truth::pixel_ray(camera, window).ray, place);
    const auto hit = truth::hit_sphere(ray);
    return hit ? glm::dvec4((*wears)(ray.origin + hit->distance * ray.direction), 1) : glm::dvec4(0);
  });
}

}  // namespace texel
