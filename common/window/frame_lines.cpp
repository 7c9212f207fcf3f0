// SPDX-License-Identifier: MIT
// T, B and N over the picture.
#include <algorithm>
#include <cmath>

#include "app/camera.hpp"
#include "app/settings.hpp"
#include "panel.hpp"

namespace texel::window {
namespace {

using app::View;

constexpr int kSpacing = 40;  // pixels from one T, B and N to the next

/// The camera that the parameters describe.
app::OrbitCamera camera_of(params::Set& parameters) {
  const auto value = [&](const char* name) { return static_cast<float>(parameters.at(name).value()); };
  return {value("yaw"), value("pitch"), value("field_of_view"), value("distance")};
}

/// What the data views have at a pixel.
struct Views {
  image::ImageF depth, texcoord, normal, tangent;  ///< empty where the lab has no such view
  glm::ivec2 size;
  glm::mat4 world_from_view, clip_from_world;
  float tangent_of_half_angle, aspect;

  [[nodiscard]] bool is_object(glm::ivec2 p) const { return depth.at(p.x, p.y, 3) > 0; }
  static glm::vec3 vector(const image::ImageF& picture, glm::ivec2 p) {
    return {picture.at(p.x, p.y, 0), picture.at(p.x, p.y, 1), picture.at(p.x, p.y, 2)};
  }
  [[nodiscard]] glm::vec3 position(glm::ivec2 p) const {
    const glm::vec2 ndc = 2.0F * (glm::vec2(p) + 0.5F) / glm::vec2(size) - 1.0F;
    const float z = depth.at(p.x, p.y, 0), reach = z * tangent_of_half_angle;
    return glm::vec3(world_from_view * glm::vec4(ndc.x * reach * aspect, ndc.y * reach, -z, 1));
  }
  [[nodiscard]] glm::vec2 in_picture(const glm::vec3& world) const {
    const glm::vec4 clip = clip_from_world * glm::vec4(world, 1);
    return {0.5F + 0.5F * clip.x / clip.w, 0.5F - 0.5F * clip.y / clip.w};
  }
  /// Where t grows at a pixel, world space: from the differences to the pixels right of it and above.
  [[nodiscard]] glm::vec3 growth_of_t(glm::ivec2 p) const {
    const glm::ivec2 right = p + glm::ivec2(1, 0), up = p + glm::ivec2(0, 1);
    const glm::vec3 here = position(p), dx = position(right) - here, dy = position(up) - here;
    const glm::vec2 st(vector(texcoord, p)), sx = glm::vec2(vector(texcoord, right)) - st,
                                             sy = glm::vec2(vector(texcoord, up)) - st;
    const float determinant = sx.s * sy.t - sy.s * sx.t;
    return (sx.s * dy - sy.s * dx) * (determinant < 0 ? -1.0F : 1.0F);
  }
};

}  // namespace

std::vector<FrameLine> frame_lines(app::Canvas& canvas, app::AnyLab& lab, glm::ivec2 size) {
  const auto has = [&](View view) { return std::ranges::count(lab.views(), view) > 0; };
  if (!has(View::depth) || !has(View::normal)) return {};
  const app::OrbitCamera camera = camera_of(lab.parameters());
  const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
  Views views;
  views.size = size, views.aspect = aspect;
  views.world_from_view = glm::inverse(camera.view_from_world());
  views.clip_from_world = camera.clip_from_world(aspect);
  views.tangent_of_half_angle = std::tan(glm::radians(camera.field_of_view) / 2);
  views.depth = canvas.values_of(View::depth, size);
  if (has(View::texcoord)) views.texcoord = canvas.values_of(View::texcoord, size);
  if (has(View::tangent)) views.tangent = canvas.values_of(View::tangent, size);
  {
    const app::KeptValues before(lab.parameters());
    if (params::Parameter* mapping = lab.parameters().find("normal_mapping")) mapping->set_value(0);
    views.normal = canvas.values_of(View::normal, size);
  }

  std::vector<FrameLine> lines;
  const float length = 0.06F * camera.distance;  // world units
  for (int y = kSpacing / 2; y + 1 < size.y; y += kSpacing)
    for (int x = kSpacing / 2; x + 1 < size.x; x += kSpacing) {
      const glm::ivec2 p(x, y);
      if (!views.is_object(p) || !views.is_object(p + glm::ivec2(1, 0)) ||
          !views.is_object(p + glm::ivec2(0, 1)))
        continue;
      const glm::vec3 position = views.position(p), normal = Views::vector(views.normal, p);
      const auto add = [&](FrameLine::Axis axis, const glm::vec3& direction) {
        const glm::vec2 from = views.in_picture(position),
                        to = views.in_picture(position + length * direction);
        if (std::isfinite(to.x + to.y)) lines.push_back({axis, from, to});
      };
      add(FrameLine::Axis::normal, normal);
      if (views.tangent.samples.empty()) continue;
      const glm::vec3 tangent = Views::vector(views.tangent, p), side = glm::cross(normal, tangent);
      add(FrameLine::Axis::tangent, tangent);
      if (views.texcoord.samples.empty()) continue;
      add(FrameLine::Axis::bitangent, glm::dot(side, views.growth_of_t(p)) < 0 ? -side : side);
    }
  return lines;
}

}  // namespace texel::window
