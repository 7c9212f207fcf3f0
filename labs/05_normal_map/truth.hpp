// SPDX-License-Identifier: MIT
// The right answer of lab 5: the normal that each pixel should be lit with. In double precision, a ray meets
// the exact surface and not its triangles, the relief's slope comes from the formula that the normal map was
// made from, by its exact derivatives, and bends the surface's normal. See
// common/truth/include/truth/relief.hpp for the two answers: the relief as a height field, or as a map that
// was baked by the common rules. On cube and quad they are the same, until these are stretched.
#pragma once
#include <glm/gtc/constants.hpp>

#include "app/relief_truth.hpp"
#include "app/truth_scene.hpp"
#include "parameters.hpp"

namespace texel {

/// A model that has a formula, in object space.
struct Shape {
  std::function<std::optional<truth::Hit>(const truth::Ray&)> hit;
  std::function<truth::Surface(procedural::Face)> surface;  ///< only the cube's depends on the face
  double width;  ///< for how many units the relief is made: the texture's length along t
};

inline std::optional<Shape> shape_of(const std::string& model) {
  constexpr double kCube = 0.577, kQuad = 0.7, kMajor = 0.7, kMinor = 0.3;  // as app::load_model has them
  if (model == "cube")
    return Shape{[](const truth::Ray& ray) { return truth::hit_cube(ray, kCube); },
                 [](procedural::Face face) { return truth::cube_face(face, kCube); }, 2 * kCube};
  if (model == "quad")
    return Shape{[](const truth::Ray& ray) { return truth::hit_quad(ray, kQuad); },
                 [](procedural::Face) { return truth::quad(kQuad); }, 2 * kQuad};
  if (model == "sphere")
    return Shape{[](const truth::Ray& ray) { return truth::hit_sphere(ray); },
                 [](procedural::Face) { return truth::sphere(); }, glm::pi<double>()};
  if (model == "torus")
    return Shape{[](const truth::Ray& ray) { return truth::hit_torus(ray, kMajor, kMinor); },
                 [](procedural::Face) { return truth::torus(kMajor, kMinor); },
                 glm::two_pi<double>() * kMinor};
  return std::nullopt;
}

/// Unit vectors in the world, as the view `normal` has them. Empty for models and normal maps from files:
/// their formulas are not known.
inline app::Truth normal_map_truth(const NormalMapParameters& p, const std::string& normal_map,
                                   glm::ivec2 size) {
  const auto shape = shape_of(p.model);
  const auto gradient = app::height_gradient(p.normal_mapping ? normal_map : "flat");
  if (!shape || !gradient) return {};
  const truth::Camera camera = app::truth_camera(p.camera, size);
  const truth::Placement place{.linear =
                                   app::about_y(p.turn) * glm::dmat3(1, 0, 0, 0, p.stretch, 0, 0, 0, 1)};
  const double repeats = p.texture_scale;
  const truth::TexcoordMap tiles{.linear = glm::dmat2(repeats)};
  const app::Relief relief{p.truth, *gradient, p.bump_strength, shape->width / repeats};

  return [=](glm::dvec2 window) -> std::optional<glm::dvec3> {
    const truth::PixelRay pixel = truth::pixel_ray(camera, window);
    const auto hit = shape->hit(truth::object_ray(pixel.ray, place));
    if (!hit) return std::nullopt;
    const truth::Surface surface =
        truth::placed(truth::reparameterised(shape->surface(hit->face), tiles), place);
    const glm::dvec2 texcoord = tiles.texcoord(hit->texcoord);
    return relief.mean_normal(pixel, surface(texcoord), texcoord);
  };
}

}  // namespace texel
