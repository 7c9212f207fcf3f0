// SPDX-License-Identifier: MIT
#include "mesh/texcoords.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/bounds.hpp"
#include "mesh/distinct.hpp"
#include "mesh/weld.hpp"
#include "newell.hpp"

namespace texel::mesh {
namespace {

using TriangleTexcoords = std::array<glm::vec2, 3>;
using TrianglePositions = std::array<glm::vec3, 3>;  // from the box's centre

/// Where a face of this normal shows the picture: along its main axis, that with the greatest part in the
/// normal, seen straight from outside and upright.
glm::vec2 box_texcoord(const glm::vec3& p, const glm::vec3& normal) {
  const glm::vec3 part = glm::abs(normal);
  if (part.z >= part.x && part.z >= part.y) return {normal.z < 0.0F ? -p.x : p.x, p.y};
  if (part.x >= part.y) return {normal.x > 0.0F ? -p.z : p.z, p.y};
  return {p.x, normal.y > 0.0F ? -p.z : p.z};
}

/// Makes the three longitudes those of one unbroken piece: past the seam they go on beyond 1, and a corner on
/// the axis takes the mean of the others.
void mend_seam(const TrianglePositions& p, float size, TriangleTexcoords& texcoords) {
  // Within rounding: the box's centre is rounded, so a pole rarely lies at exactly 0.
  const auto on_axis = [&](std::size_t k) { return std::hypot(p[k].x, p[k].z) <= 1e-6F * size; };
  float greatest = 0.0F, sum = 0.0F;
  int count = 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (!on_axis(k)) greatest = std::max(greatest, texcoords[k].s);
  for (std::size_t k = 0; k < 3; ++k) {
    if (on_axis(k)) continue;
    if (greatest - texcoords[k].s > 0.5F) texcoords[k].s += 1.0F;
    sum += texcoords[k].s;
    ++count;
  }
  for (std::size_t k = 0; k < 3; ++k)
    if (on_axis(k) && count > 0) texcoords[k].s = sum / static_cast<float>(count);
}

}  // namespace

void generate_texcoords(Mesh& mesh, Projection projection) {
  const Bounds box = bounds(mesh);
  const glm::vec3 extent = box.extent();
  const auto or_one = [](float length) { return length > 0.0F ? length : 1.0F; };  // flat meshes
  const float size = or_one(std::max({extent.x, extent.y, extent.z}));

  // Texture coordinates by corner, then one vertex for each distinct one.
  Distinct<glm::vec2> distinct(mesh.vertex_count());
  std::vector<std::uint32_t> labels;
  labels.reserve(mesh.indices.size());
  const bool is_round = projection == Projection::cylindrical || projection == Projection::spherical;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    TrianglePositions p = of_triangle(mesh, mesh.positions, t);
    for (glm::vec3& position : p) position -= box.center();
    const glm::vec3 normal =
        projection == Projection::box ? newell_unit(p[0], p[1], p[2]) : glm::vec3(0.0F, 0.0F, 1.0F);
    TriangleTexcoords texcoords;
    for (std::size_t k = 0; k < 3; ++k) {
      texcoords[k] = is_round ? spherical_texcoord(p[k]) : box_texcoord(p[k], normal) / size + 0.5F;
      if (projection == Projection::cylindrical) texcoords[k].t = p[k].y / or_one(extent.y) + 0.5F;
    }
    if (is_round) mend_seam(p, size, texcoords);
    for (const glm::vec2& st : texcoords)
      labels.push_back(distinct.number(mix(std::uint64_t{value_bits(st.s)} << 32 | value_bits(st.t)), st));
  }
  mesh.tangents.clear();
  mesh.bitangents.clear();
  mesh.texcoords.clear();
  for (const std::uint32_t n : split_by_label(mesh, labels))
    mesh.texcoords.push_back(n == no_index ? glm::vec2(0.0F) : distinct.things()[n]);
}

void lay_texture(Mesh& mesh, const TextureLayout& layout) {
  for (glm::vec2& texcoord : mesh.texcoords) {
    const double s = layout.stretch * (texcoord.s + double{layout.shear} * texcoord.t);
    texcoord.s = static_cast<float>(layout.mirror ? 1.0 - s : s);
  }
  if (layout.mirror)
    for (glm::vec4& tangent : mesh.tangents) tangent = -tangent;
  mesh.bitangents.clear();
}

}  // namespace texel::mesh
