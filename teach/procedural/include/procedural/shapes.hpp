// SPDX-License-Identifier: MIT
#pragma once
#include <string_view>

namespace texel::procedural {

/// Whether (x, y) lies on a line of text whose strokes reach this far to each side of their middle. A capital
/// is 6 high and 4 wide, the next one begins 6 further right; the line's lower left corner is the origin.
/// Known are A-Z, 0-9, point, + and -, and the small letters s, t, u and v; anything else is a space.
bool in_text(std::string_view text, double x, double y, double half_stroke);

/// The width of a line of text in the same unit.
inline double text_width(std::string_view text) {
  return 6.0 * static_cast<double>(text.size()) - 2.0;
}

/// Whether (x, y) lies on an arrow from the origin along +x; its head is 3.2 widths long.
bool in_arrow(double x, double y, double length, double width);

/// Whether (x, y) lies in a star about the origin whose points reach `outer`, one of them along +y, and whose
/// notches lie at `inner`.
bool in_star(double x, double y, int points, double outer, double inner);

}  // namespace texel::procedural
