// SPDX-License-Identifier: MIT
#pragma once
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

/// The right answer in double precision, from the analytic surface. It shares no code with the methods
/// that are compared with it. Unless a function says otherwise: right-handed, y up, angles in radians,
/// lengths in world units, colours in linear light, no errors thrown; functions are accurate to a few
/// roundings of double, and the tests say how many.
namespace texel::truth {

/// The angle between two directions of any length, 0 to pi: atan2(|a x b|, a . b), which keeps its accuracy
/// at 0 and at pi, where the arc cosine loses half of its digits (Kahan, "How Futile are Mindless Assessments
/// of Roundoff in Floating-Point Computation?", 2006, "Mangled Angles"). 0 when one of them is zero.
double angle(glm::dvec3 a, glm::dvec3 b);

/// The same in degrees.
double angle_in_degrees(glm::dvec3 a, glm::dvec3 b);

/// How far three columns are from unit length and right angles: the largest entry of |G - I|, where G is the
/// Gram matrix transpose(m) * m. 0 for a rotation or a mirrored one.
double orthonormality(const glm::dmat3& m);

/// On which side of the plane of tangent and normal the bitangent lies: the sign of dot(cross(n, t), b). +1
/// when (t, b, n) is right-handed, -1 when the texture is mirrored, 0 when the three lie in a plane.
double handedness(glm::dvec3 tangent, glm::dvec3 bitangent, glm::dvec3 normal);

/// The derivative of v / |v| when v changes by dv: the part of dv across v, as a fraction of v's length.
glm::dvec3 normalized_derivative(glm::dvec3 v, glm::dvec3 dv);

}  // namespace texel::truth
