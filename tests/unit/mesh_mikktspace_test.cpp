// SPDX-License-Identifier: MIT
// MikkTSpace: to the last bit what the plain version (support/plain_tangents.hpp) makes, whatever the mesh
// and the number of threads; and where the rules of its reference code are easily missed, small files whose
// tangents are worked out by hand from them, and two models that were compared with the reference code.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>

#include "../support/meshes.hpp"
#include "../support/plain_tangents.hpp"
#include "mesh/distinct.hpp"
#include "mesh/normals.hpp"
#include "mesh/obj.hpp"
#include "mesh/primitives.hpp"
#include "mesh/weld.hpp"

namespace texel::mesh {
namespace {

using glm::dvec3;

// ---- The plain version.

/// Triangles between points of a coarse grid: many corners coincide, many triangles are degenerate, repeated
/// or share an edge with more than one other.
Mesh heap(std::uint64_t seed, int triangles, unsigned steps) {
  Mesh mesh;
  std::uint64_t state = seed;
  const auto number = [&state](unsigned below) { return static_cast<float>((state = mix(state)) % below); };
  for (int i = 0; i < 3 * triangles; ++i) {
    mesh.positions.emplace_back(number(steps), number(steps), number(2));
    mesh.texcoords.emplace_back(number(steps), number(2) == 0.0F ? -0.0F : 0.0F);
    mesh.normals.push_back(number(4) == 0.0F ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1));
  }
  for (glm::vec2& st : mesh.texcoords) {
    st.t += number(steps);
    mesh.indices.push_back(static_cast<std::uint32_t>((state = mix(state)) % mesh.vertex_count()));
  }
  return mesh;
}

/// The torus with its texture mirrored in one half and shrunk to a point in a quarter.
Mesh mirrored_and_shrunk() {
  Mesh mesh = torus(1.0F, 0.4F, 60, 40, {0.5F, 3});
  for (glm::vec2& st : mesh.texcoords) {
    if (st.s > 0.75F) st = {0.75F, 0.5F};
    st.t = st.t > 0.5F ? 1.0F - st.t : st.t;
  }
  return mesh;
}

/// A round cap: around its tip, T is opposite in each two triangles that face each other.
Mesh cap(std::uint32_t segments) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}};
  mesh.texcoords = {{0.5F, 1}};
  for (std::uint32_t i = 0; i <= segments; ++i) {
    const double turn = static_cast<double>(i) / segments, angle = 6.283185307179586 * turn;
    mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
    mesh.texcoords.emplace_back(turn, 0);
    if (i > 0) mesh.indices.insert(mesh.indices.end(), {0, i, i + 1});
  }
  mesh.normals.assign(mesh.vertex_count(), {0, 0, 1});
  return mesh;
}

std::vector<std::pair<const char*, Mesh>> meshes() {
  Mesh smeared = torus(1.0F, 0.4F, 30, 20), point = smeared, faceted = smeared, tiny = smeared,
       unused = smeared;
  smeared.texcoords.assign(smeared.vertex_count(), glm::vec2(0.5F));
  point.positions.assign(point.vertex_count(), glm::vec3(1.0F));
  flat_normals(faceted);
  for (glm::vec3& p : tiny.positions) p *= 1e-20F;
  unused.indices.resize(unused.indices.size() / 2);
  std::vector<std::pair<const char*, Mesh>> all = {
      {"quad", quad()},
      {"sphere", sphere(24, 40)},
      {"sphere of separate triangles", split(sphere(24, 40))},
      {"rough torus", torus(1.0F, 0.4F, 60, 40, {0.5F, 3})},
      {"mirrored and shrunk", mirrored_and_shrunk()},
      {"mirrored and shrunk, separate triangles", split(mirrored_and_shrunk())},
      {"cap", cap(64)},
      {"cap of too many triangles to divide", cap(5000)},
      {"no triangle", Mesh{}},
      {"degenerate in the texture", smeared},
      {"degenerate in space", point},
      {"flat normals", faceted},
      {"tiny", tiny},
      {"vertices that no triangle uses", unused}};
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
    all.emplace_back("heap",
                     heap(seed, 20 + 10 * static_cast<int>(seed), 2 + static_cast<unsigned>(seed % 5)));
  return all;
}

