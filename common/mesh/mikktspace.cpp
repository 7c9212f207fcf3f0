// SPDX-License-Identifier: MIT
// The tangents that baking programs make, by the rules of M. S. Mikkelsen, "Simulation of Wrinkled Surfaces
// Revisited" (2008), and of the MikkTSpace reference code that came with it. Two of its rules hang on the
// last bit of float arithmetic: whether two tangents are exactly opposite, and where a sum goes that nearly
// cancels. So all is computed in float here, in the reference's order of operations.
#include "mikktspace.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "mesh/distinct.hpp"
#include "mesh/vectors.hpp"
#include "mesh/weld.hpp"

namespace texel::mesh {
namespace {

// ---- The reference's arithmetic: a number counts as zero below the smallest normal float.

bool not_zero(float x) {
  return std::abs(x) > std::numeric_limits<float>::min();
}
bool not_zero(const glm::vec3& v) {
  return not_zero(v.x) || not_zero(v.y) || not_zero(v.z);
}
glm::vec3 unit(const glm::vec3& v) {
  return not_zero(v) ? v * (1.0F / glm::length(v)) : v;
}
/// Zero where the reference's result has no direction: it is (0, 0, 0), or far from unit length.
glm::vec3 direction(const glm::vec3& sum) {
  const glm::vec3 result = unit(sum);
  return std::abs(glm::dot(result, result) - 1.0F) < 1e-3F ? result : glm::vec3(0.0F);
}
glm::vec3 into_plane(const glm::vec3& v, const glm::vec3& normal) {
  return v - normal * glm::dot(normal, v);
}

// ---- Corners are numbered 3 * triangle + (0, 1, 2).

std::size_t next_corner(std::size_t corner) {
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}
std::size_t previous_corner(std::size_t corner) {
  return corner % 3 == 0 ? corner + 2 : corner - 1;
}

enum class Kind : std::uint8_t {
  collapsed,  ///< two corners at one place: takes no part
  loose,      ///< no texture area, or T or B without length: joins any group and adds nothing to it
  straight,   ///< keeps the texture's turn
  mirrored,   ///< turns it round
};

bool has_directions(Kind kind) {
  return kind == Kind::straight || kind == Kind::mirrored;
}

struct Triangles {
  std::vector<TriangleFrame> directions;  // unit T and B
  std::vector<Kind> kinds;
};

/// Whether step 5.2's T equals the reference's up to rounding: within half a degree.
bool same_way(const glm::dvec3& solved, const glm::dvec3& reference) {
  const double along = glm::dot(solved, reference);
  return along > 0.0 && along * along > 0.9999 * glm::dot(solved, solved) * glm::dot(reference, reference);
}

/// Twice the signed area in texture space, as the reference has it.
float float_area(const std::array<glm::vec2, 3>& st) {
  const glm::vec2 d1 = st[1] - st[0], d2 = st[2] - st[0];
  return d1.s * d2.t - d1.t * d2.s;
}

/// T and B by triangle_frame; where they agree with the reference's up to rounding, the reference's bits.
Kind find_directions(const std::array<glm::vec3, 3>& p, const std::array<glm::vec2, 3>& st,
                     TriangleFrame& directions) {
  if (p[0] == p[1] || p[0] == p[2] || p[1] == p[2]) return Kind::collapsed;
  const glm::vec3 e1 = p[1] - p[0], e2 = p[2] - p[0];
  const glm::vec2 d1 = st[1] - st[0], d2 = st[2] - st[0];
  const float area = float_area(st);
  if (!not_zero(area)) return Kind::loose;
  const float turn = area > 0.0F ? 1.0F : -1.0F;
  const glm::vec3 tangent = e1 * d2.t - e2 * d1.t, bitangent = e1 * -d2.s + e2 * d1.s;
  const TriangleFrame solved = triangle_frame({p[1], p[0], p[2]}, {st[1], st[0], st[2]});
  if (same_way(solved.tangent, turn * tangent)) {
    const float length_s = glm::length(tangent), length_t = glm::length(bitangent);
    if (not_zero(length_s)) directions.tangent = tangent * (turn / length_s);
    if (not_zero(length_t)) directions.bitangent = bitangent * (turn / length_t);
    if (!not_zero(length_s / std::abs(area)) || !not_zero(length_t / std::abs(area))) return Kind::loose;
  } else {
    directions = {unit_or_zero(solved.tangent), unit_or_zero(solved.bitangent)};
    if (is_zero(directions.tangent) || is_zero(directions.bitangent)) return Kind::loose;
  }
  return area > 0.0F ? Kind::straight : Kind::mirrored;
}

Triangles find_triangles(const Mesh& mesh, unsigned threads) {
  Triangles triangles{std::vector<TriangleFrame>(mesh.triangle_count()),
                      std::vector<Kind>(mesh.triangle_count())};
  in_runs(threads, mesh.triangle_count(), [&](std::size_t t) {
    triangles.kinds[t] = find_directions(of_triangle(mesh, mesh.positions, t),
                                         of_triangle(mesh, mesh.texcoords, t), triangles.directions[t]);
  });
  return triangles;
}

/// Which part does the things with this hash, by its lower half: DistinctTable takes the upper one.
unsigned part_of(std::uint64_t hash, unsigned parts) {
  return static_cast<unsigned>((hash & 0xFFFFFFFFU) * parts >> 32);
}

/// For each corner the first vertex of its mesh that has the same position, normal and texcoord.
std::vector<std::uint32_t> weld_corners(const Mesh& mesh, unsigned threads) {
  const auto same = [&mesh](std::uint32_t a, std::uint32_t b) {
    return mesh.positions[a] == mesh.positions[b] && mesh.normals[a] == mesh.normals[b] &&
           mesh.texcoords[a] == mesh.texcoords[b];
  };
  const auto hash_of = [&mesh](std::size_t v) {
    std::uint64_t hash = 0;
    const auto add = [&hash](float x, float y) {
      hash = mix(hash ^ (std::uint64_t{value_bits(x)} << 32 | value_bits(y)));
    };
    for (int k = 0; k < 3; ++k) add(mesh.positions[v][k], mesh.normals[v][k]);
    add(mesh.texcoords[v].s, mesh.texcoords[v].t);
    return hash;
  };
  std::vector<std::uint64_t> hashes(mesh.vertex_count());
  in_runs(threads, hashes.size(), [&](std::size_t v) { hashes[v] = hash_of(v); });
  // Equal vertices have equal hashes: each part welds those whose hash is its own.
  std::vector<std::uint32_t> of_vertex(mesh.vertex_count());
  in_parallel(threads, threads, [&](std::size_t part) {
    DistinctTable table(mesh.vertex_count() / threads);
    std::vector<std::uint32_t> first;  // the first vertex of each number
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
      if (part_of(hashes[v], threads) != part) continue;
      const std::uint32_t n = table.number(hashes[v], [&](std::uint32_t k) { return same(first[k], v); });
      if (n == first.size()) first.push_back(v);
      of_vertex[v] = first[n];
    }
  });
  std::vector<std::uint32_t> of_corner(mesh.indices.size());
  in_runs(threads, of_corner.size(), [&](std::size_t c) { of_corner[c] = of_vertex[mesh.indices[c]]; });
  return of_corner;
}

/// For the edge that starts at each corner, the corner at which the same edge starts in the triangle on its
/// other side, or none. Only edges that run in opposite directions match. Where more than two triangles share
/// an edge, they are taken in the mesh's order, and each is paired with the first before it that still has no
/// partner.
///
/// The reference finds the same pairs by sorting, but at the last vertex, where it may miss a pair.
std::vector<std::uint32_t> opposite_edges(const std::vector<std::uint32_t>& welded,
                                          const std::vector<Kind>& kinds, unsigned threads) {
  struct Edge {
    std::uint32_t from, to;     // its vertices, in the direction of the corners that wait
    std::uint32_t first, last;  // corners without a partner, or no_index
  };
  std::vector<std::uint32_t> opposite(welded.size(), no_index);  // of one that waits: the next that does
  in_parallel(threads, threads, [&](std::size_t part) {
    std::vector<Edge> edges;
    DistinctTable table(welded.size() / 2 / threads);
    bool several_wait = false;
    const auto add = [&](std::uint32_t c, std::uint32_t from, std::uint32_t to) {
      const auto [low, high] = std::minmax(from, to);
      const std::uint64_t hash = mix(std::uint64_t{low} << 32 | high);
      if (part_of(hash, threads) != part) return;
      const std::uint32_t n = table.number(hash, [&](std::uint32_t k) {
        return (edges[k].from == from && edges[k].to == to) || (edges[k].from == to && edges[k].to == from);
      });
      if (n == edges.size()) edges.push_back({from, to, no_index, no_index});
      Edge& edge = edges[n];
      if (edge.first == no_index) {
        edge = {from, to, c, c};
      } else if (edge.from == from) {
        opposite[edge.last] = c;
        edge.last = c;
        several_wait = true;
      } else {
        const std::uint32_t partner = edge.first;
        edge.first = opposite[partner];
        opposite[c] = partner;
        opposite[partner] = c;
      }
    };
    for (std::uint32_t c = 0; c < welded.size(); c += 3) {
      if (kinds[c / 3] == Kind::collapsed) continue;
      add(c, welded[c], welded[c + 1]);
      add(c + 1, welded[c + 1], welded[c + 2]);
      add(c + 2, welded[c + 2], welded[c]);
    }
    if (!several_wait) return;
    for (const Edge& edge : edges)
      for (std::uint32_t alone = edge.first; alone != no_index;)
        alone = std::exchange(opposite[alone], no_index);
  });
  return opposite;
}

/// The group of each corner, or no_index, and the kind of each group.
struct Groups {
  std::vector<std::uint32_t> of_corner;
  std::vector<Kind> kinds;
};

/// Corners of one welded vertex whose triangles edges join and which turn the texture the same way are a
/// group; triangles are tried in the mesh's order.
Groups group_corners(const std::vector<std::uint32_t>& opposite, const std::vector<Kind>& kinds) {
  Groups groups{std::vector<std::uint32_t>(opposite.size(), no_index), {}};
  std::vector<Kind> taken = kinds;  // a loose triangle takes the kind of the first group that reaches it
  std::vector<std::size_t> stack;
  for (std::size_t start = 0; start < opposite.size(); ++start) {
    const Kind mine = kinds[start / 3];
    if (!has_directions(mine) || groups.of_corner[start] != no_index) continue;
    const auto group = static_cast<std::uint32_t>(groups.kinds.size());
    groups.kinds.push_back(mine);
    stack.push_back(start);
    while (!stack.empty()) {
      const std::size_t corner = stack.back();
      stack.pop_back();
      if (groups.of_corner[corner] != no_index) continue;
      if (taken[corner / 3] == Kind::loose) taken[corner / 3] = mine;
      if (taken[corner / 3] != mine) continue;
      groups.of_corner[corner] = group;
      // Across the edge that leaves this vertex, and across the one that arrives at it. In the neighbour the
      // edge runs the other way, so this vertex is at that edge's end and at its start.
      if (const std::uint32_t left = opposite[corner]; left != no_index) stack.push_back(next_corner(left));
      if (const std::uint32_t right = opposite[previous_corner(corner)]; right != no_index)
        stack.push_back(right);
    }
  }
  return groups;
}

/// A triangle's T at one of its corners, at unit length in the plane of the corner's normal, and the corner's
/// angle in that plane, by which it counts. Both zero where one is not finite.
struct Spoke {
  glm::vec3 tangent{0.0F};
  float angle = 0.0F;
};

Spoke spoke_at(const Mesh& mesh, std::size_t corner, const glm::vec3& triangle_tangent) {
  const std::uint32_t vertex = mesh.indices[corner];
  const glm::vec3 &normal = mesh.normals[vertex], &here = mesh.positions[vertex];
  const auto towards = [&](std::size_t other) {
    return unit(into_plane(mesh.positions[mesh.indices[other]] - here, normal));
  };
  const float cosine =
      std::clamp(glm::dot(towards(previous_corner(corner)), towards(next_corner(corner))), -1.0F, 1.0F);
  const Spoke spoke{unit(into_plane(triangle_tangent, normal)),
                    static_cast<float>(std::acos(double{cosine}))};
  return std::isfinite(glm::dot(spoke.tangent, spoke.tangent) * spoke.angle) ? spoke : Spoke{};
}

/// What a group adds up to, and whether some of its T or B may be opposite: never where all are less than a
/// right angle from the first, by more than rounding.
struct Sum {
  glm::vec3 tangent{0.0F};
  glm::vec3 first_tangent{0.0F}, first_bitangent{0.0F};
  std::uint32_t count = 0;
  bool may_oppose = false;

