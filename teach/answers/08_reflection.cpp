// SPDX-License-Identifier: MIT
// The right answer of lab 8: where the light that a pixel shows comes from. In double precision, a ray goes
// from the eye through the middle of the pixel, meets the ball itself and not its triangles (a quadratic
// equation), and is reflected, or refracted by Snell's law, at the ball's exact normal. Its colour is that of
// the function that the cube map was made from, mean over the pixel. See
// teach/truth/include/truth/optics.hpp.
#include "08_reflection/parameters.hpp"
#include "answers/answer.hpp"
#include "answers/camera.hpp"
#include "answers/color.hpp"
#include "truth/optics.hpp"
#include "truth/surface.hpp"

namespace texel::reflection {
namespace {

enum class TruthOf { direction, color };
constexpr params::Item kTruths[] = {
    {"direction", "The reflected or refracted ray, in degrees"},
    {"color", "The mean, over the pixel, of what its rays show, in 8-bit levels"}};

/// Where the light that one view ray shows comes from: unit vectors in the world.
struct Seen {
  glm::dvec3 reflected, refracted;
  double reflectance;  ///< 1 where there is no refracted ray
};

/// Nothing beside the ball.
std::optional<Seen> see(const truth::PixelRay& pixel, const truth::Placement& ball, double index) {
  const auto hit = truth::hit_sphere(truth::object_ray(pixel.ray, ball));
  if (!hit) return std::nullopt;
  const glm::dvec3 incident = pixel.ray.direction,
                   normal = truth::placed(truth::sphere(), ball)(hit->texcoord).normal;
  const bool leaves = glm::dot(incident, normal) > 0;  // the eye is inside
  const double here = leaves ? index : 1, beyond = leaves ? 1 : index;
  const glm::dvec3 reflected = truth::reflected(incident, normal);
  return Seen{reflected, truth::refracted(incident, normal, here, beyond).value_or(reflected),
              truth::reflectance(incident, normal, here, beyond)};
}

struct Answer final : answers::ChosenAnswer<ReflectionParameters, TruthOf> {
  Answer() : ChosenAnswer({"truth", TruthOf::direction, kTruths, "What the view error compares with"}) {}
  [[nodiscard]] std::vector<std::string_view> methods() const override {
    return {"method", "normal_method", "evaluate", "normal_matrix", "lookup", "rings", "segments"};
  }
  [[nodiscard]] app::Measure measure(const ReflectionParameters& /*parameters*/) const override {
    if (chosen_ == TruthOf::color)
      return {app::View::color, app::Unit::steps, "the mean of what the exact ball shows over the pixel"};
    return {app::View::direction, app::Unit::degrees, "the ray of the exact ball"};
  }
  /// Unit vectors in the world, as the view `direction` has them: the refracted rays of surface "refraction",
  /// where there is one, and else the reflected ones. Or colours in 8-bit levels, for cube maps with a
  /// formula.
  [[nodiscard]] answers::Truth truth(const ReflectionParameters& p, glm::ivec2 size) const override {
    const truth::Camera camera = answers::camera_of(p.camera, size);
    const truth::Placement ball{.linear = answers::about_y(p.turn) * answers::about_x(p.tilt) *
                                          glm::dmat3(1, 0, 0, 0, p.stretch, 0, 0, 0, 1)};
    const auto see_at = [=](glm::dvec2 window) {
      return see(truth::pixel_ray(camera, window), ball, p.index);
    };
    if (chosen_ == TruthOf::direction)
      return [=](glm::dvec2 window) -> std::optional<glm::dvec3> {
        const auto seen = see_at(window);
        if (!seen) return std::nullopt;
        return p.surface == Surface::refraction ? seen->refracted : seen->reflected;
      };
    const auto environment = answers::cube_map_color(p.cube_map);
    if (!environment) return {};
    return answers::mean_in_steps([=](glm::dvec2 window) {
      const auto seen = see_at(window);
      if (!seen) return glm::dvec4(0);
      const glm::dvec3 reflected = environment(seen->reflected), refracted = environment(seen->refracted);
      if (p.surface == Surface::mirror) return glm::dvec4(reflected, 1);
      if (p.surface == Surface::refraction) return glm::dvec4(refracted, 1);
      return glm::dvec4(glm::mix(refracted, reflected, seen->reflectance), 1);
    });
  }
};

const bool known = answers::know<ReflectionParameters, Answer>();

}  // namespace
}  // namespace texel::reflection
