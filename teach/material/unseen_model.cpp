// SPDX-License-Identifier: MIT
// Sums, products and square roots only: they are the same on every machine, and sines are not.
#include "material/unseen_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <map>
#include <numeric>
#include <utility>

#include "core/error.hpp"
#include "mesh/distinct.hpp"

namespace texel::material {
namespace {

/// Numbers that look like chance and follow from the seed.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(mesh::mix(seed)) {}

  std::uint64_t bits() { return mesh::mix(state_++); }
  double between(double least, double most) {
    return least + (most - least) * (static_cast<double>(bits() >> 11) * 0x1p-53);
  }
  /// least to most, both of them too.
  std::size_t index(std::size_t least, std::size_t most) {
    return least + static_cast<std::size_t>(bits() % (most - least + 1));
  }
  bool coin() { return bits() % 2 == 0; }
  template <class Value>
  void shuffle(std::vector<Value>& values) {
    for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[bits() % i]);
  }
  // Braces, here and below: in them the calls come one after the other on every compiler.
  glm::dvec2 point(double least, double most) { return {between(least, most), between(least, most)}; }
  glm::dvec3 vector(double least, double most) {
    return {between(least, most), between(least, most), between(least, most)};
  }
  glm::dvec3 direction() {
    while (true) {
      const glm::dvec3 v = vector(-1, 1);
      const double length = glm::length(v);
      if (length > 0.1 && length < 1) return v / length;
    }
  }

 private:
  std::uint64_t state_;
};

/// Indices from 1; no vt where it is 0.
struct Corner {
  int v = 0, vt = 0, vn = 0;
};

/// The file as it is written. Each list's function returns the new entry's index.
class ObjText {
 public:
  int position(const glm::dvec3& p, const std::string& more = "") {
    text_ += fmt::format("v {:.6f} {:.6f} {:.6f}{}\n", p.x, p.y, p.z, more);
    return ++positions_;
  }
  int texcoord(const std::string& numbers) {
    text_ += "vt " + numbers + "\n";
    return ++texcoords_;
  }
  int texcoord(const glm::dvec2& st) { return texcoord(fmt::format("{:.6f} {:.6f}", st.s, st.t)); }
  int normal(const glm::dvec3& n) {
    text_ += fmt::format("vn {:.6f} {:.6f} {:.6f}\n", n.x, n.y, n.z);
    return ++normals_;
  }
  /// With `both_ways` each second index, by chance, is counted backwards from the list's latest entry.
  void face(const std::vector<Corner>& corners, Random* both_ways = nullptr) {
    const auto written = [&](int index, int count) {
      return both_ways != nullptr && both_ways->coin() ? index - count - 1 : index;
    };
    text_ += 'f';
    for (const Corner& corner : corners) {
      const int v = written(corner.v, positions_);
      const std::string vt = corner.vt == 0 ? "" : fmt::format("{}", written(corner.vt, texcoords_));
      text_ += fmt::format(" {}/{}/{}", v, vt, written(corner.vn, normals_));
    }
    text_ += '\n';
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
  int positions_ = 0, texcoords_ = 0, normals_ = 0;
};

/// So many numbers from `first` on.
std::vector<std::size_t> numbers_from(std::size_t first, std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), first);
  return numbers;
}

/// Points in columns and rows, uneven, facing +z.
struct Relief {
  std::size_t columns, rows;  ///< of points
  std::vector<glm::dvec3> points;
  std::vector<glm::dvec2> texcoords;  ///< t is 0 in the first row
  std::vector<glm::dvec3> normals;

  explicit Relief(Random& random) : columns(random.index(5, 10)), rows(random.index(5, 10)) {
    for (std::size_t j = 0; j < rows; ++j)
      for (std::size_t i = 0; i < columns; ++i) {
        const double x = (static_cast<double>(i) + random.between(0.35, 0.65)) / static_cast<double>(columns),
                     y = (static_cast<double>(j) + random.between(0.35, 0.65)) / static_cast<double>(rows);
        points.emplace_back(x, y, random.between(0.47, 0.53));
        texcoords.emplace_back(x, j == 0 ? 0 : y);
        normals.push_back(glm::normalize(glm::dvec3(random.point(-0.2, 0.2), 1)));
      }
  }

