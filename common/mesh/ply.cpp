// SPDX-License-Identifier: MIT
#include "mesh/ply.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "core/error.hpp"

namespace texel::mesh {
namespace {

static_assert(std::endian::native == std::endian::little, "PLY bytes are copied as they lie in memory");

constexpr std::size_t face_bytes = 1 + 3 * sizeof(std::int32_t);

template <class Value>
void append(std::string& bytes, const Value& value) {
  const std::size_t at = bytes.size();
  bytes.resize(at + sizeof(Value));
  std::memcpy(bytes.data() + at, &value, sizeof(Value));
}

template <class Value>
Value take(std::string_view& bytes) {
  Value value;
  std::memcpy(&value, bytes.data(), sizeof(Value));
  bytes.remove_prefix(sizeof(Value));
  return value;
}

/// Calls `visit` with each attribute that a PLY file can hold, and its lines in the header.
template <class MeshType, class Visit>
void for_each_property(MeshType& mesh, Visit visit) {
  visit(mesh.positions, "property float x\nproperty float y\nproperty float z\n");
  visit(mesh.normals, "property float nx\nproperty float ny\nproperty float nz\n");
  visit(mesh.texcoords, "property float s\nproperty float t\n");
  visit(mesh.tangents, "property float tx\nproperty float ty\nproperty float tz\nproperty float tw\n");
}

constexpr std::string_view header_end = "end_header\n";

/// With the properties of those attributes that the mesh has.
std::string header_of(const Mesh& mesh, std::size_t faces) {
  std::string header =
      fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", mesh.vertex_count());
  for_each_property(mesh, [&](const auto& values, const char* lines) {
    const bool is_position = static_cast<const void*>(&values) == &mesh.positions;  // in an empty mesh too
    if (!values.empty() || is_position) header += lines;
  });
  return header +
         fmt::format("element face {}\nproperty list uchar int vertex_indices\n{}", faces, header_end);
}

}  // namespace

std::string to_ply(const Mesh& mesh) {
  std::string bytes = header_of(mesh, mesh.triangle_count());
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
    for_each_property(mesh, [&](const auto& values, const char*) {
      if (!values.empty()) append(bytes, values[v]);
    });
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    if (i % 3 == 0) append(bytes, std::uint8_t{3});
    append(bytes, mesh.indices[i]);
  }
  return bytes;
}

Mesh parse_ply(std::string_view bytes, const std::string& name) {
  const auto fail = [&name](const std::string& what) {
    return Error::failed(what, {name}, "write the file with --mesh");
  };
  const std::size_t end = std::min(bytes.find(header_end), bytes.size());
  const std::string_view header = bytes.substr(0, end + header_end.size());
  bytes.remove_prefix(header.size());
  const auto count = [&](std::string_view before) {
    std::uint32_t number = 0;
    if (const std::size_t at = header.find(before); at != std::string_view::npos)
      std::from_chars(header.data() + at + before.size(), header.data() + header.size(), number);
    return std::size_t{number};
  };
  const std::size_t vertices = count("element vertex "), faces = count("element face ");
  // Before anything is allocated: a header may promise more than there is.
  if (bytes.size() < vertices * sizeof(glm::vec3)) throw fail("the PLY file is cut off");
  Mesh mesh;
  std::size_t expected = faces * face_bytes;
  for_each_property(mesh, [&](auto& values, const char* lines) {
    if (header.find(lines) == std::string_view::npos) return;
    values.resize(vertices);
    expected += vertices * sizeof(values[0]);
  });
  if (header != header_of(mesh, faces)) throw fail("is not a PLY file as the labs write it");
  if (bytes.size() != expected)
    throw fail(fmt::format("the PLY file has {} bytes after its header, not {}", bytes.size(), expected));

  for (std::size_t v = 0; v < vertices; ++v)
    for_each_property(mesh, [&](auto& values, const char*) {
      if (values.empty()) return;
      values[v] = take<std::remove_reference_t<decltype(values[v])>>(bytes);
      for (int k = 0; k < values[v].length(); ++k)
        if (!std::isfinite(values[v][k])) throw fail(fmt::format("vertex {} is not finite", v));
    });
  mesh.indices.reserve(3 * faces);
  for (std::size_t f = 0; f < faces; ++f) {
    if (take<std::uint8_t>(bytes) != 3) throw fail(fmt::format("face {} is not a triangle", f));
    for (int k = 0; k < 3; ++k) mesh.indices.push_back(take<std::uint32_t>(bytes));
  }
  for (const std::uint32_t index : mesh.indices)
    if (index >= vertices) throw fail(fmt::format("a triangle names vertex {} of {}", index, vertices));
  return mesh;
}

}  // namespace texel::mesh
