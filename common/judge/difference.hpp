// SPDX-License-Identifier: MIT
// What the files of this folder share: how a vertex stream is judged, and what makes a drawn picture or
// stream of the expected one, whatever line caused it, found in the data alone.
#pragma once
#include <glm/glm.hpp>

#include "image/image.hpp"
#include "judge/judge.hpp"
#include "judge/mistakes.hpp"
#include "mesh/mesh.hpp"

namespace texel::judge {

/// Judges a vertex stream. Vertices are matched by position and texture coordinate, so that their order does
/// not matter; what is compared are their normals and tangents, direction and length, and the sum of the
/// angles of the triangles around them, each with its triangle's direction, which is the same however a flat
/// polygon was cut. `limit` is in degrees. A number of vertices other than the reference's fails.
Verdict compare_streams(double limit, mesh::Mesh reference, mesh::Mesh own);

/// Two streams, and whether the vertices of the own one are the reference's by their indices.
struct VertexPairs {
  mesh::Mesh reference, own;
  /// Of each vertex' triangles: angle times unit normal, degrees.
  std::vector<glm::dvec3> reference_sums = {}, own_sums = {};
  bool are_pairs = false;
};
VertexPairs paired(mesh::Mesh reference, mesh::Mesh own);

/// The mask's pixels of the object, or of the background, without those beside the other: where the object's
/// edge passes between them is the rasteriser's choice.
image::Image8 part_of(const image::Image8& mask, bool is_object);

/// What is compared: a view's values, or an attribute of a vertex stream.
enum class Quantity { color, normal, tangent, texcoord, direction, level, depth, mask, position, side, turn };

/// How drawn values follow from expected ones: up to `unknown` those of a channel, then those of the whole.
enum class Way : std::uint8_t {
  same,
  constant,
  negated,
  other,
  minus_other,
  one_minus,
  fraction,
  cut_off,
  scaled,
  shifted,
  whole,
  decoded,
  encoded,
  lit,
  inverted,
  affine,
  veiled,
  unknown,
  longer,
  bitangent,
  leaning,
  turned,
  added,
  placed,
  moved,
  sharper,
  blurred,
  grey,
  elsewhere,
  apart,
  nothing,
  covering,
  outline,
  less,
  more,
  merged,
  repeated
};

/// What became of a channel, or of the whole.
struct Change {
  Quantity quantity{};
  Way way{};
  int channel = 0, from = 0;       ///< the channel that is wrong, and the expected one that stands there
  glm::dvec3 numbers = {0, 0, 0};  ///< factors, offsets, an angle: those that the way has

  /// Whether it is the same but for its numbers, which depend on the case's settings.
  bool operator==(const Change& other) const {
    return quantity == other.quantity && way == other.way && channel == other.channel && from == other.from;
  }
};

/// Where it is wrong, if what is right does not follow.
enum class Where : std::uint8_t { everywhere, a_part, silhouette, mirrored };

struct Difference {
  std::vector<Change> changes;
  double share = 0;  ///< of the wrong pixels or vertices, at least kExplained
  int cost = 0;      ///< the less, the simpler
  Where where = Where::everywhere;
  std::size_t wrong = 0, count = 0;  ///< vertices of a stream

  [[nodiscard]] Way way() const { return changes.front().way; }
};

/// The part of what is wrong that a difference explains.
constexpr double kExplained = 0.95;
/// Differences that cost less say what became of each value; from kVague on they say a direction or a place
/// alone, and from kLast on only that it is none of the others.
constexpr int kPlain = 13, kVague = 20, kLast = 100, kAnyCost = 1000;

/// All ways in which the case's values follow from the expected ones, the simplest first.
std::vector<Difference> differences(const course::Case& of, const Failed& failed);

/// "The expected normal with y negated: so it is at 99 % of the wrong places." Without its numbers, which
/// could carry text out of a run, unless `has_numbers`.
std::string words(const Difference& difference, bool has_numbers);

}  // namespace texel::judge
