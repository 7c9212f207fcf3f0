// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "procedural/dual.hpp"

/// A point's place in a pattern: which brick, plank or scale, and how far inside. Height fields and
/// colours are both made from these and match each other. Lengths are in texture widths; all repeat
/// on the unit square.
namespace texel::procedural {

/// A brick of the running bond, 4 across and 8 high.
template <class Real>
struct Brick {
  int column = 0, row = 0;
  Real x, y;    ///< from the brick's middle
  Real inside;  ///< 0 in the mortar, 1 on the face, between them the bevel
};
/// Of double for its colour, and of Dual for its height.
template <class Real>
Brick<Real> brick_at(Real u, Real v);

/// A plank, 6 above each other, each as long as the texture is wide, with its ends staggered.
struct Plank {
  int row = 0;
  Dual x, y;    ///< from the plank's middle: x along it, -0.5 to 0.5, y across it
  Dual inside;  ///< 0 in the groove between two planks, 1 on the face, between them the rounded edge
  Dual ring;    ///< age of the wood: a growth ring for each whole number
  Dual knot;    ///< 1 in the middle of a knot, 0 away from it
};
Plank plank_at(double u, double v);

/// One of the scales that may cover a point.
struct Scale {
  int column = 0, row = 0;
  Dual x,
      y;     ///< in columns and rows from where it is held: its tip lies at y = -1.2, its sides at x = +-0.5
  Dual rim;  ///< distance to its free edge, positive inside
  Dual cover;  ///< 1 where it hides what lies below it, 0 outside, between them its rounded rim
};
inline constexpr int scale_columns = 8, scale_rows = 12;

/// The three scales that may cover a point, the lowest first; the lowest covers it wherever no other does.
std::array<Scale, 3> scales_at(double u, double v);

}  // namespace texel::procedural
