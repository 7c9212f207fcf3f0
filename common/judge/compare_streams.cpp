// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "difference.hpp"
#include "mesh/vectors.hpp"

namespace texel::judge {
namespace {

using glm::dvec3;

/// Positions and texture coordinates that are this close are the same: float32 keeps 1e-7 of them.
constexpr double kSame = 1e-4;
/// A direction along which few vertices of a model lie equally far.
constexpr dvec3 kAcross = {0.36, 0.48, 0.8};
/// Without any weld there are up to six vertices for one.
constexpr std::size_t kMostTooMany = 16;

/// The angle between two vectors in degrees; 180 where only one is zero.
double angle_between(const dvec3& a, const dvec3& b) {
  return (a == dvec3(0)) != (b == dvec3(0)) ? 180 : glm::degrees(mesh::angle_between(a, b));
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

/// A mesh whose vertices can be looked up.
struct Lookup {
  Lookup(const mesh::Mesh& of, const std::vector<dvec3>& its_sums) : mesh(of), sums(its_sums) {
    for (std::uint32_t i = 0; i < mesh.vertex_count(); ++i)
      places.emplace(glm::dot(dvec3(mesh.positions[i]), kAcross), i);
  }

  /// How wrong the vertex `i` of the other mesh is, in degrees: beside that of those here which fits best.
  [[nodiscard]] double error_of(const Lookup& other, std::uint32_t i) const {
    double least = 180;
    const double place = glm::dot(dvec3(other.mesh.positions[i]), kAcross);
    for (auto near = places.lower_bound(place - kSame); near != places.end(); ++near) {
      if (near->first > place + kSame) break;
      least = std::min(least, apart(other, i, near->second));
    }
    return least;
  }

  /// How far vertex `j` here is from vertex `i` of the other, in degrees; 180 for another place or side.
  [[nodiscard]] double apart(const Lookup& other, std::uint32_t i, std::uint32_t j) const {
    if (glm::distance(dvec3(other.mesh.positions[i]), dvec3(mesh.positions[j])) > kSame ||
        (!mesh.texcoords.empty() && glm::distance(other.mesh.texcoords[i], mesh.texcoords[j]) > kSame))
      return 180;
    double error = glm::distance(other.sums[i], sums[j]);
    if (!mesh.normals.empty())
      error = std::max(error, degrees_between(other.mesh.normals[i], mesh.normals[j]));
    if (!mesh.tangents.empty()) {
      const glm::vec4 a = other.mesh.tangents[i], b = mesh.tangents[j];
      if (!(std::abs(a.w - b.w) <= kSame)) return 180;
      error = std::max(error, degrees_between(dvec3(a), dvec3(b)));
    }
    return error;
  }

  const mesh::Mesh& mesh;
  const std::vector<dvec3>& sums;
  std::multimap<double, std::uint32_t> places;  ///< by how far they lie along kAcross
};

bool has_same_attributes(const mesh::Mesh& a, const mesh::Mesh& b) {
  return a.normals.empty() == b.normals.empty() && a.texcoords.empty() == b.texcoords.empty() &&
         a.tangents.empty() == b.tangents.empty();
}

/// How many of the reference's vertices have one like them, and the error of the worst but one of a thousand.
struct Match {
  double share = 0, error = 180;
};

Match match(const Lookup& reference, const Lookup& other, double limit) {
  // A stream of very many vertices at one place would take very long.
  if (reference.mesh.vertex_count() == 0 ||
      other.mesh.vertex_count() > kMostTooMany * reference.mesh.vertex_count() ||
      !has_same_attributes(reference.mesh, other.mesh))
    return {};
  std::vector<double> errors;
  for (std::uint32_t i = 0; i < reference.mesh.vertex_count(); ++i)
    errors.push_back(other.error_of(reference, i));
  std::sort(errors.begin(), errors.end());
  const auto right = std::upper_bound(errors.begin(), errors.end(), limit) - errors.begin();
  // More vertices than needed are as wrong as fewer.
  const double count =
      static_cast<double>(std::max(reference.mesh.vertex_count(), other.mesh.vertex_count()));
  return {static_cast<double>(right) / count, errors[(999 * errors.size() + 999) / 1000 - 1]};
}

/// Of the first vertex that is wrong in an attribute: where it is, what it has there, and whose value that
/// is.
template <class Vector>
std::string first_wrong(const char* name, const VertexPairs& both,
                        std::vector<Vector> mesh::Mesh::*attribute) {
  const std::vector<Vector>&expected = both.reference.*attribute, &own = both.own.*attribute;
  const auto is_same = [](const Vector& a, const Vector& b) { return glm::distance(a, b) <= 10 * kSame; };
  const auto text_of = [](const auto& value) {
    std::string text;
    for (int c = 0; c < value.length(); ++c)
      text += fmt::format("{}{:.3g}", c > 0 ? ", " : "(", std::round(1e6F * value[c]) / 1e6F + 0.0F);
    return text + ")";
  };
  std::vector<std::uint32_t> wrong;
  for (std::uint32_t i = 0; i < expected.size(); ++i)
    if (!is_same(expected[i], own[i])) wrong.push_back(i);
  if (wrong.empty()) return "";
  const std::uint32_t i = wrong.front();
  const auto& corners = both.reference.indices;
  const auto owner =
      std::ranges::find_if(expected, [&](const Vector& other) { return is_same(other, own[i]); });
  return fmt::format(
      "The {} of the vertex at {}, a corner of triangle {}, is {} and not {}{}; so are {} of {} vertices "
      "wrong.",
      name, text_of(both.reference.positions[i]), (std::ranges::find(corners, i) - corners.begin()) / 3 + 1,
      text_of(own[i]), text_of(expected[i]),
      owner == expected.end()
          ? ""
          : ", but that of the one at " +
                text_of(both.reference.positions[static_cast<std::size_t>(owner - expected.begin())]),
      wrong.size(), expected.size());
}

}  // namespace

VertexPairs paired(mesh::Mesh reference, mesh::Mesh own) {
  VertexPairs both{std::move(reference), std::move(own)};
  both.reference_sums = angle_sums(both.reference);
  both.own_sums = angle_sums(both.own);
  // They come in the same order: at least half have the same place or texture coordinate.
  const auto in_order = [](const auto& a, const auto& b) {
    std::size_t same = 0;
    for (std::size_t i = 0; i < a.size() && a.size() == b.size(); ++i)
      same += glm::distance(a[i], b[i]) <= kSame ? 1U : 0U;
    return same > 0 && 2 * same >= a.size();
  };
  both.are_pairs = has_same_attributes(both.reference, both.own) &&
                   both.reference.vertex_count() == both.own.vertex_count() &&
                   (in_order(both.reference.positions, both.own.positions) ||
                    in_order(both.reference.texcoords, both.own.texcoords));
  return both;
}

Verdict compare_streams(double limit, mesh::Mesh reference_mesh, mesh::Mesh own_mesh) {
  const VertexPairs both = paired(std::move(reference_mesh), std::move(own_mesh));
  const Lookup reference(both.reference, both.reference_sums), own(both.own, both.own_sums);
  const Match found = match(reference, own, limit);
  const std::size_t count = own.mesh.vertex_count(), expected = reference.mesh.vertex_count();
  if (found.error <= limit && count == expected) return {true, 1, found.error, {}};
  // A vertex too many or too few is as wrong as one at another place.
  if (count != expected)
    return {false, 0, 180,
            fmt::format("{} vertices instead of {}; {:.0f} % of the expected ones are there and right.",
                        count, expected, 100 * found.share)};
  if (!has_same_attributes(reference.mesh, own.mesh))
    return {false, 0, found.error, "The vertex stream has other attributes than the expected one."};
  for (const std::string& text : {first_wrong("place", both, &mesh::Mesh::positions),
                                  first_wrong("texture coordinate", both, &mesh::Mesh::texcoords),
                                  first_wrong("normal", both, &mesh::Mesh::normals),
                                  first_wrong("tangent", both, &mesh::Mesh::tangents)})
    if (both.are_pairs && !text.empty()) return {false, 0, found.error, text};
  return {false, 0, found.error,
          fmt::format("{}{:.0f} % of the expected vertices are there and right.",
                      both.are_pairs ? "Triangles are wrong; " : "", 100 * found.share)};
}

}  // namespace texel::judge
