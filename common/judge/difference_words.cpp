// SPDX-License-Identifier: MIT
// The words for differences: the same wherever they are read.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "difference.hpp"
#include "judge/results.hpp"

namespace texel::judge {
namespace {

/// What is said of each Way: {c} are the channels, {e} the expected one that stands there, {k}, {b} and {v}
/// numbers.
constexpr std::array kWays = {
    "",
    "{b} everywhere for {c}",
    "{c} negated",
    "{e} in place of {c}",
    "-{e} in place of {c}",
    "1 - {e} in place of {c}",
    "only the fraction of {c}",
    "{c} kept between {k} and {b}",
    "{c} times {k}",
    "{b} added to {c}",
    "a whole number added to {c}",
    "{c} decoded from sRGB once more",
    "{c} encoded as sRGB once more",
    "the light of {c} times {k}",
    "1 minus the light of {c}",
    "{c} times {k} with {b} added",
    "the light of {c} times {k} with {b} added",
    "only {c} wrong",
    ", but its length is about {k} and not 1",
    ", turned by 90 degrees around the normal",
    ", but not made perpendicular to the normal",
    ", turned by {a} degrees around the axis ({v})",
    ", with the vector ({v}) added before it was made a unit vector",
    ", {placed}",
    ", moved by {k} pixels to the right and {b} up",
    ", but sharper: neighbouring pixels differ {k} times as much",
    ", but blurred: neighbouring pixels differ {k} times as much",
    ", but grey",
    ", but with its colours at other places",
    ", turned at each place in another way, by about {a} degrees",
    ", but nothing is drawn there",
    ", but something is drawn where only the background should be",
    ", but of another outline: some of the object is missing, or lies where the background should be",
    ", but {less} by about {k} {unit}",
    ", but {more} by about {k} {unit}",
    ", but vertices that differ in it alone are one",
    ", but some vertices come more than once",
};
constexpr std::array kPlaced = {"mirrored, left for right", "upside down", "turned by 180 degrees",
                                "mirrored at its diagonal"};
/// What quantities are called, and channels of theirs; what less and more of them is called, and in what it
/// is counted.
struct Names {
  const char* name;
  std::array<const char*, 3> channels = {"x", "y", "z"};
  const char *less = "less", *more = "more", *unit = "units";
};
constexpr std::array<const char*, 3> kIt = {"it", "it", "it"};
constexpr auto kNames = std::to_array<Names>({
    {"picture", {"red", "green", "blue"}, "darker", "brighter", "8-bit steps"},
    {"normal"},
    {"tangent"},
    {"texture coordinate", {"s (or u)", "t (or v)", ""}},
    {"direction"},
    {"level of detail", kIt, "lower, so too sharp,", "higher, so too blurred,", "levels"},
    {"depth", kIt, "nearer", "farther away"},
    {"mask", kIt},
    {"position"},
    {"sign w", kIt},
    {"direction of the triangles"},
});

const Names& names_of(Quantity quantity) {
  return kNames.at(static_cast<std::size_t>(quantity));
}

/// "0.5", "-1", "2.2".
std::string number(double value) {
  return std::abs(value - std::round(value)) < 2e-4 ? fmt::format("{:.0f}", std::round(value) + 0.0)
                                                    : fmt::format("{:.3g}", value);
}

std::string place(const Difference& of) {
  constexpr std::array kPlaces = {"", " in a part of it", " at the silhouette",
                                  " where the texture is mirrored"};
  if (of.where == Where::a_part && of.count > 0)
    return fmt::format(" at {} of the {} vertices", of.wrong, of.count);
  return kPlaces.at(static_cast<std::size_t>(of.where));
}

/// What became of one channel, or of several in the same way.
std::string change_text(const Change& of, const std::vector<std::string>& channels, bool has_numbers) {
  const Names& names = names_of(of.quantity);
  const double angle = glm::length(of.numbers);
  const glm::dvec3 v = of.way == Way::turned && angle > 0 ? of.numbers / angle : of.numbers;
  const auto shown = [&](const std::string& text) { return has_numbers ? text : "some number"; };
  const bool is_whole =
      of.channel == 1 && (of.way == Way::added || of.way == Way::bitangent || of.way == Way::turned);
  return (is_whole ? ", negated" : "") +
         fmt::format(
             fmt::runtime(kWays.at(static_cast<std::size_t>(of.way))), fmt::arg("c", listed(channels)),
             fmt::arg("e", of.channel == of.from ? listed(channels)
                                                 : names.channels.at(static_cast<std::size_t>(of.from))),
             fmt::arg("k", shown(number(of.numbers.x))), fmt::arg("b", shown(number(of.numbers.y))),
             fmt::arg("a", has_numbers ? number(angle) : "some"),
             fmt::arg("v", has_numbers ? fmt::format("{}, {}, {}", number(v.x), number(v.y), number(v.z))
                                       : "some numbers"),
             fmt::arg("less", names.less), fmt::arg("more", names.more), fmt::arg("unit", names.unit),
             fmt::arg("placed",
                      kPlaced.at(static_cast<std::size_t>(of.way == Way::placed ? of.channel : 0))));
}

/// The words of one quantity's changes: channels that changed alike are named together.
std::string changes_text(std::vector<Change> changes, bool has_numbers) {
  if (changes.front().way > Way::unknown) return change_text(changes.front(), {}, has_numbers);
  std::vector<std::string> terms;
  while (!changes.empty()) {
    const Change one = changes.front();
    const auto name_of = [&](int channel) -> std::string {
      return names_of(one.quantity).channels.at(static_cast<std::size_t>(channel));
    };
    std::vector<std::string> channels;
    std::erase_if(changes, [&](const Change& two) {
      const auto near = [](double a, double b) { return std::abs(a - b) <= 0.01 * std::abs(a); };
      const bool is_alike = two.way == one.way && (one.channel == one.from) == (two.channel == two.from) &&
                            (one.channel == one.from || one.from == two.from) &&
                            near(one.numbers.x, two.numbers.x) && near(one.numbers.y, two.numbers.y);
      if (is_alike) channels.push_back(name_of(two.channel));
      return is_alike;
    });
    terms.push_back(change_text(one, channels, has_numbers));
  }
  return " with " + listed(terms);
}

}  // namespace

std::string words(const Difference& difference, bool has_numbers) {
  std::vector<std::string> parts;
  const auto& all = difference.changes;
  for (auto first = all.begin(), last = first; first != all.end(); first = last) {
    last = std::find_if(first, all.end(), [&](const Change& one) { return one.quantity != first->quantity; });
    const std::string name = fmt::format("the expected {}", names_of(first->quantity).name);
    // Of a stream alone: of a picture it says nothing that all channels are wrong.
    const std::ptrdiff_t channels = first->quantity == Quantity::texcoord ? 2 : 3;
    const bool is_another = last - first == channels && std::all_of(first, last, [](const Change& one) {
                              return one.way == Way::unknown;
                            });
    parts.push_back(is_another
                        ? fmt::format("the expected vertices with another {}", names_of(first->quantity).name)
                        : name + changes_text({first, last}, has_numbers));
  }
  std::string text = listed(parts);
  text[0] = 'T';
  return text + place(difference) +
         fmt::format(": so it is at {:.0f} % of what is wrong.", std::floor(100 * difference.share));
}

}  // namespace texel::judge
