// SPDX-License-Identifier: MIT
// The right answer of lab 7: the direction in which each pixel of the background looks. In double precision,
// from the field of view and the camera's angles alone: there is no matrix in it to be inverted, and near and
// far do not matter. See teach/truth/include/truth/ray.hpp.
#include "07_environment/parameters.hpp"
#include "07_environment/scene.hpp"
#include "answers/answer.hpp"
#include "answers/camera.hpp"
#include "truth/ray.hpp"

namespace texel::environment {
namespace {

struct Answer final : answers::Answer<EnvironmentParameters> {
  [[nodiscard]] std::vector<std::string_view> methods() const override {
    return {"method", "plane", "precision", "depth_method", "near", "far"};
  }
  [[nodiscard]] app::Measure measure(const EnvironmentParameters& /*parameters*/) const override {
    return {app::View::direction, app::Unit::degrees, "the ray of the pixel, beside the spheres"};
  }
  /// Unit vectors in the world, as the view `direction` has them. Where a sphere stands there is no answer:
  /// one sees its triangles' normals, which are tested in labs 6 and 8.
  [[nodiscard]] answers::Truth truth(const EnvironmentParameters& p, glm::ivec2 size) const override {
    const truth::Camera camera = answers::camera_of(p.camera, size);
    return [=](glm::dvec2 window) -> std::optional<glm::dvec3> {
      const truth::Ray ray = truth::ray_through(camera, window);
      // The triangles lie inside of the true sphere, so whatever passes the sphere passes them too.
      for (const glm::dvec4 sphere : kSpheres)
        if (truth::hit_sphere({ray.origin - glm::dvec3(sphere), ray.direction}, sphere.w))
          return std::nullopt;
      return ray.direction;
    };
  }
};

const bool known = answers::know<EnvironmentParameters, Answer>();

}  // namespace
}  // namespace texel::environment