  /// Calls visit(i, a, b, c) for the two triangles of each cell of a row, whose lower left point is in column
  /// i; counter-clockwise.
  template <class Visit>
  void triangles(std::size_t row, Visit visit) const {
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      const std::size_t a = row * columns + i, b = a + 1, c = b + columns, d = a + columns;
      visit(i, a, b, c);
      visit(i, a, c, d);
    }
  }
};

/// Where each point's entry of a list stands, the list being written in an order of its own.
template <class Write>
void write_shuffled(std::vector<std::size_t> points, Random& random, std::vector<Corner>& corners,
                    int Corner::*index, Write write) {
  random.shuffle(points);
  for (const std::size_t point : points) corners[point].*index = write(point);
}

std::string numbers(Random& random) {
  const Relief relief(random);
  ObjText text;
  std::vector<Corner> corners(relief.points.size());
  const std::vector<std::size_t> all = numbers_from(0, corners.size());
  write_shuffled(all, random, corners, &Corner::v, [&](std::size_t point) {
    const std::string weight = random.coin() ? " 1.000000" : "";
    std::string color;
    if (random.coin()) {
      const glm::dvec3 rgb = random.vector(0, 1);
      color = fmt::format(" {:.6f} {:.6f} {:.6f}", rgb.r, rgb.g, rgb.b);
    }
    return text.position(relief.points[point], weight + color);
  });
  write_shuffled(all, random, corners, &Corner::vt, [&](std::size_t point) {
    const glm::dvec2 st = relief.texcoords[point];
    if (st.t == 0) return text.texcoord(fmt::format("{:.6f}", st.s));
    const std::string third = random.coin() ? fmt::format(" {:.6f}", random.between(0, 1)) : "";
    return text.texcoord(fmt::format("{:.6f} {:.6f}{}", st.s, st.t, third));
  });
  write_shuffled(all, random, corners, &Corner::vn,
                 [&](std::size_t point) { return text.normal(relief.normals[point]); });
  for (std::size_t j = 0; j + 1 < relief.rows; ++j)
    relief.triangles(j, [&](std::size_t, std::size_t a, std::size_t b, std::size_t c) {
      text.face({corners[a], corners[b], corners[c]});
    });
  return text.take();
}

std::string negative(Random& random) {
  const Relief relief(random);
  ObjText text;
  std::vector<Corner> corners(relief.points.size());
  for (std::size_t j = 0; j < relief.rows; ++j) {
    const std::vector<std::size_t> row = numbers_from(j * relief.columns, relief.columns);
    write_shuffled(row, random, corners, &Corner::v,
                   [&](std::size_t point) { return text.position(relief.points[point]); });
    write_shuffled(row, random, corners, &Corner::vt,
                   [&](std::size_t point) { return text.texcoord(relief.texcoords[point]); });
    write_shuffled(row, random, corners, &Corner::vn,
                   [&](std::size_t point) { return text.normal(relief.normals[point]); });
    if (j > 0)
      relief.triangles(j - 1, [&](std::size_t, std::size_t a, std::size_t b, std::size_t c) {
        text.face({corners[a], corners[b], corners[c]}, &random);
      });
  }
  return text.take();
}

/// Two cuts through a relief make four patches, each with entries of its own along the cuts.
struct Patches {
  std::size_t column, row;
  [[nodiscard]] std::size_t of(std::size_t i, std::size_t j) const {
    return (i < column ? 0U : 1U) + (j < row ? 0U : 2U);
  }
};

