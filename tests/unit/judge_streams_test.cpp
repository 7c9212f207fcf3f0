// SPDX-License-Identifier: MIT
// How vertex streams are judged.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "judge/judge.hpp"
#include "mesh/ply.hpp"
#include "mesh/primitives.hpp"

namespace texel::judge {
namespace {

using mesh::Mesh;

class JudgeMesh : public testing::Test {
 protected:
  JudgeMesh() { of_.name = "m", of_.view = course::View::mesh, of_.limit = 0.05; }

  Verdict verdict(const Mesh& reference, const Mesh& picture) {
    const std::string expected = mesh::to_ply(reference);
    return judge(of_, {expected, {}}, mesh::to_ply(picture));
  }

  course::Case of_;
};

/// A flat pentagon with a dent, cut in one of two right ways or as a fan, which leaves it.
Mesh dented(std::vector<std::uint32_t> indices) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 0.5F, 0}, {0, 2, 0}};
  mesh.normals.assign(5, {0, 0, 1});
  mesh.indices = std::move(indices);
  return mesh;
}
const std::vector<std::uint32_t> kOneCut = {0, 1, 3, 1, 2, 3, 0, 3, 4};
const std::vector<std::uint32_t> kAnotherOrder = {4, 0, 3, 3, 0, 1, 2, 3, 1};

TEST_F(JudgeMesh, takes_any_order_of_vertices_and_triangles) {
  Mesh reference = mesh::torus(0.7F, 0.3F, 24, 12);
  Mesh reversed = reference;
  std::reverse(reversed.positions.begin(), reversed.positions.end());
  std::reverse(reversed.normals.begin(), reversed.normals.end());
  std::reverse(reversed.texcoords.begin(), reversed.texcoords.end());
  const auto last = static_cast<std::uint32_t>(reference.vertex_count() - 1);
  for (std::uint32_t& index : reversed.indices) index = last - index;
  std::rotate(reversed.indices.begin(), reversed.indices.begin() + 30, reversed.indices.end());
  EXPECT_TRUE(verdict(reference, reversed).passed) << verdict(reference, reversed).message;
  EXPECT_TRUE(verdict(dented(kOneCut), dented(kAnotherOrder)).passed);
}

TEST_F(JudgeMesh, takes_every_right_cut_of_a_flat_polygon_and_no_fan_beyond_it) {
  Mesh square = dented({0, 1, 2, 0, 2, 4}), other = dented({0, 1, 4, 1, 2, 4});
  square.positions[3] = other.positions[3] = {5, 5, 5};
  EXPECT_TRUE(verdict(square, other).passed) << verdict(square, other).message;
  const Verdict fan = verdict(dented(kOneCut), dented({0, 1, 2, 0, 2, 3, 0, 3, 4}));
  EXPECT_FALSE(fan.passed);
  EXPECT_EQ(fan.score, 0);
}

TEST_F(JudgeMesh, sees_a_flipped_triangle_a_turned_normal_and_a_lost_handedness) {
  Mesh reference = mesh::torus(0.7F, 0.3F, 24, 12);
  reference.tangents.assign(reference.vertex_count(), {1, 0, 0, 1});
  Mesh flipped = reference;
  std::swap(flipped.indices[0], flipped.indices[1]);
  EXPECT_FALSE(verdict(reference, flipped).passed);
  const auto says = [&](const Mesh& own, const char* what) {
    const std::string message = verdict(reference, own).message;
    EXPECT_NE(message.find(what), std::string::npos) << message;
  };
  says(flipped, "of the others, triangles are wrong, by up to ");
  Mesh turned = reference;
  for (glm::vec3& normal : turned.normals) normal = {normal.x, -normal.y, normal.z};
  EXPECT_FALSE(verdict(reference, turned).passed);
  says(turned, "of the others, normals are wrong, by up to ");
  Mesh moved = reference;
  for (glm::vec3& position : moved.positions) position.x += 2;
  says(moved, "of the others, places or texture coordinates are wrong.");
  Mesh handed = reference;
  for (std::size_t i = 0; i < 10; ++i) handed.tangents[i].w = -1;
  const Verdict found = verdict(reference, handed);
  EXPECT_FALSE(found.passed);
  EXPECT_EQ(found.score, 0);
  says(handed, "97 % of the vertices are right; of the others, the tangents' signs w (1 or -1) are wrong.");
  handed = reference;
  for (std::size_t i = 0; i < 10; ++i) handed.tangents[i].w = 0.9F;
  EXPECT_EQ(verdict(reference, handed).score, 0) << "w multiplies the bitangent: it is a sign alone";
  handed.tangents.clear();
  says(handed, "other attributes");
}

TEST_F(JudgeMesh, counts_vertices_that_are_too_many) {
  const Mesh reference = mesh::torus(0.7F, 0.3F, 24, 12);
  Mesh twice = reference;
  const auto count = static_cast<std::uint32_t>(reference.vertex_count());
  twice.positions.insert(twice.positions.end(), reference.positions.begin(), reference.positions.end());
  twice.normals.insert(twice.normals.end(), reference.normals.begin(), reference.normals.end());
  twice.texcoords.insert(twice.texcoords.end(), reference.texcoords.begin(), reference.texcoords.end());
  for (std::size_t i = 0; i < twice.indices.size() / 2; ++i) twice.indices[i] += count;
  const Verdict found = verdict(reference, twice);
  EXPECT_FALSE(found.passed);
  EXPECT_EQ(found.score, 0) << "though each expected one is there";
  EXPECT_NE(found.message.find("650 vertices instead of 325"), std::string::npos) << found.message;
}

TEST_F(JudgeMesh, scores_an_angle_by_how_many_limits_it_is_off) {
  const Mesh reference = mesh::torus(0.7F, 0.3F, 24, 12);
  Mesh turned = reference;
  const float angle = glm::radians(0.15F);
  for (glm::vec3& normal : turned.normals)
    normal = {std::cos(angle) * normal.x - std::sin(angle) * normal.z, normal.y,
              std::sin(angle) * normal.x + std::cos(angle) * normal.z};
  const Verdict found = verdict(reference, turned);
  EXPECT_FALSE(found.passed);
  EXPECT_NEAR(found.score, 0.25, 0.01) << "three times the limit";
}

TEST_F(JudgeMesh, refuses_what_is_no_stream) {
  const Mesh reference = mesh::torus(0.7F, 0.3F, 24, 12);
  const std::string stream = mesh::to_ply(reference);
  const Verdict broken = judge(
      of_, {stream, {}}, "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nend_header\n");
  EXPECT_EQ(broken.score, 0);
  EXPECT_TRUE(broken.message.starts_with("The vertex stream")) << broken.message;
  EXPECT_EQ(judge(of_, {stream, {}}, std::nullopt).score, 0);
}

}  // namespace
}  // namespace texel::judge
