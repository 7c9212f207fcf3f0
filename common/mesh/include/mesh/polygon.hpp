// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace texel::mesh {

using Triangle = std::array<std::uint32_t, 3>;

/// How a polygon was cut into triangles.
enum class Cut {
  fan,   ///< triangles (0, i, i+1), which is right for convex polygons and more
  ears,  ///< concave: by clipping ears
  /// It crosses itself, has no area, or has more than max_clipped_corners: some triangles may overlap.
  approximate,
};

/// Concave polygons with more corners are fanned, since clipping ears takes quadratic time.
inline constexpr std::size_t max_clipped_corners = 4096;

/// Cuts a polygon, given by its corners in order around it, into corners - 2 triangles of the same winding,
/// written as indices into `corners`; nothing for fewer than 3 corners. Works in the polygon's own plane,
/// whose normal is Newell's (Sutherland, Sproull and Schumacker 1974), so the corners need not lie exactly in
/// it. `triangles` is overwritten; giving the same vector each time spares allocations.
Cut triangulate(std::span<const glm::vec3> corners, std::vector<Triangle>& triangles);

}  // namespace texel::mesh
