// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec3.hpp>
#include <optional>

/// Rays at a smooth boundary. Incident rays point **towards** the surface, as in GLSL's reflect and refract;
/// normals have unit length.
namespace texel::truth {

/// i - 2 (n . i) n: of the incident ray's length, on either side of the surface.
glm::dvec3 reflected(glm::dvec3 incident, glm::dvec3 normal);

/// The unit ray that goes on behind the boundary from a medium of index n_from to one of n_to, by Snell's law
/// n_from sin(a) = n_to sin(b); nothing on total internal reflection. `incident` has unit length and may come
/// from either side of the normal.
std::optional<glm::dvec3> refracted(glm::dvec3 incident, glm::dvec3 normal, double n_from, double n_to);

/// The part of unpolarised light that is reflected at the boundary, 0 to 1; 1 on total internal reflection.
/// Source: M. Born and E. Wolf, "Principles of Optics", section 1.5.2.
double reflectance(glm::dvec3 incident, glm::dvec3 normal, double n_from, double n_to);

}  // namespace texel::truth
