// SPDX-License-Identifier: MIT
#include "mesh/ply.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "mesh/primitives.hpp"

namespace texel::mesh {
namespace {

/// A sphere of 33 vertices and 36 faces, with tangents.
Mesh full() {
  Mesh mesh = sphere(4, 6);
  revolution_tangents(mesh);
  return mesh;
}

TEST(Ply, gives_back_what_was_written_in_every_combination) {
  for (int kept = 0; kept < 8; ++kept) {
    Mesh mesh = full();
    if ((kept & 1) == 0) mesh.normals.clear();
    if ((kept & 2) == 0) mesh.texcoords.clear();
    if ((kept & 4) == 0) mesh.tangents.clear();
    const Mesh back = parse_ply(to_ply(mesh), "test.ply");
    EXPECT_EQ(back.positions, mesh.positions);
    EXPECT_EQ(back.normals, mesh.normals);
    EXPECT_EQ(back.texcoords, mesh.texcoords);
    EXPECT_EQ(back.tangents, mesh.tangents);
    EXPECT_EQ(back.indices, mesh.indices);
  }
  EXPECT_EQ(parse_ply(to_ply(Mesh{}), "empty.ply").vertex_count(), 0U);
}

TEST(Ply, has_the_header_that_scripts_outside_read) {
  const std::string bytes = to_ply(full());
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 33\n"
      "property float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\n"
      "property float nz\nproperty float s\nproperty float t\nproperty float tx\nproperty float ty\n"
      "property float tz\nproperty float tw\nelement face 36\n"
      "property list uchar int vertex_indices\nend_header\n";
  EXPECT_EQ(bytes.substr(0, header.size()), header);
  EXPECT_EQ(bytes.size(), header.size() + 33 * 48 + 36 * 13);
}

TEST(Ply, refuses_what_it_did_not_write) {
  const std::string good = to_ply(full());
  const auto replaced = [&good](std::size_t at, std::size_t length, const std::string& by) {
    return std::string(good).replace(at, length, by);
  };
  const auto in_header = [&](const std::string& what, const std::string& by) {
    return replaced(good.find(what), what.size(), by);
  };
  const std::size_t last_index = good.size() - 4, last_face = good.size() - 13;
  EXPECT_NO_THROW(parse_ply(replaced(last_index, 4, std::string("\x20\0\0\0", 4)), "32.ply"));
  for (const std::string& bad :
       {std::string(), std::string("ply\n"), good.substr(0, 100), good.substr(0, good.size() - 1), good + "x",
        in_header("binary_little", "binary_big"), in_header("float nx", "float xx"),
        in_header("vertex 33", "vertex 34"), in_header("vertex 33", "vertex 4294967295"),
        in_header("vertex 33", "vertex x"), in_header("face 36", "face 99999999999"),
        replaced(last_index, 4, std::string("\x21\0\0\0", 4)), replaced(last_index, 4, "\xFF\xFF\xFF\x7F"),
        replaced(last_face, 1, "\x04"),
        replaced(good.find("end_header\n") + 11, 4, std::string("\0\0\xC0\x7F", 4))})  // not a number
    EXPECT_THROW(parse_ply(bad, "bad.ply"), Error);
}

}  // namespace
}  // namespace texel::mesh
