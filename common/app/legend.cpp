// SPDX-License-Identifier: MIT
#include "app/legend.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

#include "app/camera.hpp"
#include "core/json.hpp"
#include "image/compared.hpp"
#include "image/difference.hpp"

namespace texel::app {
namespace {

using course::View;

constexpr int kBar = 96, kSide = 40;  // pixels

/// From the tick before the least value to the one after the largest.
Legend bar(const std::string& title, double least, double most, double step, View view) {
  const double first = step * std::floor(least / step),
               last = std::max(step * std::ceil(most / step), first + step);
  image::ImageF values(kBar, 1, 3);
  image::Difference parts{.width = kBar, .height = 1};
  for (int x = 0; x < kBar; ++x) {
    const double at = (x + 0.5) / kBar, part = view == View::mask ? std::round(at) : at;
    parts.pixels.push_back(part);
    values.at(x, 0, 0) = static_cast<float>(first + part * (last - first));
  }
  Legend legend{title, {}, false, {}};
  legend.picture = view == View::error ? image::heatmap(parts, 1) : image::shown(values, name_of(view));
  const auto count = static_cast<int>(std::lround((last - first) / step));
  for (int i = 0; i <= count; ++i)
    legend.ticks.emplace_back(static_cast<double>(i) / count, fmt::format("{:.4g}", first + i * step));
  return legend;
}

/// All texture coordinates of a tile, or all directions that the camera sees on a ball.
Legend map_of(View view, params::Set& parameters) {
  const auto angle = [&](const char* name) { return static_cast<float>(parameters.at(name).value()); };
  const glm::vec3 toward = direction_from_angles(angle("yaw"), angle("pitch")),
                  right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), toward)),
                  up = glm::cross(toward, right);
  const bool is_ball = view != View::texcoord;
  image::ImageF values(kSide, kSide, 3);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const glm::vec2 at = (glm::vec2(x, y) + 0.5F) / static_cast<float>(kSide), round = 2.0F * at - 1.0F;
      const float z = std::sqrt(std::max(1 - glm::dot(round, round), 0.0F));
      const glm::vec3 value = is_ball ? round.x * right + round.y * up + z * toward : glm::vec3(at, 0);
      for (int c = 0; c < 3; ++c) values.at(x, y, c) = value[c];
    }
  const std::string title =
      is_ball ? fmt::format("{} of a ball, world space", name_of(view)) : "texcoord: s to the right, t up";
  return {title, image::shown(values, name_of(view)), is_ball, {}};
}

}  // namespace

double round_up(double value) {
  if (!(value > 0)) return 1;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= value) return factor * power;
  return 10 * power;
}

Legend error_legend(double full_scale, course::Unit unit) {
  const double most = full_scale > 0 ? full_scale : 1;
  return bar(fmt::format("error in {}", name_of(unit)), 0, most, most / 2, View::error);
}

Legend legend_of(View view, params::Set& parameters, const image::ImageF& values) {
  if (view == View::color || view == View::mesh) return {};
  if (view == View::mask) return bar("mask: 1 on the surface, 0 beside it", 0, 1, 1, view);
  if (view != View::lod && view != View::depth) return map_of(view, parameters);
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (std::size_t i = 0; i + 3 < values.samples.size(); i += 4)
    if (const auto value = static_cast<double>(values.samples[i]);
        values.samples[i + 3] > 0 && std::isfinite(value))
      least = std::min(least, value), most = std::max(most, value);
  if (least > most) return {};
  if (view == View::lod) return bar("level of detail", least, most, 1, view);
  return bar("depth in units", least, most, round_up(std::max(most - least, 1e-3) / 5), view);
}

std::string to_json(const Legend& legend) {
  return to_text(Json{{"title", legend.title},
                      {"width", legend.picture.width},
                      {"height", legend.picture.height},
                      {"colors", fmt::format("{:02x}", fmt::join(legend.picture.samples, ""))},
                      {"ball", legend.is_ball},
                      {"ticks", legend.ticks}});
}

}  // namespace texel::app
