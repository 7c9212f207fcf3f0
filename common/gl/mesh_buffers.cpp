// SPDX-License-Identifier: MIT
#include "gl/mesh_buffers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "core/error.hpp"

namespace texel::gl {

MeshBuffers::MeshBuffers(mesh::Mesh mesh) : mesh_(std::move(mesh)) {
  glBindVertexArray(vertex_array_.id());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(std::span(mesh_.indices).size_bytes()),
               mesh_.indices.data(), GL_STATIC_DRAW);
  glBindVertexArray(0);
}

void MeshBuffers::bind(const Program& program) {
  glBindVertexArray(vertex_array_.id());
  const std::vector<Attribute>& read = program.attributes();
  int next = 0;
  mesh::for_each_attribute(mesh_, [&]<class Vector>(const std::vector<Vector>& values) {
    const auto attribute = static_cast<Attribute>(next++);
    const auto location = static_cast<GLuint>(attribute);
    if (std::ranges::count(read, attribute) == 0) return glDisableVertexAttribArray(location);
    if (values.empty())
      throw Error::failed(
          fmt::format("reads the attribute '{}', which the mesh does not have", kAttributeNames[location]),
          program.place(), "choose a method that does not need it, or add it to the mesh");
    if (!attributes_.contains(attribute)) {
      glBindBuffer(GL_ARRAY_BUFFER, attributes_[attribute].id());
      glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(std::span(values).size_bytes()), values.data(),
                   GL_STATIC_DRAW);
      glVertexAttribPointer(location, Vector::length(), GL_FLOAT, GL_FALSE, 0, nullptr);
    }
    glEnableVertexAttribArray(location);
  });
}

void MeshBuffers::draw(const Program& program) {
  draw(program, {"", 0, static_cast<std::uint32_t>(mesh_.indices.size())});
}

void MeshBuffers::draw_closed(const Program& program, bool is_outside) {
  if (is_outside) glEnable(GL_CULL_FACE);
  draw(program);
  glDisable(GL_CULL_FACE);
}

void MeshBuffers::draw(const Program& program, const mesh::Group& group) {
  bind(program);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(group.index_count), GL_UNSIGNED_INT,
                 reinterpret_cast<const void*>(group.first_index * sizeof(std::uint32_t)));
}

}  // namespace texel::gl
