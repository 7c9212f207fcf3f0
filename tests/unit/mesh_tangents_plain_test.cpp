// SPDX-License-Identifier: MIT
// The tangents of MikkTSpace's rules against the same step by step (support/plain_tangents.hpp): to the last
// bit, whatever the mesh and the number of threads.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

#include "../support/plain_tangents.hpp"
#include "mesh/distinct.hpp"
#include "mesh/normals.hpp"
#include "mesh/primitives.hpp"
#include "mesh/tangents.hpp"
#include "mesh/weld.hpp"

namespace texel::mesh {
namespace {

template <class Value>
bool same_bits(const std::vector<Value>& a, const std::vector<Value>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), sizeof(Value) * a.size()) == 0);
}

void expect_same(const Mesh& expected, const Mesh& mesh, const char* what) {
  EXPECT_TRUE(same_bits(expected.indices, mesh.indices)) << what;
  EXPECT_TRUE(same_bits(expected.positions, mesh.positions)) << what;
  EXPECT_TRUE(same_bits(expected.normals, mesh.normals)) << what;
  EXPECT_TRUE(same_bits(expected.texcoords, mesh.texcoords)) << what;
  EXPECT_TRUE(same_bits(expected.tangents, mesh.tangents)) << what;
  EXPECT_TRUE(same_bits(expected.bitangents, mesh.bitangents)) << what;
}

void expect_same(const TangentReport& expected, const TangentReport& report, const char* what) {
  EXPECT_EQ(expected.degenerate_triangles, report.degenerate_triangles) << what;
  EXPECT_EQ(expected.fallback_vertices, report.fallback_vertices) << what;
  EXPECT_EQ(expected.split_vertices, report.split_vertices) << what;
}

/// Triangles between points of a coarse grid: many corners coincide, many triangles are degenerate, repeated
/// or share an edge with more than one other.
Mesh heap(std::uint64_t seed, int triangles, unsigned steps) {
  Mesh mesh;
  std::uint64_t state = seed;
  const auto number = [&state](unsigned below) { return static_cast<float>((state = mix(state)) % below); };
  for (int i = 0; i < 3 * triangles; ++i) {
    mesh.positions.emplace_back(number(steps), number(steps), number(2));
    mesh.texcoords.emplace_back(number(steps), number(2) == 0.0f ? -0.0f : 0.0f);
    mesh.normals.push_back(number(4) == 0.0f ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1));
  }
  for (int i = 0; i < 3 * triangles; ++i) {
    const auto count = static_cast<unsigned>(3 * triangles);
    mesh.texcoords[static_cast<std::size_t>(i)].t += number(steps);
    mesh.indices.push_back(static_cast<std::uint32_t>((state = mix(state)) % count));
  }
  return mesh;
}

/// The torus with its texture mirrored in one half and shrunk to a point in a quarter.
Mesh mirrored_and_shrunk() {
  Mesh mesh = torus(1.0f, 0.4f, 60, 40, {0.5f, 3});
  for (glm::vec2& st : mesh.texcoords) {
    if (st.s > 0.75f) st = {0.75f, 0.5f};
    st.t = st.t > 0.5f ? 1.0f - st.t : st.t;
  }
  return mesh;
}

/// A round cap: around its tip, T is opposite in each two triangles that face each other.
Mesh cap(std::uint32_t segments) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}};
  mesh.texcoords = {{0.5f, 1}};
  for (std::uint32_t i = 0; i <= segments; ++i) {
    const double turn = static_cast<double>(i) / segments, angle = 6.283185307179586 * turn;
    mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
    mesh.texcoords.emplace_back(turn, 0);
    if (i > 0) mesh.indices.insert(mesh.indices.end(), {0, i, i + 1});
  }
  mesh.normals.assign(mesh.vertex_count(), {0, 0, 1});
  return mesh;
}

struct Case {
  const char* name;
  Mesh mesh;
};

