// SPDX-License-Identifier: MIT
#include "app/gestures.hpp"

#include <algorithm>
#include <cmath>

namespace texel::app {
namespace {

constexpr double kDegreesPerUnit = 0.35;
constexpr double kNearer = 0.9;  // of the distance, by one step of the wheel

/// Sets it to what a function makes of its value, within its range.
template <class Function>
void change(params::Set& parameters, const char* name, Function&& function) {
  if (params::Parameter* p = parameters.find(name))
    p->set_value(std::clamp(function(p->value()), p->least, p->most));
}

/// Two angles, in degrees: one goes round, the other stays between the poles.
void turn_both(params::Set& parameters, const char* round, const char* up, glm::dvec2 degrees) {
  change(parameters, round, [&](double angle) { return std::remainder(angle + degrees.x, 360); });
  change(parameters, up, [&](double angle) { return angle + degrees.y; });
}

}  // namespace

void orbit(params::Set& parameters, glm::vec2 moved) {
  turn_both(parameters, "yaw", "pitch", kDegreesPerUnit * glm::dvec2(-moved.x, moved.y));
}

void move_light(params::Set& parameters, glm::vec2 moved) {
  turn_both(parameters, "light_yaw", "light_pitch", kDegreesPerUnit * glm::dvec2(moved.x, -moved.y));
}

void zoom(params::Set& parameters, double steps) {
  change(parameters, "distance", [&](double distance) { return distance * std::pow(kNearer, steps); });
}

void fit_view(params::Set& parameters, double aspect, double made_for) {
  params::Parameter* angle = parameters.find("field_of_view");
  const double narrower = aspect / std::max(made_for, 1.0);
  if (angle == nullptr || narrower >= 1) return;
  const double wider = 2 * std::atan(std::tan(glm::radians(angle->value()) / 2) / narrower);
  angle->set_value(std::min(glm::degrees(wider), angle->most));
}

void turn(params::Set& parameters, double degrees) {
  if (params::Parameter* p = parameters.find("turn")) {
    const double to = p->value() + degrees;
    p->set_value(to > p->most ? to - 360 : to < p->least ? to + 360 : to);
  }
}

}  // namespace texel::app
