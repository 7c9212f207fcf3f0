// SPDX-License-Identifier: MIT
#include "mesh/normals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "../support/meshes.hpp"
#include "mesh/primitives.hpp"
#include "mesh/vectors.hpp"
#include "mesh/weld.hpp"
#include "steps.hpp"

namespace texel::mesh {
namespace {

using test::icosphere;

/// The largest angle between two lists of directions.
double worst_degrees(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    worst = std::max(worst, glm::degrees(angle_between(glm::dvec3(a[i]), glm::dvec3(b[i]))));
  return worst;
}

TEST(Normals, of_a_face_points_to_its_counter_clockwise_side_at_any_size) {
  // By the library, and by lab 4.
  for (const FaceNormal by : {FaceNormal{}, FaceNormal{face_normal}}) {
    const auto normal_of = [&](std::vector<glm::vec3> corners) {
      Mesh triangle;
      triangle.positions = std::move(corners);
      triangle.indices = {0, 1, 2};
      flat_normals(triangle, by);
      return triangle.normals[0];
    };
    for (const float size : {1e-30f, 1e-6f, 1.0f, 1e6f, 1e30f})
      EXPECT_EQ(normal_of({{0, 0, 0}, {size, 0, 0}, {0, size, 0}}), glm::vec3(0, 0, 1)) << size;
    EXPECT_EQ(normal_of({{1, 2, 3}, {2, 2, 5}, {1, 6, 4}}), normal_of({{2, 2, 5}, {1, 6, 4}, {1, 2, 3}}));
    EXPECT_EQ(normal_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}), fallback_normal) << "no area";
  }
  EXPECT_EQ(face_normal({0, 0, 0}, {1, 1, 1}, {2, 2, 2}), glm::vec3(0.0f)) << "no area";
}

TEST(Normals, are_those_of_the_given_function) {
  const FaceNormal forward = [](const glm::vec3&, const glm::vec3&, const glm::vec3&) {
    return glm::vec3(0, 0, 1);
  };
  Mesh flat = cube_split(), smooth = cube_split();
  flat_normals(flat, forward);
  smooth_normals(smooth, Weighting::angle, forward);
  for (const Mesh& mesh : {flat, smooth})
    for (const glm::vec3& normal : mesh.normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
}

TEST(Normals, smooth_ones_come_near_the_exact_ones) {
  struct Row {
    const char* name;
    Mesh mesh;
    Weighting weighting;
    double limit;  // degrees, just above what was measured
  };
  const Row rows[] = {
      {"sphere by area", sphere(32, 64), Weighting::area,
       0.95},  // next to the poles, where areas are unequal
      {"sphere by angle", sphere(32, 64), Weighting::angle, 0.09},
      {"torus by area", torus(1.0f, 0.4f, 64, 32), Weighting::area, 0.18},
      {"torus by angle", torus(1.0f, 0.4f, 64, 32), Weighting::angle, 0.18},
      {"icosphere by angle", icosphere(4), Weighting::angle, 0.15},
  };
  for (const Row& row : rows) {
    Mesh mesh = row.mesh;
    smooth_normals(mesh, row.weighting);
    const double worst = worst_degrees(mesh.normals, row.mesh.normals);
    EXPECT_LT(worst, row.limit) << row.name;
    EXPECT_GT(worst, 0.0) << row.name << ": the exact normals were left as they are";
  }
}

TEST(Normals, smooth_ones_are_the_same_on_both_sides_of_a_seam) {
  Mesh mesh = torus(1.0f, 0.4f, 12, 8);
  smooth_normals(mesh, Weighting::angle);
  for (std::size_t row = 0; row <= 8; ++row) EXPECT_EQ(mesh.normals[row * 13], mesh.normals[row * 13 + 12]);
}

TEST(Normals, by_angle_do_not_depend_on_how_a_face_is_cut) {
  // A cube's corner: by area a face whose diagonal ends there counts twice.
  Mesh cube = cube_split();
  smooth_normals(cube, Weighting::angle);
  for (std::size_t v = 0; v < 24; ++v)
    EXPECT_LT(glm::degrees(angle_between(glm::dvec3(cube.normals[v]), glm::dvec3(cube.positions[v]))), 1e-4);
  smooth_normals(cube, Weighting::area);
  double worst = 0.0;
  for (std::size_t v = 0; v < 24; ++v)
    worst = std::max(worst,
                     glm::degrees(angle_between(glm::dvec3(cube.normals[v]), glm::dvec3(cube.positions[v]))));
  EXPECT_GT(worst, 10.0);  // acos(5 / sqrt(27)) = 15.8 where one face counts twice, 13.3 at other corners
}

TEST(Normals, flat_ones_split_only_where_faces_differ) {
  Mesh cube =
      weld(parse_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\nf 1 5 2\n", "a.obj"));
  flat_normals(cube, face_normal);
  EXPECT_EQ(cube.vertex_count(), 7u);  // the two triangles of the square share, the third one does not
  for (std::size_t i = 0; i < cube.indices.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(cube.normals[cube.indices[i + k]],
                face_normal(cube.positions[cube.indices[i]], cube.positions[cube.indices[i + 1]],
                            cube.positions[cube.indices[i + 2]]));
}

TEST(Normals, of_triangles_without_area_fall_back) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}, {1, 0, 1}};
  mesh.indices = {0, 1, 2, 3, 3, 4};
  smooth_normals(mesh, Weighting::angle);
  for (const glm::vec3& normal : mesh.normals) EXPECT_EQ(normal, fallback_normal);
  flat_normals(mesh);
  for (const glm::vec3& normal : mesh.normals) EXPECT_EQ(normal, fallback_normal);
}

