// SPDX-License-Identifier: MIT
#include "truth/surface.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <utility>

#include "truth/relief.hpp"

namespace texel::truth {

using glm::dvec2;
using glm::dvec3;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double tau = 2 * pi;

/// The square about `centre` whose sides are 2 right and 2 up long.
Surface square(dvec3 center, dvec3 right, dvec3 up) {
  const dvec3 normal = glm::normalize(glm::cross(right, up));
  return [=](dvec2 texcoord) {
    const dvec2 xy = 2.0 * texcoord - 1.0;
    return SurfacePoint{
        .position = center + xy.x * right + xy.y * up, .ds = 2.0 * right, .dt = 2.0 * up, .normal = normal};
  };
}

/// An angle as a fraction of a turn in [0, 1).
double turns(double angle) {
  const double fraction = angle / tau;
  const double wrapped = fraction - std::floor(fraction);
  return wrapped < 1 ? wrapped : 0;  // just below 0, the sum rounds to 1
}

}  // namespace

Surface quad(double half_size) {
  return square(dvec3(0), dvec3(half_size, 0, 0), dvec3(0, half_size, 0));
}

Surface cube_face(image::Face face, double half_size) {
  const dvec3 out = image::axes(face)[2];
  const dvec3 up = out.y == 0 ? dvec3(0, 1, 0) : dvec3(0, 0, -out.y);
  return square(half_size * out, half_size * glm::cross(up, out), half_size * up);
}

Surface sphere(double radius) {
  return [radius](dvec2 texcoord) {
    const double longitude = tau * texcoord.s, latitude = pi * (texcoord.t - 0.5);
    const dvec3 outward(std::sin(longitude), 0, std::cos(longitude));
    const dvec3 east(std::cos(longitude), 0, -std::sin(longitude));
    const dvec3 north = std::cos(latitude) * dvec3(0, 1, 0) - std::sin(latitude) * outward;
    const dvec3 normal = std::cos(latitude) * outward + std::sin(latitude) * dvec3(0, 1, 0);
    return SurfacePoint{.position = radius * normal,
                        .ds = radius * (tau * std::cos(latitude) * east),
                        .dt = radius * (pi * north),
                        .normal = normal};
  };
}

Surface torus(double major, double minor) {
  return [major, minor](dvec2 texcoord) {
    const double a = tau * texcoord.s, b = tau * texcoord.t;
    const dvec3 outward(std::sin(a), 0, std::cos(a));
    const dvec3 east(std::cos(a), 0, -std::sin(a));
    const dvec3 normal = std::cos(b) * outward + std::sin(b) * dvec3(0, 1, 0);
    return SurfacePoint{.position = major * outward + minor * normal,
                        .ds = tau * major * east + minor * (tau * std::cos(b) * east),
                        .dt = minor * (tau * (std::cos(b) * dvec3(0, 1, 0) - std::sin(b) * outward)),
                        .normal = normal};
  };
}

dvec2 sphere_texcoord(dvec3 p) {
  return {turns(std::atan2(p.x, p.z)), std::atan2(p.y, std::hypot(p.x, p.z)) / pi + 0.5};
}

dvec2 torus_texcoord(dvec3 p, double major) {
  return {turns(std::atan2(p.x, p.z)), turns(std::atan2(p.y, std::hypot(p.x, p.z) - major))};
}

dvec2 TexcoordMap::parameter(dvec2 texcoord) const {
  return glm::inverse(linear) * (texcoord - offset);
}

Surface reparameterized(Surface surface, const TexcoordMap& map) {
  return [surface = std::move(surface), map](dvec2 texcoord) {
    const SurfacePoint own = surface(map.parameter(texcoord));
    const glm::dmat2 change = glm::inverse(map.linear);  // columns: how the parameters go with s and with t
    return SurfacePoint{.position = own.position,
                        .ds = own.ds * change[0].x + own.dt * change[0].y,
                        .dt = own.ds * change[1].x + own.dt * change[1].y,
                        .normal = own.normal};
  };
}

Surface placed(Surface surface, const Placement& world_from_object) {
  const glm::dmat3 normal_matrix = glm::transpose(glm::inverse(world_from_object.linear));
  return [surface = std::move(surface), world_from_object, normal_matrix](dvec2 texcoord) {
    const SurfacePoint own = surface(texcoord);
    return SurfacePoint{.position = world_from_object.linear * own.position + world_from_object.offset,
                        .ds = world_from_object.linear * own.ds,
                        .dt = world_from_object.linear * own.dt,
                        .normal = glm::normalize(normal_matrix * own.normal)};
  };
}

double handedness(dvec3 tangent, dvec3 bitangent, dvec3 normal) {
  const double volume = glm::dot(glm::cross(normal, tangent), bitangent);
  return static_cast<double>(volume > 0) - static_cast<double>(volume < 0);
}

Frame orthonormal_frame(const SurfacePoint& point) {
  const dvec3 normal = point.normal, tangent = glm::normalize(point.ds - normal * glm::dot(normal, point.ds));
  const double side = handedness(point.ds, point.dt, normal);
  return {tangent, side * glm::cross(normal, tangent), normal, side};
}

dvec3 surface_gradient(const SurfacePoint& point, dvec2 height_gradient) {
  const dvec3 along = height_gradient.s * glm::cross(point.dt, point.normal) +
                      height_gradient.t * glm::cross(point.normal, point.ds);
  return along / glm::dot(point.normal, glm::cross(point.ds, point.dt));
}

dvec3 relief_normal(const SurfacePoint& point, dvec2 height_gradient, double strength) {
  return glm::normalize(point.normal - strength * surface_gradient(point, height_gradient));
}

dvec3 mapped_normal(const Frame& frame, dvec3 texel) {
  return glm::normalize(texel.x * frame.tangent + texel.y * frame.bitangent + texel.z * frame.normal);
}

}  // namespace texel::truth
