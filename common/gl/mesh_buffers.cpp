// SPDX-License-Identifier: MIT
#include "gl/mesh_buffers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "core/error.hpp"

namespace texel::gl {
namespace {

/// The floats of one attribute and how many a vertex has; empty when the mesh does not have it.
struct Stream {
  std::span<const float> floats;
  GLint components = 0;
};

template <class Vector>
Stream stream(const std::vector<Vector>& values) {
  if (values.empty()) return {};
  return {{&values.front().x, values.size() * static_cast<std::size_t>(Vector::length())}, Vector::length()};
}

Stream stream(const mesh::Mesh& mesh, Attribute attribute) {
  switch (attribute) {
    case Attribute::position:
      return stream(mesh.positions);
    case Attribute::normal:
      return stream(mesh.normals);
    case Attribute::texcoord:
      return stream(mesh.texcoords);
    case Attribute::tangent:
      return stream(mesh.tangents);
    case Attribute::bitangent:
      return stream(mesh.bitangents);
    case Attribute::color:
      return stream(mesh.colors);
  }
  return {};
}

}  // namespace

MeshBuffers::MeshBuffers(std::shared_ptr<const mesh::Mesh> mesh) : mesh_(std::move(mesh)) {}
MeshBuffers::MeshBuffers(mesh::Mesh mesh)
    : MeshBuffers(std::make_shared<const mesh::Mesh>(std::move(mesh))) {}
MeshBuffers::MeshBuffers(MeshBuffers&& other) noexcept = default;
MeshBuffers::~MeshBuffers() = default;

std::size_t MeshBuffers::bytes() const {
  std::size_t bytes = mesh_->indices.size() * sizeof(std::uint32_t);
  mesh::for_each_attribute(*mesh_, [&](const auto& values) { bytes += std::span(values).size_bytes(); });
  return 2 * bytes;
}

void MeshBuffers::bind(const Program& program) {
  glBindVertexArray(vertex_array_.id());
  if (indices_ == nullptr) {
    indices_ = std::make_unique<Buffer>();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_->id());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(mesh_->indices.size() * sizeof(std::uint32_t)),
                 mesh_->indices.data(), GL_STATIC_DRAW);
  }
  const std::vector<Attribute>& read = program.attributes();
  for (const auto& [attribute, buffer] : attributes_)
    if (std::find(read.begin(), read.end(), attribute) == read.end())
      glDisableVertexAttribArray(static_cast<GLuint>(attribute));
  for (const Attribute attribute : read) {
    const auto location = static_cast<GLuint>(attribute);
    if (!attributes_.contains(attribute)) {
      const Stream values = stream(*mesh_, attribute);
      if (values.floats.empty())
        throw Error::failed(
            fmt::format("reads the attribute '{}', which the mesh does not have", kAttributeNames[location]),
            program.place(), "choose a method that does not need it, or add it to the mesh");
      glBindBuffer(GL_ARRAY_BUFFER, attributes_[attribute].id());
      glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.floats.size_bytes()), values.floats.data(),
                   GL_STATIC_DRAW);
      glVertexAttribPointer(location, values.components, GL_FLOAT, GL_FALSE, 0, nullptr);
    }
    glEnableVertexAttribArray(location);
  }
}

void MeshBuffers::draw(const Program& program) {
  draw(program, {"", 0, static_cast<std::uint32_t>(mesh_->indices.size())});
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
