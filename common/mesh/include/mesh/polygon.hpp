// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace texel::mesh {

using Triangle = std::array<std::uint32_t, 3>;

/// Concave polygons with more corners are fanned, since clipping ears takes quadratic time.
inline constexpr std::size_t max_clipped_corners = 4096;

/// Cuts a polygon, given by its three or more corners in order around it, into corners - 2 triangles of the
/// same winding, written as indices into `corners`. Works in the polygon's own plane, whose normal is
/// Newell's (Sutherland, Sproull and Schumacker 1974), so the corners need not lie exactly in it. False when
/// some triangles may overlap: it crosses itself, has no area, or is concave with more than
/// max_clipped_corners. `triangles` is overwritten; giving the same vector each time spares allocations.
bool triangulate(std::span<const glm::vec3> corners, std::vector<Triangle>& triangles);

/// Twice the signed area of the triangle a b c: positive when counter-clockwise.
inline double area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether some corner of the rest of the polygon lies inside or on the triangle a b c, which is then no ear.
/// Corners at the same place as a, b or c do not count: a polygon with a bridge to a hole has such.
bool holds_a_corner(const std::vector<glm::dvec2>& flat, const std::vector<std::uint32_t>& rest,
                    const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

/// Appends the triangles (0, i, i+1).
void fan(std::size_t corners, std::vector<Triangle>& triangles);

/// Cuts a simple polygon in the plane into triangles (ear clipping; Meisters 1975: each simple polygon has
/// two ears). False when it found a place without an ear and cut a corner all the same. Lab 3 teaches it:
/// labs/03_obj_texcoords/clip_ears.cpp.
bool clip_ears(const std::vector<glm::dvec2>& flat, std::vector<Triangle>& triangles);

}  // namespace texel::mesh
