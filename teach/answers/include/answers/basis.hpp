// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <glm/glm.hpp>

/// Orthonormal frames around a unit vector n in 32-bit floats, as a shader builds them in each pixel: the
/// same as shaders/09_bump/frame.glsl, statement for statement. The columns are T, B and N = n; all are
/// right-handed, cross(T, B) = N. "Error" is the largest entry of |transpose(F) F - I|; that of n itself, up
/// to 2e-7 for a vector that was made unit in floats, is a part of it. Nothing is thrown.
namespace texel::answers {

/// The rotation that takes +z to n by the shortest way. Near n = -z it divides by almost 0: half a rounding
/// of n.z, 3e-8, becomes an error of 1.2e-7 / (1 + n.z), which is 0.2 at 0.001 radians from -z and reaches 1
/// just above the limit, below which a fixed frame is returned. Source: J. R. Frisvad, "Building an
/// Orthonormal Basis from a 3D Unit Vector Without Normalization", JGT 16 (2012), listing 3.
inline glm::mat3 frisvad(const glm::vec3& n) {
  if (n.z < -0.9999999F) return {glm::vec3(0, -1, 0), glm::vec3(-1, 0, 0), n};
  const float a = 1 / (1 + n.z), b = -n.x * n.y * a;
  return {glm::vec3(1 - n.x * n.x * a, b, -n.x), glm::vec3(b, 1 - n.y * n.y * a, -n.y), n};
}

/// The same for n.z >= 0; for the other half the frame of (n.x, n.y, -n.z), mirrored. It is Duff's frame,
/// in other words.
inline glm::mat3 sign_corrected(const glm::vec3& n) {
  const float side = n.z < 0 ? -1.0F : 1.0F;
  const float a = 1 / (1 + std::abs(n.z)), b = -n.x * n.y * a;
  return {glm::vec3(1 - n.x * n.x * a, b, -side * n.x), side * glm::vec3(b, 1 - n.y * n.y * a, -side * n.y),
          n};
}

/// One formula for both halves; T and B jump where n.z changes its sign (-0 counts as 0, in the paper as
/// negative). Source: T. Duff, J. Burgess, P. Christensen, C. Hery, A. Kensler, M. Liani and R. Villemin,
/// "Building an Orthonormal Basis, Revisited", JCGT 6 (2017), listing 3.
inline glm::mat3 duff(const glm::vec3& n) {
  const float side = n.z < 0 ? -1.0F : 1.0F;
  const float a = -1 / (side + n.z), b = n.x * n.y * a;
  return {glm::vec3(1 + side * n.x * n.x * a, side * b, -side * n.x),
          glm::vec3(b, side + n.y * n.y * a, -n.y), n};
}

/// Leaves out the smaller of n.x and n.z, swaps the other two and changes a sign: perpendicular to n, and at
/// least 0.7 long before it is made unit. T and B jump where |n.x| = |n.z|. Source: J. F. Hughes and T.
/// Moeller, "Building an Orthonormal Basis from a Unit Vector", JGT 4 (1999).
inline glm::mat3 hughes_moller(const glm::vec3& n) {
  const glm::vec3 bitangent =
      glm::normalize(std::abs(n.x) > std::abs(n.z) ? glm::vec3(-n.y, n.x, 0) : glm::vec3(0, -n.z, n.y));
  return {glm::cross(bitangent, n), bitangent, n};
}

/// T perpendicular to n and to +y, so along the circles of latitude. At n = +y and -y there is none: T and B
/// are NaN there.
inline glm::mat3 cross_up(const glm::vec3& n) {
  const glm::vec3 tangent = glm::normalize(glm::cross(n, glm::vec3(0, 1, 0)));
  return {tangent, glm::cross(n, tangent), n};
}

/// The frame in which the worksheet's texture coordinates run (shaders/lib/sphere_coordinates.glsl): T along
/// the circle of latitude, where u grows, to -x at n = +z; B along the meridian, where v grows, down. At the
/// poles u has no direction, and T is -x. The same directions as cross_up() has, with that case taken care
/// of.
inline glm::mat3 uv_aligned(const glm::vec3& n) {
  const float radius = std::sqrt(n.x * n.x + n.z * n.z);
  // Nearer to the pole, the squares would lose their digits below the smallest float.
  const glm::vec3 tangent = radius > 1e-16F ? glm::vec3(-n.z, 0, n.x) / radius : glm::vec3(-1, 0, 0);
  return {tangent, glm::cross(n, tangent), n};
}

/// Calls visit(name, frame) for each of them, from the worksheet's to the default: `name` as lab 9's
/// parameter `method` has it, `frame` a function of n. Each `frame` has a type of its own, so that a loop in
/// `visit` is compiled with that frame in line.
template <class Visit>
void for_each_basis(Visit&& visit) {
  visit("rotate-to-normal", [](const glm::vec3& n) { return frisvad(n); });
  visit("sign-corrected", [](const glm::vec3& n) { return sign_corrected(n); });
  visit("duff", [](const glm::vec3& n) { return duff(n); });
  visit("hughes-moller", [](const glm::vec3& n) { return hughes_moller(n); });
  visit("cross-up", [](const glm::vec3& n) { return cross_up(n); });
  visit("uv-aligned", [](const glm::vec3& n) { return uv_aligned(n); });
}

}  // namespace texel::answers