  void add(const Spoke& spoke, const glm::vec3& bitangent, const glm::vec3& normal) {
    if (count++ == 0) {
      first_tangent = spoke.tangent;
      first_bitangent = into_plane(bitangent, normal);
    }
    may_oppose = may_oppose || !(glm::dot(first_tangent, spoke.tangent) > 1e-3F &&
                                 glm::dot(first_bitangent, bitangent) > 1e-3F);
    tangent += spoke.tangent * spoke.angle;
  }
};

/// The sum of each group, in the order of the corners whatever the number of threads.
std::vector<Sum> sum_by_group(const Mesh& mesh, const Groups& groups, const Triangles& triangles,
                              unsigned threads) {
  std::vector<Sum> sums(groups.kinds.size());
  in_parallel(threads, threads, [&](std::size_t part) {
    const std::size_t begin = sums.size() * part / threads, end = sums.size() * (part + 1) / threads;
    for (std::size_t t = 0; t < triangles.kinds.size(); ++t) {
      if (!has_directions(triangles.kinds[t])) continue;
      const auto& [tangent, bitangent] = triangles.directions[t];
      for (std::size_t c = 3 * t; c < 3 * t + 3; ++c)
        if (const std::uint32_t group = groups.of_corner[c]; group >= begin && group < end)
          sums[group].add(spoke_at(mesh, c, tangent), bitangent, mesh.normals[mesh.indices[c]]);
    }
  });
  return sums;
}

/// Tangents with their signs, and which of them each corner has.
struct Frames {
  std::vector<glm::vec4> tangents;
  std::vector<std::uint32_t> of_corner;
};

/// One corner of a group.
struct Member {
  std::uint32_t corner;
  glm::vec3 tangent, bitangent;  // unit, in the normal's plane
  glm::vec3 weighted;            // its part of the sum
};

/// The reference's angular threshold of 180 degrees: a triangle counts those of its group but the ones whose
/// T or B is exactly opposite to its own (in float). Corners that count all keep the group's tangent; each
/// other sum is another tangent.
void divide(const std::vector<Member>& members, std::uint32_t group, Frames& frames) {
  const glm::vec4 whole = frames.tangents[group];
  std::map<std::array<float, 3>, std::uint32_t> known{{{whole.x, whole.y, whole.z}, group}};
  for (const Member& member : members) {
    glm::vec3 sum(0.0F);
    bool counts_all = true;
    for (const Member& other : members) {
      if (glm::dot(member.tangent, other.tangent) > -1.0F &&
          glm::dot(member.bitangent, other.bitangent) > -1.0F)
        sum += other.weighted;
      else
        counts_all = false;
    }
    if (counts_all) continue;
    const glm::vec3 tangent = direction(sum);
    const auto [place, is_new] = known.try_emplace({tangent.x, tangent.y, tangent.z},
                                                   static_cast<std::uint32_t>(frames.tangents.size()));
    if (is_new) frames.tangents.emplace_back(tangent, whole.w);
    frames.of_corner[member.corner] = place->second;
  }
}

/// With more triangles than this around a vertex a group is not divided: it would take their number squared.
constexpr std::uint32_t most_divided = 4096;

/// The groups' tangents; more where T or B of a group's triangles are opposite.
Frames find_frames(const Mesh& mesh, Groups groups, const Triangles& triangles, unsigned threads) {
  const std::vector<Sum> sums = sum_by_group(mesh, groups, triangles, threads);
  Frames frames;
  frames.tangents.reserve(sums.size() + 1);
  for (std::size_t g = 0; g < sums.size(); ++g)
    frames.tangents.emplace_back(direction(sums[g].tangent),
                                 groups.kinds[g] == Kind::mirrored ? -1.0F : 1.0F);
  frames.of_corner = std::move(groups.of_corner);

  std::vector<std::pair<std::uint32_t, std::uint32_t>> divided;  // groups and their corners
  for (std::uint32_t c = 0; c < frames.of_corner.size(); ++c) {
    const std::uint32_t group = frames.of_corner[c];
    if (group != no_index && has_directions(triangles.kinds[c / 3]) && sums[group].may_oppose &&
        sums[group].count <= most_divided)
      divided.emplace_back(group, c);
  }
  std::sort(divided.begin(), divided.end());
  std::vector<Member> members;
  for (std::size_t i = 0; i < divided.size(); ++i) {
    const auto [group, corner] = divided[i];
    const glm::vec3& normal = mesh.normals[mesh.indices[corner]];
    const auto& [tangent, bitangent] = triangles.directions[corner / 3];
    const Spoke spoke = spoke_at(mesh, corner, tangent);
    members.push_back(
        {corner, spoke.tangent, unit(into_plane(bitangent, normal)), spoke.tangent * spoke.angle});
    if (i + 1 < divided.size() && divided[i + 1].first == group) continue;
    divide(members, group, frames);
    members.clear();
  }
  return frames;
}

/// The corners of collapsed triangles take what the first other corner of the same welded vertex has.
void give_to_collapsed(const std::vector<std::uint32_t>& welded, const std::vector<Kind>& kinds,
                       Frames& frames) {
  if (std::count(kinds.begin(), kinds.end(), Kind::collapsed) == 0) return;
  std::vector<std::uint32_t> at(welded.size(), no_index);  // by welded vertex
  for (std::size_t c = 0; c < welded.size(); ++c)
    if (kinds[c / 3] != Kind::collapsed && at[welded[c]] == no_index) at[welded[c]] = frames.of_corner[c];
  for (std::size_t c = 0; c < welded.size(); ++c)
    if (kinds[c / 3] == Kind::collapsed && at[welded[c]] != no_index) frames.of_corner[c] = at[welded[c]];
}

}  // namespace

