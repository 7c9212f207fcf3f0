// SPDX-License-Identifier: MIT
// What tests compare with, in double precision, and no program needs.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "procedural/noise.hpp"
#include "truth/surface.hpp"

namespace texel::test {

/// The i-th of a list of numbers in [0, 1) that stays the same; each axis has its own.
inline double number(int i, int axis) {
  return procedural::random(i, axis, 9);
}

/// The angle between two directions of any length, 0 to pi radians: atan2(|a x b|, a . b), which keeps its
/// accuracy at 0 and at pi, where the arc cosine loses half of its digits (Kahan, "How Futile are Mindless
/// Assessments of Roundoff in Floating-Point Computation?", 2006, "Mangled Angles"). 0 when one of them is
/// zero.
inline double angle(glm::dvec3 a, glm::dvec3 b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

inline double angle_in_degrees(glm::dvec3 a, glm::dvec3 b) {
  return glm::degrees(angle(a, b));
}

/// The central difference of f around 0: its derivative, but for the step squared and rounding over the step.
template <class Function>
auto difference(double step, Function f) {
  return (f(step) - f(-step)) / (2 * step);
}

/// How far three columns are from unit length and right angles: the largest entry of |G - I|, where G is the
/// Gram matrix transpose(m) * m. 0 for a rotation or a mirrored one.
inline double orthonormality(const glm::dmat3& m) {
  const glm::dmat3 gram = glm::transpose(m) * m;
  double largest = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) largest = std::max(largest, std::abs(gram[i][j] - (i == j ? 1.0 : 0.0)));
  return largest;
}

/// The share of unpolarised light that a boundary between two clear media reflects: the mean of Fresnel's two
/// polarisations (Born and Wolf, Principles of Optics, section 1.5.2). 1 on total internal reflection.
/// `cosine` of the angle of incidence.
inline double fresnel(double cosine, double n_from, double n_to) {
  const double eta = n_from / n_to, cos_b_squared = (1 - eta) * (1 + eta) + eta * eta * cosine * cosine;
  if (cos_b_squared <= 0) return 1;
  const double cos_b = std::sqrt(cos_b_squared);
  const double across = (n_from * cosine - n_to * cos_b) / (n_from * cosine + n_to * cos_b);
  const double within = (n_to * cosine - n_from * cos_b) / (n_to * cosine + n_from * cos_b);
  return 0.5 * (across * across + within * within);
}

/// Texture coordinates whose lines of equal s turn by `angle`, towards smaller s as t grows.
inline truth::TexcoordMap sheared(double angle) {
  return {.linear = {glm::dvec2(1, 0), glm::dvec2(std::tan(angle), 1)}};
}

/// The texture repeats `ratio` times as often along s as along t.
inline truth::TexcoordMap stretched(double ratio) {
  return {.linear = {glm::dvec2(ratio, 0), glm::dvec2(0, 1)}};
}

/// s runs the other way: 1 - s.
inline truth::TexcoordMap mirrored() {
  return {.linear = {glm::dvec2(-1, 0), glm::dvec2(0, 1)}, .offset = {1, 0}};
}

/// T where s grows, B where t grows, both in the surface. They are at right angles only where the
/// parameterisation is orthogonal.
inline truth::Frame parametric_frame(const truth::SurfacePoint& point) {
  return {.tangent = glm::normalize(point.ds),
          .bitangent = glm::normalize(point.dt),
          .normal = point.normal,
          .handedness = truth::handedness(point.ds, point.dt, point.normal)};
}

}  // namespace texel::test
