// SPDX-License-Identifier: MIT
// FLIP (Andersson et al. 2020) in double precision, with the constants as the paper has them: what
// perception::flip_errors must come near to, and what its speed is measured against.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "perception/perception.hpp"

namespace texel::perception {

using image::Image8;
using Vector = glm::dvec3;

/// X and Z of D65, Y = 1 (IEC 61966-2-1).
inline constexpr Vector white_xyz = {23359437.0 / 24577794, 1, 80288307.0 / 73733382};

/// The linear part of an sRGB-encoded value, both 0 to 1.
double plain_linear(double encoded);
Vector plain_xyz(const Vector& linear_rgb);
/// L*a*b* with the Hunt effect of linear RGB.
Vector plain_hunt_lab(const Vector& linear_rgb);
double plain_hyab(const Vector& a, const Vector& b);
/// A HyAB distance as an error of 0 to 1.
double plain_color_error(double distance);

/// The error of each pixel, row after row.
std::vector<double> plain_flip(const Image8& reference, const Image8& image);

}  // namespace texel::perception