template <class Value>
bool same_bits(const std::vector<Value>& a, const std::vector<Value>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), sizeof(Value) * a.size()) == 0);
}

bool same_bits(const Mesh& a, const Mesh& b) {
  return same_bits(a.indices, b.indices) && same_bits(a.positions, b.positions) &&
         same_bits(a.normals, b.normals) && same_bits(a.texcoords, b.texcoords) &&
         same_bits(a.tangents, b.tangents) && same_bits(a.bitangents, b.bitangents);
}

Mesh computed(Mesh mesh, TangentMethod method = TangentMethod::mikktspace, unsigned threads = 0) {
  compute_tangents(mesh, method, threads);
  return mesh;
}
Mesh plain(Mesh mesh) {
  plain_mikktspace(mesh);
  return mesh;
}

/// How many vertices MikkTSpace splits off.
std::size_t copies_of(const Mesh& mesh) {
  return computed(mesh).vertex_count() - mesh.vertex_count();
}

/// Unit tangents that lie in the plane of the normal, but where the method leaves them.
void expect_usable(const Mesh& mesh, TangentMethod method, const char* name) {
  ASSERT_EQ(mesh.tangents.size(), mesh.vertex_count());
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const glm::vec4& t = mesh.tangents[v];
    ASSERT_NEAR(glm::length(glm::vec3(t)), 1.0F, 1e-6F) << name << ", vertex " << v;
    ASSERT_EQ(std::abs(t.w), 1.0F) << name;
    // The plain average leans, and what MikkTSpace gives where it finds no tangent. A T that is nearly along
    // the normal loses digits in the projection: 1.1e-6 was measured.
    if (method != TangentMethod::averaged && t != glm::vec4(1, 0, 0, -1)) {
      ASSERT_NEAR(glm::dot(glm::vec3(t), mesh.normals[v]), 0.0F, 2e-6F) << name << ", vertex " << v;
    }
  }
}

TEST(TangentsPlain, are_usable_and_equal_the_plain_version_with_any_number_of_threads) {
  for (const auto& [name, mesh] : meshes())
    for (const TangentMethod method : test::tangent_methods) {
      const Mesh expected = method == TangentMethod::mikktspace ? plain(mesh) : computed(mesh, method, 1);
      expect_usable(expected, method, name);
      for (const unsigned threads : {0U, 1U, 2U, 3U, 7U})
        EXPECT_TRUE(same_bits(computed(mesh, method, threads), expected))
            << name << ", method " << static_cast<int>(method) << ", " << threads << " threads";
    }
  // Large enough for threads of its own.
  const Mesh large = split(torus(1.0F, 0.4F, 300, 200, {0.5F, 4}));
  EXPECT_TRUE(same_bits(computed(large), plain(large)));
}

TEST(Mikktspace, divides_a_cap_s_tip_up_to_4096_triangles) {
  // With an odd number none faces another exactly. Rounding decides whether two that do are opposite to the
  // last bit: measured 64 of 64 and 4017 of 4096.
  EXPECT_EQ(copies_of(cap(63)), 0U);
  EXPECT_GT(copies_of(cap(64)), 32U);
  EXPECT_GT(copies_of(cap(4096)), 2048U);
  EXPECT_EQ(copies_of(cap(4098)), 0U);
}

// ---- The reference code.

Mesh model(const std::string& name) {
  return weld(load_obj(std::filesystem::path(TEXEL_MODELS) / (name + ".obj")));
}

/// Tangent and sign of each corner.
std::vector<glm::vec4> corner_tangents(const Mesh& mesh) {
  const Mesh result = computed(mesh);
  std::vector<glm::vec4> tangents;
  for (const std::uint32_t v : result.indices) tangents.push_back(result.tangents[v]);
  return tangents;
}

void expect_corner(const glm::vec4& tangent, const dvec3& direction, std::size_t corner) {
  EXPECT_LT(glm::distance(dvec3(tangent), glm::normalize(direction)), 1e-6) << "corner " << corner;
  EXPECT_EQ(tangent.w, 1) << "corner " << corner;
}

