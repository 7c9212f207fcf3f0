// SPDX-License-Identifier: MIT
// The right answer of lab 3. In double precision, a ray meets the exact surface that the file's triangles
// stand for. There the normal is known, and so is the texture coordinate: by the surface's own formula, or by
// the projection's, which a mesh follows at its vertices only. The picture is the function that the file was
// made from, lit there. Known are sphere, torus, quad and the cubes; the report's two cubes count as what
// they should be, a copy of the picture on each face.
#include <algorithm>
#include <numbers>

#include "03_obj_texcoords/import.hpp"
#include "03_obj_texcoords/parameters.hpp"
#include "answers/answer.hpp"
#include "answers/color.hpp"
#include "answers/shape.hpp"

namespace texel::obj_texcoords {
namespace {

enum class Quantity { color, texcoord, normal };
constexpr params::Item kQuantities[] = {
    {"color", "The lit picture, in 8-bit levels: the sum of all errors"},
    {"texcoord", "The texture coordinate, in texels: errors between vertices and at seams"},
    {"normal", "The normal, in degrees: errors of flat and smooth normals"}};

/// What one of the bundled files stands for, once it has been made to fit the unit sphere.
struct ExactModel {
  answers::Shape shape;
  glm::dvec2 begin;             ///< the file's texture coordinate where the shape's own is (0, 0)
  double longest_side, height;  ///< of the box around it, whose centre is the origin
};

std::optional<ExactModel> exact_model(const std::string& model) {
  // A corner of the cube and of the quad lies at distance 1.
  const double cube = 1 / std::numbers::sqrt3, quad = 1 / std::numbers::sqrt2;
  const bool is_cube = model == "cube_before" || model == "cube_split";
  const auto shape = answers::model_shape(is_cube ? "cube" : model, cube, quad);
  if (!shape) return std::nullopt;
  if (model == "sphere") return ExactModel{*shape, {0.5, 0}, 2, 2};
  if (model == "torus") return ExactModel{*shape, {0.5, 0.5}, 2, 0.6};
  const double side = model == "quad" ? 2 * quad : 2 * cube;
  return ExactModel{*shape, {0, 0}, side, side};
}

/// Where the ray meets the model, in object space.
struct ExactPoint {
  glm::dvec3 position, normal;
  glm::dvec2 texcoord;  ///< as the file has it, 0..1
};

std::optional<ExactPoint> meet(const ExactModel& model, const truth::Ray& object_ray) {
  const auto hit = model.shape.hit(object_ray);
  if (!hit) return std::nullopt;
  const truth::SurfacePoint point = model.shape.at(*hit);
  glm::dvec2 texcoord = hit->texcoord + model.begin;
  for (int c = 0; c < 2; ++c)
    if (texcoord[c] > 1) texcoord[c] -= 1;  // past the file's seam
  return ExactPoint{point.position, point.normal, texcoord};
}

/// The point seen along an axis (0, 1, 2) from the side to which the normal points, upright; object units.
glm::dvec2 seen_along(int axis, const ExactPoint& at) {
  const double side = at.normal[axis] < 0 ? -1 : 1;
  if (axis == 0) return {-side * at.position.z, at.position.y};
  if (axis == 1) return {at.position.x, -side * at.position.z};
  return {side * at.position.x, at.position.y};
}

/// The axis that the surface faces most.
int main_axis(glm::dvec3 normal) {
  const glm::dvec3 part = glm::abs(normal);
  if (part.z >= part.x && part.z >= part.y) return 2;
  return part.x >= part.y ? 0 : 1;
}

/// The texture coordinate by the projection's formula at the point itself; by the file's for `from_file`.
/// Triplanar has three.
glm::dvec2 exact_texcoord(const ExactModel& model, Projection projection, const ExactPoint& at) {
  const glm::dvec3 p = at.position;
  const double around = std::atan2(p.x, p.z) / (2 * std::numbers::pi);
  const double longitude = around < 0 ? around + 1 : around;
  switch (projection) {
    case Projection::planar:
      return glm::dvec2(p) / model.longest_side + 0.5;
    case Projection::box:
      return seen_along(main_axis(at.normal), at) / model.longest_side + 0.5;
    case Projection::cylindrical:
      return {longitude, p.y / model.height + 0.5};
    case Projection::spherical:
      return {longitude, std::atan2(p.y, std::hypot(p.x, p.z)) / std::numbers::pi + 0.5};
    default:
      return at.texcoord;
  }
}

/// Whether the texture coordinate goes around the model and meets its own beginning.
bool goes_around(const ObjTexcoordsParameters& p) {
  if (p.projection == Projection::from_file) return p.model == "sphere" || p.model == "torus";
  return p.projection == Projection::cylindrical || p.projection == Projection::spherical;
}

/// The picture's colour at the point, linear light.
glm::dvec3 exact_color(const ExactModel& model, const ObjTexcoordsParameters& p, procedural::Texture texture,
                       const ExactPoint& at) {
  const auto look_up = [&](glm::dvec2 texcoord) {
    return glm::dvec3(procedural::color(texture, texcoord.s, p.flip_v ? 1 - texcoord.t : texcoord.t));
  };
  const double repeats = p.texture_scale;
  if (p.projection != Projection::triplanar)
    return look_up(repeats * exact_texcoord(model, p.projection, at));
  glm::dvec3 sum(0);
  double weights = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double weight = std::pow(std::abs(at.normal[axis]), 6);
    sum += weight * look_up(repeats / model.longest_side * seen_along(axis, at) + 0.5);
    weights += weight;
  }
  return sum / weights;
}

/// Linear light that a surface sends to the eye: Lambert's cosine over what comes from everywhere, and
/// Blinn's highlight with the exponent 48 where the light reaches. All directions are unit vectors in world
/// space. The formula of shaders/lib/light.glsl.
glm::dvec3 exact_light(const app::Light& light, glm::dvec3 to_light, glm::dvec3 albedo, glm::dvec3 normal,
                       glm::dvec3 to_eye) {
  const double cosine = glm::dot(normal, to_light);
  const glm::dvec3 everywhere = double{light.ambient} * albedo;
  if (cosine <= 0) return everywhere;
  const double facing = std::max(glm::dot(normal, glm::normalize(to_light + to_eye)), 0.0);
  return everywhere + (1.0 - light.ambient) * cosine * albedo + light.specular * std::pow(facing, 48);
}

struct Answer final : answers::ChosenAnswer<ObjTexcoordsParameters, Quantity> {
  Answer()
      : ChosenAnswer(
            {"truth", Quantity::color, kQuantities, "What the view error compares with the exact answer"}) {}
  [[nodiscard]] std::vector<std::string_view> methods() const override {
    return {"method", "normals", "linear_light"};
  }
  /// Degrees, texels or 8-bit levels, as the parameter `truth` says.
  [[nodiscard]] app::Measure measure(const ObjTexcoordsParameters& p) const override {
    constexpr double texels = 512;  // in the width and height of each bundled picture
    switch (chosen_) {
      case Quantity::color:
        return {app::View::color, app::Unit::steps, "the picture's function on the exact surface, lit"};
      case Quantity::texcoord:
        return {app::View::texcoord, app::Unit::texels, "the coordinate of the exact surface", texels,
                goes_around(p)};
      case Quantity::normal:
        break;
    }
    return {app::View::normal, app::Unit::degrees, "the normal of the exact surface"};
  }
  /// What the measure's view should show. Empty for models and pictures that have no formula, and for the
  /// texture coordinate of triplanar, of which there are three, and for the vertices' colours.
  [[nodiscard]] answers::Truth truth(const ObjTexcoordsParameters& p, glm::ivec2 size) const override {
    const Quantity quantity = chosen_;
    const auto model = exact_model(p.model);
    const auto texture = answers::texture_of(p.texture == "material" ? "label_grid" : p.texture);
    if (!model) return {};
    const truth::Camera camera = answers::camera_of(p.camera, size);
    const truth::Placement place{.linear = answers::about_y(p.turn)};
    const auto meet_at = [=, model = *model](const truth::Ray& ray) {
      return meet(model, truth::object_ray(ray, place));
    };
    if (quantity == Quantity::texcoord && p.projection == Projection::triplanar) return {};
    if (quantity != Quantity::color)
      return [=, model = *model](glm::dvec2 window) -> std::optional<glm::dvec3> {
        const auto at = meet_at(truth::ray_through(camera, window));
        if (!at) return std::nullopt;
        if (quantity == Quantity::normal) return place.linear * at->normal;
        return glm::dvec3(double{p.texture_scale} * exact_texcoord(model, p.projection, *at), 0);
      };
    if (!texture || p.tint == Tint::vertices) return {};
    glm::dvec3 tint(1);
    for (int c = 0; c < 3 && p.tint != Tint::none; ++c)
      tint[c] = image::linear_from_srgb(double{part_color(0)[c]});  // these models have one part
    const glm::dvec3 to_light(p.light.direction());
    return answers::mean_in_steps([=, model = *model, texture = *texture](glm::dvec2 window) {
      const truth::Ray ray = truth::ray_through(camera, window);
      const auto at = meet_at(ray);
      if (!at) return glm::dvec4(0);
      const glm::dvec3 albedo = tint * exact_color(model, p, texture, *at);
      return glm::dvec4(exact_light(p.light, to_light, albedo, place.linear * at->normal, -ray.direction), 1);
    });
  }
};

const bool known = answers::know<ObjTexcoordsParameters, Answer>();

}  // namespace
}  // namespace texel::obj_texcoords
