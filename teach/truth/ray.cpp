// SPDX-License-Identifier: MIT
#include "truth/ray.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

namespace texel::truth {

using glm::dvec2;
using glm::dvec3;

namespace {

/// The direction to a point at these angles in degrees; (0, 0) is +z.
dvec3 toward(double yaw, double pitch) {
  const double a = glm::radians(yaw), b = glm::radians(pitch);
  return {std::sin(a) * std::cos(b), std::sin(b), std::cos(a) * std::cos(b)};
}

/// What all rays of a camera have in common.
struct Axes {
  dvec3 eye, right, back, up;  ///< the picture's right and up: where the eye goes when yaw or pitch grows
  double pixel;                ///< its side in the picture plane at distance 1; pixels are square

  [[nodiscard]] dvec3 through(const Camera& camera, dvec2 window) const {
    const dvec2 from_middle = pixel * (window - 0.5 * dvec2(camera.width, camera.height));
    return from_middle.x * right + from_middle.y * up - back;
  }
};

/// Thousands of rays of one camera follow each other: sines and cosines would take as long as the rest.
const Axes& axes_of_last(const Camera& camera) {
  thread_local Camera last{.height = 0};
  thread_local Axes axes;
  if (camera == last) return axes;
  last = camera;
  const dvec3 right = toward(camera.yaw + 90, 0), back = toward(camera.yaw, camera.pitch);
  axes = {camera.eye(), right, back, glm::cross(back, right),
          2 * std::tan(0.5 * glm::radians(camera.field_of_view)) / camera.height};
  return axes;
}

/// The derivative of v / |v| when v changes by dv: the part of dv across v, as a fraction of v's length.
dvec3 normalized_derivative(dvec3 v, dvec3 dv) {
  return (dv - v * (glm::dot(v, dv) / glm::dot(v, v))) / glm::length(v);
}

}  // namespace

dvec3 Camera::eye() const {
  return distance * toward(yaw, pitch);
}

PixelRay pixel_ray(const Camera& camera, dvec2 window) {
  const Axes& axes = axes_of_last(camera);
  const dvec3 through = axes.through(camera, window);
  return {.ray = {axes.eye, glm::normalize(through)},
          .dx = normalized_derivative(through, axes.pixel * axes.right),
          .dy = normalized_derivative(through, axes.pixel * axes.up)};
}

Ray ray_through(const Camera& camera, dvec2 window) {
  const Axes& axes = axes_of_last(camera);
  return {axes.eye, glm::normalize(axes.through(camera, window))};
}

Ray object_ray(const Ray& world_ray, const Placement& world_from_object) {
  const glm::dmat3 inverse = glm::inverse(world_from_object.linear);
  return {inverse * (world_ray.origin - world_from_object.offset), inverse * world_ray.direction};
}

std::optional<Hit> hit_quad(const Ray& ray, double half_size) {
  const double distance = -ray.origin.z / ray.direction.z;
  if (!(distance > 0) || !std::isfinite(distance)) return std::nullopt;
  const dvec2 xy = dvec2(ray.origin) + distance * dvec2(ray.direction);
  if (std::max(std::abs(xy.x), std::abs(xy.y)) > half_size) return std::nullopt;
  return Hit{.distance = distance, .texcoord = xy / (2 * half_size) + 0.5};
}

std::optional<Hit> hit_cube(const Ray& ray, double half_size) {
  // The ray is inside from the last entry into a pair of planes to the first exit from one.
  double enter = -std::numeric_limits<double>::infinity(), leave = -enter;
  int enter_axis = 0, leave_axis = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (ray.direction[axis] == 0) {
      if (std::abs(ray.origin[axis]) > half_size) return std::nullopt;
      continue;
    }
    const double side = std::copysign(half_size, ray.direction[axis]);
    const double first = (-side - ray.origin[axis]) / ray.direction[axis];
    const double last = (side - ray.origin[axis]) / ray.direction[axis];
    if (first > enter) {
      enter = first;
      enter_axis = axis;
    }
    if (last < leave) {
      leave = last;
      leave_axis = axis;
    }
  }
  if (enter > leave || leave <= 0) return std::nullopt;
  const bool outside = enter > 0;
  const double distance = outside ? enter : leave;
  const int axis = outside ? enter_axis : leave_axis;
  const bool negative = (ray.direction[axis] > 0) == outside;
  const auto face = static_cast<image::Face>(2 * axis + (negative ? 1 : 0));
  const dvec3 position = ray.origin + distance * ray.direction;
  const SurfacePoint middle = cube_face(face, half_size)({0.5, 0.5});
  // ds and dt are at right angles and as long as the face is wide.
  const dvec2 along(glm::dot(position, middle.ds), glm::dot(position, middle.dt));
  return Hit{.distance = distance, .texcoord = along / glm::dot(middle.ds, middle.ds) + 0.5, .face = face};
}

std::optional<Hit> hit_sphere(const Ray& ray, double radius) {
  const double squared = glm::dot(ray.direction, ray.direction);
  const double middle =
      -glm::dot(ray.origin, ray.direction) / squared;  // where the ray is nearest to the centre
  const dvec3 nearest = ray.origin + middle * ray.direction;
  const double discriminant = radius * radius - glm::dot(nearest, nearest);
  if (discriminant < 0) return std::nullopt;
  const double half = std::sqrt(discriminant / squared);
  // An eye on the sphere itself sees its far side: the rounding of where it stands is no hit.
  const double from_middle = middle > half * (1 + 1e-12) ? -half : half;
  if (middle + from_middle <= 0) return std::nullopt;
  // From the nearest point: an eye far away then costs no digits of the position.
  return Hit{.distance = middle + from_middle,
             .texcoord = sphere_texcoord(nearest + from_middle * ray.direction)};
}

PositionGradient position_gradient(const PixelRay& pixel, const SurfacePoint& point) {
  const dvec3 direction = pixel.ray.direction;
  const double distance = glm::length(point.position - pixel.ray.origin);
  const double facing = glm::dot(direction, point.normal);
  const auto carried = [&](dvec3 change) {
    return distance * (change - direction * (glm::dot(change, point.normal) / facing));
  };
  return {carried(pixel.dx), carried(pixel.dy)};
}

TexcoordGradient texcoord_gradient(const PixelRay& pixel, const SurfacePoint& point) {
  const PositionGradient position = position_gradient(pixel, point);
  // Unit lengths first: where ds is short, its square would lose what the direction still has.
  const dvec2 lengths(glm::length(point.ds), glm::length(point.dt));
  const dvec3 s = point.ds / lengths.s, t = point.dt / lengths.t;
  const double across = glm::dot(point.normal, glm::cross(s, t));
  const auto solved = [&](dvec3 change) {
    const dvec2 along(glm::dot(point.normal, glm::cross(change, t)),
                      glm::dot(point.normal, glm::cross(s, change)));
    return along / (across * lengths);
  };
  return {solved(position.dx), solved(position.dy)};
}

}  // namespace texel::truth