TEST(MikktspaceReference, does_not_add_up_tangents_that_are_exactly_opposite) {
  // Four triangles around a tip, their T along the four sides of a square: up, left, down, right. At the tip
  // each counts itself and its two neighbours, which cancel, and not the one that faces it: T is its own.
  const dvec3 sides[] = {{0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 0, 0}};
  Mesh roof = model("hard/opposite_tangents");
  EXPECT_EQ(copies_of(roof), 3U) << "four vertices at the tip";
  const std::vector<glm::vec4> tangents = corner_tangents(roof);
  ASSERT_EQ(tangents.size(), 12U);
  for (std::size_t t = 0; t < 4; ++t) {
    expect_corner(tangents[3 * t], sides[t], 3 * t);
    // Along the rim two neighbours count alike; at the texture's seam one is alone.
    expect_corner(tangents[3 * t + 1], t > 0 ? sides[t - 1] + sides[t] : sides[t], 3 * t + 1);
    expect_corner(tangents[3 * t + 2], t < 3 ? sides[t] + sides[t + 1] : sides[t], 3 * t + 2);
  }
  // With a rim point moved by 1 % two sides are no longer parallel, and all four count in each other's sum.
  for (glm::vec3& p : roof.positions)
    if (p.x > 0 && p.y > 0) p.x *= 1.01F;
  EXPECT_EQ(copies_of(roof), 2U) << "up and down are not opposite now; left and right are";
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
    expect_corner(tangents[3 * i], unit[(i + 3) % 4] + unit[i] + unit[(i + 1) % 4], 3 * i);
}

TEST(MikktspaceReference, pairs_the_first_two_triangles_that_run_opposite_ways_along_an_edge) {
  // Seen along z: an edge upwards from A to B; two sheets to its left whose T are (1, -1) and (1, 1), and one
  // to its right, (1, 0), which runs along the edge the other way. It is the first sheet's neighbour.
  const dvec3 first = glm::normalize(dvec3(1, -1, 0)), second(1, 1, 0), right(1, 0, 0);
  const dvec3 at_a = 45.0 * first + 90.0 * right, at_b = 90.0 * first + 45.0 * right;
  const std::vector<dvec3> expected = {at_a, at_b, first, second, second, second, at_b, at_a, right};
  const std::vector<glm::vec4> tangents = corner_tangents(model("hard/three_at_an_edge"));
  ASSERT_EQ(tangents.size(), 9U);
  for (std::size_t c = 0; c < 9; ++c) expect_corner(tangents[c], expected[c], c);
}

TEST(MikktspaceReference, gives_1_0_0_and_minus_1_where_no_texture_area_reaches) {
  // The first triangle has T = (0, 1, 0). Over its long edge the second takes both ends' T, and its far
  // corner has none. The third only touches a corner: none there either. The last has two corners at one
  // place: it takes the T of any triangle at the same vertex, without an edge.
  const std::vector<bool> reached = {true,  true,  true,  true, true,  false,
                                     false, false, false, true, false, false};
  const std::vector<glm::vec4> tangents = corner_tangents(model("hard/no_texture_area"));
  ASSERT_EQ(tangents.size(), 12U);
  for (std::size_t c = 0; c < 12; ++c)
    if (reached[c])
      expect_corner(tangents[c], {0, 1, 0}, c);
    else
      EXPECT_EQ(tangents[c], glm::vec4(1, 0, 0, -1)) << c;
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
    digest.sum += static_cast<double>(mix(c) >> 11U) * 0x1p-53 * dvec3(tangents[c]);
    if (tangents[c].w < 0) ++digest.mirrored;
    glm::vec4& own = first[mesh.indices[c]];
    if (own.w == 0.0F) own = tangents[c];
    if (own.w != tangents[c].w || test::degrees_between(own, tangents[c]) > 1) ++digest.split;
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
    EXPECT_LT(glm::distance(ours.sum, reference.sum), 0.001) << name;
  }
}

}  // namespace
}  // namespace texel::mesh
