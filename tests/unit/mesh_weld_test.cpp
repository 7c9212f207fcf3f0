// SPDX-License-Identifier: MIT
#include "mesh/weld.hpp"

#include <gtest/gtest.h>

#include <string>

#include "cube.hpp"
#include "mesh/distinct.hpp"
#include "mesh/normals.hpp"
#include "mesh/primitives.hpp"
#include "mesh/tangents.hpp"
#include "steps.hpp"

namespace texel::mesh {
namespace {

using namespace cube_wrap;
using cube_wrap::weld;

ObjData square(const std::string& text) {
  return parse_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n" + text, "test.obj");
}

TEST(Distinct, numbers_things_by_first_appearance_however_they_hash) {
  for (const bool colliding : {false, true}) {
    DistinctTable table;
    std::vector<std::uint32_t> things;
    for (std::uint32_t i = 0; i < 3000; ++i) {
      const std::uint32_t thing = i % 1000;
      const std::uint32_t n =
          table.number(colliding ? 42 : mix(thing), [&](std::uint32_t k) { return things[k] == thing; });
      EXPECT_EQ(n, thing);
      if (n == things.size()) things.push_back(thing);
    }
    EXPECT_EQ(things.size(), 1000U);
  }
}

TEST(Weld, makes_one_vertex_for_each_distinct_corner_and_keeps_what_each_says) {
  const std::pair<const char*, std::size_t> rows[] = {
      {"f 1 2 3\nf 1 3 4\n", 4},                          // shared
      {"f 1/1 2/1 3/1\nf 1/1 3/1 4/1\n", 4},              // shared with vt
      {"f 1/1 2/1 3/1\nf 1/2 3/2 4/2\n", 6},              // another vt splits
      {"f 1//1 2//1 3//1\nf 1//2 3//2 4//2\n", 6},        // another vn splits
      {"f 1/1/1 2/1/1 3/1/1\nf 1/1/2 3/1/1 4/1/1\n", 5},  // equal vt, other vn at one corner
      {"f 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/2/1 4/1/1\n", 5},  // equal vn, other vt at one corner
      {"f 1/2/1 2/1/2 3/2/2 4/1/1\n", 4},
  };
  for (const auto& [faces, vertices] : rows) {
    SCOPED_TRACE(faces);
    const ObjData data = square("vt 0.1 0.2\nvt 0.3 0.4\nvn 0 0 2\nvn 0 3 0\n" + std::string(faces));
    const Mesh mesh = weld(data);
    EXPECT_EQ(mesh.vertex_count(), vertices);
    EXPECT_EQ(mesh.texcoords.empty(), data.corners[0].texcoord == no_index);
    ASSERT_EQ(mesh.indices.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {
      const auto& [position, texcoord, normal] = data.corners[i];
      const std::uint32_t vertex = mesh.indices[i];
      EXPECT_EQ(mesh.positions[vertex], data.positions[position]);
      if (texcoord != no_index) {
        EXPECT_EQ(mesh.texcoords[vertex], data.texcoords[texcoord]);
      }
      if (normal != no_index) {
        EXPECT_EQ(mesh.normals[vertex], glm::normalize(data.normals[normal]));
      }
    }
  }
}

TEST(Weld, groups_triangles_by_material_in_order_of_first_use) {
  const Mesh mesh =
      weld(square("f 1 2 3\nusemtl a\nf 2 3 4\nusemtl b\nf 3 4 1\nusemtl a\nf 4 1 2\nf 1 2 4\n"));
  const Group expected[] = {{"", 0, 3}, {"a", 3, 9}, {"b", 12, 3}};
  ASSERT_EQ(mesh.groups.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(mesh.groups[i].material, expected[i].material);
    EXPECT_EQ(mesh.groups[i].first_index, expected[i].first_index);
    EXPECT_EQ(mesh.groups[i].index_count, expected[i].index_count);
  }
  EXPECT_TRUE(weld(square("f 1 2 3\n")).groups.empty());
}

TEST(Weld, fills_what_some_corners_lack) {
  const Mesh mesh = weld(square("vt 0.5 0.5\nvn 0 0 0\nvn 1 0 0\nf 1/1/2 2/1/1 3\n"));
  EXPECT_EQ(mesh.texcoords[2], glm::vec2(0.0F));
  EXPECT_EQ(mesh.normals[0], glm::vec3(1.0F, 0.0F, 0.0F));  // as written
  EXPECT_EQ(mesh.normals[1], glm::vec3(0.0F, 0.0F, 1.0F));  // of zero length: generated
  EXPECT_EQ(mesh.normals[2], glm::vec3(0.0F, 0.0F, 1.0F));
}

TEST(Weld, of_a_mesh_takes_minus_zero_as_zero_drops_unused_vertices_and_keeps_apart_what_differs) {
  Mesh mesh;
  mesh.positions = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0F, 0, 0}, {1, 1, 0}};
  mesh.indices = {1, 2, 3, 4, 2, 5};
  EXPECT_EQ(weld(mesh).vertex_count(), 4U);
  EXPECT_EQ(weld(mesh).indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 1, 3}));
  // Each attribute in turn differs between two vertices; the attributes after it are the same.
  mesh.normals.assign(6, {0, 0, 1});
  mesh.texcoords.assign(6, {0, 0});
  mesh.tangents.assign(6, {1, 0, 0, 1});
  mesh.bitangents.assign(6, {0, 1, 0});
  mesh.colors.assign(6, {1, 1, 1});
  EXPECT_EQ(weld(mesh).vertex_count(), 4U);
  for (int attribute = 0; attribute < 6; ++attribute) {
    Mesh other = mesh;
    int at = 0;
    for_each_attribute(other, [&](auto& values) {
      if (at++ == attribute) values[4][0] += 0.5F;
    });
    EXPECT_EQ(weld(other).vertex_count(), 5U) << attribute;
  }
}

