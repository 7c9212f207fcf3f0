// SPDX-License-Identifier: MIT
#include "truth/surface.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "../support/oracles.hpp"
#include "procedural/cube_maps.hpp"
#include "procedural/noise.hpp"

namespace texel::truth {
namespace {

using glm::dvec2;
using glm::dvec3;
using std::numbers::pi;
using test::angle;
using test::mirrored;
using test::orthonormality;
using test::sheared;
using test::stretched;

dvec2 texcoord(int i) {
  return {procedural::random(i, 0, 5), procedural::random(i, 1, 5)};
}

TEST(TruthBasis, handedness_changes_with_every_swap_and_turn) {
  const dvec3 t(2, 0, 0), b(1, 3, 0), n(0, 0, 1);
  EXPECT_EQ(handedness(t, b, n), 1.0);
  EXPECT_EQ(handedness(b, t, n), -1.0);
  EXPECT_EQ(handedness(-t, b, n), -1.0);
  EXPECT_EQ(handedness(t, b, -n), -1.0);
  EXPECT_EQ(handedness(t, -2.0 * t, n), 0.0);
}

std::vector<std::pair<std::string, Surface>> surfaces() {
  const Placement skewed{{dvec3(2, 0.3, 0), dvec3(-0.4, 0.5, 0.1), dvec3(0.2, 0, 1.5)}, {3, -2, 1}};
  const Placement mirror{{dvec3(-1, 0, 0), dvec3(0, 4, 0), dvec3(0, 0, 1)}, {0, 0, 0}};
  std::vector<std::pair<std::string, Surface>> all{
      {"quad", quad(0.7)},
      {"sphere", sphere(1.5)},
      {"torus", torus(1, 0.4)},
      {"sheared torus", reparameterized(torus(1, 0.4), sheared(pi / 4))},
      {"stretched torus", reparameterized(torus(1, 0.4), stretched(4))},
      {"mirrored sphere", reparameterized(sphere(), mirrored())},
      {"skewed sphere", placed(sphere(), skewed)},
      {"mirrored, stretched torus", placed(torus(1, 0.4), mirror)},
      {"both", placed(reparameterized(torus(1, 0.4), sheared(-0.6)), skewed)}};
  for (const image::Face face : procedural::faces)
    all.emplace_back(fmt::format("cube {}", static_cast<int>(face)), cube_face(face, 0.5));
  return all;
}

TEST(TruthSurface, derivatives_are_what_differences_show) {
  for (const auto& [name, surface] : surfaces())
    for (int i = 0; i < 500; ++i) {
      const SurfacePoint point = surface(texcoord(i));
      const auto along = [&, &at = surface](dvec2 direction) {
        return test::difference(2e-6, [&](double d) { return at(texcoord(i) + d * direction).position; });
      };
      // Measured: 1.4e-10 of the longer one, half of it the rounding of 1e-16 over the step.
      const double most = 6e-10 * std::max({glm::length(point.ds), glm::length(point.dt), 1.0});
      ASSERT_LT(glm::distance(point.ds, along({1, 0})), most) << name;
      ASSERT_LT(glm::distance(point.dt, along({0, 1})), most) << name;
    }
}

TEST(TruthSurface, normals_and_frames_are_orthonormal_and_their_sign_is_that_of_the_texture) {
  for (const auto& [name, surface] : surfaces())
    for (int i = 0; i < 500; ++i) {
      const SurfacePoint p = surface(texcoord(i));
      // A few roundings of 1.1e-16 of the lengths involved.
      ASSERT_NEAR(glm::length(p.normal), 1, 1e-15) << name;
      ASSERT_LT(std::abs(glm::dot(p.normal, p.ds)), 4e-15 * glm::length(p.ds) + 4e-15) << name;
      ASSERT_LT(std::abs(glm::dot(p.normal, p.dt)), 4e-15 * glm::length(p.dt) + 4e-15) << name;
      const Frame frame = orthonormal_frame(p);
      ASSERT_LT(orthonormality({frame.tangent, frame.bitangent, frame.normal}), 1e-14) << name;
      ASSERT_EQ(frame.handedness, name.find("mirrored") != std::string::npos ? -1.0 : 1.0) << name;
      ASSERT_GT(glm::dot(frame.bitangent, p.dt), 0.0) << name;
    }
}

TEST(TruthSurface, normal_points_outward_however_the_texture_or_the_object_is_mirrored) {
  const Placement mirror{{dvec3(-1, 0, 0), dvec3(0, 4, 0), dvec3(0, 0, 1)}};
  for (const Surface& ball : {sphere(), reparameterized(sphere(), mirrored()), placed(sphere(), mirror)})
    for (int i = 0; i < 100; ++i) {
      const SurfacePoint p = ball(texcoord(i));
      EXPECT_GT(glm::dot(p.normal, p.position), 0.2);  // at least 1/4 of the ellipsoid's longest axis
    }
  for (const image::Face face : procedural::faces)
    EXPECT_EQ(cube_face(face, 0.5)({0.3, 0.6}).normal, procedural::direction(face, 0.5, 0.5));
  EXPECT_EQ(quad()({0.3, 0.6}).normal, dvec3(0, 0, 1));
}

TEST(TruthSurface, corners_and_quarters_lie_where_the_shapes_are_documented) {
  using image::Face;
  const std::tuple<Surface, dvec2, dvec3> rows[] = {{quad(0.7), {0, 0}, {-0.7, -0.7, 0}},
                                                    {quad(0.7), {1, 1}, {0.7, 0.7, 0}},
                                                    {sphere(), {0, 0.5}, {0, 0, 1}},
                                                    {sphere(), {0.25, 0.5}, {1, 0, 0}},
                                                    {sphere(), {0.7, 1}, {0, 1, 0}},
                                                    {sphere(), {0.7, 0}, {0, -1, 0}},
                                                    {torus(1, 0.25), {0, 0}, {0, 0, 1.25}},
                                                    {torus(1, 0.25), {0.25, 0.25}, {1, 0.25, 0}},
                                                    {torus(1, 0.25), {0.25, 0.5}, {0.75, 0, 0}},
                                                    {cube_face(Face::positive_z), {0, 0}, {-1, -1, 1}},
                                                    {cube_face(Face::negative_z), {0, 0}, {1, -1, -1}},
                                                    {cube_face(Face::positive_x), {0, 0}, {1, -1, 1}},
                                                    {cube_face(Face::negative_x), {0, 0}, {-1, -1, -1}},
                                                    {cube_face(Face::positive_y), {0, 0}, {-1, 1, 1}},
                                                    {cube_face(Face::negative_y), {0, 0}, {-1, -1, -1}},
                                                    {cube_face(Face::positive_y), {1, 1}, {1, 1, -1}},
                                                    {cube_face(Face::negative_y), {1, 1}, {1, -1, 1}}};
  // Sines and cosines of whole quarters are off by a rounding of pi.
  for (const auto& [surface, st, position] : rows)
    EXPECT_LT(glm::distance(surface(st).position, position), 1e-15) << position.x << ' ' << position.y;
}

TEST(TruthSurface, texture_coordinate_at_poles_and_seam_is_one_of_those_there) {
  EXPECT_EQ(sphere_texcoord({0, 2, 0}), dvec2(0, 1));
  EXPECT_EQ(sphere_texcoord({0, -2, 0}), dvec2(0, 0));
  EXPECT_EQ(sphere_texcoord({0, 0, -1}).s, 0.5);
  EXPECT_LT(sphere_texcoord({-1e-300, 0, 1}).s, 1.0) << "just below the seam";
}

TEST(TruthSurface, frame_at_a_pole_is_the_limit_along_the_meridian) {
  for (const double pole : {0.0, 1.0})
    for (const double s : {0.0, 0.1, 0.6}) {
      const SurfacePoint at_pole = sphere()({s, pole});
      EXPECT_LT(glm::length(at_pole.ds), 1e-15);  // the cosine of pi / 2 rounds to 6e-17
      const Frame frame = orthonormal_frame(at_pole);
      EXPECT_LT(angle(frame.tangent, dvec3(std::cos(2 * pi * s), 0, -std::sin(2 * pi * s))), 1e-15);
      EXPECT_EQ(frame.handedness, 1.0);
    }
}

TEST(TruthSurface, frame_of_another_normal_is_orthonormal_and_keeps_the_side_of_the_tangent) {
  // A flat square with the normal of a smooth neighbour, 45 degrees off towards +x.
  SurfacePoint flat = reparameterized(quad(), mirrored())({0.5, 0.5});
  flat.normal = glm::normalize(dvec3(1, 0, 1));
  const Frame frame = orthonormal_frame(flat);
  EXPECT_LT(angle(frame.tangent, {-1, 0, 1}), 1e-15);  // ds runs to -x, turned into the normal's plane
  EXPECT_LT(angle(frame.bitangent, {0, 1, 0}), 1e-15);
  EXPECT_EQ(frame.normal, flat.normal);
  EXPECT_EQ(frame.handedness, -1.0);
}

TEST(TruthSurface, change_of_parameters_moves_no_point_and_goes_back) {
  for (const TexcoordMap& map : {sheared(0.7), stretched(4), mirrored()})
    for (int i = 0; i < 100; ++i) {
      const dvec2 st = texcoord(i);
      // One rounding of the 2x2 inverse, over the texture of 4 widths.
      EXPECT_LT(glm::distance(map.parameter(map.texcoord(st)), st), 5e-16);
      const dvec3 here = torus(1, 0.4)(st).position;
      EXPECT_LT(glm::distance(reparameterized(torus(1, 0.4), map)(map.texcoord(st)).position, here), 5e-15);
    }
  EXPECT_EQ(stretched(4).texcoord({0.5, 0.5}), dvec2(2, 0.5));
  EXPECT_EQ(mirrored().texcoord({0.25, 0.5}), dvec2(0.75, 0.5));
}

}  // namespace
}  // namespace texel::truth
