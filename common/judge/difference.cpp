// SPDX-License-Identifier: MIT
#include "difference.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <span>
#include <utility>

#include "core/error.hpp"
#include "image/color.hpp"
#include "image/load.hpp"
#include "mesh/ply.hpp"

namespace texel::judge {
namespace {

using course::View;
using glm::dvec3;
using enum Way;
using enum Quantity;

// --- What is wrong, beside what is expected ----------------------------------------------------------------

/// A pixel or vertex.
struct Pair {
  dvec3 expected{0}, own{0};
  int at = 0;  ///< row by row from the bottom
  bool is_object = true, is_at_edge = false;
  dvec3 normal{0};  ///< of a vertex, as expected
  double side = 1;  ///< and w of its tangent
};

/// One quantity: some of the pairs that are wrong, and then of those that are right.
struct Field {
  Quantity quantity{};
  int channels = 3;
  double tolerance = 0;  ///< of a channel, or of a direction's chord
  std::vector<Pair> pairs = {};
  std::size_t wrong = 0;
  double rightness = 1;          ///< how many right pixels one stands for, over how many wrong ones
  course::Size size{0, 0};       ///< of a picture
  bool is_plain = false;         ///< the background has one value
  dvec3 background{0};           ///< that, or what a picture has where nothing is drawn
  Values values = {}, own = {};  ///< expected ones and own ones, of all pixels

