// SPDX-License-Identifier: MIT
#include "procedural/cube_maps.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "procedural/shapes.hpp"

namespace texel::procedural {

namespace {

using glm::dvec3;

/// What the labelled cube shows on a face, and where up is for the one who reads it.
struct Label {
  const char* name;
  const char* word;
  dvec3 color;  // linear light
  dvec3 up;
};
constexpr Label labels[] = {
    {"+X", "RIGHT", {0.62, 0.022, 0.022}, {0, 1, 0}}, {"-X", "LEFT", {0.02, 0.40, 0.46}, {0, 1, 0}},
    {"+Y", "UP", {0.06, 0.42, 0.03}, {0, 0, 1}},      {"-Y", "DOWN", {0.42, 0.03, 0.40}, {0, 0, -1}},
    {"+Z", "BACK", {0.025, 0.08, 0.62}, {0, 1, 0}},   {"-Z", "FRONT", {0.80, 0.42, 0.01}, {0, 1, 0}}};

}  // namespace

glm::dvec3 direction(image::Face face, double s, double t) {
  return glm::normalize(image::axes(face) * dvec3(2 * s - 1, 2 * t - 1, 1));
}

glm::dvec3 smooth_color(glm::dvec3 d) {
  d = glm::normalize(d);
  // Harmonics of degree 1 to 3 whose weights keep each sum within 0..1; squared, the colours are deeper.
  const dvec3 sum(0.5 + 0.42 * d.x + 0.55 * d.y * d.z, 0.5 + 0.42 * d.y + 0.55 * d.z * d.x,
                  0.5 + 0.36 * d.z + 1.30 * d.x * d.y * d.z);
  return sum * sum;
}

glm::dvec3 labelled_color(glm::dvec3 d) {
  const image::Face face = image::face_coordinate(d).face;
  const Label& text = labels[static_cast<int>(face)];
  const glm::dmat3& axis = image::axes(face);
  // What one sees from the middle of the cube: x to the right, y up, both -1..1 on the face.
  const dvec3 right = glm::cross(axis[2], text.up);
  const double depth = glm::dot(d, axis[2]);
  const double x = glm::dot(d, right) / depth, y = glm::dot(d, text.up) / depth;

  const dvec3 white(0.95);
  const double rim = std::max(std::abs(x), std::abs(y));
  if (rim > 0.97) return white;
  if (rim > 0.90) return text.color * 0.45;

  const auto on_text = [&](const char* line, double middle_x, double bottom, double size, double weight) {
    return in_text(line, (x - middle_x) / size + 0.5 * text_width(line), (y - bottom) / size, weight);
  };
  if (on_text(text.name, 0.0, 0.12, 0.095, 0.75)) return white;
  if (on_text(text.word, 0.0, -0.20, 0.034, 0.70)) return white;

  // Arrows from a common foot below the word; they point where s and t of the table grow.
  const double ux = glm::dot(axis[0], right), vy = glm::dot(axis[1], text.up);
  const double foot = vy > 0 ? -0.76 : -0.40;
  if (in_arrow(x * ux, y - foot, 0.34, 0.032) || in_arrow((y - foot) * vy, x, 0.34, 0.032)) return white;
  if (on_text("+u", 0.50 * ux, foot - 0.08, 0.026, 0.70)) return white;
  if (on_text("+v", -0.20 * ux, foot + 0.20 * vy - 0.08, 0.026, 0.70)) return white;

  const bool line = std::abs(std::remainder(x, 0.225)) < 0.004 || std::abs(std::remainder(y, 0.225)) < 0.004;
  return line ? text.color * 0.78 : text.color;
}

}  // namespace texel::procedural
