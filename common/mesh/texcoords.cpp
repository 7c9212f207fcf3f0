// SPDX-License-Identifier: MIT
#include "mesh/texcoords.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mesh/bounds.hpp"
#include "mesh/distinct.hpp"
#include "mesh/normals.hpp"
#include "mesh/weld.hpp"
#include "newell.hpp"

namespace texel::mesh {

namespace {

using TriangleTexcoords = std::array<glm::vec2, 3>;
using TrianglePositions = std::array<glm::vec3, 3>;  // from the box's centre

/// The texture coordinates of a face seen straight from outside along its main axis, upright: the one with
/// the greatest part in the normal.
TriangleTexcoords box_texcoords(const TrianglePositions& p, float size) {
  const glm::vec3 normal = newell_unit(p[0], p[1], p[2]);
  const glm::vec3 part = glm::abs(normal);
  TriangleTexcoords texcoords;
  for (std::size_t k = 0; k < 3; ++k) {
    glm::vec2 st;
    if (part.z >= part.x && part.z >= part.y)
      st = {normal.z < 0.0f ? -p[k].x : p[k].x, p[k].y};
    else if (part.x >= part.y)
      st = {normal.x > 0.0f ? -p[k].z : p[k].z, p[k].y};
    else
      st = {p[k].x, normal.y > 0.0f ? -p[k].z : p[k].z};
    texcoords[k] = st / size + 0.5f;
  }
  return texcoords;
}

/// Makes the three longitudes those of one unbroken piece: past the seam they go on beyond 1, and a corner on
/// the axis takes the mean of the others.
void mend_seam(const TrianglePositions& p, float size, TriangleTexcoords& texcoords) {
  // Within rounding: the box's centre is rounded, so a pole rarely lies at exactly 0.
  const auto on_axis = [&](std::size_t k) { return std::hypot(p[k].x, p[k].z) <= 1e-6f * size; };
  float greatest = 0.0f, sum = 0.0f;
  int count = 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (!on_axis(k)) greatest = std::max(greatest, texcoords[k].s);
  for (std::size_t k = 0; k < 3; ++k) {
    if (on_axis(k)) continue;
    if (greatest - texcoords[k].s > 0.5f) texcoords[k].s += 1.0f;
    sum += texcoords[k].s;
    ++count;
  }
  for (std::size_t k = 0; k < 3; ++k)
    if (on_axis(k) && count > 0) texcoords[k].s = sum / static_cast<float>(count);
}

TriangleTexcoords round_texcoords(const TrianglePositions& p, Projection projection, float size,
                                  float height) {
  TriangleTexcoords texcoords;
  for (std::size_t k = 0; k < 3; ++k) {
    texcoords[k] = spherical_texcoord(p[k]);
    if (projection == Projection::cylindrical) texcoords[k].t = p[k].y / height + 0.5f;
  }
  mend_seam(p, size, texcoords);
  return texcoords;
}

TriangleTexcoords planar_texcoords(const TrianglePositions& p, float size) {
  TriangleTexcoords texcoords;
  for (std::size_t k = 0; k < 3; ++k) texcoords[k] = glm::vec2(p[k]) / size + 0.5f;
  return texcoords;
}

}  // namespace

void generate_texcoords(Mesh& mesh, Projection projection) {
  const Bounds box = bounds(mesh);
  const glm::vec3 extent = box.extent();
  const auto or_one = [](float length) { return length > 0.0f ? length : 1.0f; };  // flat meshes
  const float size = or_one(std::max({extent.x, extent.y, extent.z}));

  // Texture coordinates by corner, then one vertex for each distinct one.
  std::vector<glm::vec2> distinct;
  std::vector<std::uint32_t> labels(mesh.indices.size());
  DistinctTable table(mesh.vertex_count());
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    TrianglePositions p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = mesh.positions[mesh.indices[i + k]] - box.center();
    TriangleTexcoords texcoords;
    switch (projection) {
      case Projection::planar:
        texcoords = planar_texcoords(p, size);
        break;
      case Projection::box:
        texcoords = box_texcoords(p, size);
        break;
      case Projection::cylindrical:
      case Projection::spherical:
        texcoords = round_texcoords(p, projection, size, or_one(extent.y));
        break;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::vec2& st = texcoords[k];
      labels[i + k] = table.number(mix(std::uint64_t{value_bits(st.s)} << 32 | value_bits(st.t)),
                                   [&](std::uint32_t n) { return distinct[n] == st; });
      if (labels[i + k] == distinct.size()) distinct.push_back(st);
    }
  }
  mesh.tangents.clear();
  mesh.bitangents.clear();
  mesh.texcoords.clear();
  const std::vector<std::uint32_t> label = split_by_label(mesh, labels);
  mesh.texcoords.reserve(label.size());
  for (const std::uint32_t n : label) mesh.texcoords.push_back(n == no_index ? glm::vec2(0.0f) : distinct[n]);
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
