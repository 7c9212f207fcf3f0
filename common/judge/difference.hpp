// SPDX-License-Identifier: MIT
// What makes a drawn picture of the expected one, whatever line caused it: found in the data alone.
#pragma once
#include <glm/glm.hpp>
#include <string_view>

#include "judge/mistakes.hpp"

namespace texel::judge {

/// What is compared: a view's values, or an attribute of a vertex stream.
enum class Quantity { color, normal, tangent, texcoord, direction, level, depth, mask, position, side, turn };

/// How drawn values follow from expected ones, as what is said of it: {c} are the channels, {e} the expected
/// one that stands there, {k}, {b}, {a} and {v} numbers. What is said of the whole begins with a comma.
using Way = std::string_view;
namespace ways {
inline constexpr Way same = "";
inline constexpr Way constant = "{b} everywhere for {c}";
inline constexpr Way negated = "{c} negated";
inline constexpr Way other = "{e} in place of {c}";
inline constexpr Way minus_other = "-{e} in place of {c}";
inline constexpr Way one_minus = "1 - {e} in place of {c}";
inline constexpr Way fraction = "only the fraction of {c}";
inline constexpr Way cut_off = "{c} kept between {k} and {b}";
inline constexpr Way scaled = "{c} times {k}";
inline constexpr Way shifted = "{b} added to {c}";
inline constexpr Way whole = "a whole number added to {c}";
inline constexpr Way decoded = "{c} decoded from sRGB once more";
inline constexpr Way encoded = "{c} encoded as sRGB once more";
inline constexpr Way lit = "the light of {c} times {k}";
inline constexpr Way inverted = "1 minus the light of {c}";
inline constexpr Way affine = "{c} times {k} with {b} added";
inline constexpr Way unknown = "only {c} wrong";
inline constexpr Way longer = ", but its length is about {k} and not 1";
inline constexpr Way bitangent = ", turned by 90 degrees around the normal";
inline constexpr Way leaning = ", but not made perpendicular to the normal";
inline constexpr Way turned = ", turned by {a} degrees around the axis ({v})";
inline constexpr Way added = ", with the vector ({v}) added before it was made a unit vector";
inline constexpr Way placed = ", {placed}";
inline constexpr Way moved = ", moved by {k} pixels to the right and {b} up";
inline constexpr Way sharper = ", but sharper: neighbouring pixels differ {k} times as much";
inline constexpr Way blurred = ", but blurred: neighbouring pixels differ {k} times as much";
inline constexpr Way grey = ", but grey";
inline constexpr Way nothing = ", but nothing is drawn there";
inline constexpr Way covering = ", but something is drawn where only the background should be";
inline constexpr Way outline =
    ", but of another outline: some of the object is missing, or lies where the background should be";
inline constexpr Way less = ", but {less} by about {k} {unit}";
inline constexpr Way more = ", but {more} by about {k} {unit}";
}  // namespace ways

/// What became of a channel, or of the whole.
struct Change {
  Quantity quantity{};
  Way way = {};
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
};

/// The part of what is wrong that a difference explains.
constexpr double kExplained = 0.95;
/// Differences that cost less say what became of each value; from kVague on they say a direction or a place
/// alone.
constexpr int kPlain = 12, kVague = 20, kAnyCost = 1000;

/// All ways in which the case's values follow from the expected ones, the simplest first.
std::vector<Difference> differences(const course::Case& of, const Failed& failed);

/// "The expected normal with y negated: so it is at 99 % of the wrong places." Without its numbers, which
/// could carry text out of a run, unless `has_numbers`.
std::string words(const Difference& difference, bool has_numbers);

}  // namespace texel::judge
