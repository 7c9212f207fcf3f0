// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "answers/measuring.hpp"
#include "app/legend.hpp"
#include "core/error.hpp"

namespace texel::answers {
namespace {

using app::ErrorFigures;
using app::Measure;
using app::Unit;

Measure in(Unit unit, double scale = 1) {
  return {app::View{}, unit, "", scale};
}

/// A picture one pixel high; each pixel has three values and alpha.
image::ImageF row(std::initializer_list<std::array<float, 4>> pixels) {
  image::ImageF picture(static_cast<int>(pixels.size()), 1, 4);
  auto sample = picture.samples.begin();
  for (const auto& pixel : pixels) sample = std::copy(pixel.begin(), pixel.end(), sample);
  return picture;
}

TEST(ErrorPicture, counts_in_its_unit_and_goes_the_short_way_round_a_surface_that_closes) {
  const image::ImageF a = row({{1, 0, 0, 1}}), b = row({{0, 2, 0, 1}}), c = row({{0.125F, 0.5F, 0, 1}}),
                      d = row({{0.875F, 2.5F, 0, 1}});
  Measure closed = in(Unit::texels, 512);
  closed.repeats = true;
  // Angles do not depend on lengths; 90 degrees is exact by atan2 but for the conversion from radians.
  const std::tuple<image::ImageF, image::ImageF, Measure, float> rows[] = {
      {a, b, in(Unit::degrees), 90},      {a, b, in(Unit::texels), std::sqrt(5.0F)},
      {a, b, in(Unit::steps), 2},         {a, b, in(Unit::levels), 1},
      {a, b, in(Unit::levels, 512), 512}, {c, d, in(Unit::texels, 512), 512 * std::hypot(0.75F, 2.0F)},
      {c, d, closed, 512 * 0.25F}};
  for (const auto& [from, to, measure, error] : rows)
    EXPECT_FLOAT_EQ(error_picture(from, to, measure).at(0, 0), error);
}

TEST(ErrorPicture, is_known_only_where_both_have_a_value) {
  const image::ImageF error =
      error_picture(row({{1, 0, 0, 1}, {1, 0, 0, 0}, {1, 0, 0, 1}}),
                    row({{0, 0, 0, 1}, {0, 0, 0, 1}, {0, 0, 0, 0}}), in(Unit::levels));
  for (int x = 0; x < 3; ++x) EXPECT_EQ(error.at(x, 0, 3), x == 0 ? 1 : 0) << x;
  EXPECT_THROW(error_picture(error, image::ImageF(2, 1, 4), in(Unit::levels)), Error) << "another size";
}

TEST(TruthPicture, asks_at_the_middle_of_each_pixel) {
  image::ImageF picture(3, 3, 4);
  add_truth_rows(
      picture,
      [](glm::dvec2 window) -> std::optional<glm::dvec3> {
        if (window.x > 2) return std::nullopt;
        return glm::dvec3(window, window.y > 2 ? NAN : 0.0);
      },
      0, 3);
  EXPECT_EQ(picture.at(0, 0, 0), 0.5F);
  EXPECT_EQ(picture.at(1, 1, 1), 1.5F);
  EXPECT_EQ(picture.at(1, 1, 3), 1);
  EXPECT_EQ(picture.at(2, 0, 3), 0);  // no answer
  EXPECT_EQ(picture.at(0, 2, 3), 0);  // no finite one
}

TEST(ErrorFigures, leave_out_what_is_not_finite_and_count_it) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const image::ImageF truth = row({{0, 0, 0, 1}, {0, 0, 0, 1}, {0, 0, 0, 1}, {0, 0, 0, 1}});
  const ErrorFigures figures =
      figures_of(row({{3, 0, 0, 1}, {nan, 0, 0, 1}, {4, 0, 0, 1}, {99, 0, 0, 0}}), truth);
  EXPECT_EQ(figures.pixels, 3);
  EXPECT_EQ(figures.truth_pixels, 4);
  EXPECT_EQ(figures.coverage(), 0.75);
  EXPECT_EQ(figures.non_finite, 1);
  EXPECT_DOUBLE_EQ(figures.mean, 3.5);
  EXPECT_DOUBLE_EQ(figures.rms, std::sqrt(12.5));
  EXPECT_EQ(figures.max, 4);
  EXPECT_EQ(figures.median, 3);
}

TEST(ErrorFigures, tell_apart_what_a_move_by_a_pixel_explains) {
  // A step from 0 to 100 that the picture has a pixel too far to the right, and one pixel that is 3 off.
  const image::ImageF truth =
      row({{0, 0, 0, 1}, {100, 0, 0, 1}, {100, 0, 0, 1}, {100, 0, 0, 1}, {100, 0, 0, 1}});
  const image::ImageF picture =
      row({{0, 0, 0, 1}, {1, 0, 0, 1}, {100, 0, 0, 1}, {97, 0, 0, 1}, {100, 0, 0, 1}});
  const image::ImageF error = error_picture(picture, truth, in(Unit::levels));
  ErrorFigures figures = figures_of(error, truth);
  tell_outlines_apart(figures, error, picture, truth, in(Unit::levels));
  EXPECT_EQ(figures.max, 99);
  EXPECT_EQ(figures.max_aside, 3);
  EXPECT_EQ(figures.outline_pixels, 1);
}

TEST(ErrorFigures, say_why_there_are_none) {
  const image::ImageF nothing = row({{0, 0, 0, 0}}), one = row({{1, 0, 0, 1}});
  const image::ImageF nan = row({{std::numeric_limits<float>::quiet_NaN(), 0, 0, 1}});
  EXPECT_EQ(figures_of(one, one).reason, nullptr);
  std::set<std::string> reasons;
  for (const auto& [error, truth] : {std::pair{nan, one}, {nothing, one}, {nothing, nothing}}) {
    const ErrorFigures figures = figures_of(error, truth);
    EXPECT_TRUE(std::isnan(figures.mean + figures.rms + figures.p99 + figures.max));
    reasons.insert(figures.reason);
  }
  EXPECT_EQ(reasons.size(), 3);
}

TEST(ErrorFigures, take_the_99th_percentile_by_nearest_rank) {
  image::ImageF error(200, 1, 4);
  for (int x = 0; x < 200; ++x) {
    error.at(x, 0, 0) = static_cast<float>(200 - x);
    error.at(x, 0, 3) = 1;
  }
  EXPECT_EQ(figures_of(error, error).p99, 198);  // 99 % of 200 values are 198
  EXPECT_EQ(figures_of(error, error).max, 200);
}

TEST(ErrorScale, ends_at_1_2_or_5_times_a_power_of_ten) {
  for (const auto& [error, end] : {std::pair{0.0, 1.0}, {1, 1}, {1.2, 2}, {23, 50}, {51, 100}})
    EXPECT_EQ(app::round_up(error), end);
}

TEST(Legend, has_whole_levels_over_the_range_that_is_there) {
  params::Set none;
  image::ImageF levels(3, 1, 4);
  levels.samples = {1.5F, 0, 0, 1, 3.2F, 0, 0, 1, 9, 0, 0, 0};  // the last one is background
  const app::Legend legend = app::legend_of(app::View::lod, none, levels);
  ASSERT_EQ(legend.ticks.size(), 4U);
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(legend.ticks[static_cast<std::size_t>(i)], std::pair(i / 3.0, std::to_string(1 + i)));
  EXPECT_TRUE(app::legend_of(app::View::lod, none, image::ImageF(1, 1, 4)).title.empty());
  const app::Legend error = app::error_legend(0.5, Unit::degrees);
  EXPECT_EQ(error.title, "error in degrees");
  EXPECT_EQ(error.ticks.back(), std::pair(1.0, std::string("0.5")));
}

TEST(ErrorMap, shows_what_is_not_finite_in_magenta) {
  const image::Image8 map = error_map(row({{std::numeric_limits<float>::infinity(), 0, 0, 1}}), 1);
  EXPECT_EQ(map.samples, (std::vector<std::uint8_t>{255, 0, 255, 255}));
}

}  // namespace
}  // namespace texel::answers
