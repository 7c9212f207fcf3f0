// SPDX-License-Identifier: MIT
// What tells vertices apart, and the limits of what is read and measured.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "core/error.hpp"
#include "mesh/bounds.hpp"
#include "mesh/obj.hpp"
#include "mesh/ply.hpp"
#include "mesh/texcoords.hpp"
#include "mesh/weld.hpp"
#include "steps.hpp"

namespace texel::mesh {
namespace {

Mesh triangle() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.indices = {0, 1, 2};
  return mesh;
}

TEST(Split, gives_a_vertex_with_three_labels_two_copies) {
  Mesh mesh = triangle();
  mesh.indices = {0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2};
  const std::vector<std::uint32_t> labels = {5, 5, 5, 6, 5, 5, 7, 5, 5, 6, 5, 5};
  const std::vector<std::uint32_t> of_vertex = split_by_label(mesh, labels);
  ASSERT_EQ(mesh.vertex_count(), 5U);
  for (std::size_t i = 0; i < labels.size(); ++i) EXPECT_EQ(of_vertex[mesh.indices[i]], labels[i]) << i;
  EXPECT_EQ(mesh.indices[3], mesh.indices[9]) << "one copy for each label";
}

TEST(Weld, keeps_vertices_apart_that_differ_in_one_attribute_alone) {
  // Each attribute in turn differs between two vertices; the attributes after it are the same.
  Mesh full = triangle();
  full.positions.push_back(full.positions[0]);
  full.normals.assign(4, {0, 0, 1});
  full.texcoords.assign(4, {0, 0});
  full.tangents.assign(4, {1, 0, 0, 1});
  full.bitangents.assign(4, {0, 1, 0});
  full.colors.assign(4, {1, 1, 1});
  full.indices = {0, 1, 2, 3, 1, 2};
  EXPECT_EQ(texel::weld(full).vertex_count(), 3U);
  for (int attribute = 0; attribute < 6; ++attribute) {
    Mesh mesh = full;
    int at = 0;
    for_each_attribute(mesh, [&](auto& values) {
      if (at++ == attribute) values[3][0] += 0.5F;
    });
    EXPECT_EQ(texel::weld(mesh).vertex_count(), 4U) << attribute;
  }
}

TEST(Obj, keeps_texture_coordinates_as_they_are_written) {
  const ObjData data =
      parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.25 0.75\nvt 2 -1\nf 1/1 2/2 3/1\n", "a.obj");
  EXPECT_EQ(data.texcoords[0], glm::vec2(0.25F, 0.75F));
  EXPECT_EQ(data.texcoords[1], glm::vec2(2, -1));
}

TEST(Obj, begins_a_comment_at_a_word_only) {
  const ObjData data = parse_obj("v 0 0 0 #1\nv 1 0 0\nv 0 1 0\ns 1 #2\nf 1 2 3 #4\n", "a.obj");
  EXPECT_EQ(data.triangle_count(), 1U);
  EXPECT_TRUE(data.report.warnings.empty());
}

TEST(Obj, joins_lines_with_a_blank_between) {
  // 1 and 2 are two indices, not 12.
  const ObjData data = parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1\\\n2\\\n3\n", "a.obj");
  EXPECT_EQ(data.triangle_count(), 1U);
}

TEST(Ply, refuses_an_index_just_beyond_the_last_vertex) {
  std::string bytes = to_ply(triangle());
  EXPECT_NO_THROW(parse_ply(bytes, "a.ply"));
  const std::int32_t beyond = 3;
  std::memcpy(bytes.data() + bytes.size() - sizeof beyond, &beyond, sizeof beyond);
  EXPECT_THROW(parse_ply(bytes, "a.ply"), Error);
}

TEST(Bounds, unit_size_is_that_of_the_farthest_vertex_in_any_direction) {
  for (int axis = 0; axis < 3; ++axis) {
    Mesh mesh = triangle();
    mesh.positions = {{0, 0, 0}, {1, 1, 1}, {0, 0, 0}};
    mesh.positions[1][axis] = 10;
    normalize_to_unit(mesh);
    EXPECT_NEAR(glm::length(mesh.positions[0]), 1, 1e-6) << axis;
    EXPECT_NEAR(glm::length(mesh.positions[1]), 1, 1e-6) << axis;
  }
}

TEST(Texcoords, of_a_cylinder_fill_its_height_however_wide_it_is) {
  for (const float height : {0.5F, 20.0F}) {
    Mesh mesh = triangle();
    mesh.positions = {{1, 0, 0}, {0, 0, 1}, {-1, height, 0}};
    generate_texcoords(mesh, Projection::cylindrical);
    EXPECT_NEAR(mesh.texcoords[0].t, 0, 1e-6) << height;
    EXPECT_NEAR(mesh.texcoords[2].t, 1, 1e-6) << height;
  }
}

}  // namespace
}  // namespace texel::mesh
