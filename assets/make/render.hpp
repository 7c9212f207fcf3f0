// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <glm/vec4.hpp>

#include "image/image.hpp"

namespace texel::assets {

/// Linear-light colour and straight alpha at (u, v); u runs right and v up, 0..1 over the picture.
using Colour = std::function<glm::dvec4(double u, double v)>;

/// A picture of a function: each pixel is the mean of samples x samples points of its area, averaged in
/// linear light (colour weighted by alpha, so that a transparent surrounding does not tint an edge), then
/// sRGB-encoded. `channels`: 1 grey (the mean of R, G and B), 2 grey and alpha, 3 RGB, 4 RGBA. Uses all
/// cores; the result does not depend on how many.
image::Image8 render(int width, int height, int channels, int samples, const Colour& colour);

/// Calls row(y) for every y in 0..height-1, on all cores.
void for_each_row(int height, const std::function<void(int y)>& row);

}  // namespace texel::assets