std::string shared(Random& random) {
  const Relief relief(random);
  // The two pairs of cuts differ, so that there are corners with another vt, another vn, and both.
  const Patches by_texcoord{random.index(1, relief.columns / 2 - 1), random.index(1, relief.rows / 2 - 1)};
  const Patches by_normal{random.index(relief.columns / 2, relief.columns - 2),
                          random.index(relief.rows / 2, relief.rows - 2)};
  ObjText text;
  std::vector<Corner> places(relief.points.size());
  write_shuffled(numbers_from(0, places.size()), random, places, &Corner::v,
                 [&](std::size_t point) { return text.position(relief.points[point]); });

  std::array<glm::dvec2, 4> offsets;
  std::array<glm::dvec3, 4> tilts;
  for (glm::dvec2& offset : offsets) offset = random.point(0, 0.4);
  for (glm::dvec3& tilt : tilts) tilt = glm::dvec3(random.point(-0.3, 0.3), 0);
  std::map<std::pair<std::size_t, std::size_t>, int> vt, vn;  // of a patch and a point
  const auto corner = [&](std::size_t point, std::size_t texture, std::size_t side) {
    const auto [texcoord, is_new_texcoord] = vt.try_emplace({texture, point});
    if (is_new_texcoord)
      texcoord->second = text.texcoord(0.6 * glm::dvec2(relief.points[point]) + offsets[texture]);
    const auto [normal, is_new_normal] = vn.try_emplace({side, point});
    if (is_new_normal) normal->second = text.normal(glm::normalize(relief.normals[point] + tilts[side]));
    return Corner{places[point].v, texcoord->second, normal->second};
  };
  std::vector<std::vector<Corner>> faces;
  for (std::size_t j = 0; j + 1 < relief.rows; ++j)
    relief.triangles(j, [&](std::size_t i, std::size_t a, std::size_t b, std::size_t c) {
      const std::size_t texture = by_texcoord.of(i, j), side = by_normal.of(i, j);
      faces.push_back({corner(a, texture, side), corner(b, texture, side), corner(c, texture, side)});
    });
  // One triangle once more, above: only v tells its corners from the first one's.
  faces.push_back(faces.front());
  const std::array<std::size_t, 3> above = {0, 1, relief.columns + 1};
  for (std::size_t k = 0; k < 3; ++k)
    faces.back()[k].v = text.position(relief.points[above[k]] + glm::dvec3(0, 0, 0.3));
  random.shuffle(faces);  // equal corners lie far apart
  for (const std::vector<Corner>& corners : faces) text.face(corners);
  return text.take();
}

/// Twice the signed area of a triangle.
double area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double distance_to_edge(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const double along = glm::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
  return glm::distance(p, a + along * (b - a));
}

/// A polygon in the plane, counter-clockwise.
using Outline = std::vector<glm::dvec2>;

/// Turns pieces of the outline round until no two edges cross; each time it becomes shorter, so this ends.
void untangle(Outline& outline) {
  const std::size_t n = outline.size();
  bool again = true;
  while (again) {
    again = false;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 2; j < n; ++j) {
        if (i == 0 && j == n - 1) continue;  // neighbours
        const glm::dvec2 &a = outline[i], &b = outline[i + 1], &c = outline[j], &d = outline[(j + 1) % n];
        if (area(a, b, c) * area(a, b, d) >= 0 || area(c, d, a) * area(c, d, b) >= 0) continue;
        std::reverse(outline.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                     outline.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        again = true;
      }
  }
  double twice_area = 0;
  for (std::size_t i = 1; i + 1 < n; ++i) twice_area += area(outline[0], outline[i], outline[i + 1]);
  if (twice_area < 0) std::reverse(outline.begin(), outline.end());
}

/// Whether rounding to 6 decimals cannot make it touch itself or straighten a corner.
bool is_sturdy(const Outline& outline) {
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2 &before = outline[(i + n - 1) % n], &tip = outline[i], &after = outline[(i + 1) % n];
    const double sine = area(before, tip, after) / (glm::distance(before, tip) * glm::distance(tip, after));
    if (std::abs(sine) < 0.2) return false;
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t next = (j + 1) % n;
      if (i != j && i != next && distance_to_edge(tip, outline[j], outline[next]) < 0.1) return false;
    }
  }
  return true;
}

bool is_right_as_a_fan(const Outline& outline) {
  for (std::size_t i = 1; i + 1 < outline.size(); ++i)
    if (area(outline[0], outline[i], outline[i + 1]) <= 0) return false;
  return true;
}

/// Moves and widens it until it fills the unit disc.
void fill_disc(Outline& outline) {
  glm::dvec2 least = outline[0], most = outline[0];
  for (const glm::dvec2& p : outline) least = glm::min(least, p), most = glm::max(most, p);
  double radius = 0;
  for (glm::dvec2& p : outline) {
    p -= 0.5 * (least + most);
    radius = std::max(radius, glm::length(p));
  }
  for (glm::dvec2& p : outline) p /= radius;
}

