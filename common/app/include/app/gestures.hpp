// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>

#include "params/set.hpp"

/// What mouse, wheel and turntable do to a lab's parameters: the same in the window and on a page. A lab
/// without the parameter stays as it is.
namespace texel::app {

/// Turns the camera by a drag. `moved`: x to the right and y down, in the units of the window (CSS pixels).
void orbit(params::Set& parameters, glm::vec2 moved);
/// Turns the light by a drag, as orbit.
void move_light(params::Set& parameters, glm::vec2 moved);
/// Brings the camera nearer by so many steps of the wheel.
void zoom(params::Set& parameters, double steps);
/// Widens the camera's angle where a picture of that aspect is narrower than the one it was made for, or than
/// a square: nothing of the model is cut off.
void fit_view(params::Set& parameters, double aspect, double made_for);
/// Turns the model about its vertical axis, in degrees, round and round.
void turn(params::Set& parameters, double degrees);

}  // namespace texel::app
