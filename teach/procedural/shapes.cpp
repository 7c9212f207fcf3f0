// SPDX-License-Identifier: MIT
#include "procedural/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace texel::procedural {

namespace {

/// The known characters, and the strokes of each as polylines, parted by spaces: each pair of digits is a
/// point (x, y).
constexpr std::string_view characters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789+.-stuv";
constexpr std::string_view strokes[] = {"0004264440 0242",
                                        "00063645443303 3342413000",
                                        "4536160501103041",
                                        "00062644422000",
                                        "46060040 0333",
                                        "460600 0333",
                                        "45361605011030414323",
                                        "0006 4046 0343",
                                        "1030 1636 2026",
                                        "4641301001",
                                        "0006 4602 1340",
                                        "060040",
                                        "0006234640",
                                        "00064046",
                                        "100105163645413010",
                                        "00063645443303",
                                        "100105163645413010 2240",
                                        "00063645443303 2340",
                                        "453616050413334241301001",
                                        "0646 2026",
                                        "060110304146",
                                        "062046",
                                        "0610233046",
                                        "0046 0640",
                                        "062346 2320",
                                        "06460040",
                                        "100105163645413010 1135",
                                        "152620 1030",
                                        "05163645440040",
                                        "0516364544334241301001 1333",
                                        "30360242",
                                        "460603334241301001",
                                        "4536160501103041423303",
                                        "064610",
                                        "130405163645443313 1302011030414233",
                                        "0110304145361605041343",
                                        "0343 2125",
                                        "2021",
                                        "0343",
                                        "4414031232413000",
                                        "1611203041 0434",
                                        "0401103041 4440",
                                        "042044"};

double distance_to_segment(double x, double y, double x0, double y0, double x1, double y1) {
  const double dx = x1 - x0, dy = y1 - y0;
  const double along = std::clamp(((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(x - x0 - along * dx, y - y0 - along * dy);
}

double distance_to_character(char c, double x, double y) {
  double nearest = 1e9;
  const std::size_t known = characters.find(c);
  const std::string_view points = known == characters.npos ? std::string_view() : strokes[known];
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
