// SPDX-License-Identifier: MIT
#include "truth/relief.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "../support/oracles.hpp"
#include "procedural/height_fields.hpp"
#include "procedural/noise.hpp"

namespace texel::truth {
namespace {

using glm::dvec2;
using glm::dvec3;
using test::angle;
using test::mirrored;
using test::sheared;
using test::stretched;

const double eighth_turn = glm::radians(45.0);

/// Places on a surface, with the gradient of the smooth bumps there.
struct Bump {
  dvec2 st, slope;
};
std::vector<Bump> bumps() {
  std::vector<Bump> all;
  for (int i = 0; i < 200; ++i) {
    const dvec2 st(procedural::random(i, 0, 3), 0.05 + 0.9 * procedural::random(i, 1, 3));
    const procedural::Dual h = procedural::height(procedural::HeightField::bump, st.s, st.t);
    all.push_back({st, {h.du, h.dv}});
  }
  return all;
}

dvec3 texel_at(dvec2 st) {
  return procedural::normal(procedural::HeightField::bump, st.s, st.t);
}

TEST(TruthRelief, gradient_lies_in_the_surface_and_gives_the_change_of_height_along_every_step) {
  for (const Surface& surface :
       {quad(), sphere(2), torus(1, 0.4), reparameterized(torus(1, 0.4), sheared(0.7)),
        placed(sphere(), {{dvec3(4, 0, 0), dvec3(0.5, 1, 0), dvec3(0, 0, 1)}})})
    for (const auto& [st, slope] : bumps()) {
      const SurfacePoint p = surface(st);
      const dvec3 gradient = surface_gradient(p, slope);
      // Roundings of slopes of at most 0.5 and steps of at most 26 units.
      EXPECT_LT(std::abs(glm::dot(gradient, p.normal)), 1e-15);
      EXPECT_NEAR(glm::dot(gradient, p.ds), slope.s, 1e-14);
      EXPECT_NEAR(glm::dot(gradient, p.dt), slope.t, 1e-14);
      // Constant height leaves the normal as it is.
      EXPECT_LT(angle(relief_normal(p, {0, 0}), p.normal), 1e-15);
      EXPECT_LT(angle(relief_normal(p, slope, 0), p.normal), 1e-15);
    }
}

TEST(TruthRelief, height_field_does_not_depend_on_how_the_texture_coordinates_run) {
  const Surface surface = torus(1, 0.4);
  for (const TexcoordMap& map : {sheared(eighth_turn), stretched(4), mirrored()})
    for (const auto& [st, slope] : bumps()) {
      // The same heights in other coordinates: the gradient of h(parameter(texcoord)) by the chain rule.
      const dvec2 other_slope = glm::transpose(glm::inverse(map.linear)) * slope;
      const SurfacePoint other = reparameterized(surface, map)(map.texcoord(st));
      EXPECT_LT(angle(relief_normal(other, other_slope), relief_normal(surface(st), slope)), 4e-15);
    }
}

TEST(TruthRelief, both_truths_agree_where_the_texture_keeps_right_angles_and_lengths_alone) {
  // The square of 1.4 units: a texture width is 1.4 units long along s and t, so heights are 1.4 times as
  // high.
  for (const auto& [st, slope] : bumps())
    for (const Surface& surface : {quad(), cube_face(image::Face::negative_x, 0.7)}) {
      const SurfacePoint p = surface(st);
      EXPECT_LT(angle(relief_normal(p, 1.4 * slope), mapped_normal(orthonormal_frame(p), texel_at(st))),
                4e-16);
    }
  const auto mean_difference = [](const TexcoordMap& map) {
    double sum = 0;
    for (const auto& [st, slope] : bumps()) {
      const SurfacePoint p = reparameterized(quad(0.5), map)(st);
      sum +=
          test::angle_in_degrees(relief_normal(p, slope), mapped_normal(orthonormal_frame(p), texel_at(st)));
    }
    return sum / 200;
  };
  EXPECT_LT(mean_difference({}), 1e-13);
  EXPECT_LT(mean_difference(mirrored()), 1e-13) << "handedness takes care of it";
  EXPECT_GT(mean_difference(sheared(eighth_turn)), 5.0);
  EXPECT_GT(mean_difference(stretched(4)), 5.0);
}

TEST(TruthRelief, a_texel_is_read_along_the_axes_of_the_frame) {
  const Frame frame = orthonormal_frame(sphere()({0.25, 0.5}));
  EXPECT_LT(angle(mapped_normal(frame, {0, 0, 5}), {1, 0, 0}), 1e-15) << "the flat texel is the normal";
  EXPECT_LT(angle(mapped_normal(frame, {1, 0, 0}), {0, 0, -1}), 1e-15) << "x is where s grows";
  EXPECT_LT(angle(mapped_normal(frame, {0, 1, 0}), {0, 1, 0}), 1e-15) << "y is where t grows";
}

}  // namespace
}  // namespace texel::truth
