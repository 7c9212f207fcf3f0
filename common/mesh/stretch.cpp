// SPDX-License-Identifier: MIT
#include "mesh/stretch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "mesh/tangents.hpp"
#include "mesh/vectors.hpp"
#include "newell.hpp"

namespace texel::mesh {

Stretch measure_stretch(const Mesh& mesh) {
  if (mesh.texcoords.size() != mesh.vertex_count() || mesh.normals.size() != mesh.vertex_count())
    throw Error::failed("the mesh has no texture coordinates or no normals", {}, "generate some");
  Stretch stretch;
  double surface = 0, textured = 0, texture = 0, sum_squared = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto p = of_triangle(mesh, mesh.positions, t);
    const auto st = of_triangle(mesh, mesh.texcoords, t);
    const glm::dvec3 face = newell_normal(p);
    const double area = 0.5 * glm::length(face);
    if (area == 0) continue;
    surface += area;
    for (const glm::vec3& normal : of_triangle(mesh, mesh.normals, t)) {
      const double degrees = glm::degrees(angle_between(face, normal));
      stretch.mean_deviation += degrees * area / 3;
      stretch.max_deviation = std::max(stretch.max_deviation, degrees);
    }
    const double twice_texture_area = texture_area(st);
    if (twice_texture_area == 0) {
      ++stretch.zero_area_triangles;
      continue;
    }
    if (twice_texture_area < 0) ++stretch.mirrored_triangles;
    // The surface's derivatives by s and t, and their dot products (the first fundamental form, constant on a
    // triangle).
    const glm::dvec3 edge1(p[1] - p[0]), edge2(p[2] - p[0]);
    const glm::dvec2 step1(st[1] - st[0]), step2(st[2] - st[0]);
    const glm::dvec3 by_s = (step2.t * edge1 - step1.t * edge2) / twice_texture_area;
    const glm::dvec3 by_t = (step1.s * edge2 - step2.s * edge1) / twice_texture_area;
    const double a = glm::dot(by_s, by_s), b = glm::dot(by_s, by_t), c = glm::dot(by_t, by_t);
    const double greatest = std::sqrt(0.5 * (a + c + std::hypot(a - c, 2 * b)));  // singular value
    const double shear = std::abs(90 - glm::degrees(std::atan2(2 * area / std::abs(twice_texture_area), b)));
    textured += area;
    texture += 0.5 * std::abs(twice_texture_area);
    sum_squared += 0.5 * (a + c) * area;
    stretch.mean_shear += shear * area;
    stretch.l_infinity = std::max(stretch.l_infinity, greatest);
    stretch.max_shear = std::max(stretch.max_shear, shear);
  }
  if (surface > 0) stretch.mean_deviation /= surface;
  if (textured == 0) return stretch;
  const double even = std::sqrt(textured / texture);  // what one step would reach, spread evenly
  stretch.l2 = std::sqrt(sum_squared / textured) / even;
  stretch.l_infinity /= even;
  stretch.mean_shear /= textured;
  return stretch;
}

std::vector<std::string> describe_stretch(const Mesh& mesh) {
  const Stretch stretch = measure_stretch(mesh);
  return {
      fmt::format("{} of {} triangles are smeared (no texture area), {} mirrored",
                  stretch.zero_area_triangles, mesh.triangle_count(), stretch.mirrored_triangles),
      fmt::format("stretch of the others: {:.3f} on average (L2), {:.3f} at most (L infinity); 1 is even",
                  stretch.l2, stretch.l_infinity),
      fmt::format("shear: {:.1f} degrees on average, {:.1f} at most", stretch.mean_shear, stretch.max_shear),
      fmt::format("normals: {:.1f} degrees from their triangle's on average, {:.1f} at most",
                  stretch.mean_deviation, stretch.max_deviation)};
}

}  // namespace texel::mesh
