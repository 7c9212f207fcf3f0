// SPDX-License-Identifier: MIT
#include "mesh/bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/said.hpp"
#include "cube.hpp"
#include "mesh/primitives.hpp"
#include "steps.hpp"

namespace texel::mesh {
namespace {

using cube_wrap::cube_before;
using cube_wrap::cube_shared;

/// A cube of so many units a side, moved along x.
Mesh cube_at(float x, float half_size) {
  Mesh cube = cube_shared(cube_before, half_size);
  for (glm::vec3& position : cube.positions) position.x += x;
  return cube;
}

TEST(LostShape, is_none_for_models_of_any_size_that_floats_can_tell_apart) {
  for (const float size : {1e-37F, 1e-3F, 1.0F, 1e18F, 1.5e38F})
    EXPECT_EQ(lost_shape(cube_at(0.0F, size)), "") << size;
  EXPECT_EQ(lost_shape(cube_at(1e3F, 0.1F)), "");
  EXPECT_EQ(lost_shape(cube_at(1e6F, 50.0F)), "") << "1600 floats along it are finer than pixels";
  EXPECT_EQ(lost_shape(torus(0.7F, 0.001F, 48, 24)), "") << "a thin ring";
}

TEST(LostShape, says_why_nothing_would_be_seen) {
  Mesh point = cube_at(0.0F, 1e-3F), far_vertex = cube_at(0.0F, 1e-30F);
  for (glm::vec3& position : point.positions) position += 1e6F;
  far_vertex.positions.emplace_back(1e30F, 0.0F, 0.0F);
  far_vertex.indices.insert(far_vertex.indices.end(), {0, 1, 8});
  Mesh line = far_vertex;
  for (std::size_t i = 0; i < line.positions.size(); ++i)
    line.positions[i] = static_cast<float>(i) * glm::vec3(1.0F, 0.5F, 0.25F);
  const std::pair<Mesh, const char*> rows[] = {
      {point, "one point, 1000000 1000000 1000000,"},
      // At 1e6 floats are 1/16 apart: 160 of them along 10.
      {cube_at(1e6F, 5.0F), "10 long and lies 1e+06 from the origin, where 32-bit floats are 0.0625 apart"},
      {cube_at(1e6F, 1e-3F), "0.002 long"},  // flat now, since x is lost
      {far_vertex, "size of 1e+30 its triangles are points and lines"},
      {line, "points and lines"}};
  for (const auto& [mesh, part] : rows) EXPECT_TRUE(test::has(lost_shape(mesh), part)) << lost_shape(mesh);
}

void expect_unit(Mesh mesh) {
  normalize_to_unit(mesh);
  EXPECT_LT(glm::length(bounds(mesh).center()), 1e-6F);  // float32 offsets of three radii
  float farthest = 0.0F;
  for (const glm::vec3& p : mesh.positions) farthest = std::max(farthest, glm::length(p));
  EXPECT_NEAR(farthest, 1.0F, 1e-6F);
}

TEST(Bounds, center_and_unit_size_hold_for_models_of_any_size_and_place) {
  for (const float size : {1e-6F, 1.0F, 1e6F}) {
    Mesh mesh = sphere(16, 32, size);
    for (glm::vec3& p : mesh.positions) p += glm::vec3(3.0F * size, -size, 0.0F);
    expect_unit(mesh);
  }
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {  // the farthest vertex in any direction
    mesh.positions = {{0, 0, 0}, {1, 1, 1}};
    mesh.positions[1][axis] = 10;
    expect_unit(mesh);
  }
  mesh.positions = {{5.0F, 5.0F, 5.0F}};
  normalize_to_unit(mesh);
  EXPECT_EQ(mesh.positions[0], glm::vec3(0.0F));
  Mesh empty;
  normalize_to_unit(empty);
  EXPECT_EQ(bounds(empty).extent(), glm::vec3(0.0F));
}

}  // namespace
}  // namespace texel::mesh
