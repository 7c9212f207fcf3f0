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
  std::function<truth::Surface(procedural::Face)> surface;  ///< only a cube's depends on the face

  [[nodiscard]] truth::SurfacePoint at(const truth::Hit& where) const {
    return surface(where.face)(where.texcoord);
  }
};

inline Shape cube_shape(double half_size) {
  return {[=](const truth::Ray& ray) { return truth::hit_cube(ray, half_size); },
          [=](procedural::Face face) { return truth::cube_face(face, half_size); }};
}
inline Shape quad_shape(double half_size) {
  return {[=](const truth::Ray& ray) { return truth::hit_quad(ray, half_size); },
          [=](procedural::Face) { return truth::quad(half_size); }};
}
inline Shape sphere_shape() {
  return {[](const truth::Ray& ray) { return truth::hit_sphere(ray); },
          [](procedural::Face) { return truth::sphere(); }};
}
inline Shape torus_shape(double major, double minor) {
  return {[=](const truth::Ray& ray) { return truth::hit_torus(ray, major, minor); },
          [=](procedural::Face) { return truth::torus(major, minor); }};
}

/// One of kModels (app/models.hpp) in the size that load_model gives it. Nothing for ship, gator and files of
/// the user's: their formulas are not known.
inline std::optional<Shape> model_shape(const std::string& model) {
  if (model == "cube") return cube_shape(0.577);
  if (model == "quad") return quad_shape(0.7);
  if (model == "sphere") return sphere_shape();
  if (model == "torus") return torus_shape(0.7, 0.3);
  return std::nullopt;
}

}  // namespace texel::answers
