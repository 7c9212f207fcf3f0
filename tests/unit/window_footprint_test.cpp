// SPDX-License-Identifier: MIT
// What a pixel covers of a texture, beside coordinates and derivatives that are known.
#include <glad/gl.h>
#include <gtest/gtest.h>

#include <functional>

#include "procedural/cube_maps.hpp"
#include "texture_view.hpp"
#include "truth/cube_map.hpp"

namespace texel::window {
namespace {

/// The values of 3x3 pixels; x and y from -1 to 1. Those of the mask's bits are missing, the first is the
/// lower left.
image::ImageF around(const std::function<glm::dvec3(double x, double y)>& value, unsigned missing = 0) {
  image::ImageF picture(3, 3, 4);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) {
      if ((missing >> (3 * y + x) & 1U) != 0) continue;
      const glm::dvec3 v = value(x - 1, y - 1);
      for (int c = 0; c < 3; ++c) picture.at(x, y, c) = static_cast<float>(v[c]);
      picture.at(x, y, 3) = 1;
    }
  return picture;
}
constexpr unsigned kLeft = 1U << 3, kMiddle = 1U << 4, kRight = 1U << 5;

// Coordinates are read from a float picture: near 1 they are exact to 2^-24, and their differences to 2^-23.
constexpr double kExact = 0x1p-22;

void expect_near(glm::dvec2 value, glm::dvec2 expected, double within) {
  EXPECT_NEAR(value.x, expected.x, within);
  EXPECT_NEAR(value.y, expected.y, within);
}

glm::dvec3 sheared(double x, double y) {
  return {0.3 + 0.02 * x + 0.004 * y, 0.6 - 0.01 * x + 0.03 * y, 0};
}

std::optional<Footprint> texcoords(const image::ImageF& picture) {
  return footprint_of(picture, /*is_cube=*/false);
}
std::optional<Footprint> directions(const image::ImageF& picture) {
  return footprint_of(picture, /*is_cube=*/true);
}

TEST(Footprint, is_the_parallelogram_of_the_coordinates_by_the_neighbours_that_are_there) {
  const Footprint f = *texcoords(around(sheared));
  expect_near(f.place, {0.3, 0.6}, kExact);
  expect_near(f.dx, {0.02, -0.01}, kExact);
  expect_near(f.dy, {0.004, 0.03}, kExact);
  expect_near(f.at(0.5, -0.5), {0.308, 0.58}, kExact);
  for (const unsigned missing : {kLeft, kRight})
    expect_near(texcoords(around(sheared, missing))->dx, {0.02, -0.01}, kExact);
  EXPECT_EQ(texcoords(around(sheared, kLeft | kRight))->dx, glm::dvec2(0));
  EXPECT_FALSE(texcoords(around(sheared, kMiddle)));
  // It does not cross a seam, where the coordinate begins again.
  const auto seam = [](double x, double y) { return sheared(x, y) - glm::dvec3(x > 0 ? 1 : 0, 0, 0); };
  expect_near(texcoords(around(seam))->dx, {0.02, -0.01}, kExact);
}

TEST(Footprint, has_the_level_of_its_longer_side_or_of_a_part_of_it) {
  const Footprint f{{0, 0}, {8.0 / 256, 0}, {0, 2.0 / 128}};
  EXPECT_EQ(f.sides({256, 128}), glm::dvec2(8, 2));
  EXPECT_EQ(f.level({256, 128}, 1), 3);
  EXPECT_EQ(f.level({256, 128}, 2), 2);
  EXPECT_EQ(f.level({256, 128}, 16), 1) << "four samples are enough";
  EXPECT_EQ(Footprint{}.level({256, 128}, 1), -50) << "nothing changes, as in lib/level_of_detail.glsl";
}

TEST(Footprint, lies_on_the_face_that_the_direction_meets) {
  const glm::dvec3 step_x(1e-3, 2e-3, -1e-3), step_y(-2e-3, 1e-3, 1e-3);
  for (const image::Face face : procedural::faces) {
    const glm::dvec3 middle = procedural::direction(face, 0.3, 0.8);
    const Footprint f =
        *directions(around([&](double x, double y) { return middle + x * step_x + y * step_y; }));
    const truth::TexcoordGradient exact = truth::face_gradient(middle, {step_x, step_y});
    EXPECT_EQ(f.face, static_cast<int>(face));
    expect_near(f.place, {0.3, 0.8}, kExact);
    // A difference is not the derivative: half the second one is of the order of 1e-3 squared.
    expect_near(f.dx, exact.dx, 1e-5);
    expect_near(f.dy, exact.dy, 1e-5);
  }
}

TEST(Footprint, stays_on_its_face) {
  const glm::dvec3 middle = procedural::direction(image::Face::positive_z, 0.999, 0.5);
  const auto to_the_right = [&](double x, double) { return middle + glm::dvec3(0.01 * x, 0, 0); };
  EXPECT_GT(directions(around(to_the_right))->dx.x, 0);
  EXPECT_EQ(directions(around(to_the_right, kLeft))->dx.x, 0) << "the right neighbour is on the next face";
}

TEST(Wrapped, goes_where_the_wrap_mode_says) {
  EXPECT_EQ(wrapped(-1.75, GL_REPEAT), 0.25);
  EXPECT_EQ(wrapped(1.25, GL_MIRRORED_REPEAT), 0.75);
  EXPECT_EQ(wrapped(-0.25, GL_MIRRORED_REPEAT), 0.25);
  EXPECT_EQ(wrapped(2.25, GL_MIRRORED_REPEAT), 0.25);
  EXPECT_EQ(wrapped(1.25, GL_CLAMP_TO_EDGE), 1);
}

}  // namespace
}  // namespace texel::window
