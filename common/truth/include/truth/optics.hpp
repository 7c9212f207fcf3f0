// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec3.hpp>
#include <optional>

#include "truth/cube_map.hpp"
#include "truth/ray.hpp"

/// Rays at a smooth boundary. Incident rays point **towards** the surface, as in GLSL's reflect and refract;
/// normals have unit length.
namespace texel::truth {

/// i - 2 (n . i) n: of the incident ray's length, on either side of the surface.
glm::dvec3 reflected(glm::dvec3 incident, glm::dvec3 normal);

/// The change of the reflected ray when incident ray and normal change (Igehy, "Tracing Ray
/// Differentials", SIGGRAPH 1999, on reflection).
glm::dvec3 reflected_derivative(glm::dvec3 incident, glm::dvec3 d_incident, glm::dvec3 normal,
                                glm::dvec3 d_normal);

/// The unit ray that goes on behind the boundary from a medium of index n_from to one of n_to, by Snell's law
/// n_from sin(a) = n_to sin(b); nothing on total internal reflection. `incident` has unit length and may come
/// from either side of the normal.
std::optional<glm::dvec3> refracted(glm::dvec3 incident, glm::dvec3 normal, double n_from, double n_to);

/// The share of unpolarised light that a boundary between two clear media reflects, 0..1, by the angle of
/// incidence: the mean of Fresnel's two polarisations (Born and Wolf, Principles of Optics, section 1.5.2). 1
/// on total internal reflection. `cosine` is that between incident ray and normal, 0..1; its sign is dropped.
double fresnel(double cosine, double n_from, double n_to);

/// The critical angle: from this angle of incidence on, all light is reflected (n_from > n_to).
double critical_angle(double n_from, double n_to);

/// What a pixel of a mirroring sphere sees.
struct MirrorPoint {
  SurfacePoint surface;                ///< where the ray meets the sphere, in the world
  glm::dvec2 texcoord;                 ///< of sphere()
  glm::dvec3 incident;                 ///< unit, from the eye to that point
  glm::dvec3 reflected;                ///< unit, the direction in which the environment is seen
  DirectionGradient reflected_change;  ///< of `reflected`, per pixel
};

/// The mirror at a pixel's ray: a sphere placed in the world, so an ellipsoid under a non-uniform scale.
/// Nothing where the ray misses it. From inside, the ray meets the far wall; its normal points outwards.
std::optional<MirrorPoint> mirror_point(const PixelRay& pixel, const Placement& world_from_object = {},
                                        double radius = 1);

}  // namespace texel::truth
