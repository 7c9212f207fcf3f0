// SPDX-License-Identifier: MIT
// Where a picture passes: up to the limit and no further, in the unit of its view; and what a wrong one
// scores. tests/labs/score_test.cpp has the scores of wrong pictures of labs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/files.hpp"
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
  /// Grey; in the object's rows the columns from `left` to `right` have the value `there`.
  [[nodiscard]] std::string grey(int value, int left = 0, int right = 0, int there = 0) const {
    image::Image8 picture(kSide, kSide, 3);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        for (int c = 0; c < 3; ++c)
          picture.at(x, y, c) =
              static_cast<std::uint8_t>(x >= left && x < right && y >= 10 && y < 30 ? there : value);
    return bytes_of(picture);
  }
  /// R and G as functions of the pixel.
  template <class Values>
  [[nodiscard]] std::string values(const Values& of, int height = kSide) const {
    image::ImageF picture(kSide, height, 3);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < kSide; ++x) {
        const std::pair<double, double> value = of(x, y);
        picture.at(x, y, 0) = static_cast<float>(value.first);
        picture.at(x, y, 1) = static_cast<float>(value.second);
      }
    return bytes_of(picture);
  }
  /// Directions in the plane of x and y, at an angle to x.
  [[nodiscard]] std::string directions(double degrees) const {
    const double angle = degrees * std::acos(-1.0) / 180;
    return values([=](int, int) { return std::pair(std::cos(angle), std::sin(angle)); });
  }
  /// Coordinates that bend, with a slope of 0.01 to 0.09 a pixel.
  [[nodiscard]] std::string coordinates(double moved) const {
    return values([=](int x, int y) {
      const double at = x + moved;
      return std::pair(0.01 * at + 0.001 * at * at, 0.02 * y);
    });
  }
  [[nodiscard]] Verdict judged(course::View view, double limit, const std::string& right,
                               const std::string& picture) const {
    course::Case one;
    one.view = view, one.size = {kSide, kSide}, one.limit = limit;
    return judge(one, {right, mask_}, picture);
  }

  ScratchFolder folder_;
  std::string mask_;
};

TEST_F(JudgeOfPictures, passes_up_to_the_limit_and_what_a_gpu_rounds_and_no_further) {
  using course::View;
  constexpr double kPasses = -1;
  struct Row {
    const char* what;
    View view;
    double limit;
    std::string right, picture;
    double error;  ///< of one that fails
  };
  const Row rows[] = {
      {"steps", View::color, 3, grey(100), grey(103), kPasses},
      {"steps beyond", View::color, 3, grey(100), grey(104), 4},
      // Columns 9 and 10 lie on both sides of the object's edge, where renderers differ.
      {"the object's edge", View::color, 3, grey(100), grey(100, 9, 11, 200), kPasses},
      {"within the edge", View::color, 3, grey(100), grey(100, 11, 13, 200), 100},
      {"the background alone", View::color, 3, grey(100), grey(100, 0, 9, 200), 100},
      {"degrees", View::normal, 2, directions(0), directions(1.9), kPasses},
      {"degrees beyond", View::normal, 2, directions(0), directions(2.1), 2.1},
      {"a flat picture", View::normal, 0.05, directions(0), directions(0.06), 0.06},
      {"moved by a 256th", View::texcoord, 1e-4, coordinates(0), coordinates(1.0 / 256), kPasses},
      {"moved by a 100th", View::texcoord, 1e-4, coordinates(0), coordinates(-1.0 / 100), kPasses},
      // The whole of it counts.
      {"moved too far", View::texcoord, 1e-4, coordinates(0), coordinates(1.0 / 40),
       (0.01 + 0.002 * 39) / 40}};
  for (const Row& row : rows) {
    const Verdict verdict = judged(row.view, row.limit, row.right, row.picture);
    EXPECT_EQ(verdict.passed, row.error == kPasses) << row.what << ": " << verdict.message;
    // float32 keeps directions to a few 1e-6 degrees.
    if (row.error != kPasses) {
      EXPECT_NEAR(verdict.error, row.error, 1e-4) << row.what;
    }
  }
}

