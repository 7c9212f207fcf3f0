// SPDX-License-Identifier: MIT
// The view `error`: pictures compared with the labs' right answers.
#include "answers/measuring.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

#include "answers/camera.hpp"
#include "app/canvas.hpp"
#include "app/legend.hpp"
#include "core/error.hpp"
#include "core/json.hpp"
#include "core/parallel.hpp"
#include "core/stopwatch.hpp"
#include "image/color.hpp"

namespace texel::answers {
namespace {

using app::ErrorFigures;
using app::Measure;
using app::Unit;

glm::dvec3 value_at(const image::ImageF& picture, int x, int y) {
  return {picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2)};
}

using Color = std::array<std::uint8_t, 3>;
constexpr Color kOutside = {52, 56, 64}, kNotFinite = {255, 0, 255};

Color heat_color(double t) {
  const std::array<float, 3> heat = image::heat(static_cast<float>(t));
  Color color;
  for (std::size_t c = 0; c < 3; ++c) color[c] = image::to_encoding8(heat[c], image::Encoding::linear);
  return color;
}

void put(image::Image8& picture, int x, int y, const Color& color) {
  for (int c = 0; c < 3; ++c) picture.at(x, y, c) = color[static_cast<std::size_t>(c)];
  picture.at(x, y, 3) = 255;
}

double error_of(const glm::dvec3& value, const glm::dvec3& truth, const Measure& measure) {
  switch (measure.unit) {
    case Unit::degrees:
      return glm::degrees(std::atan2(glm::length(glm::cross(value, truth)), glm::dot(value, truth)));
    case Unit::texels: {
      const glm::dvec2 apart(value - truth);
      return measure.scale * glm::length(measure.repeats ? apart - glm::round(apart) : apart);
    }
    case Unit::steps: {
      const glm::dvec3 apart = glm::abs(value - truth);
      return measure.scale * std::max({apart.x, apart.y, apart.z});
    }
    case Unit::levels:
    case Unit::texture_widths:
    case Unit::units:
      break;
  }
  return measure.scale * std::abs(value.x - truth.x);
}

/// Why there are no means, in a sentence; null where there are.
const char* why_nothing(const ErrorFigures& figures) {
  if (figures.pixels > figures.non_finite) return nullptr;
  if (figures.pixels > 0) return "no pixel is finite";
  if (figures.truth_pixels > 0)
    return "the picture has no pixel where the object must be: look whether the near plane cuts it off";
  return "the object is not in the picture: look from another side, or from farther away";
}

}  // namespace

void add_truth_rows(image::ImageF& picture, const Truth& truth, int first, int end) {
  in_parallel(processors(), static_cast<std::size_t>(end - first), [&](std::size_t row) {
    const int y = first + static_cast<int>(row);
    for (int x = 0; x < picture.width; ++x) {
      const std::optional<glm::dvec3> value = truth(glm::dvec2(x + 0.5, y + 0.5));
      if (!value || !std::isfinite(value->x + value->y + value->z)) continue;
      for (int c = 0; c < 3; ++c) picture.at(x, y, c) = static_cast<float>((*value)[c]);
      picture.at(x, y, 3) = 1;
    }
  });
}

image::ImageF error_picture(const image::ImageF& picture, const image::ImageF& truth,
                            const Measure& measure) {
  if (picture.width != truth.width || picture.height != truth.height)
    throw Error::failed("the picture and the truth differ in size");
  image::ImageF error(picture.width, picture.height, 4);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      // A NaN in alpha counts as drawn.
      if (picture.at(x, y, 3) == 0 || truth.at(x, y, 3) == 0) continue;
      const glm::dvec3 value = value_at(picture, x, y);
      const bool finite = std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z);
      error.at(x, y, 0) = finite ? static_cast<float>(error_of(value, value_at(truth, x, y), measure))
                                 : std::numeric_limits<float>::quiet_NaN();
      error.at(x, y, 3) = 1;
    }
  return error;
}

ErrorFigures figures_of(const image::ImageF& error, const image::ImageF& truth) {
  ErrorFigures figures;
  std::vector<double> values;
  for (int y = 0; y < error.height; ++y)
    for (int x = 0; x < error.width; ++x) {
      if (truth.at(x, y, 3) != 0) ++figures.truth_pixels;
      if (error.at(x, y, 3) == 0) continue;
      ++figures.pixels;
      const auto value = static_cast<double>(error.at(x, y, 0));
      if (std::isfinite(value))
        values.push_back(value);
      else
        ++figures.non_finite;
    }
  figures.reason = why_nothing(figures);
  if (values.empty()) return figures;
  double sum = 0, squares = 0;
  for (const double value : values) {
    sum += value;
    squares += value * value;
  }
  const auto count = static_cast<double>(values.size());
  figures.mean = sum / count;
  figures.rms = std::sqrt(squares / count);
  const auto quantile = [&](double q) {  // nearest rank
    const auto rank = static_cast<std::ptrdiff_t>(std::ceil(q * count)) - 1;
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    return values[static_cast<std::size_t>(rank)];
  };
  figures.median = quantile(0.5);
  figures.p99 = quantile(0.99);
  figures.max = quantile(1);
  return figures;
}

