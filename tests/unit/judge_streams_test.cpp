// SPDX-License-Identifier: MIT
// How vertex streams are judged.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "../support/said.hpp"
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

const Mesh kTorus = mesh::torus(0.7F, 0.3F, 24, 12);

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
  Mesh reversed = kTorus;
  std::reverse(reversed.positions.begin(), reversed.positions.end());
  std::reverse(reversed.normals.begin(), reversed.normals.end());
  std::reverse(reversed.texcoords.begin(), reversed.texcoords.end());
  const auto last = static_cast<std::uint32_t>(kTorus.vertex_count() - 1);
  for (std::uint32_t& index : reversed.indices) index = last - index;
  std::rotate(reversed.indices.begin(), reversed.indices.begin() + 30, reversed.indices.end());
  EXPECT_TRUE(verdict(kTorus, reversed).passed) << verdict(kTorus, reversed).message;
  EXPECT_TRUE(verdict(dented(kOneCut), dented(kAnotherOrder)).passed);
  Mesh beyond = dented(kAnotherOrder);  // the corners lie on the borders of the cells that they are found by
  for (glm::vec3& position : beyond.positions) position -= 2e-5F;
  EXPECT_TRUE(verdict(dented(kOneCut), beyond).passed);
}

TEST_F(JudgeMesh, takes_every_right_cut_of_a_flat_polygon_and_no_fan_beyond_it) {
  Mesh square = dented({0, 1, 2, 0, 2, 4}), other = dented({0, 1, 4, 1, 2, 4});
  square.positions[3] = other.positions[3] = {5, 5, 5};
  EXPECT_TRUE(verdict(square, other).passed) << verdict(square, other).message;
  const Verdict fan = verdict(dented(kOneCut), dented({0, 1, 2, 0, 2, 3, 0, 3, 4}));
  EXPECT_FALSE(fan.passed);
  EXPECT_EQ(fan.score, 0);
}

TEST_F(JudgeMesh, sees_what_is_wrong_and_says_it) {
  Mesh reference = kTorus;
  reference.tangents.assign(reference.vertex_count(), {1, 0, 0, 1});
  const auto sign = [](float w) {
    return [w](Mesh& mesh) {
      for (std::size_t i = 0; i < 10; ++i) mesh.tangents[i].w = w;
    };
  };
  const char* const signs = "; so are 10 of 325 vertices wrong.";
  const std::pair<std::function<void(Mesh&)>, const char*> rows[] = {
      {[](Mesh& mesh) { std::swap(mesh.indices[0], mesh.indices[1]); },
       "Triangles are wrong; 99 % of the expected vertices are there and right."},
      {[](Mesh& mesh) {
         for (glm::vec3& normal : mesh.normals) normal.y = -normal.y;
       },
       ", a corner of triangle 2, is (0, -0.5, 0.866) and not (0, 0.5, 0.866), but that of the one at (0, "},
      {[](Mesh& mesh) {
         for (glm::vec3& position : mesh.positions) position.x += 2;
       },
       "The place of the vertex at "},
      {sign(-1), signs},
      {sign(0.9F), signs},  // w multiplies the bitangent: it is a sign alone
      {[](Mesh& mesh) { mesh.tangents.clear(); }, "other attributes"}};
  for (const auto& [spoil, says] : rows) {
    Mesh own = reference;
    spoil(own);
    const Verdict found = verdict(reference, own);
    EXPECT_FALSE(found.passed) << says;
    EXPECT_EQ(found.score, 0) << says;
    EXPECT_TRUE(test::has(found.message, says)) << found.message;
  }
}

TEST_F(JudgeMesh, counts_vertices_that_are_too_many) {
  Mesh twice = kTorus;
  const auto count = static_cast<std::uint32_t>(kTorus.vertex_count());
  twice.positions.insert(twice.positions.end(), kTorus.positions.begin(), kTorus.positions.end());
  twice.normals.insert(twice.normals.end(), kTorus.normals.begin(), kTorus.normals.end());
  twice.texcoords.insert(twice.texcoords.end(), kTorus.texcoords.begin(), kTorus.texcoords.end());
  for (const std::uint32_t index : kTorus.indices) twice.indices.push_back(index + count);
  const Verdict found = verdict(kTorus, twice);
  EXPECT_FALSE(found.passed);
  EXPECT_EQ(found.score, 0) << "though each expected one is there";
  EXPECT_TRUE(test::has(found.message, "650 vertices instead of 325")) << found.message;
}

TEST_F(JudgeMesh, takes_an_error_that_is_just_the_limit) {
  Mesh moved = kTorus, more = kTorus;
  moved.positions[7] = more.positions[7] = {9, 9, 9};
  of_.limit = 180;  // how far off a vertex at another place counts
  EXPECT_TRUE(verdict(kTorus, moved).passed);
  for (const auto attribute : {&Mesh::positions, &Mesh::normals}) (more.*attribute).push_back({9, 9, 9});
  more.texcoords.emplace_back(9, 9);
  const std::string message = verdict(kTorus, more).message;
  EXPECT_TRUE(test::has(message, "326 vertices instead of 325; 100 % of the expected")) << message;
}

TEST_F(JudgeMesh, compares_vertex_by_vertex_where_half_of_the_places_are_the_same) {
  for (const auto& [wrong, says] :
       {std::pair(2, "The place of the vertex at "), {3, "0 % of the expected"}}) {
    Mesh expected = mesh::quad(), own = expected;
    for (glm::vec2& texcoord : own.texcoords) texcoord += 5.0F;
    for (int i = 0; i < wrong; ++i) own.positions[static_cast<std::size_t>(i)] += 5.0F;
    EXPECT_TRUE(verdict(expected, own).message.starts_with(says)) << verdict(expected, own).message;
  }
}

TEST_F(JudgeMesh, scores_an_angle_by_how_many_limits_it_is_off) {
  Mesh turned = kTorus;
  const float angle = glm::radians(0.15F);
  for (glm::vec3& normal : turned.normals)
    normal = {std::cos(angle) * normal.x - std::sin(angle) * normal.z, normal.y,
              std::sin(angle) * normal.x + std::cos(angle) * normal.z};
  const Verdict found = verdict(kTorus, turned);
  EXPECT_FALSE(found.passed);
  EXPECT_NEAR(found.score, 0.25, 0.01) << "three times the limit";
}

TEST_F(JudgeMesh, refuses_what_is_no_stream) {
  const std::string stream = mesh::to_ply(kTorus);
  const Verdict broken = judge(
      of_, {stream, {}}, "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nend_header\n");
  EXPECT_EQ(broken.score, 0);
  EXPECT_TRUE(broken.message.starts_with("The vertex stream")) << broken.message;
  EXPECT_EQ(judge(of_, {stream, {}}, std::nullopt).score, 0);
}

}  // namespace
}  // namespace texel::judge
