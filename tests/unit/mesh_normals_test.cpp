// SPDX-License-Identifier: MIT
#include "mesh/normals.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/meshes.hpp"
#include "mesh/primitives.hpp"
#include "mesh/weld.hpp"
#include "steps.hpp"

namespace texel::mesh {
namespace {

using cube_wrap::face_normal;
using cube_wrap::weld;

using test::degrees_between;

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
    for (const float size : {1e-30F, 1e-6F, 1.0F, 1e6F, 1e30F})
      EXPECT_EQ(normal_of({{0, 0, 0}, {size, 0, 0}, {0, size, 0}}), glm::vec3(0, 0, 1)) << size;
    EXPECT_EQ(normal_of({{1, 2, 3}, {2, 2, 5}, {1, 6, 4}}), normal_of({{2, 2, 5}, {1, 6, 4}, {1, 2, 3}}));
    EXPECT_EQ(normal_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}), fallback_normal) << "no area";
  }
  EXPECT_EQ(face_normal({0, 0, 0}, {1, 1, 1}, {2, 2, 2}), glm::vec3(0.0F)) << "no area";
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
  // The limits are degrees, just above what was measured.
  const std::tuple<const char*, Mesh, Weighting, double> rows[] = {
      {"sphere by area", sphere(32, 64), Weighting::area,
       0.95},  // next to the poles, where areas are unequal
      {"sphere by angle", sphere(32, 64), Weighting::angle, 0.09},
      {"torus by area", torus(1.0F, 0.4F, 64, 32), Weighting::area, 0.18},
      {"torus by angle", torus(1.0F, 0.4F, 64, 32), Weighting::angle, 0.18},
      {"icosphere by angle", test::icosphere(4), Weighting::angle, 0.15},
  };
  for (const auto& [name, exact, weighting, limit] : rows) {
    Mesh mesh = exact;
    smooth_normals(mesh, weighting);
    double worst = 0.0;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
      worst = std::max(worst, degrees_between(mesh.normals[v], exact.normals[v]));
    EXPECT_LT(worst, limit) << name;
    EXPECT_GT(worst, 0.0) << name << ": the exact normals were left as they are";
  }
}

// Of an OBJ file: which faces share a normal, and by how much each of them counts, worked out by hand.
TEST(Normals, of_a_file_follow_weights_positions_and_smoothing_groups) {
  // Two triangles along the x axis at right angles: one lies in z = 0 and has area 1/2, the other stands in
  // y = 0; it has area 3/2, or 1/2 with its tip at vertex 5.
  const std::string fold = "v 0 0 0\nv 1 0 0\nv 0 -1 0\nv 0 0 3\nv 0 0 1\nv 1 0 1\n", flat = "f 1 3 2\n";
  const glm::dvec3 up(0, 0, 1), front(0, -1, 0), between(0, -1, 1);
  const auto area = Weighting::area, angle = Weighting::angle;
  // The normals of some corners, and the number of vertices after welding.
  using Normals = std::vector<std::pair<std::size_t, glm::dvec3>>;
  const std::tuple<std::string, Weighting, Normals, std::size_t> rows[] = {
      {flat + "f 1 2 4\n", area, {{0, {0, -1.5, 0.5}}}, 4},
      {flat + "f 1 2 4\n", angle, {{0, between}}, 4},  // both corners have 90 degrees
      // The second face is a square, whose diagonal ends at vertex 1: by area it counts twice.
      {flat + "f 1 2 6\nf 1 6 5\n", area, {{0, {0, -2, 1}}}, 5},
      {flat + "f 1 2 6\nf 1 6 5\n", angle, {{0, between}}, 5},
      // The second triangle has lines of its own for the two points that it shares.
      {flat + "v 0 0 0\nv 1 0 0\nf 7 8 5\n", angle, {{0, between}, {3, between}}, 6},
      // One group, or never switched on: all smooth.
      {"s 1\n" + flat + "f 1 2 5\n", angle, {{0, between}, {3, between}}, 4},
      {"s 1\n" + flat + "s 1\nf 1 2 5\n", angle, {{0, between}, {3, between}}, 4},
      // Creases.
      {"s 1\n" + flat + "s 2\nf 1 2 5\n", angle, {{0, up}, {3, front}}, 6},
      {"s off\n" + flat + "s 3\nf 1 2 5\n", angle, {{0, up}, {3, front}}, 6},
      // Off, two triangles share an edge and no normal.
      {"s 1\n" + flat + "s off\nf 1 2 5\nf 1 5 2\n", angle, {{0, up}, {3, front}, {6, -front}}, 9},
      // What stands before the first s line is off too.
      {flat + "f 1 2 5\ns 1\nf 1 2 5\n", angle, {{0, up}, {3, front}, {6, front}}, 9},
  };
  for (const auto& [faces, weighting, normals, vertices] : rows) {
    SCOPED_TRACE(faces);
    ObjData data = parse_obj(fold + faces, "a.obj");
    generate_missing_normals(data, weighting);
    for (const auto& [corner, direction] : normals)
      EXPECT_LT(
          glm::distance(glm::dvec3(data.normals[data.corners[corner].normal]), glm::normalize(direction)),
          1e-6)
          << "corner " << corner;
    EXPECT_EQ(weld(data).vertex_count(), vertices);
  }
}

TEST(Normals, of_a_file_can_be_taken_away_and_made_anew) {
  ObjData data = parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 0 0\nf 1//1 2//1 3//1\n", "a.obj");
  generate_missing_normals(data, Weighting::angle);
  EXPECT_EQ(data.normals.size(), 1U) << "none is missing";
  remove_normals(data);
  generate_missing_normals(data, Weighting::angle);
  EXPECT_EQ(weld(data).normals[0], glm::vec3(0, 0, 1));
}

TEST(Normals, flat_ones_split_only_where_faces_differ) {
  Mesh cube =
      weld(parse_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\nf 1 5 2\n", "a.obj"));
  flat_normals(cube, face_normal);
  EXPECT_EQ(cube.vertex_count(), 7U);  // the two triangles of the square share, the third one does not
  for (std::size_t i = 0; i < cube.indices.size(); ++i)
    EXPECT_EQ(cube.normals[cube.indices[i]], i < 6 ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0)) << i;
}

TEST(Normals, of_triangles_without_area_fall_back_and_add_nothing_to_their_neighbours) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}, {1, 0, 1}};
  mesh.indices = {0, 1, 2, 3, 3, 4};
  smooth_normals(mesh, Weighting::angle);
  for (const glm::vec3& normal : mesh.normals) EXPECT_EQ(normal, fallback_normal);
  flat_normals(mesh);
  for (const glm::vec3& normal : mesh.normals) EXPECT_EQ(normal, fallback_normal);
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
  mesh.indices = {0, 1, 2, 0, 1, 3};
  smooth_normals(mesh, Weighting::area);
  EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
  EXPECT_EQ(mesh.normals[3], fallback_normal);
}

}  // namespace
}  // namespace texel::mesh