TEST(Split, by_label_gives_a_vertex_one_copy_for_each_further_label) {
  Mesh mesh = quad();
  const std::uint32_t a = mesh.indices[0], b = mesh.indices[1], c = mesh.indices[2];
  mesh.indices = {a, b, c, a, b, c, a, b, c, a, b, c};
  const std::vector<std::uint32_t> labels = {5, 5, no_index, 6, 5, 5, 7, 5, 5, 6, 5, 5};
  const std::vector<std::uint32_t> of_vertex = split_by_label(mesh, labels);
  EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{a, b, c, 4, b, c, 5, b, c, 4, b, c}));
  ASSERT_EQ(of_vertex.size(), 6U);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] != no_index) {
      EXPECT_EQ(of_vertex[mesh.indices[i]], labels[i]) << i;
    }
  for (const std::size_t copy : {4U, 5U}) EXPECT_EQ(mesh.texcoords[copy], mesh.texcoords[a]);
}

TEST(Cube, by_face_welds_to_24_vertices_that_equal_the_primitive) {
  const Mesh mesh = weld(cube_by_face()), expected = cube_split();
  EXPECT_EQ(mesh.vertex_count(), 24U);
  EXPECT_EQ(mesh.triangle_count(), expected.triangle_count());
  for (std::size_t v = 0; v < 24; ++v) {
    int found = 0;
    for (std::size_t e = 0; e < 24; ++e)
      found += mesh.positions[v] == expected.positions[e] && mesh.normals[v] == expected.normals[e] &&
               mesh.texcoords[v] == expected.texcoords[e];
    EXPECT_EQ(found, 1) << "vertex " << v;
  }
}

/// How the texture lies on the triangles, face by face: + the right way round, - mirrored, 0 no area.
std::string turns(const Mesh& cube) {
  std::string turns;
  for (std::size_t t = 0; t < cube.triangle_count(); ++t) {
    const double area = texture_area(of_triangle(cube, cube.texcoords, t));
    turns += t % 2 == 0 && t > 0 ? " " : "";
    turns += area > 0 ? '+' : (area < 0 ? '-' : '0');
  }
  return turns;
}

TEST(Cube, of_the_report_covers_its_faces_as_the_report_says) {
  // Before: the front is right, the back mirrored, the others smeared.
  EXPECT_EQ(turns(cube_shared(cube_before)), "++ -- 00 00 00 00");
  EXPECT_EQ(cube_before[0], glm::vec2(0));
  EXPECT_EQ(cube_before[1], glm::vec2(0, 1)) << "the upper left shows the upper left";
  // Stretched: the front is turned by 180 degrees, and of each other side one triangle is mirrored.
  EXPECT_EQ(turns(cube_shared(cube_stretched)), "++ -- +- -+ -+ +-");
  EXPECT_EQ(cube_stretched[0], glm::vec2(1)) << "the lower left shows the upper right";
}

}  // namespace
}  // namespace texel::mesh