std::vector<Case> cases() {
  std::vector<Case> all = {{"quad", quad()},
                           {"sphere", sphere(24, 40)},
                           {"sphere of separate triangles", split(sphere(24, 40))},
                           {"rough torus", torus(1.0f, 0.4f, 60, 40, {0.5f, 3})},
                           {"mirrored and shrunk", mirrored_and_shrunk()},
                           {"mirrored and shrunk, separate triangles", split(mirrored_and_shrunk())},
                           {"cap", cap(64)},
                           {"cap of too many triangles to divide", cap(5000)},
                           {"no triangle", Mesh{}}};
  Mesh flat = torus(1.0f, 0.4f, 30, 20);
  flat.texcoords.assign(flat.vertex_count(), glm::vec2(0.5f));
  all.push_back({"degenerate in the texture", flat});
  flat = torus(1.0f, 0.4f, 30, 20);
  flat.positions.assign(flat.vertex_count(), glm::vec3(1.0f));
  all.push_back({"degenerate in space", flat});
  Mesh faceted = torus(1.0f, 0.4f, 30, 20);
  flat_normals(faceted);
  all.push_back({"flat normals", faceted});
  Mesh tiny = torus(1.0f, 0.4f, 30, 20);
  for (glm::vec3& p : tiny.positions) p *= 1e-20f;
  all.push_back({"tiny", tiny});
  Mesh unused = torus(1.0f, 0.4f, 12, 9);
  unused.indices.resize(unused.indices.size() / 2);
  all.push_back({"vertices that no triangle uses", unused});
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
    all.push_back(
        {"heap", heap(seed, 20 + 10 * static_cast<int>(seed), 2 + static_cast<unsigned>(seed % 5))});
  return all;
}

TEST(MikktspacePlain, equals_the_plain_version_with_any_number_of_threads) {
  for (const Case& c : cases()) {
    Mesh expected = c.mesh;
    const TangentReport report = plain_mikktspace(expected);
    for (const unsigned threads : {0U, 1U, 2U, 3U, 7U}) {
      Mesh mesh = c.mesh;
      expect_same(report, compute_tangents(mesh, TangentMethod::mikktspace, threads), c.name);
      expect_same(expected, mesh, c.name);
    }
  }
}

TEST(MikktspacePlain, divides_a_cap_s_tip_up_to_4096_triangles) {
  // With an odd number none faces another exactly. Rounding decides whether two that do are opposite to the
  // last bit: measured 64 of 64 and 4017 of
  // 4096.
  const auto copies = [](std::uint32_t segments) {
    Mesh mesh = cap(segments);
    return compute_tangents(mesh, TangentMethod::mikktspace).split_vertices;
  };
  EXPECT_EQ(copies(63), 0U);
  EXPECT_GT(copies(64), 32U);
  EXPECT_GT(copies(4096), 2048U);
  EXPECT_EQ(copies(4098), 0U);
}

TEST(Tangents, are_the_same_by_every_method_with_any_number_of_threads) {
  for (const Case& c : cases())
    for (const TangentMethod method : {TangentMethod::averaged, TangentMethod::gram_schmidt,
                                       TangentMethod::angle_weighted, TangentMethod::mikktspace}) {
      Mesh expected = c.mesh;
      const TangentReport report = compute_tangents(expected, method, 1);
      for (const unsigned threads : {2U, 3U, 7U}) {
        Mesh mesh = c.mesh;
        expect_same(report, compute_tangents(mesh, method, threads), c.name);
        expect_same(expected, mesh, c.name);
      }
    }
}

TEST(MikktspacePlain, is_the_same_in_a_mesh_that_is_large_enough_for_threads_of_its_own) {
  const Mesh whole = split(torus(1.0f, 0.4f, 300, 200, {0.5f, 4}));
  Mesh expected = whole, mesh = whole;
  plain_mikktspace(expected);
  compute_tangents(mesh, TangentMethod::mikktspace);
  expect_same(expected, mesh, "120 thousand triangles");
}

}  // namespace
}  // namespace texel::mesh