  [[nodiscard]] bool is_near(const dvec3& a, const dvec3& b) const {
    const dvec3 d = glm::abs(a - b);
    return std::max({d.x, d.y, d.z}) <= tolerance;
  }
};

dvec3 at(const Values& values, int place) {
  const auto value = values.at(static_cast<std::size_t>(place));
  return {value[0], value[1], value[2]};
}

Field picture_field(const course::Case& of, const Failed& failed) {
  constexpr std::size_t kMostWrong = 1000, kMostRight = 400;  // a share of 0.95 is then known to 0.01
  constexpr int kEdge = 4;                                    // pixels that the silhouette is wide
  constexpr std::array kQuantities = {color, normal, tangent, texcoord, direction, level, depth, mask};
  const bool is_direction = unit_of(of.view) == course::Unit::degrees, is_color = of.view == View::color;
  const double limit = tolerance(of);
  Field field{kQuantities.at(static_cast<std::size_t>(of.view))};
  field.size = of.size;
  field.channels = of.view == View::texcoord ? 2 : is_direction || is_color ? 3 : 1;
  // Where a case is lenient, since renderers differ at its edges, the rest is as exact as elsewhere.
  field.tolerance = std::min(limit, is_direction ? 0.004 : is_color ? 4 : of.view == View::lod ? 0.1 : limit);
  field.values = parse_values(of, failed.reference);
  const Values& own = field.own = parse_values(of, failed.picture);
  if (own.count != field.values.count) return field;
  const image::Image8 all = image::parse_png(failed.mask, "the mask", of.size.width, of.size.height);
  std::array<std::vector<int>, 2> places;  // right, wrong
  bool has_background = false, is_even = true;
  for (const bool is_object : {false, true}) {
    const image::Image8 part = part_of(all, is_object);
    if (is_object && places[1].empty()) places[0].clear();  // nobody asks what the background follows
    for (int i = 0; i < static_cast<int>(part.samples.size()); ++i) {
      if (part.samples[static_cast<std::size_t>(i)] == 0) continue;
      const dvec3 e = at(field.values, i), o = at(own, i);
      if (!is_object && !std::exchange(has_background, true)) field.background = e;
      is_even &= is_object || e == field.background;
      const auto count = static_cast<std::size_t>(field.channels);
      places[are_same({&e[0], count}, {&o[0], count}, limit) ? 0 : 1].push_back(i);
    }
  }
  field.is_plain = has_background && is_even;
  if (!field.is_plain) field.background = dvec3(0);
  for (const bool is_wrong : {true, false}) {
    const std::vector<int>& from = places[is_wrong ? 1 : 0];
    const std::size_t some = std::min(from.size(), is_wrong ? kMostWrong : kMostRight);
    for (std::size_t i = 0; i < some; ++i) {  // evenly, but not in one column
      const double within = std::fmod(static_cast<double>(i) * std::numbers::phi, 1);
      const int place = from[static_cast<std::size_t>(
          (static_cast<double>(i) + within) * static_cast<double>(from.size()) / static_cast<double>(some))];
      const int x = place % of.size.width, y = place / of.size.width;
      Pair pair{at(field.values, place), at(own, place), place, all.at(x, y) > 127};
      for (const auto& [dx, dy] : {std::pair(kEdge, 0), {-kEdge, 0}, {0, kEdge}, {0, -kEdge}})
        if (x + dx >= 0 && y + dy >= 0 && x + dx < of.size.width && y + dy < of.size.height)
          pair.is_at_edge |= (all.at(x + dx, y + dy) > 127) != pair.is_object;
      field.pairs.push_back(pair);
    }
    const double weight = static_cast<double>(from.size()) / std::max(1.0, static_cast<double>(some));
    field.rightness = is_wrong ? weight : weight / field.rightness;
    if (is_wrong && some >= 8) field.wrong = some;
  }
  return field;
}

std::vector<Field> stream_fields(const Failed& failed) {
  const VertexPairs both = paired(mesh::parse_ply(failed.reference, "the reference"),
                                  mesh::parse_ply(failed.picture, "the stream"));
  std::vector<Field> fields;
  const auto add = [&](Field field, auto value) {
    std::vector<Pair> right;
    for (std::size_t i = 0; both.are_pairs && i < both.own.vertex_count(); ++i) {
      Pair pair{value(both.reference, i), value(both.own, i)};
      if (!both.reference.normals.empty()) pair.normal = both.reference.normals[i];
      if (!both.reference.tangents.empty()) pair.side = both.reference.tangents[i].w;
      (field.is_near(pair.expected, pair.own) ? right : field.pairs).push_back(pair);
    }
    field.wrong = field.pairs.size();
    field.pairs.insert(field.pairs.end(), right.begin(), right.end());
    if (field.wrong > 0) fields.push_back(std::move(field));
  };
  constexpr double same = 1e-4, chord = 1e-3;  // as compare_streams has it; 0.05 degrees
  const auto value_of = [](const auto& list, std::size_t i) {
    return list.empty() ? dvec3(0) : dvec3(list[i]);
  };
  add({position, 3, same}, [&](const mesh::Mesh& m, std::size_t i) { return value_of(m.positions, i); });
  add({texcoord, 2, same}, [](const mesh::Mesh& m, std::size_t i) {
    return m.texcoords.empty() ? dvec3(0) : dvec3(m.texcoords[i], 0);
  });
  add({normal, 3, chord}, [&](const mesh::Mesh& m, std::size_t i) { return value_of(m.normals, i); });
  add({tangent, 3, chord}, [&](const mesh::Mesh& m, std::size_t i) { return value_of(m.tangents, i); });
  add({side, 1, same}, [](const mesh::Mesh& m, std::size_t i) {
    return dvec3(m.tangents.empty() ? 0 : m.tangents[i].w, 0, 0);
  });
  if (fields.empty())
    add({turn, 3, 0.05}, [&](const mesh::Mesh& m, std::size_t i) {
      return (&m == &both.own ? both.own_sums : both.reference_sums)[i];
    });
  return fields;
}

// --- Channel by channel ------------------------------------------------------------------------------------

/// A way that may be, and of which pairs it is true.
struct Option {
  Change change;
  int cost = 0;
  std::vector<char> hits = {};
};
using Options = std::vector<Option>;

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double share_of(const std::vector<char>& hits, const Field& of) {
  const auto followed = std::ranges::count(std::span(hits).first(of.wrong), 1);
  return static_cast<double>(followed) / static_cast<double>(of.wrong);
}

/// Keeps a way if enough of the wrong pairs follow it.
template <class Holds>
void add(Options& options, const Field& of, const Change& change, int cost, Holds holds) {
  Option one{change, cost};
  for (const Pair& pair : of.pairs) one.hits.push_back(holds(pair) ? 1 : 0);
  if (share_of(one.hits, of) >= kExplained) options.push_back(std::move(one));
}

constexpr auto bit = [](Quantity one) { return 1U << static_cast<unsigned>(one); };
constexpr std::uint32_t kUnit = bit(normal) | bit(tangent) | bit(direction),
                        kSingle = bit(level) | bit(depth) | bit(mask),
                        kLinear = kSingle | bit(texcoord) | bit(position) | bit(color);

using Curve = double (*)(double);
constexpr Curve as_it_is = [](double value) { return value; };
constexpr Curve fraction_of = [](double value) { return value - std::floor(value); };
constexpr Curve light = [](double value) {
  return image::linear_from_srgb(std::clamp(value / 255, 0.0, 1.0));
};
constexpr Curve sample = [](double value) {
  return 255 * image::srgb_from_linear(std::clamp(value, 0.0, 1.0));
};
constexpr Curve part = [](double value) { return value / 255; };
constexpr Curve step = [](double value) { return 255 * value; };

/// What a channel may become: out(k in(e) + b) of the expected value e, its own or another channel's. A k or
/// b that is kFit is the median over the wrong pairs: a few that do not follow change nothing.
struct Rule {
  Way way;
  int cost, distinct;  ///< of so many different values it can be told
  std::uint32_t of;
  bool is_of_other;
  double k, b;
  Curve in = as_it_is, out = as_it_is;
};
constexpr double kFit = HUGE_VAL;
constexpr auto kRules = std::to_array<Rule>({
    {same, 0, 1, ~0U, false, 1, 0},
    {constant, 2, 1, ~bit(mask), false, 0, kFit},
    {negated, 2, 2, ~(kSingle | bit(color)), false, -1, 0},
    {other, 2, 2, ~0U, true, 1, 0},
    {minus_other, 3, 2, ~bit(color), true, -1, 0},
    {one_minus, 3, 2, bit(texcoord) | bit(mask), false, -1, 1},
    {one_minus, 4, 2, bit(texcoord), true, -1, 1},
    {fraction, 3, 2, bit(texcoord), false, 1, 0, fraction_of},
    {inverted, 3, 4, bit(color), false, -1, 1, light, sample},
    {decoded, 3, 4, bit(color), false, 1, 0, light, step},
    {encoded, 3, 4, bit(color), false, 1, 0, part, sample},
    {lit, 3, 8, bit(color), false, kFit, 0, light, sample},
    {scaled, 4, 2, kLinear, false, kFit, 0},
    {shifted, 4, 3, kLinear, false, 1, kFit},
    {affine, 7, 6, kLinear, false, kFit, kFit},
    {veiled, 4, 8, bit(color), false, kFit, kFit, light, sample},
});

/// Whether a channel is wrong by far, and not about as much as another one that passes.
bool is_far_off(const Field& of, int channel) {
  std::vector<double> off;
  for (std::size_t i = 0; i < of.wrong; ++i)
    off.push_back(std::abs(of.pairs[i].own[channel] - of.pairs[i].expected[channel]));
  return of.quantity != color || median(std::move(off)) > 2 * of.tolerance;
}

/// How many different values a channel has where it is wrong, up to 16.
int distinct(const Field& of, int channel) {
  std::set<long long> seen;
  for (std::size_t i = 0; i < of.wrong && seen.size() < 16; ++i)
    seen.insert(std::llround(of.pairs[i].expected[channel] / (4 * of.tolerance)));
  return static_cast<int>(seen.size());
}

std::pair<double, double> fitted(const Field& of, const Rule& rule, int c, int from) {
  std::vector<double> factors, offsets;
  const auto e = [&](std::size_t i) { return rule.in(of.pairs[i % of.wrong].expected[from]); };
  const auto o = [&](std::size_t i) {
    return rule.out == as_it_is ? of.pairs[i % of.wrong].own[c] : light(of.pairs[i % of.wrong].own[c]);
  };
  // Not half of all: that is often the same column, some rows higher.
  const auto far = static_cast<std::size_t>(static_cast<double>(of.wrong) / std::numbers::phi);
  const auto apart = [&](std::size_t i) { return std::abs(e(i) - e(i + far)); };
  double most = 0;
  for (std::size_t i = 0; i < of.wrong; ++i) most = std::max(most, apart(i));
  for (std::size_t i = 0; i < of.wrong; ++i) {
    const double k = rule.b == kFit ? (o(i) - o(i + far)) / (e(i) - e(i + far)) : o(i) / e(i);
    // Of two values that are close rounding makes any slope.
    if (std::isfinite(k) && !(rule.out == sample && o(i) > 0.97) && (rule.b != kFit || 2 * apart(i) > most))
      factors.push_back(k);
  }
  const double k = rule.k == kFit ? median(std::move(factors)) : rule.k;
  for (std::size_t i = 0; i < of.wrong; ++i) offsets.push_back(o(i) - k * e(i));
  return {k, rule.b == kFit ? median(std::move(offsets)) : rule.b};
}

Options channel_options(const Field& of, int c) {
  Options found;
  for (const Rule& rule : kRules)
    for (int from = 0; from < of.channels && (rule.of & bit(of.quantity)) != 0; ++from) {
      const bool is_fit = rule.k == kFit || rule.b == kFit;
      if ((from != c) != rule.is_of_other ||
          distinct(of, from) < (is_fit && of.quantity == color ? 5 : rule.distinct))
        continue;
      const auto [k, b] = fitted(of, rule, c, from);
      if (rule.k == kFit && (std::abs(k) < 0.002 || (std::abs(k - 1) < 0.002 && b == 0)))
        continue;  // another way says it
      add(found, of, {of.quantity, rule.way, c, from, {k, b, 0}}, rule.cost,
          [&, k = k, b = b](const Pair& p) {
            const double value = rule.out(k * rule.in(p.expected[from]) + b);
            return std::abs(p.own[c] - (of.quantity == color ? std::clamp(value, 0.0, 255.0) : value)) <=
                   of.tolerance;
          });
    }
  const auto [low, high] =
      std::ranges::minmax_element(of.pairs, {}, [&](const Pair& one) { return one.own[c]; });
  const double least = low->own[c], most = high->own[c];
  if ((bit(of.quantity) & (bit(texcoord) | bit(level))) != 0 && most - least > 8 * of.tolerance)
    add(found, of, {of.quantity, cut_off, c, c, {least, most, 0}}, 4, [&](const Pair& p) {
      return std::abs(p.own[c] - std::clamp(p.expected[c], least, most)) <= of.tolerance;
    });
  if (of.quantity == texcoord && distinct(of, c) > 4)  // between 0 and 1 each change is a whole number
    add(found, of, {of.quantity, whole, c, c}, 5,
        [&](const Pair& p) { return std::abs(std::remainder(p.own[c] - p.expected[c], 1)) <= of.tolerance; });
  std::ranges::stable_sort(found, {}, &Option::cost);
  if (found.size() > 4) found.resize(4);
  return found;
}

// --- As a whole --------------------------------------------------------------------------------------------

constexpr auto unit = [](const dvec3& v) { return v == dvec3(0) ? v : glm::normalize(v); };

/// The matrix that takes expected directions to own ones: the sum of own expected' times the inverse of that
/// of expected expected'.
struct Turn {
  glm::dmat3 own{0}, expected{1e-9};

