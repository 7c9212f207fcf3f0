// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <string>

#include "mesh/mesh.hpp"

namespace texel::mesh {

/// The box around a mesh, axis-aligned, in object space; both zero for an empty mesh.
struct Bounds {
  glm::vec3 least{0.0F};
  glm::vec3 greatest{0.0F};

  [[nodiscard]] glm::vec3 center() const { return 0.5F * least + 0.5F * greatest; }
  [[nodiscard]] glm::vec3 extent() const { return greatest - least; }
};

Bounds bounds(const Mesh& mesh);

/// Says why a model is nearly invisible or has lost its shape in float32's 7 digits; "" if all is well.
/// Reasons: all vertices lie at one point; the triangles have no area compared with the model's size; or it
/// is so far from the origin that fewer than 1024 floats lie along it, which is coarser than pixels.
std::string lost_shape(const Mesh& mesh);

/// Moves the box's centre to the origin and scales evenly so that the farthest vertex lies at distance 1; a
/// mesh without extent is only moved. In double, so that models of any size and place keep their shape.
/// Normals and tangents stay as they are.
void normalize_to_unit(Mesh& mesh);

}  // namespace texel::mesh
