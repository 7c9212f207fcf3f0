// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "app/canvas.hpp"

namespace texel::app {

/// One axis of a surface's tangent frame, as a line over the picture: places from (0, 0), the picture's upper
/// left corner, to (1, 1).
struct FrameLine {
  enum class Axis { tangent, bitangent, normal } axis;
  glm::vec2 from, to;
};

/// T, B and N on a grid over the visible surface, of those that the lab draws as views. They are the
/// surface's own: without the normal map. B stands at right angles to N and T, on the side to which t grows.
/// `spacing` in pixels. Throws Error as Canvas::draw.
std::vector<FrameLine> frame_lines(Canvas& canvas, AnyLab& lab, glm::ivec2 size, int spacing);

}  // namespace texel::app
