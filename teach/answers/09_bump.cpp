// SPDX-License-Identifier: MIT
// The right answer of lab 9: the direction that the bumpy mirror shows, or the mean of its colours over a
// pixel. In double precision, a ray meets the exact sphere, the relief's slope comes from the formula that
// the normal map was made from, by its exact derivatives, and the ray is reflected at the normal that
// follows. See teach/truth/include/truth/relief.hpp for the two normals: as a height field (Blinn's, and
// Mikkelsen's surface gradient) or as a map read in the frame of u and v.
#include <glm/gtc/constants.hpp>

#include "09_bump/parameters.hpp"
#include "answers/answer.hpp"
#include "answers/basis.hpp"
#include "answers/camera.hpp"
#include "answers/color.hpp"
#include "answers/relief.hpp"
#include "truth/optics.hpp"

namespace texel::bump {
namespace {

enum class TruthOf { height_field, baked_map, color };
constexpr params::Item kTruths[] = {
    answers::kReliefTruths[0],
    answers::kReliefTruths[1],
    {"color", "The mean, over the pixel, of what the rays of the baked map show, in 8-bit levels"}};

/// The method's basis, at directions all around: the cost of a frame alone is too small to see in the time of
/// a picture, so the benchmark runs the same function on the CPU many times.
app::Preparation bases_around(Method method) {
  constexpr std::size_t kDirections = 100'000;
  std::vector<glm::vec3> directions;
  for (std::size_t i = 0; i < kDirections; ++i) {  // a spiral from pole to pole: even on the sphere
    const double y = 1 - (2 * static_cast<double>(i) + 1) / kDirections,
                 angle = 2.399963 * static_cast<double>(i);
    const double radius = std::sqrt(1 - y * y);
    directions.emplace_back(radius * std::sin(angle), y, radius * std::cos(angle));
  }
  // Blinn's way differs in what it does with the map's normal; its frame is that of u and v.
  const std::string name =
      kMethods[static_cast<std::size_t>(method == Method::blinn ? Method::uv_aligned : method)].name;
  return {"basis", kDirections, [directions = std::move(directions), name] {
            answers::for_each_basis([&](const char* basis, auto frame) {
              if (basis != name) return;
              glm::mat3 sum(0);
              for (const glm::vec3& n : directions) sum += frame(n);
              volatile float kept = sum[0].x + sum[1].y;  // or the loop would be left out
              static_cast<void>(kept);
            });
          }};
}

struct Answer final : answers::ChosenAnswer<BumpParameters, TruthOf> {
  Answer() : ChosenAnswer({"truth", TruthOf::baked_map, kTruths, "What the view error compares with"}) {}
  [[nodiscard]] std::vector<std::string_view> methods() const override {
    return {"method", "mip_filter", "incident", "rings", "segments"};
  }
  [[nodiscard]] app::Measure measure(const BumpParameters& /*parameters*/) const override {
    if (chosen_ == TruthOf::color)
      return {app::View::color, app::Unit::steps, "the mean of what the exact relief shows over the pixel"};
    return {app::View::direction, app::Unit::degrees, answers::name_of(relief())};
  }
  /// Unit vectors in the world, as the view `direction` has them; or colours in 8-bit levels. Empty for a
  /// normal map or, for colours, a cube map whose formula is not known.
  [[nodiscard]] answers::Truth truth(const BumpParameters& p, glm::ivec2 size) const override {
    const auto gradient = answers::height_gradient(p.normal_mapping ? p.normal_map : "flat");
    if (!gradient) return {};
    const truth::Camera camera = answers::camera_of(p.camera, size);
    const truth::Placement ball{.linear = answers::about_x(p.tilt) * answers::about_y(p.turn)};
    // The worksheet's coordinates run against those of truth::sphere, u = -s and v = 1 - t, `repeats` times
    // over.
    const double repeats = p.repeats;
    const truth::TexcoordMap worksheet{.linear = glm::dmat2(-repeats), .offset = {0, repeats}};
    const truth::Surface surface = truth::placed(truth::reparameterized(truth::sphere(), worksheet), ball);
    // The relief is as high as a map must be that fits the half meridian `repeats` times: no stretch along v.
    const answers::Relief relief{this->relief(), *gradient, p.bump_strength, glm::pi<double>() / repeats};

    const auto see = [=](glm::dvec2 window, bool mean) -> std::optional<glm::dvec3> {
      const truth::PixelRay pixel = truth::pixel_ray(camera, window);
      const auto hit = truth::hit_sphere(truth::object_ray(pixel.ray, ball));
      if (!hit) return std::nullopt;
      const glm::dvec2 texcoord = worksheet.texcoord(hit->texcoord);
      const auto normal = mean ? relief.mean_normal(pixel, surface(texcoord), texcoord)
                               : relief.normal(surface(texcoord), texcoord);
      if (!normal) return std::nullopt;
      return truth::reflected(pixel.ray.direction, *normal);
    };
    if (chosen_ != TruthOf::color) return [=](glm::dvec2 window) { return see(window, true); };
    const auto environment = answers::cube_map_color(p.cube_map);
    if (!environment) return {};
    return answers::mean_in_steps([=](glm::dvec2 window) {
      const auto seen = see(window, false);
      return seen ? glm::dvec4(environment(*seen), 1) : glm::dvec4(0);
    });
  }
  [[nodiscard]] std::optional<app::Preparation> preparation(const BumpParameters& p,
                                                            const app::Assets& /*assets*/) const override {
    return bases_around(p.method);
  }

 private:
  [[nodiscard]] answers::ReliefTruth relief() const {
    return chosen_ == TruthOf::height_field ? answers::ReliefTruth::height_field
                                            : answers::ReliefTruth::baked_map;
  }
};

const bool known = answers::know<BumpParameters, Answer>();

}  // namespace
}  // namespace texel::bump
