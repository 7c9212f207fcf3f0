// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec3.hpp>

namespace texel::assets {

/// A landscape around a small square, seen from 2.6 m above its middle: linear-light RGB in 0..1 for a unit
/// direction. Mountains and a lake with a lighthouse lie towards -z, a village towards +z, the sun stands
/// behind the left shoulder of one who looks along -z.
glm::dvec3 scene_colour(glm::dvec3 direction);

}  // namespace texel::assets
