// SPDX-License-Identifier: MIT
#include "mesh/bounds.hpp"

#include <gtest/gtest.h>

#include "cube.hpp"
#include "mesh/primitives.hpp"

namespace texel::mesh {
namespace {

/// A cube of so many units a side, moved along x.
Mesh cube_at(float x, float half_size) {
  Mesh cube = cube_shared(cube_before, half_size);
  for (glm::vec3& position : cube.positions) position.x += x;
  return cube;
}

bool says(const Mesh& mesh, const char* part) {
  return lost_shape(mesh).find(part) != std::string::npos;
}

TEST(LostShape, is_none_for_models_of_any_size_that_floats_can_tell_apart) {
  for (const float size : {1e-37f, 1e-3f, 1.0f, 1e18f, 1.5e38f})
    EXPECT_EQ(lost_shape(cube_at(0.0f, size)), "") << size;
  EXPECT_EQ(lost_shape(cube_at(1e3f, 0.1f)), "");
  EXPECT_EQ(lost_shape(torus(0.7f, 0.001f, 48, 24)), "") << "a thin ring";
}

TEST(LostShape, says_that_all_is_one_point) {
  Mesh mesh = cube_at(0.0f, 1e-3f);
  for (glm::vec3& position : mesh.positions) position += 1e6f;
  EXPECT_TRUE(says(mesh, "one point, 1000000 1000000 1000000,")) << lost_shape(mesh);
}

TEST(LostShape, says_how_far_apart_floats_are_far_from_the_origin) {
  // At 1e6 that is 1/16: 160 of them along 10.
  EXPECT_TRUE(says(cube_at(1e6f, 5.0f),
                   "10 long and lies 1e+06 from the origin, where 32-bit floats are 0.0625 apart"))
      << lost_shape(cube_at(1e6f, 5.0f));
  EXPECT_EQ(lost_shape(cube_at(1e6f, 50.0f)), "") << "1600 are finer than pixels";
  EXPECT_TRUE(says(cube_at(1e6f, 1e-3f), "0.002 long")) << "flat now, since x is lost";
}

TEST(LostShape, says_that_triangles_have_no_area_beside_the_size) {
  Mesh mesh = cube_at(0.0f, 1e-30f);
  mesh.positions.emplace_back(1e30f, 0.0f, 0.0f);
  mesh.indices.insert(mesh.indices.end(), {0, 1, 8});
  EXPECT_TRUE(says(mesh, "size of 1e+30 its triangles are points and lines")) << lost_shape(mesh);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    mesh.positions[i] = static_cast<float>(i) * glm::vec3(1.0f, 0.5f, 0.25f);
  EXPECT_TRUE(says(mesh, "points and lines")) << "collinear: " << lost_shape(mesh);
}

}  // namespace
}  // namespace texel::mesh
