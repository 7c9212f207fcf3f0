// SPDX-License-Identifier: MIT
#include "truth/optics.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace texel::truth {

using glm::dvec3;

namespace {

/// The squared cosine behind the boundary, 1 - eta^2 (1 - cosine^2) by Snell's law; negative on total
/// internal reflection. In this form it is a sum of positive terms into a denser medium, exact at grazing
/// incidence too.
double cosine_squared_behind(double cosine, double eta) {
  return (1 - eta) * (1 + eta) + eta * eta * cosine * cosine;
}

/// The change of the reflected ray when incident ray and normal change (Igehy, "Tracing Ray
/// Differentials", SIGGRAPH 1999, on reflection).
dvec3 reflected_derivative(dvec3 incident, dvec3 d_incident, dvec3 normal, dvec3 d_normal) {
  const double change = glm::dot(d_incident, normal) + glm::dot(incident, d_normal);
  return d_incident - 2.0 * (glm::dot(incident, normal) * d_normal + change * normal);
}

}  // namespace

dvec3 reflected(dvec3 incident, dvec3 normal) {
  return incident - 2 * glm::dot(normal, incident) * normal;
}

std::optional<dvec3> refracted(dvec3 incident, dvec3 normal, double n_from, double n_to) {
  // The part of the ray along the boundary is scaled by the indices; the rest of the unit length goes on.
  const double across = glm::dot(incident, normal);
  const double rest = cosine_squared_behind(across, n_from / n_to);
  if (rest < 0) return std::nullopt;
  const dvec3 along = (n_from / n_to) * (incident - across * normal);
  return along + std::copysign(std::sqrt(rest), across) * normal;
}

double reflectance(dvec3 incident, dvec3 normal, double n_from, double n_to) {
  const double here = std::abs(glm::dot(incident, normal));
  const double squared = cosine_squared_behind(here, n_from / n_to);
  if (squared <= 0) return 1;
  const double beyond = std::sqrt(squared);
  const auto part = [](double a, double b) { return (a - b) * (a - b) / ((a + b) * (a + b)); };
  return (part(n_from * here, n_to * beyond) + part(n_to * here, n_from * beyond)) / 2;
}

std::optional<MirrorPoint> mirror_point(const PixelRay& pixel, const Placement& world_from_object,
                                        double radius) {
  const auto hit = hit_sphere(object_ray(pixel.ray, world_from_object), radius);
  if (!hit) return std::nullopt;
  MirrorPoint mirror;
  mirror.texcoord = hit->texcoord;
  mirror.surface = placed(sphere(radius), world_from_object)(hit->texcoord);
  mirror.incident = pixel.ray.direction;
  mirror.reflected = reflected(mirror.incident, mirror.surface.normal);
  const TexcoordGradient texcoord = texcoord_gradient(pixel, mirror.surface);
  const auto change = [&](dvec3 d_incident, glm::dvec2 d_texcoord) {
    const dvec3 d_normal = mirror.surface.normal_ds * d_texcoord.s + mirror.surface.normal_dt * d_texcoord.t;
    return reflected_derivative(mirror.incident, d_incident, mirror.surface.normal, d_normal);
  };
  mirror.reflected_change = {change(pixel.dx, texcoord.dx), change(pixel.dy, texcoord.dy)};
  return mirror;
}

}  // namespace texel::truth