  [[nodiscard]] glm::dmat3 matrix() const { return own * glm::inverse(expected); }
  void add(const dvec3& e, const dvec3& o) {
    own += glm::outerProduct(o, e), expected += glm::outerProduct(e, e);
  }
  [[nodiscard]] double away(const dvec3& e, const dvec3& o) const { return glm::distance(matrix() * e, o); }
};

/// The vector that is added to expected directions before they become unit vectors, own x (expected + v) = 0:
/// three equations for v that are linear in it.
struct Offset {
  glm::dmat3 crosses{1e-9};
  dvec3 right{0};

  [[nodiscard]] dvec3 vector() const { return glm::inverse(crosses) * right; }
  void add(const dvec3& e, const dvec3& o) {
    const glm::dmat3 flat = glm::dmat3(1) - glm::outerProduct(o, o);  // into o's plane
    crosses += flat, right -= flat * e;
  }
  [[nodiscard]] double away(const dvec3& e, const dvec3& o) const {
    return glm::length(glm::cross(o, unit(e + vector())));
  }
};

/// A Turn or Offset by least squares, three times, each time without what does not follow.
template <class Sums>
Sums fitted_without_strays(const Field& of) {
  std::vector<double> away(of.wrong, 0);
  Sums sums;
  for (int round = 0; round < 3; ++round) {
    const double most = std::max(3 * median(away), of.tolerance);
    sums = Sums();
    for (std::size_t i = 0; i < of.wrong; ++i)
      if (away[i] <= most) sums.add(of.pairs[i].expected, unit(of.pairs[i].own));
    for (std::size_t i = 0; i < of.wrong; ++i)
      away[i] = sums.away(of.pairs[i].expected, unit(of.pairs[i].own));
  }
  return sums;
}

void add_directions(Options& found, const Field& of) {
  const auto near = [&](const dvec3& a, const dvec3& b) { return glm::distance(a, b) <= of.tolerance; };
  std::vector<double> lengths, angles;
  std::set<std::array<int, 3>> cells;  // of expected directions: few can be taken anywhere
  for (std::size_t i = 0; i < of.wrong; ++i) {
    const dvec3 &e = of.pairs[i].expected, &o = of.pairs[i].own, cell = 10.0 * e;
    lengths.push_back(glm::length(o));
    angles.push_back(std::atan2(glm::length(glm::cross(e, o)), glm::dot(e, o)));
    cells.insert({static_cast<int>(cell.x), static_cast<int>(cell.y), static_cast<int>(cell.z)});
  }
  add(found, of, {of.quantity, longer, 0, 0, {median(lengths), 0, 0}}, 4,
      [&](const Pair& p) { return near(unit(p.own), p.expected); });
  for (const int sign : {1, -1})
    add(found, of, {of.quantity, bitangent, (1 - sign) / 2, 0}, 4, [&](const Pair& p) {
      return near(p.own, static_cast<double>(sign) * glm::cross(p.normal, p.expected));
    });
  add(found, of, {of.quantity, leaning, 0, 0}, 5,
      [&](const Pair& p) { return near(unit(p.own - glm::dot(p.own, p.normal) * p.normal), p.expected); });
  const double away = median(std::move(angles));
  // Any small turn fits what is wrong by two or three times what may be: such were said, and were false.
  if (of.wrong < 60 || cells.size() < 12 || away < 4 * of.tolerance) return;
  add(found, of, {of.quantity, apart, 0, 0, {glm::degrees(away), 0, 0}}, kLast,
      [](const Pair&) { return true; });

  const glm::dmat3 map = fitted_without_strays<Turn>(of).matrix();
  const double side = glm::determinant(map) < 0 ? -1 : 1;  // a mirror turns what was negated
  const glm::dmat3 rotation = side * map;
  const glm::dmat3 gram = glm::transpose(rotation) * rotation - glm::dmat3(1);  // 0 of a turn
  const bool is_turn = glm::length(gram[0]) + glm::length(gram[1]) + glm::length(gram[2]) < 0.01;
  // Along the axis, twice the sine of the angle long; the trace is 1 and twice the cosine.
  const dvec3 across = {rotation[1][2] - rotation[2][1], rotation[2][0] - rotation[0][2],
                        rotation[0][1] - rotation[1][0]};
  const double angle = std::atan2(glm::length(across), rotation[0][0] + rotation[1][1] + rotation[2][2] - 1);
  if (is_turn && glm::length(across) > 0.01)  // of half a turn it says no axis
    add(found, of, {of.quantity, turned, side < 0 ? 1 : 0, 0, unit(across) * glm::degrees(angle)}, 7,
        [&](const Pair& p) { return near(map * p.expected, unit(p.own)); });
  const dvec3 offset = fitted_without_strays<Offset>(of).vector();
  for (const int sign : {1, -1})
    add(found, of, {of.quantity, added, (1 - sign) / 2, 0, offset}, 8, [&](const Pair& p) {
      return near(static_cast<double>(sign) * unit(p.expected + offset), unit(p.own));
    });
}

/// Another place of the expected picture: mirrored, turned, or moved by whole pixels.
void add_moved(Options& found, const Field& of) {
  const int w = of.size.width, h = of.size.height;
  for (int i = 0; i < 4 + 169; ++i) {
    const int dx = i < 4 ? 0 : (i - 4) % 13 - 6, dy = i < 4 ? 0 : (i - 4) / 13 - 6;
    const auto holds = [&](const Pair& p) {
      const int x = p.at % w - dx, y = p.at / w - dy;
      const glm::ivec2 from = i == 0   ? glm::ivec2(w - 1 - x, y)
                              : i == 1 ? glm::ivec2(x, h - 1 - y)
                              : i == 2 ? glm::ivec2(w - 1 - x, h - 1 - y)
                              : i == 3 ? glm::ivec2(y, x)
                                       : glm::ivec2(x, y);
      return from.x >= 0 && from.y >= 0 && from.x < w && from.y < h &&
             of.is_near(at(of.values, from.y * w + from.x), p.own);
    };
    int held = 0;  // most are not worth all pixels
    for (std::size_t k = 0; k < 64; ++k) held += holds(of.pairs[k * of.wrong / 64]) ? 1 : 0;
    if (held > 54)
      add(found, of, {of.quantity, i < 4 ? placed : moved, i < 4 ? i : 0, 0, {dx, dy, 0}}, i < 4 ? 4 : 6,
          holds);
  }
}

/// The same colours on an average over blocks, but another contrast from pixel to pixel.
void add_contrast(Options& found, const Field& of) {
  constexpr int kSide = 16;
  constexpr double kClear = 1.15, kMean = 12;  // 8-bit steps: filters keep a mean but for rounding and edges
  const auto block = [&](const Pair& p) {
    return p.at / of.size.width / kSide * of.size.width + p.at % of.size.width / kSide;
  };
  std::map<int, bool> is_even;  // by block: its mean is the same
  double own = 0, expected = 0;
  for (std::size_t i = 0; i < of.wrong; ++i) {
    const int left = of.pairs[i].at % of.size.width / kSide * kSide,
              bottom = of.pairs[i].at / of.size.width / kSide * kSide;
    if (is_even.contains(block(of.pairs[i])) || left + kSide > of.size.width ||
        bottom + kSide > of.size.height)
      continue;
    dvec3 sum(0);
    for (int k = 0; k < kSide * (kSide - 1); ++k) {
      const int place = (bottom + k / (kSide - 1)) * of.size.width + left + k % (kSide - 1);
      sum += at(of.own, place) - at(of.values, place);
      own += glm::distance(at(of.own, place), at(of.own, place + 1));
      expected += glm::distance(at(of.values, place), at(of.values, place + 1));
    }
    is_even[block(of.pairs[i])] = glm::length(sum) <= kMean * kSide * (kSide - 1);
  }
  const double ratio = own / std::max(expected, 1e-9);
  if (ratio > kClear || ratio < 1 / kClear)
    add(found, of, {of.quantity, ratio > 1 ? sharper : blurred, 0, 0, {ratio, 0, 0}}, kPlain,
        [&](const Pair& p) { return is_even[block(p)]; });
}

/// The same colours, as often, at other places: sorted they are much nearer than pixel by pixel.
void add_elsewhere(Options& found, const Field& of) {
  std::vector<double> expected = of.values.all, own = of.own.all;
  const auto apart = [&] {
    return std::inner_product(own.begin(), own.end(), expected.begin(), 0.0, std::plus(),
                              [](double a, double b) { return std::abs(a - b); });
  };
  const double here = apart();
  std::ranges::sort(expected), std::ranges::sort(own);
  if (apart() < 0.1 * here) add(found, of, {color, elsewhere}, kLast, [](const Pair&) { return true; });
}

void add_pictures(Options& found, const Field& of) {
  if (of.quantity == color || (bit(of.quantity) & kUnit) != 0) add_moved(found, of);
  if (of.quantity == color) {
    add_contrast(found, of);
    add_elsewhere(found, of);
    add(found, of, {of.quantity, grey}, 10, [&](const Pair& p) {
      return of.is_near(p.own, dvec3(p.own.x)) && !of.is_near(p.expected, dvec3(p.expected.x));
    });
  }
  const auto is_nothing = [&](const Pair& p) {
    return (p.is_object || !of.is_plain) && of.is_near(p.own, of.background);
  };
  const auto is_covering = [&](const Pair& p) {
    return of.is_plain && !p.is_object && !of.is_near(p.own, of.background);
  };
  if (of.is_plain || of.quantity != color)
    add(found, of, {of.quantity, nothing}, of.quantity == texcoord ? 4 : 3, is_nothing);
  add(found, of, {of.quantity, covering}, 3, is_covering);
  const auto outside = std::ranges::count_if(std::span(of.pairs).first(of.wrong),
                                             [&](const Pair& p) { return is_nothing(p) || is_covering(p); });
  if (of.is_plain && 3 * outside > static_cast<std::ptrdiff_t>(of.wrong))
    add(found, of, {of.quantity, outline}, kVague + 1, [](const Pair&) { return true; });
  if (of.quantity != color && (bit(of.quantity) & kSingle) == 0) return;
  const auto more_by = [](const Pair& p) { return glm::dot(p.own - p.expected, dvec3(1.0 / 3)); };
  std::vector<double> all;
  for (std::size_t i = 0; i < of.wrong; ++i) all.push_back(more_by(of.pairs[i]));
  const double by = median(std::move(all));
  if (std::abs(by) > of.tolerance)
    add(found, of, {of.quantity, by < 0 ? less : more, 0, 0, {std::abs(by), 0, 0}}, kVague,
        [&](const Pair& p) { return more_by(p) * by > 0; });
}

// --- All together ------------------------------------------------------------------------------------------

/// Where it is wrong, if nearly all of such a place is.
void put_place(const Field& of, Difference& in) {
  in.where = Where::a_part, in.wrong = of.wrong, in.count = of.size.width > 0 ? 0 : of.pairs.size();
  const auto ask = [&](Where where, double filled, auto is_there) {
    std::array<double, 2> count = {0, 0};  // wrong, right
    for (std::size_t i = 0; i < of.pairs.size(); ++i)
      count[i < of.wrong ? 0 : 1] += is_there(of.pairs[i]) ? 1 : 0;
    if (count[0] > 0.97 * static_cast<double>(of.wrong) && count[0] > filled * count[1] * of.rightness)
      in.where = where;
  };
  ask(Where::silhouette, 0.5, [](const Pair& p) { return p.is_at_edge; });
  ask(Where::mirrored, 9, [](const Pair& p) { return p.side < 0; });
}

void add_difference(std::vector<Difference>& found, const Field& of,
                    std::initializer_list<const Option*> options) {
  Difference all;
  std::vector<char> hits(of.pairs.size(), 1);
  for (const Option* option : options) {
    for (std::size_t i = 0; i < hits.size(); ++i) hits[i] = static_cast<char>(hits[i] & option->hits[i]);
    all.cost += option->cost;
    if (option->change.way != same) all.changes.push_back(option->change);
  }
  all.share = share_of(hits, of);
  if (all.share < kExplained || all.changes.empty()) return;
  // Does what is right follow it too?
  const auto right = std::count(hits.begin() + static_cast<std::ptrdiff_t>(of.wrong), hits.end(), 1);
  if (all.way() < sharper &&
      static_cast<double>(right) < 0.9 * static_cast<double>(of.pairs.size() - of.wrong))
    put_place(of, all), all.cost += 3;  // what holds everywhere is simpler
  found.push_back(std::move(all));
}

/// Of a stream with too few or too many vertices: which of them became one, or whether some are repeated.
std::vector<Difference> count_differences(const Failed& failed) {
  const mesh::Mesh expected = mesh::parse_ply(failed.reference, "the reference"),
                   own = mesh::parse_ply(failed.picture, "the stream");
  const auto values = [](const mesh::Mesh& of, Quantity without) {
    std::set<std::vector<long long>> all;
    for (std::size_t i = 0; i < of.vertex_count(); ++i) {
      std::vector<long long> one;
      const auto put = [&](Quantity quantity, const auto& list) {
        for (int c = 0; quantity != without && !list.empty() && c < list[i].length(); ++c)
          one.push_back(std::llround(1e4 * double{list[i][c]}));
      };
      put(position, of.positions), put(texcoord, of.texcoords), put(normal, of.normals);
      all.insert(std::move(one));
    }
    return all;
  };
  std::vector<Difference> found;
  for (const Quantity quantity : {texcoord, normal})
    if (own.vertex_count() < expected.vertex_count() && values(own, quantity).size() == own.vertex_count() &&
        values(own, quantity) == values(expected, quantity))
      found.push_back({{{quantity, merged}}, 1, 3});
  if (own.vertex_count() > expected.vertex_count() && values(own, mask) == values(expected, mask))
    found.push_back({{{position, repeated}}, 1, 3});
  return found;
}

std::vector<Difference> differences_of(const Field& of) {
  std::vector<Difference> found;
  std::array<Options, 3> channels;
  for (int c = 0; c < 3; ++c) {
    Options& own = channels.at(static_cast<std::size_t>(c));
    if (c < of.channels) own = channel_options(of, c);
    // Of a channel of which nothing is known it is said that it is wrong, if another is right.
    if (own.empty() && (c >= of.channels || is_far_off(of, c)))
      own.push_back({{of.quantity, c < of.channels ? unknown : same, c, c},
                     c < of.channels ? kVague + 1 : 0,
                     std::vector<char>(of.pairs.size(), 1)});
  }
  for (const Option& x : channels[0])
    for (const Option& y : channels[1])
      for (const Option& z : channels[2]) {
        int right = of.channels - 3;
        bool is_known = true;
        for (const Option* option : {&x, &y, &z})
          right += option->change.way == same ? 1 : 0, is_known &= option->change.way != unknown;
        if (is_known || right > 0 || of.size.width == 0) add_difference(found, of, {&x, &y, &z});
      }
  Options whole;
  if ((bit(of.quantity) & kUnit) != 0) add_directions(whole, of);
  if (of.size.width > 0) add_pictures(whole, of);
  for (const Option& option : whole) add_difference(found, of, {&option});
  std::ranges::stable_sort(found, {}, &Difference::cost);
  if (found.size() > 12) found.resize(12);
  return found;
}

}  // namespace

std::vector<Difference> differences(const course::Case& of, const Failed& failed) {
  std::vector<Difference> all;
  try {
    if (of.is_mesh()) all = count_differences(failed);
    if (!all.empty()) return all;
    for (const Field& field : of.is_mesh() ? stream_fields(failed) : std::vector{picture_field(of, failed)}) {
      const std::vector<Difference> before = std::move(all),
                                    own = field.wrong > 0 ? differences_of(field) : std::vector<Difference>();
      all = before.empty() ? own : std::vector<Difference>();
      for (const Difference& first : before)
        for (const Difference& second : own) {  // each attribute has its own
          all.push_back(first);
          all.back().changes.insert(all.back().changes.end(), second.changes.begin(), second.changes.end());
          all.back().share = std::min(first.share, second.share), all.back().cost += second.cost;
        }
      if (all.empty()) return {};
    }
  } catch (const Error&) {  // no picture of this case
    return {};
  }
  std::ranges::stable_sort(all, {}, &Difference::cost);
  return all;
}

}  // namespace texel::judge
