// SPDX-License-Identifier: MIT
#include "mesh/weld.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"
#include "cube.hpp"
#include "mesh/distinct.hpp"
#include "mesh/normals.hpp"
#include "mesh/primitives.hpp"
#include "mesh/tangents.hpp"

namespace texel::mesh {
namespace {

using texel::weld;  // of lab 4

ObjData obj_data(const std::string& text) {
  return parse_obj(text, "test.obj");
}

const std::string obj_square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

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
    EXPECT_EQ(table.size(), 1000u);
  }
}

TEST(Weld, makes_one_vertex_for_each_distinct_corner) {
  struct Row {
    const char* faces;
    std::size_t vertices;
  };
  const Row rows[] = {
      {"f 1 2 3\nf 1 3 4\n", 4},                          // shared
      {"f 1/1 2/1 3/1\nf 1/1 3/1 4/1\n", 4},              // shared with vt
      {"f 1/1 2/1 3/1\nf 1/2 3/2 4/2\n", 6},              // another vt splits
      {"f 1//1 2//1 3//1\nf 1//2 3//2 4//2\n", 6},        // another vn splits
      {"f 1/1/1 2/1/1 3/1/1\nf 1/1/2 3/1/1 4/1/1\n", 5},  // equal vt, other vn at one corner
      {"f 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/2/1 4/1/1\n", 5},  // equal vn, other vt at one corner
  };
  for (const Row& row : rows) {
    const Mesh mesh = weld(obj_data(obj_square + "vt 0 0\nvt 1 1\nvn 0 0 1\nvn 0 1 0\n" + row.faces));
    EXPECT_EQ(mesh.vertex_count(), row.vertices) << row.faces;
    EXPECT_EQ(mesh.triangle_count(), 2u);
    EXPECT_EQ(mesh.texcoords.empty(), std::string(row.faces).find("1/1") == std::string::npos);
  }
}

TEST(Weld, keeps_what_each_corner_says) {
  const ObjData data =
      obj_data(obj_square + "vt 0.1 0.2\nvt 0.3 0.4\nvn 0 0 2\nvn 0 3 0\nf 1/2/1 2/1/2 3/2/2 4/1/1\n");
  const Mesh mesh = weld(data);
  ASSERT_EQ(mesh.indices.size(), data.corners.size());
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    EXPECT_EQ(mesh.positions[mesh.indices[i]], data.positions[data.corners[i].position]);
    EXPECT_EQ(mesh.texcoords[mesh.indices[i]], data.texcoords[data.corners[i].texcoord]);
    EXPECT_EQ(mesh.normals[mesh.indices[i]], glm::normalize(data.normals[data.corners[i].normal]));
  }
}

TEST(Weld, groups_triangles_by_material_in_order_of_first_use) {
  const Mesh mesh = weld(
      obj_data(obj_square + "f 1 2 3\nusemtl a\nf 2 3 4\nusemtl b\nf 3 4 1\nusemtl a\nf 4 1 2\nf 1 2 4\n"));
  ASSERT_EQ(mesh.groups.size(), 3u);
  EXPECT_EQ(mesh.groups[0].material, "");
  EXPECT_EQ(mesh.groups[1].material, "a");
  EXPECT_EQ(mesh.groups[1].first_index, 3u);
  EXPECT_EQ(mesh.groups[1].index_count, 9u);
  EXPECT_EQ(mesh.groups[2].first_index, 12u);
  EXPECT_EQ(mesh.groups[2].index_count, 3u);
  EXPECT_TRUE(weld(obj_data(obj_square + "f 1 2 3\n")).groups.empty());
}

TEST(Weld, makes_colors_linear) {
  const Mesh mesh = weld(obj_data("v 0 0 0 1 0.5 0\nv 1 0 0 0.04 1 1\nv 0 1 0\nf 1 2 3\n"));
  ASSERT_EQ(mesh.colors.size(), 3u);
  EXPECT_NEAR(mesh.colors[0].g, 0.214041f, 1e-6f);  // IEC 61966-2-1 of 0.5
  EXPECT_NEAR(mesh.colors[1].r, 0.04f / 12.92f, 1e-8f);
  EXPECT_EQ(mesh.colors[2], glm::vec3(1.0f));
}

TEST(Weld, fills_what_some_corners_lack) {
  const Mesh mesh = weld(obj_data(obj_square + "vt 0.5 0.5\nvn 0 0 0\nvn 1 0 0\nf 1/1/2 2/1/1 3\n"));
  EXPECT_EQ(mesh.texcoords[2], glm::vec2(0.0f));
  EXPECT_EQ(mesh.normals[0], glm::vec3(1.0f, 0.0f, 0.0f));  // as written
  EXPECT_EQ(mesh.normals[1], glm::vec3(0.0f, 0.0f, 1.0f));  // of zero length: generated
  EXPECT_EQ(mesh.normals[2], glm::vec3(0.0f, 0.0f, 1.0f));
}

