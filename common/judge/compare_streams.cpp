// SPDX-License-Identifier: MIT
#include "compare_streams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <string>
#include <unordered_map>
#include <vector>

#include "judge/results.hpp"

namespace texel::judge {
namespace {

using glm::dvec3;

/// Positions and texture coordinates that are this close are the same: float32 keeps 1e-7 of them.
constexpr double kSame = 1e-4;
/// Positions are looked up in cells of this size; models are about 1 large.
constexpr double kCell = 1e-3;
/// Without any weld there are up to six vertices for one.
constexpr std::size_t kMostTooMany = 16;

/// What can be wrong with a vertex. The first two have no angle.
enum Part : std::size_t { place, side, triangles, normals, tangents };
constexpr std::array kPartNames = {"places or texture coordinates", "the tangents' signs w (1 or -1)",
                                   "triangles", "normals", "tangents"};

/// How far two vertices are apart, part by part, in degrees; 180 for another place or side.
using Apart = std::array<double, kPartNames.size()>;

double most_of(const Apart& apart) {
  return std::min(180.0, *std::max_element(apart.begin(), apart.end()));
}

/// The angle between two vectors in degrees; 180 where only one is zero.
double angle_between(const dvec3& a, const dvec3& b) {
  const bool zero_a = a == dvec3(0), zero_b = b == dvec3(0);
  if (zero_a || zero_b) return zero_a == zero_b ? 0 : 180;
  return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

/// How far apart two vectors are that should be unit vectors: the angle, or the difference of their lengths
/// as an angle whose arc is as long, if that is larger.
double degrees_between(const dvec3& a, const dvec3& b) {
  return std::max(angle_between(a, b),
                  std::min(180.0, glm::degrees(std::abs(glm::length(a) - glm::length(b)))));
}

/// For each vertex the sum over its triangles of their angle there, in degrees, times their unit normal.
std::vector<dvec3> angle_sums(const mesh::Mesh& mesh) {
  std::vector<dvec3> sums(mesh.vertex_count(), dvec3(0));
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const dvec3 p[] = {mesh.positions[mesh.indices[i]], mesh.positions[mesh.indices[i + 1]],
                       mesh.positions[mesh.indices[i + 2]]};
    const dvec3 cross = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double size = glm::length(cross);
    if (size == 0) continue;  // no area: it covers nothing
    for (std::size_t k = 0; k < 3; ++k)
      sums[mesh.indices[i + k]] +=
          angle_between(p[(k + 1) % 3] - p[k], p[(k + 2) % 3] - p[k]) * (cross / size);
  }
  return sums;
}

std::uint64_t cell_of(const dvec3& position, int dx, int dy, int dz) {
  const auto index = [](double value, int step) {
    constexpr double far = 1e12;  // cells
    return static_cast<std::uint64_t>(
        static_cast<std::int64_t>(std::clamp(std::floor(value / kCell), -far, far)) + step);
  };
  return (index(position.x, dx) * 73856093U) ^ (index(position.y, dy) * 19349663U) ^
         (index(position.z, dz) * 83492791U);
}

/// A mesh whose vertices can be looked up.
struct Lookup {
  explicit Lookup(mesh::Mesh of) : mesh(std::move(of)), sums(angle_sums(mesh)) {
    for (std::uint32_t i = 0; i < mesh.vertex_count(); ++i)
      cells[cell_of(mesh.positions[i], 0, 0, 0)].push_back(i);
  }

  /// What is wrong with the vertex `i` of the other mesh: of those here at its place the one that fits best.
  [[nodiscard]] Apart error_of(const Lookup& other, std::uint32_t i) const {
    Apart least{180};  // the place
    const dvec3 position = other.mesh.positions[i];
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dz = -1; dz <= 1; ++dz)
          if (const auto cell = cells.find(cell_of(position, dx, dy, dz)); cell != cells.end())
            for (const std::uint32_t j : cell->second)
              if (const Apart found = apart(other, i, j); least[place] > 0 || most_of(found) < most_of(least))
                least = found;
    return least;
  }

