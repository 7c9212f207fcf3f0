// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "procedural/textures.hpp"
#include "truth/ray.hpp"

namespace texel::truth {

/// A texture without texels: the colour at a texture coordinate, linear-light RGB and alpha.
using TextureFunction = std::function<glm::dvec4(glm::dvec2 texcoord)>;

/// procedural::colour as such a function: repeats on the unit square.
TextureFunction texture_function(procedural::Texture texture);

/// A texture of texels; row 0 at the bottom (t = 0). The caller decides what they mean: linear light for the
/// course's colour.
struct Bitmap {
  int width = 0, height = 0;
  std::vector<glm::dvec4> texels;  ///< width * height, row by row

  [[nodiscard]] const glm::dvec4& at(int x, int y) const {
    return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// The function's value at the middle of each texel.
Bitmap sampled(const TextureFunction& function, int width, int height);

/// What coordinates outside 0..1 read (GL_REPEAT, GL_MIRRORED_REPEAT, GL_CLAMP_TO_EDGE).
enum class Wrap { repeat, mirrored, clamp };

/// The texel that holds the coordinate: index floor(s * width). On the border of two texels, the one with the
/// larger index. The bitmap must have a texel and the coordinate be finite, below 1e15 texels. Source: OpenGL
/// 3.3 core specification, "Texture Minification".
glm::dvec4 nearest(const Bitmap& bitmap, glm::dvec2 texcoord, Wrap wrap = Wrap::repeat);

/// The four nearest texels weighted by area: exact weights, where graphics hardware has 8 bits of them.
/// Source: the same.
glm::dvec4 bilinear(const Bitmap& bitmap, glm::dvec2 texcoord, Wrap wrap = Wrap::repeat);

/// The level of detail of an isotropic mipmap lookup: log2 of the longer of the two gradients, measured in
/// texels of a base level of `size` texels. Not clamped; minus infinity if both are 0. Source: the same,
/// "Scale Factor and Level of Detail".
double level_of_detail(const TexcoordGradient& gradient, glm::dvec2 size);

/// The mean of a function of the place over a pixel: n x n samples in the middles of equal squares, whose
/// lower left corner is `corner` (a box filter of one pixel). For a smooth function the error falls with
/// 1 / n^2, across an edge with 1 / n.
glm::dvec4 pixel_mean(const std::function<glm::dvec4(glm::dvec2 window)>& colour, glm::dvec2 corner, int n);

/// The textured square of lab 1 seen by a camera.
struct QuadPicture {
  Camera camera;
  Placement world_from_object;  ///< such as tilted() below
  double half_size = 0.7;
  TexcoordMap texcoord_map;  ///< such as texture scale and offset
  TextureFunction texture;
  glm::dvec4 background{0};

  /// The colour that the ray through a place of the picture meets.
  [[nodiscard]] glm::dvec4 at(glm::dvec2 window) const;
  /// The reference for pixel (x, y), row 0 at the bottom: n x n rays, box filter, linear light. With a
  /// background of alpha 0 and an opaque texture, RGB is premultiplied and alpha is the coverage.
  [[nodiscard]] glm::dvec4 pixel(int x, int y, int n = 16) const;
};

/// Turned about the x axis by `degrees`, the top leaning away from the eye: lab 1's tilt.
Placement tilted(double degrees);

/// The exact mean of procedural::Texture::checker's pattern (8 x 8 fields, 0 in the lower left corner, 1
/// beside it) over the rectangle from `low` to `high`, low < high: written as (1 - q(s) q(t)) / 2 with the
/// square wave q, its mean is (1 - Q_s Q_t) / 2, where Q is the mean of q over a side. Independent of any
/// sampling.
double checker_mean(glm::dvec2 low, glm::dvec2 high);

}  // namespace texel::truth
