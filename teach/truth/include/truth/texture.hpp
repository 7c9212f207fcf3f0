// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <mutex>
#include <optional>
#include <vector>

#include "truth/ray.hpp"

namespace texel::truth {

/// A texture without texels: the colour at a texture coordinate, linear-light RGB and alpha.
using TextureFunction = std::function<glm::dvec4(glm::dvec2 texcoord)>;

/// The level of detail of an isotropic mipmap lookup: log2 of the longer of the two gradients, measured in
/// texels of a base level of `size` texels. Not clamped; minus infinity if both are 0. Source: the same,
/// "Scale Factor and Level of Detail".
double level_of_detail(const TexcoordGradient& gradient, glm::dvec2 size);

/// The mean of a texture that repeats over many of its texels, by integrals along s that are worked out once.
/// Samples of fields that are far smaller than a pixel would need tens of thousands.
class RepeatedTexture {
 public:
  /// `period`: after so much in s and t the texture begins again.
  explicit RepeatedTexture(TextureFunction texture, double period = 1)
      : texture_(std::move(texture)), period_(period) {}

  /// The mean over a convex quadrilateral, corners in order, texture coordinates. Nothing if it is smaller
  /// than a 64th of the period's area: then samples are as good. Off by at most 0.003, measured beside the
  /// areas of a checker's fields; the integral has 512 x 512 cells. Several threads may ask at a time.
  [[nodiscard]] std::optional<glm::dvec4> mean(std::array<glm::dvec2, 4> corners) const;

 private:
  void prepare() const;
  TextureFunction texture_;
  double period_;
  mutable std::once_flag is_prepared_;
  mutable std::vector<glm::dvec4> sums_;  ///< of each row of cells, from s = 0 to the beginning of each cell
};

/// The textured square of lab 1 seen by a camera.
struct QuadPicture {
  Camera camera;
  Placement world_from_object;  ///< such as tilted() below
  TexcoordMap texcoord_map;     ///< such as texture scale and offset
  TextureFunction texture;

  /// The colour that the ray through a place of the picture meets; 0 beside the square.
  [[nodiscard]] glm::dvec4 operator()(glm::dvec2 window) const;
  /// The mean over the pixel around a place, if its texture repeats; nothing at the square's edge and where
  /// samples are as good.
  [[nodiscard]] std::optional<glm::dvec4> mean(const RepeatedTexture& repeated, glm::dvec2 middle) const;
};

/// Turned about the x axis by `degrees`, the top leaning away from the eye: lab 1's tilt.
Placement tilted(double degrees);

}  // namespace texel::truth