  /// How far vertex `j` here is from vertex `i` of the other.
  [[nodiscard]] Apart apart(const Lookup& other, std::uint32_t i, std::uint32_t j) const {
    Apart error{};
    if (glm::distance(dvec3(other.mesh.positions[i]), dvec3(mesh.positions[j])) > kSame ||
        (!mesh.texcoords.empty() && glm::distance(other.mesh.texcoords[i], mesh.texcoords[j]) > kSame)) {
      error[place] = 180;
      return error;
    }
    error[triangles] = glm::distance(other.sums[i], sums[j]);
    if (!mesh.normals.empty()) error[normals] = degrees_between(other.mesh.normals[i], mesh.normals[j]);
    if (!mesh.tangents.empty()) {
      const glm::vec4 a = other.mesh.tangents[i], b = mesh.tangents[j];
      error[tangents] = degrees_between(dvec3(a), dvec3(b));
      if (!(std::abs(a.w - b.w) <= kSame)) error[side] = 180;
    }
    return error;
  }

  mesh::Mesh mesh;
  std::vector<dvec3> sums;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells;
};

/// How many of the reference's vertices have one like them, and the error of the worst but one of a thousand.
struct Match {
  double share = 0, error = 180;
  std::vector<Part> wrong;  ///< what is off at a tenth or more of the wrong vertices
};

Match match(const Lookup& reference, const Lookup& other, double limit) {
  const auto same = [](const auto& a, const auto& b) { return a.empty() == b.empty(); };
  // A stream of very many vertices at one place would take very long.
  if (reference.mesh.vertex_count() == 0 ||
      other.mesh.vertex_count() > kMostTooMany * reference.mesh.vertex_count() ||
      !same(reference.mesh.normals, other.mesh.normals) ||
      !same(reference.mesh.texcoords, other.mesh.texcoords) ||
      !same(reference.mesh.tangents, other.mesh.tangents))
    return {};
  std::vector<double> errors;
  std::array<std::size_t, kPartNames.size()> counts{};
  for (std::uint32_t i = 0; i < reference.mesh.vertex_count(); ++i) {
    const Apart error = other.error_of(reference, i);
    errors.push_back(most_of(error));
    for (std::size_t part = 0; part < error.size(); ++part) counts[part] += error[part] > limit ? 1U : 0U;
  }
  std::sort(errors.begin(), errors.end());
  const auto right = std::upper_bound(errors.begin(), errors.end(), limit) - errors.begin();
  // More vertices than needed are as wrong as fewer.
  const double count =
      static_cast<double>(std::max(reference.mesh.vertex_count(), other.mesh.vertex_count()));
  Match found{static_cast<double>(right) / count, errors[(999 * errors.size() + 999) / 1000 - 1], {}};
  const std::size_t wrong = errors.size() - static_cast<std::size_t>(right);
  for (std::size_t part = 0; part < counts.size(); ++part)
    if (counts[part] > 0 && 10 * counts[part] >= wrong) found.wrong.push_back(static_cast<Part>(part));
  return found;
}

/// What is wrong with a stream of the right number of vertices.
std::string what_is_wrong(const Match& found, double limit) {
  if (found.wrong.empty()) return "The vertex stream has other attributes than the expected one.";
  std::vector<std::string> names;
  for (const Part part : found.wrong) names.emplace_back(kPartNames[part]);
  std::string text = fmt::format("{:.0f} % of the vertices are right; of the others, {} are wrong",
                                 100 * found.share, listed(names));
  if (found.wrong.front() >= triangles)
    text += fmt::format(", by up to {:.3g} degrees; the limit is {:.3g}", found.error, limit);
  return text + ".";
}

}  // namespace

Verdict compare_streams(double limit, mesh::Mesh reference_mesh, mesh::Mesh own_mesh) {
  const Lookup reference(std::move(reference_mesh)), own(std::move(own_mesh));
  const Match found = match(reference, own, limit);
  const std::size_t count = own.mesh.vertex_count(), expected = reference.mesh.vertex_count();
  if (found.error <= limit && count == expected) return {true, 1, found.error, {}};
  // A vertex too many or too few is as wrong as one at another place.
  return {false, 0, count != expected ? 180 : found.error,
          count != expected
              ? fmt::format("{} vertices instead of {}; {:.0f} % of the expected ones are there and right.",
                            count, expected, 100 * found.share)
              : what_is_wrong(found, limit)};
}

}  // namespace texel::judge
