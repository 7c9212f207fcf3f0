// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "params/set.hpp"

namespace texel::window {

/// While it lives, a picture that is narrower than `aspect` times its height shows as much from left to right
/// as one that is so wide: the vertical opening angle is larger. So a narrow window does not cut the model
/// off.
class FittedView {
 public:
  FittedView(params::Set& parameters, glm::ivec2 size, double aspect)
      : angle_(parameters.find("field_of_view")) {
    if (angle_ == nullptr) return;
    before_ = angle_->value();
    const double narrower = static_cast<double>(size.x) / std::max(size.y, 1) / aspect;
    if (narrower >= 1) return;
    constexpr double kDegree = std::numbers::pi / 180;
    const double wider = 2 * std::atan(std::tan(before_ / 2 * kDegree) / narrower) / kDegree;
    angle_->set_value(std::min(wider, angle_->most));
  }
  ~FittedView() {
    if (angle_ != nullptr) angle_->set_value(before_);
  }
  FittedView(const FittedView&) = delete;
  FittedView& operator=(const FittedView&) = delete;

 private:
  params::Parameter* angle_;
  double before_ = 0;
};

}  // namespace texel::window