TEST(Normals, degenerate_neighbours_add_nothing) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
  mesh.indices = {0, 1, 2, 0, 1, 3};
  smooth_normals(mesh, Weighting::area);
  EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
  EXPECT_EQ(mesh.normals[3], fallback_normal);
}

/// A roof of two triangles at a right angle along the edge 1-2.
std::string roof(const std::string& first, const std::string& second) {
  return "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 -1\n" + first + "f 1 2 3\n" + second + "f 2 1 4\n";
}

TEST(Normals, respect_smoothing_groups) {
  struct Row {
    const char* first;
    const char* second;
    std::size_t vertices;
  };
  const Row rows[] = {
      {"", "", 4},            // never switched on: all smooth
      {"s 1\n", "", 4},       // one group
      {"s 1\n", "s 2\n", 6},  // a crease
      {"s 1\n", "s off\n", 6},
      {"s off\n", "s 3\n", 6},
      {"s 1\n", "s 1\n", 4},
  };
  for (const Row& row : rows) {
    ObjData data = parse_obj(roof(row.first, row.second), "roof.obj");
    EXPECT_EQ(generate_missing_normals(data, Weighting::angle), 6u);
    const Mesh mesh = weld(data);
    EXPECT_EQ(mesh.vertex_count(), row.vertices) << row.first << row.second;
    const glm::vec3 expected = row.vertices == 4 ? glm::normalize(glm::vec3(0, -1, 1)) : glm::vec3(0, 0, 1);
    EXPECT_LT(glm::distance(mesh.normals[0], expected), 1e-6f) << row.first << row.second;
  }
}

TEST(Normals, of_a_file_can_be_taken_away_and_made_anew) {
  ObjData data = parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 0 0\nf 1//1 2//1 3//1\n", "a.obj");
  EXPECT_EQ(generate_missing_normals(data, Weighting::angle), 0u);
  remove_normals(data);
  EXPECT_EQ(generate_missing_normals(data, Weighting::angle), 3u);
  EXPECT_EQ(weld(data).normals[0], glm::vec3(0, 0, 1));
}

}  // namespace
}  // namespace texel::mesh
