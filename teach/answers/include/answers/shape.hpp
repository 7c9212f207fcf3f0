// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "truth/ray.hpp"

/// The models that have a formula: what their meshes stand for.
namespace texel::answers {

/// A surface in object space, and where a ray meets it.
struct Shape {
  std::function<std::optional<truth::Hit>(const truth::Ray&)> hit;
  std::function<truth::Surface(image::Face)> surface;  ///< only a cube's depends on the face

  [[nodiscard]] truth::SurfacePoint at(const truth::Hit& where) const {
    return surface(where.face)(where.texcoord);
  }
};

/// One of kModels (app/models.hpp), in the size that load_model gives it unless half the side of cube or quad
/// is another. Nothing for ship, gator and files of the user's: their formulas are not known.
inline std::optional<Shape> model_shape(const std::string& model, double half_cube = 0.577,
                                        double half_quad = 0.7) {
  using image::Face;
  using truth::Ray;
  if (model == "cube")
    return Shape{[=](const Ray& ray) { return truth::hit_cube(ray, half_cube); },
                 [=](Face face) { return truth::cube_face(face, half_cube); }};
  if (model == "quad")
    return Shape{[=](const Ray& ray) { return truth::hit_quad(ray, half_quad); },
                 [=](Face) { return truth::quad(half_quad); }};
  if (model == "sphere")
    return Shape{[](const Ray& ray) { return truth::hit_sphere(ray); }, [](Face) { return truth::sphere(); }};
  if (model == "torus")
    return Shape{[](const Ray& ray) { return truth::hit_torus(ray, 0.7, 0.3); },
                 [](Face) { return truth::torus(0.7, 0.3); }};
  return std::nullopt;
}

}  // namespace texel::answers
