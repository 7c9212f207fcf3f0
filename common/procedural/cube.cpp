// SPDX-License-Identifier: MIT
#include "procedural/cube.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "procedural/shapes.hpp"

namespace texel::procedural {

namespace {

using glm::dvec3;

/// Of each face, as columns: the directions in which s, t and the major axis grow. The specification's sc, tc
/// and ma are a direction's components along them.
const glm::dmat3 axes[] = {
    {dvec3(0, 0, -1), dvec3(0, -1, 0), dvec3(1, 0, 0)}, {dvec3(0, 0, 1), dvec3(0, -1, 0), dvec3(-1, 0, 0)},
    {dvec3(1, 0, 0), dvec3(0, 0, 1), dvec3(0, 1, 0)},   {dvec3(1, 0, 0), dvec3(0, 0, -1), dvec3(0, -1, 0)},
    {dvec3(1, 0, 0), dvec3(0, -1, 0), dvec3(0, 0, 1)},  {dvec3(-1, 0, 0), dvec3(0, -1, 0), dvec3(0, 0, -1)}};

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

const char* file_name(Face face) {
  static constexpr const char* names[] = {"px", "nx", "py", "ny", "pz", "nz"};
  return names[static_cast<int>(face)];
}

glm::dvec3 direction(Face face, double s, double t) {
  return glm::normalize(axes[static_cast<int>(face)] * dvec3(2 * s - 1, 2 * t - 1, 1));
}

FaceCoordinate face_coordinate(glm::dvec3 d) {
  const dvec3 size = glm::abs(d);
  Face face = d.z < 0 ? Face::negative_z : Face::positive_z;
  if (size.x >= size.y && size.x >= size.z) {
    face = d.x < 0 ? Face::negative_x : Face::positive_x;
  } else if (size.y >= size.z) {
    face = d.y < 0 ? Face::negative_y : Face::positive_y;
  }
  const dvec3 coordinate =
      d * axes[static_cast<int>(face)];  // the dot products with the columns: sc, tc, |ma|
  return {face, 0.5 * (coordinate.x / coordinate.z + 1), 0.5 * (coordinate.y / coordinate.z + 1)};
}

glm::dvec3 smooth_color(glm::dvec3 d) {
  d = glm::normalize(d);
  // Harmonics of degree 1 to 3 whose weights keep each sum within 0..1; squared, the colours are deeper.
  const dvec3 sum(0.5 + 0.42 * d.x + 0.55 * d.y * d.z, 0.5 + 0.42 * d.y + 0.55 * d.z * d.x,
                  0.5 + 0.36 * d.z + 1.30 * d.x * d.y * d.z);
  return sum * sum;
}

glm::dvec3 labelled_color(glm::dvec3 d) {
  const int face = static_cast<int>(face_coordinate(d).face);
  const Label& text = labels[face];
  const glm::dmat3& axis = axes[face];
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
