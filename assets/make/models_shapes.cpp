// SPDX-License-Identifier: MIT
#include "models_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace texel::assets {

constexpr double pi = std::numbers::pi;

void Part::add(Face face) {
  const auto same = [](const Corner& a, const Corner& b) {
    return glm::distance(a.position, b.position) < 1e-9;
  };
  face.erase(std::unique(face.begin(), face.end(), same), face.end());
  while (face.size() > 1 && same(face.front(), face.back())) face.pop_back();
  if (face.size() >= 3) faces.push_back(std::move(face));
}

Part& Part::operator+=(const Part& other) {
  faces.insert(faces.end(), other.faces.begin(), other.faces.end());
  return *this;
}

Profile::Profile(std::initializer_list<double> keys) {
  for (const double* key = keys.begin(); key != keys.end(); key += 2) keys_.emplace_back(key[0], key[1]);
  slopes_.assign(keys_.size(), 0.0);
  const auto secant = [&](std::size_t i) {
    return (keys_[i + 1].y - keys_[i].y) / (keys_[i + 1].x - keys_[i].x);
  };
  for (std::size_t i = 1; i + 1 < keys_.size(); ++i) {
    const double before = secant(i - 1), after = secant(i);
    // The harmonic mean keeps every piece monotone; a turning point gets a level tangent.
    if (before * after > 0) slopes_[i] = 2 * before * after / (before + after);
  }
  if (keys_.size() > 1) {
    slopes_.front() = secant(0);
    slopes_.back() = secant(keys_.size() - 2);
  }
}

double Profile::operator()(double x) const {
  if (x <= keys_.front().x) return keys_.front().y;
  if (x >= keys_.back().x) return keys_.back().y;
  std::size_t i = 0;
  while (x > keys_[i + 1].x) ++i;
  const double h = keys_[i + 1].x - keys_[i].x, t = (x - keys_[i].x) / h;
  return (1 + 2 * t) * (1 - t) * (1 - t) * keys_[i].y + t * (1 - t) * (1 - t) * h * slopes_[i] +
         t * t * (3 - 2 * t) * keys_[i + 1].y + t * t * (t - 1) * h * slopes_[i + 1];
}

std::vector<dvec3> curve_through(const std::vector<dvec3>& points, int steps) {
  std::vector<dvec3> curve;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const dvec3 a = points[i], b = points[i + 1];
    const dvec3 leave = i > 0 ? 0.5 * (b - points[i - 1]) : b - a;
    const dvec3 arrive = i + 2 < points.size() ? 0.5 * (points[i + 2] - a) : b - a;
    for (int k = 0; k < steps; ++k) {
      const double t = double(k) / steps;
      curve.push_back((1 + 2 * t) * (1 - t) * (1 - t) * a + t * (1 - t) * (1 - t) * leave +
                      t * t * (3 - 2 * t) * b + t * t * (t - 1) * arrive);
    }
  }
  curve.push_back(points.back());
  return curve;
}

std::vector<dvec2> ring(const Section& section, int count) {
  // The right half finely from bottom to top, then equal arc lengths on it; the left half is its mirror
  // image.
  constexpr int fine = 240;
  std::vector<dvec2> dense;
  std::vector<double> length{0};
  for (int i = 0; i <= fine; ++i) {
    const double angle = pi * i / fine - pi / 2;
    const double c = std::max(0.0, std::cos(angle)), s = std::sin(angle);
    const double n = s < 0 ? section.down_exponent : section.up_exponent;
    const double height = s < 0 ? -section.down : section.up;
    const double x = i == 0 || i == fine ? 0.0 : std::pow(c, 2 / n);
    dense.emplace_back(section.width * x, height * std::pow(std::abs(s), 2 / n));
    if (i > 0)
      length.push_back(length.back() + glm::distance(dense[std::size_t(i)], dense[std::size_t(i) - 1]));
  }
  std::vector<dvec2> points(std::size_t(count), dense.front());
  std::size_t k = 0;
  for (int i = 1; i <= count / 2; ++i) {
    const double wanted = length.back() * 2 * i / count;
    while (k + 2 < length.size() && length[k + 1] < wanted) ++k;
    const double step = length[k + 1] - length[k];
    const double t = step > 0 ? std::min(1.0, (wanted - length[k]) / step) : 0.0;
    const dvec2 p = i == count / 2 ? dense.back() : glm::mix(dense[k], dense[k + 1], t);
    points[std::size_t(i)] = p;
    if (i < count / 2) points[std::size_t(count - i)] = {-p.x, p.y};
  }
  return points;
}

