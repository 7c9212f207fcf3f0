// SPDX-License-Identifier: MIT
// The right answer of lab 5: the normal that each pixel should be lit with. In double precision, a ray meets
// the exact surface and not its triangles, the relief's slope comes from the formula that the normal map was
// made from, by its exact derivatives, and bends the surface's normal. See
// teach/truth/include/truth/relief.hpp for the two answers: the relief as a height field, or as a map that
// was baked by the common rules. On cube and quad they are the same, until these are stretched.
#include "05_normal_map/model.hpp"
#include "05_normal_map/parameters.hpp"
#include "answers/answer.hpp"
#include "answers/camera.hpp"
#include "answers/relief.hpp"
#include "answers/shape.hpp"

namespace texel::normal_map {
namespace {

/// (s, t) as the texture is read, from the surface's own.
truth::TexcoordMap texcoord_map(const NormalMapParameters& p) {
  const double along_s = p.layout.mirror ? -p.layout.stretch : p.layout.stretch;
  const double repeats = p.texture_scale;
  return {.linear = repeats * glm::dmat2(along_s, 0, along_s * p.layout.shear, 1),
          .offset = repeats * glm::dvec2(p.layout.mirror ? 1 : 0, 0)};
}

struct Answer final : answers::ChosenAnswer<NormalMapParameters, answers::ReliefTruth> {
  Answer()
      : ChosenAnswer({"truth", answers::ReliefTruth::baked_map, answers::kReliefTruths,
                      "What the view error compares with"}) {}
  [[nodiscard]] std::vector<std::string_view> methods() const override {
    return {"method", "decode", "filter", "segments", "jitter"};
  }
  [[nodiscard]] app::Measure measure(const NormalMapParameters& /*parameters*/) const override {
    return {app::View::normal, app::Unit::degrees, answers::name_of(chosen_)};
  }
  /// Unit vectors in the world, as the view `normal` has them. Empty for models and normal maps from files:
  /// their formulas are not known.
  [[nodiscard]] answers::Truth truth(const NormalMapParameters& p, glm::ivec2 size) const override {
    const auto shape = answers::model_shape(p.model);
    const auto gradient = answers::height_gradient(p.normal_mapping ? normal_map_name(p) : "flat");
    if (!shape || !gradient) return {};
    const truth::Camera camera = answers::camera_of(p.camera, size);
    const truth::Placement place{.linear = answers::about_y(p.turn) *
                                           glm::dmat3(1, 0, 0, 0, p.stretch, 0, 0, 0, 1)};
    const truth::TexcoordMap map = texcoord_map(p);
    // The relief is made for a texture that is as long as this one is along t: on all these models the same
    // everywhere.
    const double width = glm::length(shape->surface(image::Face::positive_z)(glm::dvec2(0.5)).dt);
    const answers::Relief relief{chosen_, *gradient, p.bump_strength, width / p.texture_scale};

    return [=](glm::dvec2 window) -> std::optional<glm::dvec3> {
      const truth::PixelRay pixel = truth::pixel_ray(camera, window);
      const auto hit = shape->hit(truth::object_ray(pixel.ray, place));
      if (!hit) return std::nullopt;
      const truth::Surface surface =
          truth::placed(truth::reparameterized(shape->surface(hit->face), map), place);
      const glm::dvec2 texcoord = map.texcoord(hit->texcoord);
      return relief.mean_normal(pixel, surface(texcoord), texcoord);
    };
  }
  /// The tangents that are computed for the vertices.
  [[nodiscard]] std::optional<app::Preparation> preparation(const NormalMapParameters& p,
                                                            const app::Assets& assets) const override {
    const auto method = kept_tangents(p.method);
    const mesh::Mesh plain = textured_model(assets, p).mesh;
    if (!method || !plain.tangents.empty()) return {};
    return app::Preparation{"triangle", plain.triangle_count(), [plain, method] {
                              mesh::Mesh mesh = plain;
                              mesh::compute_tangents(mesh, *method);
                            }};
  }
};

const bool known = answers::know<NormalMapParameters, Answer>();

}  // namespace
}  // namespace texel::normal_map
