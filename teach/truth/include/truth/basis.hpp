// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec3.hpp>

/// The right answer in double precision, from the analytic surface. It shares no code with the methods
/// that are compared with it. Unless a function says otherwise: right-handed, y up, angles in radians,
/// lengths in world units, colours in linear light, no errors thrown; functions are accurate to a few
/// roundings of double, and the tests say how many.
namespace texel::truth {

/// On which side of the plane of tangent and normal the bitangent lies: the sign of dot(cross(n, t), b). +1
/// when (t, b, n) is right-handed, -1 when the texture is mirrored, 0 when the three lie in a plane.
double handedness(glm::dvec3 tangent, glm::dvec3 bitangent, glm::dvec3 normal);

/// The derivative of v / |v| when v changes by dv: the part of dv across v, as a fraction of v's length.
glm::dvec3 normalized_derivative(glm::dvec3 v, glm::dvec3 dv);

}  // namespace texel::truth