void tell_outlines_apart(ErrorFigures& figures, const image::ImageF& error, const image::ImageF& picture,
                         const image::ImageF& truth, const Measure& measure) {
  if (figures.pixels == figures.non_finite) return;
  float most = 0;
  for (int y = 0; y < error.height; ++y)
    for (int x = 0; x < error.width; ++x) {
      float least = error.at(x, y, 3) == 0 ? 0 : error.at(x, y, 0);
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, error.height - 1) && least > most; ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, error.width - 1); ++u)
          if (truth.at(u, v, 3) != 0)
            least = std::min(
                least, static_cast<float>(error_of(value_at(picture, x, y), value_at(truth, u, v), measure)));
      if (least > most) most = least;  // not a NaN
    }
  figures.max_aside = static_cast<double>(most);
  for (std::size_t i = 0; i < error.samples.size(); i += 4)
    if (error.samples[i + 3] != 0 && error.samples[i] > most) ++figures.outline_pixels;
}

double truth_error(const image::ImageF& picture, const Truth& truth, const Measure& measure) {
  constexpr int kEach = 5;  // of the rows, and of the pixels in them
  place_shift = {0x9e3779b9U, 0x7f4a7c15U};
  double squares = 0;
  int count = 0;
  for (int y = 0; y < picture.height; y += kEach)
    for (int x = y % kEach; x < picture.width; x += kEach) {
      if (picture.at(x, y, 3) == 0) continue;
      const std::optional<glm::dvec3> other = truth(glm::dvec2(x + 0.5, y + 0.5));
      if (!other) continue;
      const double apart = error_of(value_at(picture, x, y), *other, measure);
      squares += apart * apart;
      ++count;
    }
  place_shift = {0, 0};
  return std::sqrt(squares / (2 * std::max(count, 1)));
}

image::Image8 error_map(const image::ImageF& error, double scale) {
  image::Image8 map(error.width, error.height, 4);
  for (int y = 0; y < error.height; ++y)
    for (int x = 0; x < error.width; ++x) {
      const auto value = static_cast<double>(error.at(x, y, 0));
      if (error.at(x, y, 3) == 0)
        put(map, x, y, kOutside);
      else
        put(map, x, y, std::isfinite(value) ? heat_color(value / scale) : kNotFinite);
    }
  return map;
}

double Measuring::work(glm::ivec2 size, double milliseconds) {
  const Stopwatch stopwatch;
  const auto [function, parameters] = truth(size);
  const std::string key = fmt::format("{} {}x{}", parameters, size.x, size.y);
  if (key == key_ && rows_ == size.y) return 1;
  if (!function)
    throw Error::failed("there is no exact answer for these parameters", {},
                        "choose a built-in model, picture or cube map that has a formula");
  if (key != key_) {
    truth_ = image::ImageF(size.x, size.y, 4);
    rows_ = 0;
    key_ = key;
  }
  constexpr int kRows = 8;  // in one go
  while (rows_ < size.y && stopwatch.milliseconds() < milliseconds) {
    const int end = std::min(rows_ + kRows, size.y);
    add_truth_rows(truth_, function, rows_, end);
    rows_ = end;
    if (rows_ == size.y) truth_error_ = truth_error(truth_, function, measure());
  }
  return static_cast<double>(rows_) / size.y;
}

app::Measured Measuring::measured(app::Canvas& canvas, glm::ivec2 size) {
  work(size, std::numeric_limits<double>::infinity());
  const image::ImageF picture = canvas.values_of(measure().view, size);
  image::ImageF error = error_picture(picture, truth_, measure());
  ErrorFigures figures = figures_of(error, truth_);
  figures.truth_error = truth_error_;
  tell_outlines_apart(figures, error, picture, truth_, measure());
  const double full_scale = app::round_up(figures.p99);
  image::Image8 map = error_map(error, full_scale);
  return {std::move(error), figures, std::move(map), full_scale};
}

std::optional<app::Comparison> Measuring::compare_at(app::Canvas& canvas, glm::ivec2 size, glm::ivec2 pixel) {
  const Truth function = truth(size).truth;
  const std::optional<glm::dvec3> right = function ? function(glm::dvec2(pixel) + 0.5) : std::nullopt;
  if (!right) return {};
  const glm::dvec4 value = canvas.value_at(measure().view, size, pixel);
  if (value.a == 0) return {};
  return app::Comparison{measure(), value, *right, error_of(value, *right, measure())};
}

std::string Measuring::report(app::AnyLab& lab, const ErrorFigures& figures) const {
  Json json = {{"lab", lab.info().folder()},
               {"parameters", lab.parameters().key()},
               {"view", name_of(measure().view)},
               {"truth", measure().truth},
               {"truth_error", figures.truth_error},
               {"unit", name_of(measure().unit)},
               {"mean", figures.mean},
               {"rms", figures.rms},
               {"median", figures.median},
               {"p99", figures.p99},
               {"max", figures.max},
               {"max_aside", figures.max_aside},
               {"outline_pixels", figures.outline_pixels},
               {"pixels", figures.pixels},
               {"truth_pixels", figures.truth_pixels},
               {"non_finite", figures.non_finite}};
  if (figures.reason != nullptr) json["reason"] = figures.reason;
  return to_text(json, 2) + "\n";
}

}  // namespace texel::answers