void mikktspace(Mesh& mesh, unsigned threads) {
  const Triangles triangles = find_triangles(mesh, threads);
  const std::vector<std::uint32_t> welded = weld_corners(mesh, threads);
  Frames frames =
      find_frames(mesh, group_corners(opposite_edges(welded, triangles.kinds, threads), triangles.kinds),
                  triangles, threads);

  // What no group reached is (1, 0, 0) with the sign -1, whatever the normal.
  const auto nothing = static_cast<std::uint32_t>(frames.tangents.size());
  frames.tangents.emplace_back(1.0F, 0.0F, 0.0F, -1.0F);
  std::replace(frames.of_corner.begin(), frames.of_corner.end(), no_index, nothing);
  give_to_collapsed(welded, triangles.kinds, frames);

  const std::vector<std::uint32_t> of_vertex = split_by_label(mesh, frames.of_corner);
  mesh.tangents.resize(mesh.vertex_count());
  in_runs(threads, mesh.vertex_count(), [&](std::size_t v) {
    const glm::vec4& tangent = frames.tangents[of_vertex[v] == no_index ? nothing : of_vertex[v]];
    const bool has_none = is_along(glm::vec3(tangent), mesh.normals[v]);
    mesh.tangents[v] = has_none ? glm::vec4(any_orthogonal(mesh.normals[v]), tangent.w) : tangent;
  });
  // Without a texture area any direction in the plane is right. With one, that triangle_frame gave none is
  // seen.
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::uint32_t v = mesh.indices[i];
    if (of_vertex[v] == nothing && triangles.kinds[i / 3] == Kind::loose && mesh.tangents[v].x == 1.0F &&
        !not_zero(float_area(of_triangle(mesh, mesh.texcoords, i / 3))))
      mesh.tangents[v] = {unit_or_zero(orthogonal_part({1.0, 0.0, 0.0}, mesh.normals[v])),
                          mesh.tangents[v].w};
  }
}

}  // namespace texel::mesh