/// A simple polygon that fills the unit disc, which a fan gets wrong from the fourth corner on.
Outline any_outline(Random& random, std::size_t corners) {
  while (true) {
    Outline outline;
    while (outline.size() < corners) {
      const glm::dvec2 p = random.point(-1, 1);
      if (glm::length(p) < 1) outline.push_back(p);
    }
    untangle(outline);
    fill_disc(outline);
    if (is_sturdy(outline) && (corners == 3 || !is_right_as_a_fan(outline))) return outline;
  }
}

std::string polygons(Random& random) {
  constexpr std::size_t side = 4;  // cells along each edge of the cube, a polygon in each
  constexpr double radius = 0.49 / side;
  std::vector<std::size_t> cells = numbers_from(0, side * side * side);
  random.shuffle(cells);
  cells.resize(random.index(40, side * side * side));
  ObjText text;
  for (const std::size_t cell : cells) {
    const glm::dvec3 center =
        (glm::dvec3(cell % side, cell / side % side, cell / side / side) + 0.5) / double{side};
    const glm::dvec3 normal = random.direction();
    const glm::dvec3 x = glm::normalize(glm::cross(normal, random.direction()));
    const glm::dvec3 y = glm::cross(normal, x);
    const int vn = text.normal(normal);
    const Outline outline = any_outline(random, random.index(3, 9));
    std::vector<Corner> corners;
    for (const glm::dvec2& p : outline)
      corners.push_back({text.position(center + radius * (p.x * x + p.y * y)), 0, vn});
    write_shuffled(numbers_from(0, corners.size()), random, corners, &Corner::vt,
                   [&](std::size_t corner) { return text.texcoord(0.5 + 0.45 * outline[corner]); });
    text.face(corners);
  }
  return text.take();
}

/// A ball out of an octahedron whose edges are cut into so many pieces.
std::string no_vt(Random& random) {
  const int pieces = static_cast<int>(random.index(3, 5));
  const glm::dvec3 x = random.direction();
  const glm::dvec3 y = glm::normalize(glm::cross(x, random.direction()));
  const glm::dmat3 turn(x, y, glm::cross(x, y));
  const glm::dvec3 dents = random.vector(0.1, 0.3);
  ObjText text;
  std::map<std::array<int, 3>, Corner> known;
  const auto corner = [&](const std::array<int, 3>& place) {
    const auto [entry, is_new] = known.try_emplace(place);
    if (is_new) {
      const glm::dvec3 out = turn * glm::normalize(glm::dvec3(place[0], place[1], place[2]));
      entry->second.v = text.position(0.5 + 0.48 * (1 - glm::dot(dents, out * out)) * out);
      entry->second.vn = text.normal(out);
    }
    return entry->second;
  };
  std::vector<std::vector<Corner>> faces;
  for (int octant = 0; octant < 8; ++octant) {
    const std::array<int, 3> sign{(octant & 1) != 0 ? -1 : 1, (octant & 2) != 0 ? -1 : 1,
                                  (octant & 4) != 0 ? -1 : 1};
    const bool mirrored = sign[0] * sign[1] * sign[2] < 0;
    const auto at = [&](int i, int j) {
      return corner({sign[0] * (pieces - i - j), sign[1] * i, sign[2] * j});
    };
    for (int i = 0; i < pieces; ++i)
      for (int j = 0; i + j < pieces; ++j) {
        faces.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
        if (mirrored) std::swap(faces.back()[1], faces.back()[2]);
        if (i + j + 1 == pieces) continue;
        faces.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        if (mirrored) std::swap(faces.back()[1], faces.back()[2]);
      }
  }
  random.shuffle(faces);
  for (const std::vector<Corner>& corners : faces) text.face(corners);
  return text.take();
}

}  // namespace

std::string unseen_model(std::string_view kind, std::uint64_t seed) {
  constexpr std::string (*makers[])(Random&) = {numbers, negative, polygons, shared, no_vt};
  static_assert(std::size(makers) == std::size(kUnseenKinds));
  Random random(seed);
  for (std::size_t i = 0; i < std::size(makers); ++i)
    if (kind == kUnseenKinds[i]) return makers[i](random);
  const std::string near = nearest(std::string(kind), {std::begin(kUnseenKinds), std::end(kUnseenKinds)});
  throw Error::usage(fmt::format("there is no unseen model of kind '{}'", kind),
                     near.empty() ? "" : fmt::format("did you mean '{}'?", near));
}

}  // namespace texel::material
