// SPDX-License-Identifier: MIT
// Which faces share a normal, and by how much each of them counts, worked out by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "mesh/normals.hpp"
#include "mesh/obj.hpp"

namespace texel::mesh {
namespace {

void expect_direction(const glm::vec3& normal, const glm::dvec3& direction) {
  const glm::dvec3 expected = glm::normalize(direction);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(normal[k], expected[k], 1e-6);
}

/// Two triangles along the x axis at right angles: one lies in z = 0 and has area 1/2, the other stands in
/// y = 0 and reaches `height` up.
std::string folded(double height, const std::string& before_second = {}) {
  return "v 0 0 0\nv 1 0 0\nv 0 -1 0\nv 0 0 " + std::to_string(height) + "\nf 1 3 2\n" + before_second +
         "f 1 2 4\n";
}

TEST(NormalWeights, are_areas_or_angles) {
  // n = (0, 0, 1) by area 1/2 and (0, -1, 0) by area 3/2; both angles at the origin are 90 degrees.
  ObjData by_area = parse_obj(folded(3), "a.obj");
  generate_missing_normals(by_area, Weighting::area);
  expect_direction(by_area.normals[by_area.corners[0].normal], {0, -1.5, 0.5});
  ObjData by_angle = parse_obj(folded(3), "a.obj");
  generate_missing_normals(by_angle, Weighting::angle);
  expect_direction(by_angle.normals[by_angle.corners[0].normal], {0, -1, 1});
}

TEST(Normals, are_shared_by_positions_that_are_written_twice) {
  // The same fold, but the second triangle has lines of its own for the two points that it shares.
  ObjData data =
      parse_obj("v 0 0 0\nv 1 0 0\nv 0 -1 0\nf 1 3 2\nv 0 0 0\nv 1 0 0\nv 0 0 1\nf 4 5 6\n", "a.obj");
  generate_missing_normals(data, Weighting::angle);
  expect_direction(data.normals[data.corners[0].normal], {0, -1, 1});
  expect_direction(data.normals[data.corners[3].normal], {0, -1, 1});
}

TEST(Normals, are_flat_after_s_off_and_before_the_first_s) {
  // Group 1 for the first triangle only; then off, in which two triangles share an edge and no normal.
  ObjData off = parse_obj("s 1\n" + folded(1, "s off\n") + "f 1 4 2\n", "a.obj");
  generate_missing_normals(off, Weighting::angle);
  expect_direction(off.normals[off.corners[3].normal], {0, -1, 0});
  expect_direction(off.normals[off.corners[6].normal], {0, 1, 0});
  // What stands before the first s line is off too.
  ObjData late = parse_obj(folded(1, "f 1 2 4\ns 1\n"), "a.obj");
  generate_missing_normals(late, Weighting::angle);
  expect_direction(late.normals[late.corners[0].normal], {0, 0, 1});
  expect_direction(late.normals[late.corners[6].normal], {0, -1, 0});
}

}  // namespace
}  // namespace texel::mesh
