// SPDX-License-Identifier: MIT
#include "truth/relief.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "procedural/height_fields.hpp"
#include "procedural/noise.hpp"
#include "truth/basis.hpp"

namespace texel::truth {
namespace {

using glm::dvec2;
using glm::dvec3;

dvec2 inner_texcoord(int i) {
  return {procedural::random(i, 0, 3), 0.05 + 0.9 * procedural::random(i, 1, 3)};
}

/// The gradient of the smooth bumps, `width` world units to the texture width.
dvec2 bump_gradient(dvec2 st, double width = 1) {
  const procedural::Dual h = procedural::height(procedural::HeightField::bump, st.s, st.t);
  return width * dvec2(h.du, h.dv);
}
double bump(dvec2 st) {
  return procedural::height(procedural::HeightField::bump, st.s, st.t).value;
}

TEST(TruthRelief, constant_height_leaves_the_normal_as_it_is) {
  for (const Surface& surface :
       {quad(), sphere(), torus(1, 0.4), reparameterised(torus(1, 0.4), sheared(0.7))})
    for (int i = 0; i < 100; ++i) {
      const SurfacePoint p = surface(inner_texcoord(i));
      EXPECT_LT(angle(relief_normal(p, {0, 0}), p.normal), 1e-15);
      EXPECT_LT(angle(relief_normal(p, bump_gradient(inner_texcoord(i)), 0), p.normal), 1e-15);
      // A sphere or torus that grows keeps its normals: every tube's radius is changed alike.
      EXPECT_LT(angle(displaced_normal(p, 0.05, {0, 0}), p.normal), 2e-15);
    }
}

TEST(TruthRelief, gradient_lies_in_the_surface_and_gives_the_change_of_height_along_every_step) {
  for (const Surface& surface : {sphere(2), torus(1, 0.4), reparameterised(torus(1, 0.4), sheared(0.7)),
                                 placed(sphere(), {{dvec3(4, 0, 0), dvec3(0.5, 1, 0), dvec3(0, 0, 1)}})})
    for (int i = 0; i < 200; ++i) {
      const dvec2 st = inner_texcoord(i), slope = bump_gradient(st);
      const SurfacePoint p = surface(st);
      const dvec3 gradient = surface_gradient(p, slope);
      // Roundings of slopes of at most 0.5 and steps of at most 26 units.
      EXPECT_LT(std::abs(glm::dot(gradient, p.normal)), 1e-15);
      EXPECT_NEAR(glm::dot(gradient, p.ds), slope.s, 1e-14);
      EXPECT_NEAR(glm::dot(gradient, p.dt), slope.t, 1e-14);
    }
}

TEST(TruthRelief, height_field_does_not_depend_on_how_the_texture_coordinates_run) {
  const Surface surface = torus(1, 0.4);
  for (const TexcoordMap& map : {sheared(std::numbers::pi / 4), stretched(4), mirrored()})
    for (int i = 0; i < 200; ++i) {
      const dvec2 st = inner_texcoord(i), slope = bump_gradient(st);
      // The same heights in other coordinates: the gradient of h(parameter(texcoord)) by the chain rule.
      const dvec2 other_slope = glm::transpose(glm::inverse(map.linear)) * slope;
      const SurfacePoint other = reparameterised(surface, map)(map.texcoord(st));
      EXPECT_LT(angle(relief_normal(other, other_slope), relief_normal(surface(st), slope)), 4e-15);
    }
}

TEST(TruthRelief, displaced_normal_is_that_of_the_surface_that_moves) {
  const double strength = 0.7, step = 1e-5;
  for (const Surface& surface : {sphere(), torus(1, 0.4), reparameterised(torus(1, 0.4), mirrored()),
                                 reparameterised(sphere(), sheared(0.7))}) {
    double worst = 0;
    for (int i = 0; i < 300; ++i) {
      const dvec2 st = inner_texcoord(i);
      const auto moved = [&](dvec2 at) {
        const SurfacePoint p = surface(at);
        return p.position + strength * bump(at) * p.normal;
      };
      const SurfacePoint p = surface(st);
      const dvec3 ds = moved(st + dvec2(step, 0)) - moved(st - dvec2(step, 0));
      const dvec3 dt = moved(st + dvec2(0, step)) - moved(st - dvec2(0, step));
      const dvec3 across = glm::cross(ds, dt) * handedness(p.ds, p.dt, p.normal);
      worst = std::max(worst, angle(displaced_normal(p, bump(st), bump_gradient(st), strength), across));
    }
    EXPECT_LT(worst, 1e-8);  // measured 2.7e-9: the step squared times the bumps' third derivative
  }
}

TEST(TruthRelief, shallow_relief_is_the_limit_of_the_displaced_surface) {
  // What Blinn's formula leaves out is proportional to the height, when the slope stays: relief of 1/4 of the
  // height and 4 times the frequency has 1/4 of the difference.
  const Surface surface = torus(1, 0.4);
  const auto worst = [&](double times) {
    double largest = 0;
    for (int i = 0; i < 300; ++i) {
      const dvec2 st = inner_texcoord(i);
      const SurfacePoint p = surface(st);
      const dvec2 slope = bump_gradient(times * st);
      largest = std::max(
          largest, angle(displaced_normal(p, bump(times * st) / times, slope), relief_normal(p, slope)));
    }
    return largest;
  };
  EXPECT_GT(worst(1), 1e-3);
  EXPECT_NEAR(worst(4) / worst(1), 0.25, 0.06);     // measured 0.27: other points of the relief are met
  EXPECT_NEAR(worst(256) / worst(64), 0.25, 0.06);  // measured 0.29
}

TEST(TruthRelief, both_truths_agree_where_the_texture_keeps_right_angles_and_lengths) {
  // The square of 1.4 units: a texture width is 1.4 units long along s and t, so heights are 1.4 times as
  // high.
  const double width = 1.4;
  for (int i = 0; i < 200; ++i) {
    const dvec2 st = inner_texcoord(i);
    const dvec3 texel = procedural::normal(procedural::HeightField::bump, st.s, st.t);
    for (const Surface& surface : {quad(), cube_face(procedural::Face::negative_x, 0.7)}) {
      const SurfacePoint p = surface(st);
      EXPECT_LT(angle(relief_normal(p, bump_gradient(st, width)), mapped_normal(orthonormal_frame(p), texel)),
                4e-16);
    }
  }
}

TEST(TruthRelief, both_truths_differ_by_design_under_shear_and_stretch) {
  const auto mean_difference = [](const TexcoordMap& map) {
    double sum = 0;
    for (int i = 0; i < 200; ++i) {
      const dvec2 st = inner_texcoord(i);
      const SurfacePoint p = reparameterised(quad(0.5), map)(st);
      const dvec3 texel = procedural::normal(procedural::HeightField::bump, st.s, st.t);
      sum +=
          angle_in_degrees(relief_normal(p, bump_gradient(st)), mapped_normal(orthonormal_frame(p), texel));
    }
    return sum / 200;
  };
  EXPECT_LT(mean_difference({}), 1e-13);
  EXPECT_LT(mean_difference(mirrored()), 1e-13) << "handedness takes care of it";
  EXPECT_GT(mean_difference(sheared(std::numbers::pi / 4)), 5.0);
  EXPECT_GT(mean_difference(stretched(4)), 5.0);
}

TEST(TruthRelief, baking_and_reading_a_texel_gives_the_normal_back) {
  for (int i = 0; i < 200; ++i) {
    const SurfacePoint p = reparameterised(torus(1, 0.4), sheared(0.7))(inner_texcoord(i));
    const dvec3 wanted = relief_normal(p, bump_gradient(inner_texcoord(i)), 3);
    for (const Frame& frame : {orthonormal_frame(p), parametric_frame(p)}) {
      const dvec3 texel = baked_texel(frame, wanted);
      EXPECT_NEAR(glm::length(texel), 1, 1e-15);
      EXPECT_LT(angle(mapped_normal(frame, texel), wanted), 4e-15);
    }
  }
  const Frame frame = orthonormal_frame(sphere()({0.25, 0.5}));
  EXPECT_LT(angle(mapped_normal(frame, {0, 0, 5}), {1, 0, 0}), 1e-15) << "the flat texel is the normal";
  EXPECT_LT(angle(mapped_normal(frame, {1, 0, 0}), {0, 0, -1}), 1e-15) << "x is where s grows";
  EXPECT_LT(angle(mapped_normal(frame, {0, 1, 0}), {0, 1, 0}), 1e-15) << "y is where t grows";
}

}  // namespace
}  // namespace texel::truth
