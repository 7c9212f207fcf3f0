// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <glm/gtc/matrix_transform.hpp>

#include "answers/answer.hpp"
#include "app/camera.hpp"
#include "truth/ray.hpp"

/// The scene of the labs' truths: its numbers in double precision.
namespace texel::answers {

/// The camera of a picture of `size` pixels.
inline truth::Camera camera_of(const app::OrbitCamera& camera, glm::ivec2 size) {
  return {.yaw = camera.yaw,
          .pitch = camera.pitch,
          .distance = camera.distance,
          .field_of_view = camera.field_of_view,
          .width = size.x,
          .height = size.y};
}

/// Rotations by `degrees`: about x, +y leans forward to +z; about y, +z turns to +x.
inline glm::dmat3 about_x(double degrees) {
  return glm::dmat3(glm::rotate(glm::dmat4(1), glm::radians(degrees), glm::dvec3(1, 0, 0)));
}
inline glm::dmat3 about_y(double degrees) {
  return glm::dmat3(glm::rotate(glm::dmat4(1), glm::radians(degrees), glm::dvec3(0, 1, 0)));
}

/// Exchanges halves, quarters, … of the pixel in place_in_pixel: other places, as evenly spread (a digital
/// shift, Kollig and Keller). 0 for the usual ones. For one thread, while no other asks.
inline glm::uvec2 place_shift(0);

/// The i-th of `count` places (a power of two) at which a pixel is looked at, -1/2 to 1/2 from its middle,
/// which is their mean. One lies in the middle of each of `count` columns and rows, and in each box of any
/// shape between: an edge, upright or level, is found to 1/count of a pixel, for which a square grid needs
/// count^2 places. The earlier half of them is spread as evenly as the later half. Source: Sobol's (0,
/// 2)-sequence as T. Kollig and A. Keller have it, "Efficient Multidimensional Sampling" (2002).
inline glm::dvec2 place_in_pixel(std::uint32_t i, std::uint32_t count) {
  std::uint32_t x = 0, y = 0;
  for (std::uint32_t bit = 1U << 31, direction = bit; i != 0; i >>= 1, bit >>= 1, direction ^= direction >> 1)
    if ((i & 1) != 0) {
      x ^= bit;
      y ^= direction;
    }
  const double middle = place_shift == glm::uvec2(0) ? 0.5 / count : 0;
  return glm::dvec2(x ^ place_shift.x, y ^ place_shift.y) * 0x1p-32 + middle - 0.5;
}

}  // namespace texel::answers
