// SPDX-License-Identifier: MIT
#include "app/environment.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace texel::app {
namespace {

constexpr int kSide = 16;

/// Six faces of one colour each: the red channel of face i is 40 i, which says where a texel was read.
std::array<image::Image8, 6> plain_faces() {
  std::array<image::Image8, 6> faces;
  for (std::size_t i = 0; i < 6; ++i) {
    faces[i] = image::Image8(kSide, kSide, 3);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) faces[i].at(x, y) = static_cast<std::uint8_t>(40 * i);
  }
  return faces;
}

int face_at(const image::Image8& picture, int x, int y) {
  return picture.at(x, y) / 40;
}

enum : int { kPositiveX, kNegativeX, kPositiveY, kNegativeY, kPositiveZ, kNegativeZ };

TEST(EquirectangularMap, shows_each_face_where_the_worksheets_u_and_v_point) {
  const image::Image8 map = equirectangular_map(plain_faces());
  ASSERT_EQ(map.width, 4 * kSide);
  ASSERT_EQ(map.height, 2 * kSide);
  EXPECT_EQ(face_at(map, 0, kSide), kPositiveZ);          // u = 0
  EXPECT_EQ(face_at(map, kSide, kSide), kNegativeX);      // u = 1/4
  EXPECT_EQ(face_at(map, 2 * kSide, kSide), kNegativeZ);  // u = 1/2
  EXPECT_EQ(face_at(map, 3 * kSide, kSide), kPositiveX);  // u = 3/4, that is -1/4
  EXPECT_EQ(face_at(map, kSide, 0), kPositiveY);          // v = 0: the north pole
  EXPECT_EQ(face_at(map, kSide, 2 * kSide - 1), kNegativeY);
}

TEST(SphereMap, shows_each_face_where_a_ball_reflects_it_towards_positive_z) {
  const image::Image8 map = sphere_map(plain_faces());
  ASSERT_EQ(map.width, 2 * kSide);
  ASSERT_EQ(map.height, 2 * kSide);
  // The ball's normal leans by 45 degrees where it shows a direction at right angles: sin(45) = 0.71 of the
  // way out.
  const int near = 4, middle = kSide, far = 27;
  EXPECT_EQ(face_at(map, middle, middle), kPositiveZ);
  EXPECT_EQ(face_at(map, far, middle), kPositiveX);
  EXPECT_EQ(face_at(map, near, middle), kNegativeX);
  EXPECT_EQ(face_at(map, middle, far), kPositiveY);
  EXPECT_EQ(face_at(map, middle, near), kNegativeY);
  EXPECT_EQ(face_at(map, 0, middle), kNegativeZ);  // the rim
  EXPECT_EQ(face_at(map, 0, 0), kNegativeZ);       // and beyond it
}

TEST(EquirectangularMap, keeps_a_plain_color_exactly) {
  std::array<image::Image8, 6> faces;
  faces.fill(image::Image8(kSide, kSide, 3));
  for (image::Image8& face : faces) std::fill(face.samples.begin(), face.samples.end(), std::uint8_t{93});
  const image::Image8 map = equirectangular_map(faces);
  for (const std::uint8_t sample : map.samples) ASSERT_EQ(sample, 93);
}

TEST(EquirectangularMap, halves_faces_that_are_too_large) {
  std::array<image::Image8, 6> faces;
  faces.fill(image::Image8(2050, 2050, 3));
  for (image::Image8& face : faces) std::fill(face.samples.begin(), face.samples.end(), std::uint8_t{93});
  const image::Image8 map = equirectangular_map(faces);
  EXPECT_EQ(map.width, 4 * 1025);
  EXPECT_EQ(map.height, 2 * 1025);
  EXPECT_EQ(std::count(map.samples.begin(), map.samples.end(), 93), std::ssize(map.samples));
  EXPECT_EQ(sphere_map(std::move(faces)).width, 2 * 1025);
}

}  // namespace
}  // namespace texel::app
