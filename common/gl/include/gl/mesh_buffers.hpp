// SPDX-License-Identifier: MIT
#pragma once
#include <map>

#include "gl/objects.hpp"
#include "gl/program.hpp"
#include "mesh/mesh.hpp"

namespace texel::gl {

/// A mesh on the GPU: one buffer an attribute, uploaded when a program first reads it, and the indices.
class MeshBuffers {
 public:
  explicit MeshBuffers(mesh::Mesh mesh);

  /// Draws all triangles with `program`, which must be in use. Throws Error when it reads an attribute that
  /// the mesh does not have.
  void draw(const Program& program);
  /// Draws a closed surface: from outside only the triangles that turn their front to the camera.
  void draw_closed(const Program& program, bool is_outside);
  /// Draws one of the mesh's groups.
  void draw(const Program& program, const mesh::Group& group);

  [[nodiscard]] const mesh::Mesh& mesh() const { return mesh_; }

 private:
  void bind(const Program& program);
  mesh::Mesh mesh_;
  VertexArray vertex_array_;
  Buffer indices_;
  std::map<Attribute, Buffer> attributes_;
};

}  // namespace texel::gl