std::vector<Frame> frames_along(const std::vector<dvec3>& path, dvec3 hint) {
  std::vector<Frame> frames;
  dvec3 up = hint;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const dvec3 before = path[i > 0 ? i - 1 : 0], after = path[std::min(i + 1, path.size() - 1)];
    const dvec3 forward = glm::normalize(after - before);
    // Projecting the last `up` keeps the frames from turning about the path.
    up = glm::normalize(up - glm::dot(up, forward) * forward);
    frames.push_back({path[i], glm::cross(up, forward), up});
  }
  return frames;
}

namespace {

/// Rows with their texture coordinates; in a closed ring the last column repeats the first one.
struct Grid {
  Rows points;
  std::vector<std::vector<dvec2>> texcoords;
};

Grid laid_out(const Rows& rows, const Wrap& wrap) {
  Grid grid{rows, {}};
  const std::size_t columns = rows.front().size();
  std::vector<double> v(columns, 0.0);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::vector<double> step(columns, 0.0);
    double mean = 0;
    for (std::size_t c = 0; c < columns && r > 0; ++c) {
      step[c] = glm::distance(rows[r][c], rows[r - 1][c]);
      mean += step[c] / double(columns);
    }
    for (std::size_t c = 0; c < columns; ++c) v[c] += wrap.plate ? step[c] : mean;
    const std::vector<dvec3>& measured = rows[wrap.plate ? std::size_t(wrap.base_row) : r];
    double u = 0;
    std::vector<dvec2> line;
    for (std::size_t c = 0; c < columns; ++c) {
      if (c > 0) u += glm::distance(measured[c], measured[c - 1]);
      line.emplace_back(u, v[c]);
    }
    const double shift = -line[std::size_t(wrap.middle)].x;
    for (dvec2& t : line) t.x += shift;
    grid.texcoords.push_back(std::move(line));
  }
  const std::vector<dvec2> base = grid.texcoords[std::size_t(wrap.base_row)];
  for (auto& line : grid.texcoords)
    for (std::size_t c = 0; c < columns; ++c) line[c].y -= base[c].y;
  return grid;
}

Part joined(const Grid& grid) {
  Part part;
  const auto corner = [&](std::size_t r, std::size_t c) {
    return Corner{grid.points[r][c], grid.texcoords[r][c], dvec3(0)};
  };
  for (std::size_t r = 0; r + 1 < grid.points.size(); ++r)
    for (std::size_t c = 0; c + 1 < grid.points[r].size(); ++c)
      part.add({corner(r, c), corner(r, c + 1), corner(r + 1, c + 1), corner(r + 1, c)});
  return part;
}

/// Closes a convex ring with one polygon, the texture laid flat on it.
void close(Part& part, std::vector<dvec3> ring, bool reversed) {
  if (reversed) std::reverse(ring.begin(), ring.end());
  Face face;
  for (const dvec3& p : ring) face.push_back({p});
  const dvec3 normal = face_normal(face);
  if (normal == dvec3(0)) return;  // the ring is a point
  const dvec3 hint = std::abs(normal.y) > 0.9 ? dvec3(0, 0, -1) : dvec3(0, 1, 0);
  const dvec3 right = glm::normalize(glm::cross(hint, normal)), up = glm::cross(normal, right);
  for (Corner& corner : face)
    corner.texcoord = dvec2(glm::dot(corner.position, right), glm::dot(corner.position, up));
  part.add(std::move(face));
}

}  // namespace

Part open_surface(const Rows& rows, const Wrap& wrap) {
  return joined(laid_out(rows, wrap));
}

