// SPDX-License-Identifier: MIT
#include "app/gestures.hpp"

#include <algorithm>
#include <cmath>

namespace texel::app {
namespace {

constexpr double kDegreesPerUnit = 0.35;
constexpr double kNearer = 0.9;  // of the distance, by one step of the wheel

void add(params::Set& parameters, const char* name, double summand) {
  if (params::Parameter* p = parameters.find(name))
    p->set_value(std::clamp(p->value() + summand, p->least, p->most));
}

/// An angle that goes round.
void add_round(params::Set& parameters, const char* name, double degrees) {
  if (params::Parameter* p = parameters.find(name)) p->set_value(std::remainder(p->value() + degrees, 360));
}

}  // namespace

void orbit(params::Set& parameters, glm::vec2 moved) {
  add_round(parameters, "yaw", -kDegreesPerUnit * static_cast<double>(moved.x));
  add(parameters, "pitch", kDegreesPerUnit * static_cast<double>(moved.y));
}

void move_light(params::Set& parameters, glm::vec2 moved) {
  add_round(parameters, "light_yaw", kDegreesPerUnit * static_cast<double>(moved.x));
  add(parameters, "light_pitch", -kDegreesPerUnit * static_cast<double>(moved.y));
}

void zoom(params::Set& parameters, double steps) {
  if (params::Parameter* p = parameters.find("distance"))
    p->set_value(std::clamp(p->value() * std::pow(kNearer, steps), p->least, p->most));
}

void fit_view(params::Set& parameters, double aspect, double made_for) {
  params::Parameter* angle = parameters.find("field_of_view");
  const double narrower = aspect / std::max(made_for, 1.0);
  if (angle == nullptr || narrower >= 1) return;
  const double wider = 2 * std::atan(std::tan(glm::radians(angle->value()) / 2) / narrower);
  angle->set_value(std::min(glm::degrees(wider), angle->most));
}

void turn(params::Set& parameters, double degrees) {
  params::Parameter* p = parameters.find("turn");
  if (p == nullptr) return;
  const double to = p->value() + degrees;
  p->set_value(to > p->most ? to - 360 : to < p->least ? to + 360 : to);
}

}  // namespace texel::app
