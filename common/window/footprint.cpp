// SPDX-License-Identifier: MIT
#include "footprint.hpp"

#include <glad/gl.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "procedural/cube.hpp"

namespace texel::window {
namespace {

/// (s, t) of the pixel with this column and row of the 3x3; nothing where it is not known.
using PlaceAt = std::function<std::optional<glm::dvec2>(int x, int y)>;

std::optional<glm::dvec3> value_at(const image::ImageF& around, int x, int y) {
  const glm::dvec3 value(around.at(x, y, 0), around.at(x, y, 1), around.at(x, y, 2));
  if (around.at(x, y, 3) <= 0 || !std::isfinite(value.x + value.y + value.z)) return std::nullopt;
  return value;
}

std::optional<Footprint> footprint(const PlaceAt& place_at) {
  const std::optional<glm::dvec2> middle = place_at(1, 1);
  if (!middle) return std::nullopt;
  const auto step = [&](glm::ivec2 to) {
    std::optional<glm::dvec2> shortest;
    for (const int side : {1, -1}) {
      const std::optional<glm::dvec2> neighbour = place_at(1 + side * to.x, 1 + side * to.y);
      if (!neighbour) continue;
      const glm::dvec2 moved = static_cast<double>(side) * (*neighbour - *middle);
      if (!shortest || glm::length(moved) < glm::length(*shortest)) shortest = moved;
    }
    return shortest.value_or(glm::dvec2(0));
  };
  return Footprint{*middle, step({1, 0}), step({0, 1}), 0};
}

}  // namespace

glm::dvec2 Footprint::sides(glm::dvec2 size) const {
  const double a = glm::length(dx * size), b = glm::length(dy * size);
  return {std::max(a, b), std::min(a, b)};
}

double Footprint::level(glm::dvec2 size, double anisotropy) const {
  constexpr double kLeast = 0x1p-50;  // as in shaders/lib/level_of_detail.glsl: nothing changes
  const glm::dvec2 side = glm::max(sides(size), glm::dvec2(kLeast));
  return std::log2(side.x / std::clamp(std::ceil(side.x / side.y), 1.0, std::max(anisotropy, 1.0)));
}

std::optional<Footprint> footprint_of_texcoords(const image::ImageF& around) {
  return footprint([&](int x, int y) -> std::optional<glm::dvec2> { return value_at(around, x, y); });
}

std::optional<Footprint> footprint_of_directions(const image::ImageF& around) {
  const std::optional<glm::dvec3> middle = value_at(around, 1, 1);
  if (!middle || *middle == glm::dvec3(0)) return std::nullopt;
  const procedural::Face face = procedural::face_coordinate(*middle).face;
  std::optional<Footprint> result = footprint([&](int x, int y) -> std::optional<glm::dvec2> {
    const std::optional<glm::dvec3> direction = value_at(around, x, y);
    if (!direction || *direction == glm::dvec3(0)) return std::nullopt;
    const procedural::FaceCoordinate met = procedural::face_coordinate(*direction);
    if (met.face != face) return std::nullopt;
    return glm::dvec2(met.s, met.t);
  });
  result->face = static_cast<int>(face);
  return result;
}

double wrapped(double coordinate, unsigned mode) {
  const double tile = std::floor(coordinate), within = coordinate - tile;
  if (mode == GL_REPEAT) return within;
  if (mode == GL_MIRRORED_REPEAT) return std::fmod(tile, 2) != 0 ? 1 - within : within;
  return std::clamp(coordinate, 0.0, 1.0);
}

}  // namespace texel::window
