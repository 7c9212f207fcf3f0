// SPDX-License-Identifier: MIT
// An ocean liner of 1912: the bow points to +x, starboard to +z. Lengths are in units of half the ship's
// length; height and beam are about 1.4 times too large, so that the ship fills a square picture.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "models_list.hpp"
#include "models_shapes.hpp"

namespace texel::assets {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double texture_size = 0.22;  // length that one copy of the texture covers
constexpr double keel_y = -0.27, waterline_y = -0.15, deck_y = -0.01;  // amidships
constexpr double raise = 0.047;                                        // from the main deck to the deck above
constexpr double half_beam = 0.135;
constexpr double upper_deck = deck_y + raise;    // top of the hull amidships
constexpr double boat_deck = upper_deck + 0.05;  // where the funnels and the boats stand
constexpr double crisp = 40;                     // degrees; sharper edges are not smoothed

double mix(double a, double b, double t) {
  return a + (b - a) * t;
}
double smoothstep(double a, double b, double x) {
  const double t = std::clamp((x - a) / (b - a), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// Height of the main deck's edge: it rises towards the bow and less towards the stern.
double sheer(double x) {
  return deck_y + (x > 0 ? 0.055 : 0.03) * x * x;
}

/// A point of the starboard side. `t` runs from the stern (0) to the bow (1), `level` from the keel (0) by
/// the waterline (0.5) and the main deck (1) to the deck above it (2).
dvec3 hull_point(double t, double level) {
  const double l = std::min(level, 1.0);
  const double counter = std::clamp((l - 0.42) / 0.58, 0.0, 1.0);  // hangs over the rudder
  const double stern = -0.80 - 0.145 * (1 - std::pow(1 - counter, 2.4));
  const double forefoot = std::max(0.0, 1 - l / 0.3);
  const double bow = 0.865 + 0.075 * l - 0.05 * forefoot * forefoot;
  const double x =
      mix(stern, bow, t) + 0.013 * (level - l) * std::pow(t, 8.0);  // the stem goes on above the deck

  const double run = mix(0.42, 0.17, smoothstep(0.4, 0.9, l)), entrance = mix(0.45, 0.34, l);
  const double from_stern = std::min(1.0, t / run), from_bow = std::min(1.0, (1 - t) / entrance);
  // The exponent makes the end hollow and sharp (above 1) or round (1/2 is an ellipse).
  const double aft = std::pow(1 - std::pow(1 - from_stern, 2.0), mix(1.5, 0.5, smoothstep(0.35, 0.9, l)));
  const double fore = std::pow(1 - std::pow(1 - from_bow, 2.2), mix(1.35, 0.95, l));
  const double bilge = l < 0.35 ? std::pow(1 - std::pow(1 - l / 0.35, 3.0), 1 / 3.0) : 1.0;

  const double top = sheer(x);
  const double y = l < 0.5 ? mix(keel_y, waterline_y, 2 * l) : mix(waterline_y, top, 2 * l - 1);
  return {x, y + raise * (level - l), half_beam * bilge * aft * fore};
}

std::vector<double> stations(double t0, double t1) {
  constexpr int count = 60;
  std::vector<double> t{t0};
  for (int i = 0; i <= count; ++i) {
    // Closer towards both ends, where the hull is rounder.
    const double all = 0.5 - 0.5 * std::cos(pi * i / count);
    if (all > t0 + 1e-6 && all < t1 - 1e-6) t.push_back(all);
  }
  t.push_back(t1);
  return t;
}

dvec3 port(dvec3 p) {
  return {p.x, p.y, -p.z};
}

/// A closed slice of the hull between two stations and the given levels, with a flat deck and flat ends.
Part hull_block(double t0, double t1, const std::vector<double>& levels) {
  const std::vector<double> along = stations(t0, t1);
  Rows starboard, larboard;
  for (const double level : levels) {
    std::vector<dvec3> row, mirrored;
    for (const double t : along) {
      row.push_back(hull_point(t, level));
      mirrored.push_back(port(row.back()));
    }
    std::reverse(mirrored.begin(), mirrored.end());
    starboard.push_back(std::move(row));
    larboard.push_back(std::move(mirrored));
  }
  const Wrap planks{int(along.size()) / 2, int(levels.size()) - 1, true};
  Part sides = open_surface(starboard, planks);
  sides += open_surface(larboard, planks);

  Part flat;
  const auto strip = [&](const std::vector<dvec3>& edge) {
    for (std::size_t i = 0; i + 1 < edge.size(); ++i)
      flat.add({{edge[i]}, {edge[i + 1]}, {port(edge[i + 1])}, {port(edge[i])}});
  };
  const auto column = [&](std::size_t at) {
    std::vector<dvec3> edge;
    for (const auto& row : starboard) edge.push_back(row[at]);
    return edge;
  };
  strip(starboard.back());
  std::vector<dvec3> bottom = starboard.front(), fore = column(along.size() - 1);
  std::reverse(bottom.begin(), bottom.end());
  std::reverse(fore.begin(), fore.end());
  strip(bottom);
  strip(fore);
  strip(column(0));
  map_by_face(flat);
  sides += flat;
  smooth(sides, crisp);
  return sides;
}

/// The station at which a level of the hull reaches `x`.
double station_at(double x, double level = 1) {
  double low = 0, high = 1;
  for (int i = 0; i < 50; ++i)
    (hull_point(0.5 * (low + high), level).x < x ? low : high) = 0.5 * (low + high);
  return 0.5 * (low + high);
}

/// The low wall around a raised deck, from starboard round the end of the ship to port; `t_open` is where it
/// starts and ends, `t_end` (0 or 1) the end of the ship that it goes round.
Part bulwark(double t_open, double t_end) {
  constexpr double thickness = 0.006, height = 0.4;  // height in levels
  std::vector<double> along = stations(std::min(t_open, t_end), std::max(t_open, t_end));
  // The inner side starts where the ship is as wide as the wall is thick, so that the wall keeps its
  // thickness.
  double inner_end = t_end;
  while (hull_point(inner_end, 2).z < 2 * thickness) inner_end += t_end > 0.5 ? -1e-3 : 1e-3;
  std::vector<std::vector<dvec3>> sections;
  for (const double t : along) {
    const double s = (t - t_open) / (t_end - t_open);
    const dvec3 low = hull_point(t, 2), high = hull_point(t, 2 + height);
    dvec3 inner = hull_point(mix(t_open, inner_end, s), 2);
    inner.z = t == t_end ? 0 : std::max(0.0, inner.z - thickness);
    sections.push_back({low, high, {inner.x, high.y, inner.z}, {inner.x, low.y, inner.z}});
  }
  if (t_end < 0.5) std::reverse(sections.begin(), sections.end());  // now from the open end to the ship's end
  Rows rows = sections;
  for (std::size_t i = sections.size() - 1; i-- > 0;) {
    std::vector<dvec3> row;
    for (const dvec3& p : sections[i]) row.push_back(port(p));
    rows.push_back(std::move(row));
  }
  if (t_end > 0.5)
    for (auto& row : rows) std::reverse(row.begin(), row.end());
  Part part = solid(rows, {.middle = 1});
  map_by_face(part);
  smooth(part, crisp);
  return part;
}

/// The parts of the ship, sorted by material.
struct Ship {
  Part keel, hull, decks, houses, funnels, black, fittings, boats;
};

void add(Part& group, Part part, double crease = crisp) {
  smooth(part, crease);
  group += part;
}

void add_deckhouse(Ship& ship, double x0, double x1, double half_width, double bottom, double top,
                   double front, double back) {
  add(ship.houses, block(rounded_outline(x0, x1, half_width, front, back), bottom, top, 0.003));
}

/// A thin deck that stands over the house below it.
void add_deck(Ship& ship, double x0, double x1, double half_width, double y, double front, double back) {
  Part part = block(rounded_outline(x0, x1, half_width, front, back), y - 0.008, y, 0.002);
  map_by_face(part);
  add(ship.decks, part);
}

void add_pillars(Ship& ship, double x0, double x1, double z, double bottom, double top, int count) {
  for (int i = 0; i < count; ++i) {
    const double x = mix(x0, x1, double(i) / (count - 1));
    for (const double side : {-z, z})
      add(ship.houses, box({x - 0.003, bottom, side - 0.003}, {x + 0.003, top, side + 0.003}, 0));
  }
}

void add_hull(Ship& ship) {
  std::vector<double> levels;
  constexpr int bilge_rows = 8;
  for (int i = 0; i <= bilge_rows; ++i) {  // equal angles of the bilge's superellipse, then the side
    const double angle = 0.5 * pi * i / bilge_rows;
    levels.push_back(i == bilge_rows ? 0.35 : 0.35 * (1 - std::pow(std::cos(angle), 2 / 3.0)));
  }
  for (const double level : {0.385, 0.42, 0.455, 0.5, 0.56, 0.64, 0.75, 0.87, 1.0}) levels.push_back(level);
  const Part whole = hull_block(0, 1, levels);
  for (const Face& face : whole.faces) {
    double y = -1;
    for (const Corner& corner : face) y = std::max(y, corner.position.y);
    const bool deck = face_normal(face).y > 0.9;
    (deck ? ship.decks : y < waterline_y + 1e-6 ? ship.keel : ship.hull).faces.push_back(face);
  }
  const double t_fore = station_at(0.60), t_aft = station_at(-0.66);
  const auto raised = [&](double t0, double t1) {
    const Part part = hull_block(t0, t1, {1.0, 1.5, 2.0});
    for (const Face& face : part.faces)
      (face_normal(face).y > 0.9 ? ship.decks : ship.houses).faces.push_back(face);
  };
  raised(t_fore, 1);
  raised(0, t_aft);
  raised(station_at(-0.52), station_at(0.47));
  ship.houses += bulwark(t_fore, 1);
  ship.houses += bulwark(t_aft, 0);

  add(ship.keel, box({-0.845, keel_y + 0.012, -0.006}, {-0.79, waterline_y - 0.02, 0.006}, 0.003));  // rudder
}

void add_superstructure(Ship& ship) {
  const double width = half_beam;
  // The promenade: a house, pillars along its sides and the boat deck on top.
  add_deckhouse(ship, -0.49, 0.425, width - 0.03, upper_deck - 0.02, boat_deck - 0.004, 0.03, 0.0);
  add_pillars(ship, -0.485, 0.37, width - 0.010, upper_deck - 0.005, boat_deck - 0.004, 39);
  add_deck(ship, -0.50, 0.44, width - 0.004, boat_deck, 0.035, 0.012);
  // The boat deck: bridge with wings, officers' house, casings under the funnels, smoking room aft.
  const double house = boat_deck + 0.038, bridge = boat_deck + 0.052;
  add_deckhouse(ship, 0.30, 0.395, 0.075, boat_deck - 0.004, bridge - 0.004, 0.025, 0.0);
  add_deck(ship, 0.345, 0.405, width, bridge, 0.012, 0.0);
  add_deck(ship, 0.29, 0.36, 0.082, bridge, 0.0, 0.0);
  for (const double z : {-1.0, 1.0}) {  // wing cabs
    const double side = z * (width - 0.014);
    add(ship.houses,
        box({0.355, boat_deck - 0.004, side - 0.014}, {0.39, bridge - 0.004, side + 0.014}, 0.002));
  }
  add_deckhouse(ship, 0.03, 0.29, 0.062, boat_deck - 0.004, house, 0.0, 0.012);
  add_deckhouse(ship, -0.13, -0.01, 0.055, boat_deck - 0.004, house - 0.006, 0.01, 0.01);
  add_deckhouse(ship, -0.44, -0.17, 0.062, boat_deck - 0.004, house, 0.012, 0.012);
  add_deckhouse(ship, -0.425, -0.34, 0.04, house - 0.004, house + 0.022, 0.01, 0.01);
  // The house on the poop and the hatches on the well decks and the forecastle.
  add_deckhouse(ship, -0.83, -0.71, 0.05, upper_deck, upper_deck + 0.045, 0.01, 0.02);
  const auto hatch = [&](double x, double y, double length, double half_width) {
    add(ship.fittings,
        box({x - length / 2, y - 0.02, -half_width}, {x + length / 2, y + 0.012, half_width}, 0.003));
  };
  hatch(0.535, sheer(0.535) + 0.004, 0.06, 0.045);
  hatch(-0.59, sheer(-0.59) + 0.004, 0.06, 0.045);
  hatch(0.69, sheer(0.69) + raise + 0.004, 0.05, 0.03);
}

/// Four raked funnels of elliptic section, each with a black top and open at the top.
void add_funnels(Ship& ship) {
  constexpr double height = 0.215, rake = 0.115;  // rake: metres aft for each metre up
  for (const double x : {0.255, 0.075, -0.105, -0.285}) {
    const double base = boat_deck + 0.02;
    const auto piece = [&](double from, double to, dvec2 outside, dvec2 inside) {
      // Up the outside and, for the rim, down the inside again.
      Rows rows;
      const auto ring_at = [&](double up, dvec2 r) {
        std::vector<dvec3> row;
        constexpr int sides = 28;
        for (int i = 0; i < sides; ++i) {
          const double angle = 2 * pi * i / sides;
          row.emplace_back(x - rake * up + r.x * std::cos(angle), base + up, -r.y * std::sin(angle));
        }
        rows.push_back(std::move(row));
      };
      constexpr int steps = 3;
      for (int i = 0; i <= steps; ++i) ring_at(mix(from, to, double(i) / steps), outside);
      if (inside.x > 0) {
        ring_at(to, inside);
        ring_at(to - 0.03, inside);
      }
      return solid(rows, {.middle = 21});
    };
    const dvec2 r(0.041, 0.033);
    add(ship.houses, piece(-0.03, 0.018, r * 1.12, {0, 0}));
    add(ship.funnels, piece(0.0, height * 0.78, r, {0, 0}));
    add(ship.black, piece(height * 0.78, height, r * 1.03, r * 0.88));
    // The steam pipe before each funnel.
    add(ship.black,
        tube({{x + 0.047, base - 0.02, 0}, {x + 0.047 - rake * height * 1.02, base + height * 1.02, 0}},
             {1, 0, 0}, 6, [](double) { return dvec2(0.0045); }));
  }
}

/// A double-ended boat on its chocks with two davits over it.
void add_lifeboat(Ship& ship, double x, double z) {
  constexpr double length = 0.07, width = 0.0125, depth = 0.017;
  const double y = boat_deck + 0.026;
  Rows rows;
  constexpr int steps = 6;
  for (int i = 0; i <= steps; ++i) {
    const double s = 2.0 * i / steps - 1, full = std::sqrt(std::max(0.0, 1 - s * s));
    const Section section{width * full, 0.004 * full, depth * (0.4 + 0.6 * full) * full, 2, 2.2};
    const Frame frame{{x + 0.5 * length * s, y + 0.006 * s * s, z}, {0, 0, -1}, {0, 1, 0}};
    std::vector<dvec3> row;
    for (const dvec2 p : ring(section, 8)) row.push_back(frame.at(p));
    rows.push_back(std::move(row));
  }
  add(ship.boats, solid(rows, {.middle = 4}), 60);
  const double inward = z > 0 ? -1 : 1;
  for (const double end : {-0.36, 0.36}) {
    const double dx = x + end * length;
    const std::vector<dvec3> davit{{dx, boat_deck - 0.004, z + inward * 0.017},
                                   {dx, boat_deck + 0.035, z + inward * 0.017},
                                   {dx, boat_deck + 0.046, z + inward * 0.006},
                                   {dx, boat_deck + 0.040, z - inward * 0.004}};
    add(ship.fittings, tube(davit, {1, 0, 0}, 4, [](double) { return dvec2(0.0022); }));
  }
}

void add_masts_and_rigging(Ship& ship) {
  const dvec3 fore_foot(0.60, sheer(0.6), 0), fore_top(0.565, 0.50, 0);
  const dvec3 main_foot(-0.575, sheer(-0.575) - 0.01, 0), main_top(-0.615, 0.47, 0);
  const auto spar = [&](dvec3 a, dvec3 b, double thick, double thin, int sides) {
    add(ship.fittings,
        tube({a, b}, std::abs(b.x - a.x) > std::abs(b.y - a.y) ? dvec3(0, 1, 0) : dvec3(1, 0, 0), sides,
             [=](double t) { return dvec2(mix(thick, thin, t)); }),
        60);
  };
  spar(fore_foot, fore_top, 0.0085, 0.003, 10);
  spar(main_foot, main_top, 0.0085, 0.003, 10);
  const dvec3 nest = glm::mix(fore_foot, fore_top, 0.45) + dvec3(0.012, 0, 0);  // the crow's nest
  add(ship.fittings, tube({nest, nest + dvec3(0, 0.022, 0)}, {1, 0, 0}, 10,
                          [](double t) { return dvec2(0.011 + 0.003 * t); }));
  constexpr double wire = 0.0014;
  const auto rope = [&](dvec3 a, dvec3 b) { spar(a, b, wire, wire, 3); };
  rope(fore_top, hull_point(0.985, 2.4) * dvec3(1, 1, 0));
  rope(main_top, hull_point(0.01, 2.3) * dvec3(1, 1, 0));
  for (const double z : {-0.012, 0.012})
    rope(fore_top + dvec3(0, -0.006, z), main_top + dvec3(0, -0.006, z));  // the aerial
  for (const double side : {-1.0, 1.0})
    for (const double back : {0.03, 0.065}) {
      rope(glm::mix(fore_foot, fore_top, 0.8), {fore_foot.x - back, sheer(0.6) + 0.002, side * 0.105});
      rope(glm::mix(main_foot, main_top, 0.8), {main_foot.x - back, sheer(-0.6) + 0.002, side * 0.115});
    }
  // Cargo booms and a short flagstaff at the stern.
  for (const double side : {-0.02, 0.02}) {
    spar({0.60, 0.09, side}, {0.48, 0.16, side * 3}, 0.004, 0.002, 6);
    spar({-0.582, 0.06, side}, {-0.665, 0.16, side * 3}, 0.004, 0.002, 6);
  }
  spar({-0.925, upper_deck + 0.02, 0}, {-0.965, upper_deck + 0.13, 0}, 0.003, 0.0015, 6);
}

/// Ventilators: a pipe whose upper end turns forward and opens to a cowl.
void add_ventilators(Ship& ship) {
  for (const double x : {0.165, -0.015, -0.195, -0.365})
    for (const double z : {-0.074, 0.074}) {
      const double y = boat_deck - 0.004;
      const auto path = curve_through(
          {{x, y, z}, {x, y + 0.045, z}, {x + 0.006, y + 0.057, z}, {x + 0.020, y + 0.060, z}}, 2);
      add(ship.fittings,
          tube(path, {0, 0, 1}, 7,
               [](double t) { return dvec2(t < 0.6 ? 0.0065 : mix(0.0065, 0.014, (t - 0.6) / 0.4)); }),
          50);
    }
}

Part mirrored_to_port(Part part) {
  for (Face& face : part.faces) {
    for (Corner& corner : face) {
      corner.position = port(corner.position);
      corner.texcoord.x *= -1;
    }
    std::reverse(face.begin(), face.end());
  }
  return part;
}

void add_both_sides(Part& group, const Part& starboard, double crease) {
  add(group, starboard, crease);
  add(group, mirrored_to_port(starboard), crease);
}

/// A frame on the starboard plating: origin on it, `side` x `up` outwards, `up` upwards.
Frame plating(double x, double level) {
  const double t = station_at(x, level);
  const dvec3 p = hull_point(t, level);
  const dvec3 out =
      glm::normalize(glm::cross(hull_point(t + 1e-3, level) - p, hull_point(t, level + 1e-3) - p));
  const dvec3 ahead = glm::normalize(glm::cross(dvec3(0, 1, 0), out));
  return {p, ahead, glm::cross(out, ahead)};
}

/// Rows of portholes along the side: low six-sided studs that stand a little out of the plating.
void add_portholes(Ship& ship) {
  const auto row = [&](double level, double x0, double x1, int count) {
    for (int i = 0; i < count; ++i) {
      const Frame at = plating(mix(x0, x1, double(i) / (count - 1)), level);
      const dvec3 out = glm::cross(at.side, at.up);
      add_both_sides(ship.fittings, cone(at.origin - 0.002 * out, at.origin + 0.003 * out, 0.0065, 6), 70);
    }
  };
  row(0.86, -0.84, 0.86, 52);
  row(0.70, -0.72, 0.84, 48);
  row(1.5, -0.505, 0.455, 36);
  row(1.5, 0.64, 0.88, 8);
  row(1.5, -0.90, -0.68, 8);
}

void add_anchors_and_screws(Ship& ship) {
  const Frame bow = plating(0.885, 0.92);
  const auto anchor_piece = [&](dvec2 at, dvec3 radii) {
    add_both_sides(ship.fittings, ellipsoid({bow.at(at), bow.side, bow.up}, radii, 8, 6), 180);
  };
  anchor_piece({0, 0}, {0.0045, 0.022, 0.006});
  anchor_piece({0, -0.019}, {0.016, 0.005, 0.007});
  // Two three-bladed screws on their shafts.
  const dvec3 hub(-0.745, -0.215, 0.042);
  add_both_sides(ship.keel,
                 tube({hub + dvec3(0.10, 0, -0.01), hub, hub - dvec3(0.014, 0, 0)}, {0, 1, 0}, 8,
                      [](double t) { return dvec2(t < 0.9 ? 0.008 : 0.004); }),
                 50);
  for (int blade = 0; blade < 3; ++blade) {
    const double angle = 2 * pi * blade / 3 + pi / 2;
    const dvec3 out(0, std::sin(angle), std::cos(angle)), around(0, -std::cos(angle), std::sin(angle));
    const dvec3 pitched = glm::normalize(around + dvec3(0.7, 0, 0));
    add_both_sides(ship.fittings, ellipsoid({hub + 0.021 * out, pitched, out}, {0.010, 0.021, 0.002}, 10, 8),
                   180);
  }
}

}  // namespace

std::string ship_materials() {
  return material_text("The liner's materials. Colours are sRGB. CC0 1.0.",
                       {{"keel", "0.55 0.17 0.13", "wood.png"},
                        {"hull", "0.16 0.17 0.20", "wood.png"},
                        {"decks", "0.80 0.66 0.45", "wood.png"},
                        {"houses", "0.93 0.92 0.88", "wood.png"},
                        {"funnels", "0.85 0.60 0.28", "wood.png"},
                        {"black", "0.12 0.12 0.13", "wood.png"},
                        {"fittings", "0.62 0.50 0.36", "wood.png"},
                        {"boats", "0.96 0.95 0.92", "wood.png"}});
}

std::string ship() {
  Ship parts;
  add_hull(parts);
  add_superstructure(parts);
  add_funnels(parts);
  for (const double x : {0.235, 0.155, 0.075, -0.005, -0.215, -0.295, -0.375, -0.455})
    for (const double z : {-1.0, 1.0}) add_lifeboat(parts, x, z * (half_beam - 0.017));
  add_masts_and_rigging(parts);
  add_ventilators(parts);
  add_portholes(parts);
  add_anchors_and_screws(parts);
  return model_text(
      "ship.obj: an ocean liner of 1912 with four funnels. The bow points to +x, starboard to +z.\n"
      "Texture coordinates keep one scale everywhere and are never mirrored; u runs along the planks.\n"
      "Made by make_assets (assets/make/models_ship.cpp). CC0 1.0.",
      "ship.mtl",
      {{"keel", parts.keel},
       {"hull", parts.hull},
       {"decks", parts.decks},
       {"houses", parts.houses},
       {"funnels", parts.funnels},
       {"black", parts.black},
       {"fittings", parts.fittings},
       {"boats", parts.boats}},
      texture_size);
}

}  // namespace texel::assets
