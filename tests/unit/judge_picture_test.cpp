// SPDX-License-Identifier: MIT
// Where a picture passes: up to the limit and no further, in the unit of its view. What a wrong one scores is
// in tests/labs/score_test.cpp.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/files.hpp"
#include "core/scratch_folder.hpp"
#include "image/compared.hpp"
#include "image/save.hpp"
#include "judge/judge.hpp"

namespace texel::judge {
namespace {

constexpr int kSide = 40;

/// Pictures in which a square is the object.
class JudgeOfPictures : public testing::Test {
 protected:
  JudgeOfPictures() {
    image::Image8 mask(kSide, kSide, 1);
    for (int y = 10; y < 30; ++y)
      for (int x = 10; x < 30; ++x) mask.at(x, y) = 255;
    mask_ = bytes_of(mask);
  }

  [[nodiscard]] std::string bytes_of(const image::Image8& picture) const {
    image::save_png(folder_.path() / "a.png", picture);
    return read_file(folder_.path() / "a.png");
  }
  [[nodiscard]] std::string bytes_of(const image::ImageF& picture) const {
    image::save_pfm(folder_.path() / "a.pfm", picture);
    return read_file(folder_.path() / "a.pfm");
  }
  [[nodiscard]] std::string grey(int value) const {
    image::Image8 picture(kSide, kSide, 3);
    std::fill(picture.samples.begin(), picture.samples.end(), static_cast<std::uint8_t>(value));
    return bytes_of(picture);
  }
  /// Directions in the plane of x and y, at an angle to x.
  [[nodiscard]] std::string directions(double degrees) const {
    image::ImageF picture(kSide, kSide, 3);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        picture.at(x, y, 0) = static_cast<float>(std::cos(degrees * std::acos(-1.0) / 180));
        picture.at(x, y, 1) = static_cast<float>(std::sin(degrees * std::acos(-1.0) / 180));
      }
    return bytes_of(picture);
  }
  [[nodiscard]] Verdict judged(course::View view, double limit, const std::string& right,
                               const std::string& picture) const {
    course::Case one;
    one.view = view, one.size = {kSide, kSide}, one.limit = limit;
    return judge(one, {right, mask_}, picture);
  }

 private:
  ScratchFolder folder_;
  std::string mask_;
};

TEST_F(JudgeOfPictures, passes_colors_up_to_the_limit_in_steps) {
  const std::string right = grey(100);
  EXPECT_TRUE(judged(course::View::color, 3, right, grey(103)).passed);
  const Verdict beyond = judged(course::View::color, 3, right, grey(104));
  EXPECT_FALSE(beyond.passed);
  EXPECT_EQ(beyond.error, 4);
}

TEST_F(JudgeOfPictures, passes_directions_up_to_the_limit_in_degrees) {
  const std::string right = directions(0);
  EXPECT_TRUE(judged(course::View::normal, 2, right, directions(1.9)).passed);
  const Verdict beyond = judged(course::View::normal, 2, right, directions(2.1));
  EXPECT_FALSE(beyond.passed);
  EXPECT_NEAR(beyond.error, 2.1, 1e-4);  // float32 keeps directions to a few 1e-6 degrees
}

TEST_F(JudgeOfPictures, fails_numbers_that_are_not_finite_also_where_the_bytes_are_the_references) {
  image::ImageF picture(kSide, kSide, 3);
  EXPECT_TRUE(judged(course::View::texcoord, 1, bytes_of(picture), bytes_of(picture)).passed);
  for (const float value : {std::nanf(""), std::numeric_limits<float>::infinity()}) {
    picture.at(20, 20, 1) = value;
    EXPECT_FALSE(judged(course::View::texcoord, 1, bytes_of(picture), bytes_of(picture)).passed) << value;
  }
}

TEST_F(JudgeOfPictures, passes_a_right_picture_that_is_moved_by_what_a_gpu_rounds_and_by_no_more) {
  // Coordinates that bend, with a slope of 0.01 to 0.09 a pixel.
  const auto coordinates = [&](float moved) {
    image::ImageF picture(kSide, kSide, 3);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const float at = static_cast<float>(x) + moved;
        picture.at(x, y, 0) = 0.01F * at + 0.001F * at * at;
        picture.at(x, y, 1) = 0.02F * static_cast<float>(y);
      }
    return bytes_of(picture);
  };
  const std::string right = coordinates(0);
  EXPECT_TRUE(judged(course::View::texcoord, 1e-4, right, coordinates(1.0F / 256)).passed);
  EXPECT_TRUE(judged(course::View::texcoord, 1e-4, right, coordinates(-1.0F / 100)).passed);
  const Verdict beyond = judged(course::View::texcoord, 1e-4, right, coordinates(1.0F / 40));
  EXPECT_FALSE(beyond.passed);
  EXPECT_NEAR(beyond.error, (0.01 + 0.002 * 39) / 40, 1e-4) << "the whole of it";
}

TEST_F(JudgeOfPictures, forgives_nothing_where_the_right_picture_is_flat) {
  EXPECT_FALSE(judged(course::View::normal, 0.05, directions(0), directions(0.06)).passed);
}

TEST_F(JudgeOfPictures, names_a_pixel_that_has_the_error_that_is_told) {
  // One pixel of the background is farther off: it is the thousandth that does not count.
  image::ImageF right(kSide, kSide, 3), wrong(kSide, kSide, 3);
  wrong.at(15, 35, 0) = 0.3F, wrong.at(16, 35, 0) = 0.2F, wrong.at(17, 35, 0) = 0.1F;
  const std::string bytes = bytes_of(wrong);
  const image::Difference difference = image::compare(right, wrong);
  const Verdict verdict = judged(course::View::depth, 0.01, bytes_of(right), bytes);
  EXPECT_NEAR(verdict.error, difference.p999, 1e-7);
  EXPECT_NEAR(wrong.at(difference.telling_x, difference.telling_y, 0), verdict.error, 1e-7);
  EXPECT_NE(verdict.message.find(
                fmt::format("so is the pixel {}, {} ", difference.telling_x, difference.telling_y)),
            std::string::npos)
      << verdict.message;
  // The same pixel of the picture that is shown, and the same figure.
  const image::Compared shown = image::compared(wrong, right, 0.05, 0.2, "depth", image::Unit::own);
  EXPECT_EQ(shown.figures.telling_x, 16);
  EXPECT_EQ(shown.figures.telling_y, 35);
  EXPECT_EQ(shown.full_scale, 0.2);
}

}  // namespace
}  // namespace texel::judge
