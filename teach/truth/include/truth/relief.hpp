// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "truth/surface.hpp"

/// The normal of a relief laid over a surface. There are two truths. They agree where the parameterisation
/// keeps right angles and a texture width is `width` world units along s and t, and differ by design
/// elsewhere:
/// - the **height field**: the relief is a function on the surface, and its slope is taken along the surface
///   in world units. It does not depend on how the texture coordinates run there;
/// - the **baked map**: the normal map's texel is read in the frame T, B, N, as MikkTSpace's bakers and
///   renderers agreed. Its slope is per texture width, however long that is in the world.
namespace texel::truth {

/// The gradient of a height along the surface: the vector in the tangent plane whose dot product with any
/// small move on the surface is the change of height; (h_s cross(dt, n) + h_t cross(n, ds)) / dot(n,
/// cross(ds, dt)). `height_gradient` is (dh/ds, dh/dt) in world units per texture width: procedural::height's
/// du and dv times the world length of a texture width. The result is a slope, without unit. Not finite where
/// ds and dt are parallel or vanish. Source: M. S. Mikkelsen, "Bump Mapping Unparametrized Surfaces on the
/// GPU" (2010) and "Surface Gradient-Based Bump Mapping Framework" (JCGT 9(3), 2020).
glm::dvec3 surface_gradient(const SurfacePoint& point, glm::dvec2 height_gradient);

/// The height field's normal, normalize(n - strength * gradient): the limit for a relief that is shallow
/// compared with the surface's radius of curvature. Blinn's bump mapping ("Simulation of Wrinkled Surfaces",
/// 1978) is the same formula multiplied out.
glm::dvec3 relief_normal(const SurfacePoint& point, glm::dvec2 height_gradient, double strength = 1);

/// The baked map's normal: normalize(x T + y B + z N) of the frame for a texel (x, y, z) of any length.
glm::dvec3 mapped_normal(const Frame& frame, glm::dvec3 texel);

}  // namespace texel::truth
