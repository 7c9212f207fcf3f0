// SPDX-License-Identifier: MIT
// The right answer of lab 6: a pixel should show the mean, over the pixel's area, of the sphere's
// colour. That is taken as the function that the files were made from, without texels: of the direction for a
// cube map, of the worksheet's two angles for one picture. Many rays through each pixel meet the exact
// sphere, in double precision and linear light. And the level of detail should be that of the formula's
// derivative. See teach/truth/include/truth/cube_map.hpp.
#include "06_cube_map/parameters.hpp"
#include "answers/answer.hpp"
#include "answers/camera.hpp"
#include "answers/color.hpp"
#include "truth/cube_map.hpp"
#include "truth/surface.hpp"
#include "truth/texture.hpp"

namespace texel::cube_map {
namespace {

enum class TruthOf { color, level };
constexpr params::Item kTruths[] = {
    {"color", "The mean of the pictures' function over the pixel, in 8-bit levels"},
    {"level",
     "The level of detail by the exact derivative, in levels; not at the rim, where it is infinite"}};

/// The colour that the sphere has in a direction of its own space. Empty where the formula is not known.
answers::ColorOf sphere_color(const CubeMapParameters& p) {
  if (p.mapping == Mapping::cube) return answers::cube_map_color(p.cube_map);
  const auto texture = answers::texture_of(p.picture);
  if (!texture) return {};
  return [texture = *texture](glm::dvec3 direction) {
    const glm::dvec2 texcoord = truth::worksheet_texcoord(direction);
    return glm::dvec3(procedural::color(texture, texcoord.s, texcoord.t));
  };
}

truth::Placement sphere_placement(const CubeMapParameters& p) {
  return {.linear = answers::about_x(p.tilt) * answers::about_y(p.turn)};
}

/// How many texels the bundled picture, or each of the six, is wide. Nothing for the user's own.
std::optional<double> texels_across(const CubeMapParameters& p) {
  const std::string& name = p.mapping == Mapping::cube ? p.cube_map : p.picture;
  for (const params::Item& item : p.mapping == Mapping::cube ? std::span<const params::Item>(app::kCubeMaps)
                                                             : std::span<const params::Item>(app::kTextures))
    if (name == item.name) return name == "labelled" ? 256 : name == "smooth" ? 128 : 512;
  return std::nullopt;
}

/// Levels of detail, as the view `lod` has them. Nothing at the sphere's rim, the outermost hundredth of its
/// pixels: there the footprint is infinite, and the triangles decide.
answers::Truth level_truth(const CubeMapParameters& p, glm::ivec2 size) {
  constexpr double kRim = 0.1;  // cosine between ray and normal
  const auto texels = texels_across(p);
  if (!texels) return {};
  const truth::Camera camera = answers::camera_of(p.camera, size);
  const truth::Placement place = sphere_placement(p);
  return [=](glm::dvec2 window) -> std::optional<glm::dvec3> {
    const truth::PixelRay pixel = truth::pixel_ray(camera, window);
    const auto hit = truth::hit_sphere(truth::object_ray(pixel.ray, place));
    if (!hit) return std::nullopt;
    const truth::SurfacePoint point = truth::placed(truth::sphere(), place)(hit->texcoord);
    if (-glm::dot(pixel.ray.direction, point.normal) < kRim) return std::nullopt;
    const truth::PositionGradient step = truth::position_gradient(pixel, point);
    const glm::dmat3 object_from_world = glm::transpose(place.linear);  // a rotation
    const glm::dvec3 direction = object_from_world * point.position;
    const truth::DirectionGradient change{object_from_world * step.dx, object_from_world * step.dy};
    return glm::dvec3(
        p.mapping == Mapping::cube
            ? truth::cube_level_of_detail(direction, change, *texels)
            : truth::level_of_detail(truth::worksheet_gradient(direction, change), glm::dvec2(*texels)));
  };
}

/// Colours in 8-bit levels, as in the view `color` with one sample in each pixel.
answers::Truth color_truth(const CubeMapParameters& p, glm::ivec2 size) {
  const auto wears = sphere_color(p);
  if (!wears) return {};
  const truth::Camera camera = answers::camera_of(p.camera, size);
  const truth::Placement place = sphere_placement(p);
  return answers::mean_in_steps([=](glm::dvec2 window) {
    const truth::Ray ray = truth::object_ray(truth::ray_through(camera, window), place);
    const auto hit = truth::hit_sphere(ray);
    return hit ? glm::dvec4(wears(ray.origin + hit->distance * ray.direction), 1) : glm::dvec4(0);
  });
}

struct Answer final : answers::ChosenAnswer<CubeMapParameters, TruthOf> {
  Answer() : ChosenAnswer({"truth", TruthOf::color, kTruths, "What the view error compares with"}) {}
  [[nodiscard]] std::vector<std::string_view> methods() const override {
    return {"method", "faces", "seam_method", "rings", "segments"};
  }
  [[nodiscard]] app::Measure measure(const CubeMapParameters& /*parameters*/) const override {
    if (chosen_ == TruthOf::level) return {app::View::lod, app::Unit::levels, "the formula's own derivative"};
    return {app::View::color, app::Unit::steps, "the mean of the pictures' function over the pixel"};
  }
  [[nodiscard]] answers::Truth truth(const CubeMapParameters& p, glm::ivec2 size) const override {
    return chosen_ == TruthOf::level ? level_truth(p, size) : color_truth(p, size);
  }
};

const bool known = answers::know<CubeMapParameters, Answer>();

}  // namespace
}  // namespace texel::cube_map