TEST(Weld, of_a_mesh_undoes_split) {
  for (const Mesh& mesh : {cube_split(), sphere(5, 8), torus(1.0f, 0.3f, 7, 5)}) {
    const Mesh soup = split(mesh);
    EXPECT_EQ(soup.vertex_count(), 3 * mesh.triangle_count());
    const Mesh back = weld(soup);
    EXPECT_EQ(back.vertex_count(), mesh.vertex_count());
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
      EXPECT_EQ(back.positions[back.indices[i]], mesh.positions[mesh.indices[i]]);
      EXPECT_EQ(back.texcoords[back.indices[i]], mesh.texcoords[mesh.indices[i]]);
    }
  }
}

TEST(Weld, of_a_mesh_takes_minus_zero_as_zero_and_drops_unused_vertices) {
  Mesh mesh;
  mesh.positions = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0f, 0, 0}, {1, 1, 0}};
  mesh.indices = {1, 2, 3, 4, 2, 5};
  const Mesh welded = weld(mesh);
  EXPECT_EQ(welded.vertex_count(), 4u);
  EXPECT_EQ(welded.indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 1, 3}));
}

TEST(Split, by_label_copies_only_where_labels_differ) {
  Mesh mesh = quad();
  const std::vector<std::uint32_t> labels{5, 5, no_index, 7, 5, 7};
  const std::uint32_t a = mesh.indices[0];
  const auto of_vertex = split_by_label(mesh, labels);
  EXPECT_EQ(mesh.vertex_count(), 5u);
  EXPECT_EQ(mesh.indices[0], a);
  EXPECT_EQ(mesh.indices[3], 4u);
  EXPECT_EQ(mesh.texcoords[4], mesh.texcoords[a]);
  EXPECT_EQ(of_vertex[a], 5u);
  EXPECT_EQ(of_vertex[4], 7u);
}

TEST(Cube, by_face_welds_to_24_vertices_that_equal_the_primitive) {
  const Mesh mesh = weld(cube_by_face());
  EXPECT_EQ(mesh.vertex_count(), 24u);
  const Mesh expected = cube_split();
  EXPECT_EQ(mesh.triangle_count(), expected.triangle_count());
  const auto has = [&](std::size_t v) {
    for (std::size_t e = 0; e < 24; ++e)
      if (mesh.positions[v] == expected.positions[e] && mesh.normals[v] == expected.normals[e] &&
          mesh.texcoords[v] == expected.texcoords[e])
        return true;
    return false;
  };
  for (std::size_t v = 0; v < 24; ++v) EXPECT_TRUE(has(v)) << "vertex " << v;
}

/// How the texture lies on the triangles of one face: +1 the right way round, -1 mirrored, 0 no area.
std::array<int, 2> turns(const Mesh& cube, std::size_t face) {
  std::array<int, 2> result{};
  for (std::size_t t = 0; t < 2; ++t) {
    const std::uint32_t* i = &cube.indices[6 * face + 3 * t];
    const double area = texture_area({cube.texcoords[i[0]], cube.texcoords[i[1]], cube.texcoords[i[2]]});
    result[t] = area > 0.0 ? 1 : (area < 0.0 ? -1 : 0);
  }
  return result;
}

TEST(Cube, before_has_a_right_front_a_mirrored_back_and_four_smeared_faces) {
  const Mesh cube = cube_shared(cube_before);
  EXPECT_EQ(cube.vertex_count(), 8u);
  EXPECT_EQ(turns(cube, 0), (std::array<int, 2>{1, 1}));
  EXPECT_EQ(turns(cube, 1), (std::array<int, 2>{-1, -1}));
  for (std::size_t face = 2; face < 6; ++face) EXPECT_EQ(turns(cube, face), (std::array<int, 2>{0, 0}));
}

TEST(Cube, stretched_covers_all_with_one_triangle_of_each_side_mirrored) {
  const Mesh cube = cube_shared(cube_stretched);
  EXPECT_EQ(turns(cube, 0), (std::array<int, 2>{1, 1}));  // turned by 180 degrees
  EXPECT_EQ(cube.texcoords[0], glm::vec2(1.0f, 1.0f));    // lower left shows the upper right
  EXPECT_EQ(turns(cube, 1), (std::array<int, 2>{-1, -1}));
  for (std::size_t face = 2; face < 6; ++face) {
    const auto turn = turns(cube, face);
    EXPECT_EQ(turn[0] * turn[1], -1) << "face " << face;
  }
}

TEST(Cube, shared_has_closed_outward_faces_and_corner_normals) {
  const Mesh cube = cube_shared(cube_before, 2.0f);
  for (std::size_t i = 0; i < cube.indices.size(); i += 3) {
    const glm::vec3 a = cube.positions[cube.indices[i]], b = cube.positions[cube.indices[i + 1]],
                    c = cube.positions[cube.indices[i + 2]];
    EXPECT_NEAR(glm::dot(face_normal(a, b, c), a), 2.0f, 1e-6f);
    // The corner normal leaves each face's by acos(1 / sqrt 3) = 54.7 degrees: the report's second
    // shortcoming.
    EXPECT_NEAR(glm::dot(face_normal(a, b, c), cube.normals[cube.indices[i]]), 0.57735f, 1e-5f);
  }
}

}  // namespace
}  // namespace texel::mesh
