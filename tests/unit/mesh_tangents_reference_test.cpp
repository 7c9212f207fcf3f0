// SPDX-License-Identifier: MIT
// MikkTSpace where the rules of its reference code are easily missed: small files whose tangents are worked
// out by hand from them, and two models whose tangents were compared with the reference code's.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "mesh/distinct.hpp"
#include "mesh/obj.hpp"
#include "mesh/tangents.hpp"
#include "mesh/vectors.hpp"
#include "mesh/weld.hpp"

namespace texel::mesh {
namespace {

using glm::dvec3;

Mesh model(const std::string& name) {
  return weld(load_obj(std::filesystem::path(TEXEL_MODELS) / (name + ".obj")));
}

/// Tangent and sign of each corner.
std::vector<glm::vec4> corner_tangents(Mesh mesh, TangentReport* report = nullptr) {
  const TangentReport met = compute_tangents(mesh, TangentMethod::mikktspace);
  if (report != nullptr) *report = met;
  std::vector<glm::vec4> tangents;
  for (const std::uint32_t v : mesh.indices) tangents.push_back(mesh.tangents[v]);
  return tangents;
}

void expect_corner(const glm::vec4& tangent, const dvec3& direction, float sign, std::size_t corner) {
  const dvec3 expected = glm::normalize(direction);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(tangent[k], expected[k], 1e-6) << "corner " << corner;
  EXPECT_EQ(tangent.w, sign) << "corner " << corner;
}

TEST(MikktspaceReference, does_not_add_up_tangents_that_are_exactly_opposite) {
  // Four triangles around a tip, their T along the four sides of a square: up, left, down, right. At the tip
  // each counts itself and its two neighbours, which cancel, and not the one that faces it: T is its own.
  const dvec3 sides[] = {{0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 0, 0}};
  TangentReport report;
  const std::vector<glm::vec4> tangents = corner_tangents(model("hard/opposite_tangents"), &report);
  ASSERT_EQ(tangents.size(), 12U);
  EXPECT_EQ(report.split_vertices, 3U) << "four vertices at the tip";
  EXPECT_EQ(report.fallback_vertices, 0U);
  for (std::size_t t = 0; t < 4; ++t) {
    expect_corner(tangents[3 * t], sides[t], 1, 3 * t);
    // Along the rim two neighbours count alike; at the texture's seam one is alone.
    expect_corner(tangents[3 * t + 1], t > 0 ? sides[t - 1] + sides[t] : sides[t], 1, 3 * t + 1);
    expect_corner(tangents[3 * t + 2], t < 3 ? sides[t] + sides[t + 1] : sides[t], 1, 3 * t + 2);
  }
}

TEST(MikktspaceReference, adds_up_tangents_that_are_nearly_opposite) {
  // The same roof with its tip a little aside: T stays along the sides. With a rim point moved by 1 % two
  // sides are no longer parallel, and all four count in each other's sum.
  Mesh mesh = model("hard/opposite_tangents");
  for (glm::vec3& p : mesh.positions)
    if (p.x > 0 && p.y > 0) p.x *= 1.01F;
  EXPECT_EQ(compute_tangents(mesh, TangentMethod::mikktspace).split_vertices, 2U)
      << "up and down are not opposite now; left and right are";
}

TEST(MikktspaceReference, does_not_add_up_triangles_whose_bitangents_are_exactly_opposite) {
  // The roof with its texture turned by a quarter: now B runs along the sides, and T is what B was.
  Mesh mesh = model("hard/opposite_tangents");
  for (glm::vec2& st : mesh.texcoords) st = {st.t, -st.s};
  // Of triangle i, with P(i) - tip = s T + t B before the turn, s = i/4 - 1/2, t = -1 and T = 4 (P(i+1) -
  // P(i)).
  const dvec3 rim[] = {{1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}};
  std::array<dvec3, 4> unit;
  for (std::size_t i = 0; i < 4; ++i)
    unit[i] = glm::normalize((static_cast<double>(i) / 4 - 0.5) * 4.0 * (rim[(i + 1) % 4] - rim[i]) - rim[i]);
  const std::vector<glm::vec4> tangents = corner_tangents(mesh);
  for (std::size_t i = 0; i < 4; ++i)  // each counts all at the tip but the one that faces it
    expect_corner(tangents[3 * i], unit[(i + 3) % 4] + unit[i] + unit[(i + 1) % 4], 1, 3 * i);
}

TEST(MikktspaceReference, pairs_the_first_two_triangles_that_run_opposite_ways_along_an_edge) {
  // Seen along z: an edge upwards from A to B; two sheets to its left whose T are (1, -1) and (1, 1), and one
  // to its right, (1, 0), which runs along the edge the other way. It is the first sheet's neighbour.
  const std::vector<glm::vec4> tangents = corner_tangents(model("hard/three_at_an_edge"));
  ASSERT_EQ(tangents.size(), 9U);
  const dvec3 first = glm::normalize(dvec3(1, -1, 0)), right(1, 0, 0);
  const dvec3 at_a = 45.0 * first + 90.0 * right, at_b = 90.0 * first + 45.0 * right;
  expect_corner(tangents[0], at_a, 1, 0);
  expect_corner(tangents[1], at_b, 1, 1);
  expect_corner(tangents[2], first, 1, 2);
  for (std::size_t c = 3; c < 6; ++c) expect_corner(tangents[c], {1, 1, 0}, 1, c);
  expect_corner(tangents[6], at_b, 1, 6);
  expect_corner(tangents[7], at_a, 1, 7);
  expect_corner(tangents[8], right, 1, 8);
}

TEST(MikktspaceReference, gives_1_0_0_and_minus_1_where_no_texture_area_reaches) {
  const std::vector<glm::vec4> tangents = corner_tangents(model("hard/no_texture_area"));
  ASSERT_EQ(tangents.size(), 12U);
  const glm::vec4 nothing(1, 0, 0, -1);
  for (std::size_t c = 0; c < 3; ++c) expect_corner(tangents[c], {0, 1, 0}, 1, c);
  // Over its long edge the second triangle takes both ends' T, and its far corner has none.
  expect_corner(tangents[3], {0, 1, 0}, 1, 3);
  expect_corner(tangents[4], {0, 1, 0}, 1, 4);
  EXPECT_EQ(tangents[5], nothing);
  // The third only touches a corner: none there either.
  for (std::size_t c = 6; c < 9; ++c) EXPECT_EQ(tangents[c], nothing) << c;
  // The last has two corners at one place: it takes the T of any triangle at the same vertex, without an
  // edge.
  expect_corner(tangents[9], {0, 1, 0}, 1, 9);
  EXPECT_EQ(tangents[10], nothing);
  EXPECT_EQ(tangents[11], nothing);
}

TEST(MikktspaceReference, takes_every_texture_area_that_float_can_hold) {
  // On a line but for the rounding of 0.1, 0.3 and 0.9: an area of 1e-8 counts, as in the reference, where
  // the other methods see a line.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  mesh.texcoords = {{0, 0}, {0.1F, 0.3F}, {0.3F, 0.9F}};
  mesh.normals.assign(3, {0, 0, 1});
  mesh.indices = {0, 1, 2};
  Mesh other = mesh;
  EXPECT_EQ(compute_tangents(mesh, TangentMethod::mikktspace).degenerate_triangles, 0U);
  EXPECT_EQ(compute_tangents(other, TangentMethod::angle_weighted).degenerate_triangles, 1U);
}

TEST(MikktspaceReference, keeps_a_sum_of_zero_out) {
  // T along the normal: nothing of it lies in the plane. The reference writes (0, 0, 0) there; we, any vector
  // in the plane.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.texcoords = {{0, 0}, {1, 0}, {0, 1}};
  mesh.normals.assign(3, {1, 0, 0});
  mesh.indices = {0, 1, 2};
  EXPECT_EQ(compute_tangents(mesh, TangentMethod::mikktspace).fallback_vertices, 3U);
  for (const glm::vec4& tangent : mesh.tangents) {
    EXPECT_EQ(tangent.x, 0.0F);
    EXPECT_NEAR(glm::length(glm::vec3(tangent)), 1, 1e-6);
    EXPECT_EQ(tangent.w, 1.0F);
  }
}

/// What is left of all corners' tangents when each is weighted by a number from its own: another tangent at
/// one corner moves it. And the corners whose sign is -1, or whose tangent is more than a degree from that of
/// the first corner of the same vertex: where the vertex was split.
struct Digest {
  std::size_t corners = 0, mirrored = 0, split = 0;
  dvec3 sum{0.0};
};

Digest digest(const Mesh& mesh) {
  const std::vector<glm::vec4> tangents = corner_tangents(mesh);
  Digest digest{.corners = tangents.size()};
  std::vector<glm::vec4> first(mesh.vertex_count(), glm::vec4(0.0F));
  for (std::size_t c = 0; c < tangents.size(); ++c) {
    const dvec3 tangent(tangents[c]);
    digest.sum += static_cast<double>(mix(c) >> 11U) * 0x1p-53 * tangent;
    if (tangents[c].w < 0) ++digest.mirrored;
    glm::vec4& own = first[mesh.indices[c]];
    if (own.w == 0.0F) own = tangents[c];
    if (own.w != tangents[c].w || glm::degrees(angle_between(dvec3(own), tangent)) > 1) ++digest.split;
  }
  return digest;
}

TEST(MikktspaceReference, equals_the_reference_code_on_the_ship_and_the_gator) {
  // From the reference code itself (mikktspace.c, genTangSpaceDefault, on the same triangles; not part of
  // this project): the same sums were taken over its tangents. Ours were equal at every corner to the last
  // bit. A tangent that is off by a degree moves the sum by up to 0.017, and half a turn by up to 2; rounding
  // of 50 thousand corners in another library's arc cosine, 1e-7 each, by less than 0.001.
  const std::pair<const char*, Digest> expected[] = {
      {"ship", {54354, 0, 2175, {1523.14960, -23.75308, -18.54009}}},
      {"gator", {45954, 0, 630, {-48.75962, 79.69250, -87.74883}}}};
  for (const auto& [name, reference] : expected) {
    const Digest ours = digest(model(name));
    EXPECT_EQ(ours.corners, reference.corners) << name;
    EXPECT_EQ(ours.mirrored, reference.mirrored) << name;
    EXPECT_EQ(ours.split, reference.split) << name;
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(ours.sum[k], reference.sum[k], 0.001) << name;
  }
}

}  // namespace
}  // namespace texel::mesh
