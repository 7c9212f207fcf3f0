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

std::vector<std::string> describe_stretch(const Mesh& mesh) {
  if (mesh.texcoords.size() != mesh.vertex_count() || mesh.normals.size() != mesh.vertex_count())
    throw Error::failed("the mesh has no texture coordinates or no normals", {}, "generate some");
  int smeared = 0, mirrored = 0;
  double surface = 0, textured = 0, texture = 0;  // areas
  // Sums by area, of the square of the stretch too, and the greatest.
  double stretch = 0, shear = 0, deviation = 0, most_stretch = 0, most_shear = 0, most_deviation = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto p = of_triangle(mesh, mesh.positions, t);
    const auto st = of_triangle(mesh, mesh.texcoords, t);
    const glm::dvec3 face = newell_normal(p);
    const double area = 0.5 * glm::length(face);
    if (area == 0) continue;
    surface += area;
    for (const glm::vec3& normal : of_triangle(mesh, mesh.normals, t)) {
      const double degrees = glm::degrees(angle_between(face, normal));
      deviation += degrees * area / 3;
      most_deviation = std::max(most_deviation, degrees);
    }
    const double twice_texture_area = texture_area(st);
    if (twice_texture_area == 0) {
      ++smeared;
      continue;
    }
    if (twice_texture_area < 0) ++mirrored;
    // The surface's derivatives by s and t, and their dot products (the first fundamental form, constant on a
    // triangle).
    const glm::dvec3 edge1(p[1] - p[0]), edge2(p[2] - p[0]);
    const glm::dvec2 step1(st[1] - st[0]), step2(st[2] - st[0]);
    const glm::dvec3 by_s = (step2.t * edge1 - step1.t * edge2) / twice_texture_area;
    const glm::dvec3 by_t = (step1.s * edge2 - step2.s * edge1) / twice_texture_area;
    const double a = glm::dot(by_s, by_s), b = glm::dot(by_s, by_t), c = glm::dot(by_t, by_t);
    const double greatest = std::sqrt(0.5 * (a + c + std::hypot(a - c, 2 * b)));  // singular value
    const double lean = std::abs(90 - glm::degrees(std::atan2(2 * area / std::abs(twice_texture_area), b)));
    textured += area;
    texture += 0.5 * std::abs(twice_texture_area);
    stretch += 0.5 * (a + c) * area;
    shear += lean * area;
    most_stretch = std::max(most_stretch, greatest);
    most_shear = std::max(most_shear, lean);
  }
  const auto ratio = [](double sum, double whole) { return whole > 0 ? sum / whole : 0; };
  const double even = std::sqrt(ratio(textured, texture));  // what one step would reach, spread evenly
  return {fmt::format("{} of {} triangles are smeared (no texture area), {} mirrored", smeared,
                      mesh.triangle_count(), mirrored),
          fmt::format("stretch of the others: {:.3f} on average (L2), {:.3f} at most (L infinity); 1 is even",
                      ratio(std::sqrt(ratio(stretch, textured)), even), ratio(most_stretch, even)),
          fmt::format("shear: {:.1f} degrees on average, {:.1f} at most", ratio(shear, textured), most_shear),
          fmt::format("normals: {:.1f} degrees from their triangle's on average, {:.1f} at most",
                      ratio(deviation, surface), most_deviation)};
}

}  // namespace texel::mesh