TEST_F(JudgeOfPictures, says_by_how_much_a_direction_is_off) {
  const Verdict off = judged(course::View::normal, 0.1, directions(0), directions(0.3));
  EXPECT_TRUE(off.message.starts_with("Off by 0.3 degrees in 100 % of the object")) << off.message;
}

TEST_F(JudgeOfPictures, counts_pixels_beyond_the_limit_but_not_those_at_it) {
  // Of the 18 columns within the object's edge, 9 are off by 4 and 9 by 3.
  const Verdict off = judged(course::View::color, 3, grey(100), grey(103, 11, 20, 104));
  EXPECT_TRUE(off.message.starts_with("Off by 4 8-bit steps in 50 % of the object")) << off.message;
}

TEST_F(JudgeOfPictures, writes_large_errors_without_an_exponent) {
  const auto flat = [&](double value) { return values([=](int, int) { return std::pair(value, 0.0); }); };
  const Verdict off = judged(course::View::depth, 1, flat(0), flat(999.7));
  EXPECT_TRUE(off.message.starts_with("Off by 1000 units")) << off.message;
}

TEST_F(JudgeOfPictures, sees_a_wrong_background_of_one_pixel) {
  image::Image8 mask(kSide, kSide, 1), wrong(kSide, kSide, 3);
  std::fill(mask.samples.begin(), mask.samples.end(), std::uint8_t{255});
  for (const auto& [x, y] : {std::pair{0, 0}, {0, 1}, {1, 0}, {1, 1}}) mask.at(x, y) = 0;
  mask_ = bytes_of(mask);
  wrong.at(0, 0, 0) = 99;  // the only one that is not at an edge
  const Verdict verdict = judged(course::View::color, 3, grey(0), bytes_of(wrong));
  EXPECT_TRUE(!verdict.passed && verdict.error == 99) << verdict.message;
}

TEST_F(JudgeOfPictures, fails_what_has_another_size_or_numbers_that_are_not_finite) {
  const auto zero = [](int, int) { return std::pair(0.0, 0.0); };
  const std::string right = values(zero);
  EXPECT_TRUE(judged(course::View::texcoord, 1, right, right).passed);
  const Verdict low = judged(course::View::texcoord, 1, right, values(zero, kSide - 1));
  EXPECT_FALSE(low.passed);
  EXPECT_EQ(low.message, "The picture is 40x39 pixels, not 40x40");
  const Verdict grey = judged(course::View::texcoord, 1, right, bytes_of(image::ImageF(kSide, kSide, 1)));
  EXPECT_TRUE(!grey.passed && grey.message.starts_with("The picture ")) << grey.message;
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    const std::string picture =
        values([=](int x, int y) { return std::pair(0.0, x == 20 && y == 20 ? value : 0.0); });
    EXPECT_FALSE(judged(course::View::texcoord, 1, right, picture).passed) << value;
    EXPECT_FALSE(judged(course::View::texcoord, 1, picture, picture).passed) << "the reference's own bytes";
  }
}

TEST(Score, is_half_just_past_the_limit_and_nothing_from_five_times_on) {
  for (const auto& [times_limit, expected] : {std::pair{0.0, 1.0},
                                              {1, 1},
                                              {1.25, 0.46875},
                                              {2, 0.375},
                                              {3, 0.25},
                                              {5, 0},
                                              {7, 0},
                                              {1e9, 0},
                                              {std::numeric_limits<double>::infinity(), 0}})
    EXPECT_DOUBLE_EQ(score(times_limit), expected) << times_limit;
  EXPECT_EQ(score(std::nan("")), 0);
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
                fmt::format("as at the pixel {}, {} ", difference.telling_x, difference.telling_y)),
            std::string::npos)
      << verdict.message;
  // The same pixel of the picture that is shown, and the same figure.
  const image::Compared shown = image::compared(wrong, right, 0.05, 0.2, "depth", false);
  EXPECT_EQ(shown.figures.telling_x, 16);
  EXPECT_EQ(shown.figures.telling_y, 35);
  EXPECT_EQ(shown.full_scale, 0.2);
}

}  // namespace
}  // namespace texel::judge
