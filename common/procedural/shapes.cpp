// SPDX-License-Identifier: MIT
#include "procedural/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace texel::procedural {

namespace {

/// A character's strokes as polylines, parted by spaces: each pair of digits is a point (x, y).
std::string_view strokes(char c) {
  switch (c) {
    case 'A':
      return "0004264440 0242";
    case 'B':
      return "00063645443303 3342413000";
    case 'C':
      return "4536160501103041";
    case 'D':
      return "00062644422000";
    case 'E':
      return "46060040 0333";
    case 'F':
      return "460600 0333";
    case 'G':
      return "45361605011030414323";
    case 'H':
      return "0006 4046 0343";
    case 'I':
      return "1030 1636 2026";
    case 'J':
      return "4641301001";
    case 'K':
      return "0006 4602 1340";
    case 'L':
      return "060040";
    case 'M':
      return "0006234640";
    case 'N':
      return "00064046";
    case 'O':
      return "100105163645413010";
    case 'P':
      return "00063645443303";
    case 'Q':
      return "100105163645413010 2240";
    case 'R':
      return "00063645443303 2340";
    case 'S':
      return "453616050413334241301001";
    case 'T':
      return "0646 2026";
    case 'U':
      return "060110304146";
    case 'V':
      return "062046";
    case 'W':
      return "0610233046";
    case 'X':
      return "0046 0640";
    case 'Y':
      return "062346 2320";
    case 'Z':
      return "06460040";
    case '0':
      return "100105163645413010 1135";
    case '1':
      return "152620 1030";
    case '2':
      return "05163645440040";
    case '3':
      return "0516364544334241301001 1333";
    case '4':
      return "30360242";
    case '5':
      return "460603334241301001";
    case '6':
      return "4536160501103041423303";
    case '7':
      return "064610";
    case '8':
      return "130405163645443313 1302011030414233";
    case '9':
      return "0110304145361605041343";
    case '+':
      return "0343 2125";
    case '.':
      return "2021";
    case '-':
      return "0343";
    case 's':
      return "4414031232413000";
    case 't':
      return "1611203041 0434";
    case 'u':
      return "0401103041 4440";
    case 'v':
      return "042044";
    default:
      return "";
  }
}

double distance_to_character(char c, double x, double y) {
  double nearest = 1e9;
  const std::string_view points = strokes(c);
  for (std::size_t i = 0; i + 3 < points.size(); i += 2) {
    if (points[i + 2] == ' ') {  // the polyline ends here; the next one begins after the space
      ++i;
      continue;
    }
    nearest = std::min(nearest, distance_to_segment(x, y, points[i] - '0', points[i + 1] - '0',
                                                    points[i + 2] - '0', points[i + 3] - '0'));
  }
  return nearest;
}

}  // namespace

double distance_to_segment(double x, double y, double x0, double y0, double x1, double y1) {
  const double dx = x1 - x0, dy = y1 - y0;
  const double along = std::clamp(((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(x - x0 - along * dx, y - y0 - along * dy);
}

bool in_text(std::string_view text, double x, double y, double half_stroke) {
  if (y < -half_stroke || y > 6 + half_stroke) return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const double own_x = x - 6.0 * static_cast<double>(i);
    if (own_x < -half_stroke || own_x > 4 + half_stroke) continue;
    if (distance_to_character(text[i], own_x, y) < half_stroke) return true;
  }
  return false;
}

bool in_arrow(double x, double y, double length, double width) {
  const double head = 3.2 * width;
  if (x > length - head) return x < length && std::abs(y) < 0.62 * (length - x);
  return x > -0.5 * width && std::abs(y) < 0.5 * width;
}

bool in_star(double x, double y, int points, double outer, double inner) {
  // Fold the plane onto half a point, from its tip on the x axis to the notch: there the edge is one line.
  const double half_turn = std::numbers::pi / points;
  const double angle = std::abs(std::remainder(std::atan2(x, y), 2 * half_turn)), r = std::hypot(x, y);
  const double notch_x = inner * std::cos(half_turn), notch_y = inner * std::sin(half_turn);
  return (r * std::cos(angle) - outer) * notch_y < (notch_x - outer) * r * std::sin(angle);
}

}  // namespace texel::procedural
