// SPDX-License-Identifier: MIT
// Any model as the report wraps its cube: one vertex for each point in space. Nothing to do for you here.
#pragma once
#include <complex>
#include <numbers>

#include "mesh/normals.hpp"
#include "parameters.hpp"
#include "steps.hpp"

namespace texel::cube_wrap {

/// Longitude and latitude of a direction, as parts of a full and of a half turn: the angles of two points in
/// the plane. Lab 3 teaches another way.
inline glm::vec2 round_texcoord(const glm::vec3& direction) {
  const glm::dvec3 d(direction);
  const double turn = std::arg(std::complex<double>(d.z, d.x)) / (2.0 * std::numbers::pi);
  const double rise = std::arg(std::complex<double>(std::hypot(d.x, d.z), d.y)) / std::numbers::pi;
  return {turn < 0.0 ? turn + 1.0 : turn, rise + 0.5};
}

/// Any model with one vertex for each point in space. Of its faces' texture coordinates the last one is kept
/// (before), or one copy is drawn around the whole model by longitude and latitude (stretched).
inline mesh::Mesh shared_vertices(const mesh::Mesh& model, Method method) {
  mesh::Mesh shared;
  shared.positions = model.positions;
  shared.indices = model.indices;
  shared = weld(shared);  // vertices have only positions now: equal positions become one vertex
  shared.texcoords.resize(shared.vertex_count());
  for (std::size_t i = 0; i < shared.indices.size(); ++i) {
    const std::uint32_t vertex = shared.indices[i];
    shared.texcoords[vertex] = method == Method::before ? model.texcoords[model.indices[i]]
                                                        : round_texcoord(shared.positions[vertex]);
  }
  mesh::smooth_normals(shared, mesh::Weighting::angle, face_normal);
  return shared;
}

}  // namespace texel::cube_wrap
