// SPDX-License-Identifier: MIT
#include "mesh/stretch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "mesh/normals.hpp"
#include "mesh/tangents.hpp"
#include "mesh/vectors.hpp"
#include "newell.hpp"

namespace texel::mesh {
namespace {

double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
  return glm::degrees(angle_between(a, b));
}

/// One corner attribute of a triangle.
template <class Vector>
std::array<Vector, 3> corners_of(const Mesh& mesh, const std::vector<Vector>& values, std::size_t first) {
  return {values[mesh.indices[first]], values[mesh.indices[first + 1]], values[mesh.indices[first + 2]]};
}

double area_of(const std::array<glm::vec3, 3>& p) {
  const glm::dvec3 a(p[0]), b(p[1]), c(p[2]);
  return 0.5 * glm::length(glm::cross(c - a, b - a));
}

}  // namespace

Stretch measure_stretch(const Mesh& mesh) {
  if (mesh.texcoords.empty())
    throw Error::failed("the mesh has no texture coordinates", {}, "generate some by a projection");
  Stretch stretch;
  double surface = 0, texture = 0, sum_squared = 0, sum_shear = 0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const auto p = corners_of(mesh, mesh.positions, i);
    const auto st = corners_of(mesh, mesh.texcoords, i);
    const double area = area_of(p);
    if (area == 0) continue;
    const double twice_texture_area = texture_area(st);
    if (twice_texture_area == 0) {
      ++stretch.zero_area_triangles;
      continue;
    }
    if (twice_texture_area < 0) ++stretch.mirrored_triangles;
    // Dot products of the surface's derivatives by s and t (the first fundamental form, constant on a
    // triangle), from those of the edges. a: by s with itself, b: by s with by t, c: by t with itself.
    const glm::dvec3 edge1(p[1] - p[0]), edge2(p[2] - p[0]);
    const glm::dvec2 step1(st[1] - st[0]), step2(st[2] - st[0]);
    const double e11 = glm::dot(edge1, edge1), e12 = glm::dot(edge1, edge2), e22 = glm::dot(edge2, edge2);
    const double scale = 1 / (twice_texture_area * twice_texture_area);
    const double a =
        scale * (step2.t * step2.t * e11 - 2 * step1.t * step2.t * e12 + step1.t * step1.t * e22);
    const double b = scale * ((step1.s * step2.t + step2.s * step1.t) * e12 - step2.s * step2.t * e11 -
                              step1.s * step1.t * e22);
    const double c =
        scale * (step2.s * step2.s * e11 - 2 * step1.s * step2.s * e12 + step1.s * step1.s * e22);
    const double greatest = std::sqrt(0.5 * (a + c + std::hypot(a - c, 2 * b)));  // singular value
    const double shear = std::abs(90 - glm::degrees(std::atan2(2 * area / std::abs(twice_texture_area), b)));
    surface += area;
    texture += 0.5 * std::abs(twice_texture_area);
    sum_squared += 0.5 * (a + c) * area;
    sum_shear += shear * area;
    stretch.l_infinity = std::max(stretch.l_infinity, greatest);
    stretch.max_shear = std::max(stretch.max_shear, shear);
  }
  if (surface == 0) return stretch;
  const double even = std::sqrt(surface / texture);  // what one step would reach, spread evenly
  stretch.l2 = std::sqrt(sum_squared / surface) / even;
  stretch.l_infinity /= even;
  stretch.mean_shear = sum_shear / surface;
  return stretch;
}

NormalDeviation measure_normals(const Mesh& mesh) {
  if (mesh.normals.empty()) throw Error::failed("the mesh has no normals", {}, "generate some");
  NormalDeviation deviation;
  double surface = 0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const auto p = corners_of(mesh, mesh.positions, i);
    const glm::vec3 face = newell_unit(p[0], p[1], p[2]);
    if (is_zero(face)) continue;
    const double area = area_of(p);
    surface += area;
    for (const glm::vec3& normal : corners_of(mesh, mesh.normals, i)) {
      const double degrees = degrees_between(face, normal);
      deviation.mean += degrees * area / 3;
      deviation.max = std::max(deviation.max, degrees);
    }
  }
  if (surface > 0) deviation.mean /= surface;
  return deviation;
}

std::vector<std::string> describe_stretch(const Mesh& mesh) {
  const Stretch stretch = measure_stretch(mesh);
  const NormalDeviation normals = measure_normals(mesh);
  return {
      fmt::format("{} of {} triangles are smeared (no texture area), {} mirrored",
                  stretch.zero_area_triangles, mesh.triangle_count(), stretch.mirrored_triangles),
      fmt::format("stretch of the others: {:.3f} on average (L2), {:.3f} at most (L infinity); 1 is even",
                  stretch.l2, stretch.l_infinity),
      fmt::format("shear: {:.1f} degrees on average, {:.1f} at most", stretch.mean_shear, stretch.max_shear),
      fmt::format("normals: {:.1f} degrees from their triangle's on average, {:.1f} at most", normals.mean,
                  normals.max)};
}

}  // namespace texel::mesh
