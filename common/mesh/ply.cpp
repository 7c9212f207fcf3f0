// SPDX-License-Identifier: MIT
#include "mesh/ply.hpp"

#include <fmt/format.h>

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

/// Takes `expected` off the front if it stands there.
bool take_text(std::string_view& bytes, std::string_view expected) {
  if (!bytes.starts_with(expected)) return false;
  bytes.remove_prefix(expected.size());
  return true;
}

/// Calls `visit` with each attribute that a PLY file can hold, and its lines in the header.
template <class MeshType, class Visit>
void for_each_property(MeshType& mesh, Visit visit) {
  visit(mesh.positions, "property float x\nproperty float y\nproperty float z\n");
  visit(mesh.normals, "property float nx\nproperty float ny\nproperty float nz\n");
  visit(mesh.texcoords, "property float s\nproperty float t\n");
  visit(mesh.tangents, "property float tx\nproperty float ty\nproperty float tz\nproperty float tw\n");
}

constexpr std::string_view magic = "ply\nformat binary_little_endian 1.0\n";
constexpr std::string_view face_list = "property list uchar int vertex_indices\nend_header\n";

}  // namespace

std::string to_ply(const Mesh& mesh) {
  std::string bytes(magic);
  bytes += fmt::format("element vertex {}\n", mesh.vertex_count());
  std::size_t vertex_bytes = 0;
  for_each_property(mesh, [&](const auto& values, const char* lines) {
    const bool is_position = static_cast<const void*>(&values) == &mesh.positions;  // in an empty mesh too
    if (values.empty() && !is_position) return;
    bytes += lines;
    vertex_bytes += sizeof(values[0]);
  });
  bytes += fmt::format("element face {}\n{}", mesh.triangle_count(), face_list);
  bytes.reserve(bytes.size() + mesh.vertex_count() * vertex_bytes + mesh.triangle_count() * face_bytes);
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
    for_each_property(mesh, [&](const auto& values, const char*) {
      if (!values.empty()) append(bytes, values[v]);
    });
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    if (i % 3 == 0) append(bytes, std::uint8_t{3});
    append(bytes, static_cast<std::int32_t>(mesh.indices[i]));
  }
  return bytes;
}

Mesh parse_ply(std::string_view bytes, const std::string& name) {
  const auto fail = [&name](const std::string& what) {
    return Error::failed(what, {name}, "write the file with --mesh");
  };
  const auto take_count = [&](std::string_view before) {
    std::uint32_t count = 0;
    if (!take_text(bytes, before)) throw fail(fmt::format("'{}' expected in the PLY header", before));
    const auto [stop, error] = std::from_chars(bytes.data(), bytes.data() + bytes.size(), count);
    bytes.remove_prefix(static_cast<std::size_t>(stop - bytes.data()));
    if (error != std::errc{} || !take_text(bytes, "\n")) throw fail("a count is missing in the PLY header");
    return std::size_t{count};
  };

  if (!take_text(bytes, magic)) throw fail("not a binary little-endian PLY file");
  const std::size_t vertices = take_count("element vertex ");
  // Before anything is allocated: a header may promise more than there is.
  if (bytes.size() < vertices * sizeof(glm::vec3)) throw fail("the PLY file is cut off");
  Mesh mesh;
  std::size_t vertex_bytes = 0;
  for_each_property(mesh, [&](auto& values, const char* lines) {
    if (!take_text(bytes, lines)) return;
    values.resize(vertices);
    vertex_bytes += sizeof(values[0]);
  });
  if (mesh.positions.size() != vertices) throw fail("the PLY file has no x y z");
  const std::size_t faces = take_count("element face ");
  if (!take_text(bytes, face_list)) throw fail("a PLY property is unknown or in the wrong place");
  if (bytes.size() != vertices * vertex_bytes + faces * face_bytes)
    throw fail(fmt::format("the PLY file has {} bytes after its header, but the header says {}", bytes.size(),
                           vertices * vertex_bytes + faces * face_bytes));

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
    for (int k = 0; k < 3; ++k) {
      const auto index = take<std::int32_t>(bytes);
      if (index < 0 || static_cast<std::size_t>(index) >= vertices)
        throw fail(fmt::format("corner {} of triangle {} names vertex {}, but they run from 0 to {}", k + 1,
                               f + 1, index, static_cast<std::int64_t>(vertices) - 1));
      mesh.indices.push_back(static_cast<std::uint32_t>(index));
    }
  }
  return mesh;
}

}  // namespace texel::mesh
