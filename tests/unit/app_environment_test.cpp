// SPDX-License-Identifier: MIT
#include "app/environment.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace texel::app {
namespace {

constexpr int kSide = 16;

/// Six faces; all samples of face i are 40 i, which says where a texel was read.
std::array<image::Image8, 6> numbered_faces() {
  std::array<image::Image8, 6> faces;
  for (std::size_t i = 0; i < 6; ++i) {
    faces[i] = image::Image8(kSide, kSide, 3);
    std::fill(faces[i].samples.begin(), faces[i].samples.end(), static_cast<std::uint8_t>(40 * i));
  }
  return faces;
}

/// Six faces of one colour.
std::array<image::Image8, 6> plain_faces(int side) {
  image::Image8 face(side, side, 3);
  std::fill(face.samples.begin(), face.samples.end(), std::uint8_t{93});
  std::array<image::Image8, 6> faces;
  faces.fill(face);
  return faces;
}

/// Which face each place of a picture shows: x, y and the face.
void expect_faces(const image::Image8& picture, std::initializer_list<std::tuple<int, int, int>> places) {
  for (const auto& [x, y, face] : places) EXPECT_EQ(picture.at(x, y) / 40, face) << x << " " << y;
}

enum : int { kPositiveX, kNegativeX, kPositiveY, kNegativeY, kPositiveZ, kNegativeZ };

TEST(EquirectangularMap, shows_each_face_where_the_worksheets_u_and_v_point) {
  const image::Image8 map = equirectangular_map(numbered_faces());
  ASSERT_EQ(map.width, 4 * kSide);
  ASSERT_EQ(map.height, 2 * kSide);
  expect_faces(map, {{0, kSide, kPositiveZ},          // u = 0
                     {kSide, kSide, kNegativeX},      // u = 1/4
                     {2 * kSide, kSide, kNegativeZ},  // u = 1/2
                     {3 * kSide, kSide, kPositiveX},  // u = 3/4, that is -1/4
                     {kSide, 0, kPositiveY},          // v = 0: the north pole
                     {kSide, 2 * kSide - 1, kNegativeY}});
}

TEST(SphereMap, shows_each_face_where_a_ball_reflects_it_towards_positive_z) {
  const image::Image8 map = sphere_map(numbered_faces());
  ASSERT_EQ(map.width, 2 * kSide);
  ASSERT_EQ(map.height, 2 * kSide);
  // The ball's normal leans by 45 degrees where it shows a direction at right angles: sin(45) = 0.71 of the
  // way out.
  const int near = 4, middle = kSide, far = 27;
  expect_faces(map, {{middle, middle, kPositiveZ},
                     {far, middle, kPositiveX},
                     {near, middle, kNegativeX},
                     {middle, far, kPositiveY},
                     {middle, near, kNegativeY},
                     {0, middle, kNegativeZ},  // the rim
                     {0, 0, kNegativeZ}});     // and beyond it
}

TEST(EquirectangularMap, keeps_a_plain_color_exactly_and_halves_faces_that_are_too_large) {
  for (const int side : {kSide, 2050}) {
    const image::Image8 map = equirectangular_map(plain_faces(side));
    EXPECT_EQ(map.width, 4 * (side == 2050 ? 1025 : side));
    EXPECT_EQ(2 * map.height, map.width);
    EXPECT_EQ(std::count(map.samples.begin(), map.samples.end(), 93), std::ssize(map.samples));
  }
  EXPECT_EQ(sphere_map(plain_faces(2050)).width, 2 * 1025);
}

}  // namespace
}  // namespace texel::app