Part solid(const Rows& rows, const Wrap& wrap) {
  Rows closed = rows;
  for (auto& row : closed) row.push_back(row.front());
  Part part = joined(laid_out(closed, wrap));
  close(part, rows.front(), true);
  close(part, rows.back(), false);
  return part;
}

Part tube(const std::vector<dvec3>& path, dvec3 hint, int sides, const std::function<dvec2(double)>& radius) {
  Rows rows;
  const std::vector<Frame> frames = frames_along(path, hint);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const dvec2 r = radius(double(i) / double(frames.size() - 1));
    std::vector<dvec3> row;
    for (int k = 0; k < sides; ++k) {
      const double angle = 2 * pi * k / sides - pi / 2;
      row.push_back(frames[i].at({r.x * std::cos(angle), r.y * std::sin(angle)}));
    }
    rows.push_back(std::move(row));
  }
  return solid(rows, {.middle = sides / 2});
}

Part cone(dvec3 base, dvec3 tip, double radius, int sides) {
  const dvec3 axis = tip - base;
  const dvec3 hint = std::abs(axis.y) > std::abs(axis.x) ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  return tube({base, tip}, hint, sides, [=](double t) { return dvec2(radius * (1 - t)); });
}

Part ellipsoid(const Frame& frame, dvec3 radii, int columns, int rows) {
  const dvec3 forward = glm::cross(frame.side, frame.up);
  Rows points;
  for (int r = 0; r <= rows; ++r) {
    const double angle = pi * r / rows;
    const double scale = r == 0 || r == rows ? 0.0 : std::sin(angle);
    std::vector<dvec3> row;
    for (int c = 0; c < columns; ++c) {
      const double turn = 2 * pi * c / columns - pi / 2;
      row.push_back(frame.at(scale * dvec2(radii.x * std::cos(turn), radii.y * std::sin(turn))) -
                    radii.z * std::cos(angle) * forward);
    }
    points.push_back(std::move(row));
  }
  return solid(points, {.middle = columns / 2, .base_row = rows / 2});
}

namespace {

/// A surface of longitudes u and of v in 0..1, both in equal steps.
template <class Point>
Part surface_of_revolution(int columns, int rows, const Point& point) {
  Part part;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const auto corner = [&](int column, int row) {
        return point(double(column) / columns, double(row) / rows);
      };
      part.add({corner(c, r), corner(c + 1, r), corner(c + 1, r + 1), corner(c, r + 1)});
    }
  return part;
}

/// The direction in the horizontal plane; u = 0 and u = 1 are the same to the last bit.
dvec3 eastwards(double u) {
  return u == 0 || u == 1 ? dvec3(0, 0, -1) : dvec3(-std::sin(2 * pi * u), 0, -std::cos(2 * pi * u));
}

}  // namespace

Part sphere_part(int columns, int rows) {
  return surface_of_revolution(columns, rows, [](double u, double v) {
    const double latitude = pi * (v - 0.5);
    const double out = v == 0 || v == 1 ? 0.0 : std::cos(latitude);
    const dvec3 n = out * eastwards(u) + dvec3(0, std::sin(latitude), 0);
    return Corner{n, {u, v}, n};
  });
}

Part torus_part(double major, double minor, int columns, int rows) {
  return surface_of_revolution(columns, rows, [=](double u, double v) {
    const double turn = v == 1 ? -pi : 2 * pi * v - pi;  // 0 on the outer side
    const dvec3 n = std::cos(turn) * eastwards(u) + dvec3(0, std::sin(turn), 0);
    return Corner{major * eastwards(u) + minor * n, {u, v}, n};
  });
}

