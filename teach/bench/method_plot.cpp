// SPDX-License-Identifier: MIT
#include "bench/method_plot.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/settings.hpp"
#include "bench/bench.hpp"
#include "core/error.hpp"

namespace texel::bench {
namespace {

constexpr double kTruthMilliseconds = 40;  // a frame may work so long on the exact answer

/// All parameters except the method, and the size.
std::string look_of(const params::Set& parameters, glm::ivec2 size) {
  std::string look = fmt::format("{}x{}", size.x, size.y);
  for (const params::Parameter& p : parameters)
    if (p.name != "method") look.append(" ").append(p.text());
  return look;
}

}  // namespace

bool MethodPlot::is_for(app::AnyLab& lab) {
  return lab.parameters().find("method") != nullptr && std::ranges::count(lab.views(), app::View::error) > 0;
}

MethodPlot::MethodPlot(gl::Context& context, const app::Assets& assets, app::AnyLab& lab)
    : lab_(lab), canvas_(context, assets, lab) {
  for (const params::Item& item : lab.parameters().at("method").items)
    points_.emplace_back().method = item.name;
}

double MethodPlot::share() const {
  return static_cast<double>(done_) / static_cast<double>(points_.size() * (1 + kRounds));
}

void MethodPlot::forget() {
  canvas_.programs().clear();
  look_.clear();
}

void MethodPlot::begin_again(const std::string& look) {
  look_ = look, fault_.clear(), done_ = 0;
  for (Point& point : points_) point.has_error = false, point.frame_ns.clear();
}

void MethodPlot::measure_next(glm::ivec2 picture_size) {
  size_ = {std::max(kHeight * picture_size.x / std::max(picture_size.y, 1), 16), kHeight};
  if (const std::string look = look_of(lab_.parameters(), size_); look != look_) begin_again(look);
  if (share() >= 1 || !fault_.empty()) return;
  const std::size_t round = done_ / points_.size(), turn = done_ % points_.size();
  // Each round begins with another method: none is always the first.
  Point& point = points_[round == 0 ? turn : (turn + round) % points_.size()];
  const app::KeptValues before(lab_.parameters());
  try {
    lab_.parameters().at("method").set(point.method);
    if (round == 0)
      measure_error(point);
    else
      time_frame(point);
  } catch (const Error& error) {
    fault_ = error.what();
  }
}

void MethodPlot::measure_error(Point& point) {
  if (lab_.answer()->work(size_, kTruthMilliseconds) < 1) return;
  canvas_.draw(app::View::error, size_, 1);
  const app::Measure measure = lab_.answer()->measure();
  if (measure_ && measure_->unit != measure.unit)  // what is known of the last look has another unit
    for (Point& other : points_) other.milliseconds = 0;
  measure_ = measure;
  point.error = *canvas_.error_figures();
  point.has_error = true;
  ++done_;
}

void MethodPlot::time_frame(Point& point) {
  point.frame_ns.push_back(frame_nanoseconds(canvas_, size_));
  std::vector<double> sorted = point.frame_ns;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  point.milliseconds = *middle * 1e-6;
  ++done_;
}

}  // namespace texel::bench
