// SPDX-License-Identifier: MIT
// The right answer of lab 8: where the light that a pixel shows comes from. In double precision, a ray goes
// from the eye through the middle of the pixel, meets the ball itself and not its triangles (a quadratic
// equation), and is reflected, or refracted by Snell's law, at the ball's exact normal. See
// teach/truth/include/truth/optics.hpp.
#include "08_reflection/parameters.hpp"
#include "answers/camera.hpp"
#include "app/answer.hpp"
#include "truth/optics.hpp"

namespace texel::reflection {
namespace {

struct Answer final : app::Answer<ReflectionParameters> {
  [[nodiscard]] std::vector<std::string_view> methods() const override {
    return {"method", "normal_method", "evaluate", "normal_matrix", "lookup", "rings", "segments"};
  }
  [[nodiscard]] app::Measure measure(const ReflectionParameters& /*parameters*/) const override {
    return {app::View::direction, app::Unit::degrees, "the ray of the exact ball"};
  }
  /// Unit vectors in the world, as the view `direction` has them: the refracted rays of surface "refraction",
  /// where there is one, and else the reflected ones.
  [[nodiscard]] app::Truth truth(const ReflectionParameters& p, glm::ivec2 size) const override {
    const truth::Camera camera = answers::camera_of(p.camera, size);
    const truth::Placement ball{.linear = answers::about_y(p.turn) * answers::about_x(p.tilt) *
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
};

const bool known = app::know<ReflectionParameters, Answer>();

}  // namespace
}  // namespace texel::reflection