Part block(const std::vector<dvec2>& outline, double bottom, double top, double bevel) {
  const std::size_t n = outline.size();
  const auto row = [&](double y, double inset) {
    std::vector<dvec3> points;
    for (std::size_t i = 0; i < n; ++i) {
      const dvec2 to = glm::normalize(outline[(i + 1) % n] - outline[i]);
      const dvec2 from = glm::normalize(outline[i] - outline[(i + n - 1) % n]);
      // Inwards is to the left of the direction of travel; the mitre keeps the bevel equally wide on both
      // edges.
      const dvec2 left = glm::normalize(dvec2(to.y, -to.x) + dvec2(from.y, -from.x));
      const double mitre = inset / std::max(0.3, glm::dot(left, dvec2(to.y, -to.x)));
      const dvec2 p = outline[i] + mitre * left;
      points.emplace_back(p.x, y, p.y);
    }
    return points;
  };
  Rows rows{row(bottom, 0), row(top - bevel, 0)};
  if (bevel > 0) rows.push_back(row(top, bevel));
  // Seen from above x is to the right and z towards the viewer: counter-clockwise about +y.
  return solid(rows, {.middle = 0});
}

Part box(dvec3 low, dvec3 high, double bevel) {
  Part part =
      block({{low.x, high.z}, {high.x, high.z}, {high.x, low.z}, {low.x, low.z}}, low.y, high.y, bevel);
  map_by_face(part);
  return part;
}

std::vector<dvec2> rounded_outline(double x0, double x1, double half_width, double front, double back) {
  std::vector<dvec2> outline;
  const auto end = [&](double x, double length, double way) {
    const int steps = length > 0 ? 10 : 1;
    for (int i = 0; i <= steps; ++i) {
      const double angle = pi * (double(i) / steps - 0.5);
      const double across = length > 0 ? std::sin(angle) : (i == 0 ? -1.0 : 1.0);
      outline.emplace_back(x + way * length * (length > 0 ? std::cos(angle) - 1 : 0.0),
                           -way * half_width * across);
    }
  };
  end(x1, front, 1);
  end(x0, back, -1);
  return outline;
}

void map_by_face(Part& part) {
  for (Face& face : part.faces) {
    const dvec3 n = face_normal(face), a = glm::abs(n);
    for (Corner& corner : face) {
      const dvec3 p = corner.position;
      if (a.y >= a.x && a.y >= a.z)
        corner.texcoord = {p.x, n.y > 0 ? -p.z : p.z};
      else if (a.z >= a.x)
        corner.texcoord = {n.z > 0 ? p.x : -p.x, p.y};
      else
        corner.texcoord = {n.x > 0 ? -p.z : p.z, p.y};
    }
  }
}

dvec3 face_normal(const Face& face) {
  // Newell's sum is right for polygons that are neither convex nor quite flat.
  dvec3 sum(0);
  for (std::size_t i = 0; i < face.size(); ++i)
    sum += glm::cross(face[i].position - face[0].position,
                      face[(i + 1) % face.size()].position - face[0].position);
  const double length = glm::length(sum);
  return length > 0 ? sum / length : dvec3(0);
}

void smooth(Part& part, double crease_degrees) {
  struct Contribution {
    dvec3 normal;
    double angle;
  };
  const auto key = [](dvec3 p) {
    std::string text;
    for (int i = 0; i < 3; ++i) text += std::to_string(std::llround(p[i] * 1e8)) + ' ';
    return text;
  };
  std::unordered_map<std::string, std::vector<Contribution>> around;
  for (const Face& face : part.faces) {
    const dvec3 normal = face_normal(face);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const dvec3 p = face[i].position;
      const dvec3 to = glm::normalize(face[(i + 1) % face.size()].position - p);
      const dvec3 from = glm::normalize(face[(i + face.size() - 1) % face.size()].position - p);
      around[key(p)].push_back({normal, std::acos(glm::clamp(glm::dot(to, from), -1.0, 1.0))});
    }
  }
  const double least = std::cos(glm::radians(crease_degrees));
  for (Face& face : part.faces) {
    const dvec3 normal = face_normal(face);
    for (Corner& corner : face) {
      dvec3 sum(0);
      for (const Contribution& other : around[key(corner.position)])
        if (glm::dot(other.normal, normal) >= least) sum += other.angle * other.normal;
      corner.normal = glm::length(sum) > 0 ? glm::normalize(sum) : normal;
    }
  }
}

}  // namespace texel::assets
