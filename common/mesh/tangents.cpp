// SPDX-License-Identifier: MIT
#include "mesh/tangents.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/error.hpp"
#include "mesh/distinct.hpp"
#include "mesh/vectors.hpp"
#include "mesh/weld.hpp"
#include "share.hpp"

namespace texel::mesh {

TriangleFrame triangle_frame([[maybe_unused]] const std::array<glm::vec3, 3>& positions,
                             [[maybe_unused]] const std::array<glm::vec2, 3>& texcoords) {
  //@step 5.2 begin
  const glm::vec3 e1 = positions[1] - positions[0];
  const glm::vec3 e2 = positions[2] - positions[1];
  const glm::vec2 d1 = texcoords[1] - texcoords[0];  // (Delta U1, Delta V1)
  const glm::vec2 d2 = texcoords[2] - texcoords[1];
  const float determinant = d1.s * d2.t - d2.s * d1.t;
  return {(d2.t * e1 - d1.t * e2) / determinant, (d1.s * e2 - d2.s * e1) / determinant};
  //@starter
  // // Solve E1 = Delta U1 T + Delta V1 B, E2 = Delta U2 T + Delta V2 B for T and B.
  // return {};
  //@end
}

glm::vec4 orthonormalize([[maybe_unused]] const glm::vec3& normal, const glm::vec3& tangent,
                         [[maybe_unused]] const glm::vec3& bitangent) {
  //@step 5.4 begin
  const glm::vec3 in_plane = unit_or_zero(tangent - normal * glm::dot(normal, tangent));
  const float side = glm::dot(glm::cross(normal, in_plane), bitangent) < 0.0f ? -1.0f : 1.0f;
  return {in_plane, side};
  //@starter
  // // Take away the part along the normal, then find on which side the bitangent lies.
  // return {tangent, 1.0f};
  //@end
}

double texture_area(const std::array<glm::vec2, 3>& texcoords) {
  const glm::dvec2 a = glm::dvec2(texcoords[1]) - glm::dvec2(texcoords[0]);
  const glm::dvec2 b = glm::dvec2(texcoords[2]) - glm::dvec2(texcoords[0]);
  const double area = a.x * b.y - a.y * b.x;
  return std::abs(area) > 1e-7 * glm::length(a) * glm::length(b) ? area : 0.0;
}

namespace {

/// Adds a triangle's T and B to each of its three vertices' sums.
void add_to_corners(const std::array<std::uint32_t, 3>& corners, const TriangleFrame& frame,
                    std::vector<TriangleFrame>& sums) {
  //@step 5.3 begin
  for (const std::uint32_t corner : corners) {
    sums[corner].tangent += frame.tangent;
    sums[corner].bitangent += frame.bitangent;
  }
  //@starter
  // // Each triangle overwrites what the ones before it left at its vertices.
  // sums[corners[0]] = sums[corners[1]] = sums[corners[2]] = frame;
  //@end
}

std::array<std::uint32_t, 3> corners_of(const Mesh& mesh, std::size_t triangle) {
  return {mesh.indices[3 * triangle], mesh.indices[3 * triangle + 1], mesh.indices[3 * triangle + 2]};
}

template <class Value>
std::array<Value, 3> gather(const std::vector<Value>& values, const std::array<std::uint32_t, 3>& at) {
  return {values[at[0]], values[at[1]], values[at[2]]};
}

/// T and B of every triangle, zero for degenerate ones, and its turn: the sign of its texture area.
struct Frames {
  std::vector<TriangleFrame> of_triangle;
  std::vector<signed char> turn;  // +1, -1, or 0 for degenerate
};

Frames triangle_frames(const Mesh& mesh, unsigned threads, TangentReport& report) {
  Frames frames{std::vector<TriangleFrame>(mesh.triangle_count()),
                std::vector<signed char>(mesh.triangle_count())};
  in_parallel(threads, threads, [&](std::size_t part) {
    const Share share(mesh.triangle_count(), part, threads);
    for (std::size_t t = share.begin; t < share.end; ++t) {
      const auto corners = corners_of(mesh, t);
      const auto positions = gather(mesh.positions, corners);
      const auto texcoords = gather(mesh.texcoords, corners);
      const double area = texture_area(texcoords);
      TriangleFrame frame;
      if (area != 0.0) frame = triangle_frame(positions, texcoords);
      // A triangle without area in space has T and B of zero length or along the same line.
      const glm::dvec3 across = glm::cross(glm::dvec3(frame.tangent), glm::dvec3(frame.bitangent));
      if (is_zero(unit_or_zero(across))) continue;
      frames.of_triangle[t] = frame;
      frames.turn[t] = area > 0.0 ? 1 : -1;
    }
  });
  report.degenerate_triangles =
      static_cast<std::uint32_t>(std::count(frames.turn.begin(), frames.turn.end(), 0));
  return frames;
}

std::vector<std::uint32_t> split(Mesh& mesh, const std::vector<std::uint32_t>& labels,
                                 TangentReport& report) {
  const std::size_t before = mesh.vertex_count();
  std::vector<std::uint32_t> of_vertex = split_by_label(mesh, labels);
  report.split_vertices += static_cast<std::uint32_t>(mesh.vertex_count() - before);
  return of_vertex;
}

/// Gives triangles that turn the texture the other way than the first at a vertex a copy of that vertex.
void split_mirrored(Mesh& mesh, const std::vector<signed char>& turn, TangentReport& report) {
  std::vector<std::uint32_t> labels(mesh.indices.size());
  for (std::size_t i = 0; i < labels.size(); ++i)
    labels[i] = turn[i / 3] == 0 ? no_index : (turn[i / 3] > 0 ? 1 : 0);
  split(mesh, labels, report);
}

TriangleFrame scaled(const TriangleFrame& frame, double by) {
  return {glm::vec3(by * glm::dvec3(frame.tangent)), glm::vec3(by * glm::dvec3(frame.bitangent))};
}

TriangleFrame unit_frame(const TriangleFrame& frame) {
  return {unit_or_zero(frame.tangent), unit_or_zero(frame.bitangent)};
}

std::vector<TriangleFrame> sum_by_vertex(const Mesh& mesh, const Frames& frames) {
  std::vector<TriangleFrame> sums(mesh.vertex_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
    add_to_corners(corners_of(mesh, t), frames.of_triangle[t], sums);
  return sums;
}

std::vector<TriangleFrame> sum_by_angle(const Mesh& mesh, const Frames& frames) {
  std::vector<TriangleFrame> sums(mesh.vertex_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto corners = corners_of(mesh, t);
    const auto angles = corner_angles(gather(mesh.positions, corners));
    const TriangleFrame unit = unit_frame(frames.of_triangle[t]);
    for (std::size_t k = 0; k < 3; ++k) {
      const TriangleFrame weighted = scaled(unit, angles[k]);
      sums[corners[k]].tangent += weighted.tangent;
      sums[corners[k]].bitangent += weighted.bitangent;
    }
  }
  return sums;
}

/// Unit averages of T and B as they are; the sign in w is there for those who rebuild B from N and T.
void store_averages(Mesh& mesh, const std::vector<TriangleFrame>& sums, TangentReport& report) {
  mesh.bitangents.resize(mesh.vertex_count());
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const glm::vec3& normal = mesh.normals[v];
    TriangleFrame unit = unit_frame(sums[v]);
    if (is_zero(unit.tangent) || is_zero(unit.bitangent)) {
      ++report.fallback_vertices;
      if (is_zero(unit.tangent)) unit.tangent = any_orthogonal(normal);
      if (is_zero(unit.bitangent)) unit.bitangent = unit_or_zero(glm::cross(normal, unit.tangent));
      if (is_zero(unit.bitangent)) unit.bitangent = any_orthogonal(unit.tangent);
    }
    const bool mirrored = glm::determinant(glm::mat3(unit.tangent, unit.bitangent, normal)) < 0.0f;
    mesh.tangents[v] = {unit.tangent, mirrored ? -1.0f : 1.0f};
    mesh.bitangents[v] = unit.bitangent;
  }
}

void store_orthonormal(Mesh& mesh, const std::vector<TriangleFrame>& sums, TangentReport& report) {
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const glm::vec3& normal = mesh.normals[v];
    glm::vec4 tangent = orthonormalize(normal, unit_or_zero(sums[v].tangent), sums[v].bitangent);
    if (is_zero(glm::vec3(tangent))) {
      ++report.fallback_vertices;
      tangent = {any_orthogonal(normal), tangent.w};
    }
    mesh.tangents[v] = tangent;
  }
}

// ---- MikkTSpace: corners are numbered 3 * triangle + (0, 1, 2). ----

/// Which of the parts does the things with this hash, by its lower half: DistinctTable takes the upper one.
unsigned part_of(std::uint64_t hash, unsigned parts) {
  return static_cast<unsigned>((hash & 0xFFFFFFFFu) * parts >> 32);
}

/// For each corner the first vertex of its mesh that has the same position, normal and texcoord.
std::vector<std::uint32_t> weld_corners(const Mesh& mesh, unsigned threads) {
  const auto same = [&mesh](std::uint32_t a, std::uint32_t b) {
    return mesh.positions[a] == mesh.positions[b] && mesh.normals[a] == mesh.normals[b] &&
           mesh.texcoords[a] == mesh.texcoords[b];
  };
  const auto hash_of = [&mesh](std::uint32_t v) {
    std::uint64_t hash = 0;
    const auto add = [&hash](float x, float y) {
      hash = mix(hash ^ (std::uint64_t{value_bits(x)} << 32 | value_bits(y)));
    };
    for (int k = 0; k < 3; ++k) add(mesh.positions[v][k], mesh.normals[v][k]);
    add(mesh.texcoords[v].s, mesh.texcoords[v].t);
    return hash;
  };
  std::vector<std::uint64_t> hashes(mesh.vertex_count());
  in_parallel(threads, threads, [&](std::size_t part) {
    const Share share(mesh.vertex_count(), part, threads);
    for (std::size_t v = share.begin; v < share.end; ++v) hashes[v] = hash_of(static_cast<std::uint32_t>(v));
  });
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
  in_parallel(threads, threads, [&](std::size_t part) {
    const Share share(of_corner.size(), part, threads);
    for (std::size_t c = share.begin; c < share.end; ++c) of_corner[c] = of_vertex[mesh.indices[c]];
  });
  return of_corner;
}

std::size_t next_corner(std::size_t corner) {
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}
std::size_t previous_corner(std::size_t corner) {
  return corner % 3 == 0 ? corner + 2 : corner - 1;
}

/// For the edge that starts at each corner, the corner at which the same edge starts in the triangle on its
/// other side, or none. Edges that more than two triangles share are paired in order of appearance, and only
/// edges that run in opposite directions match.
std::vector<std::uint32_t> opposite_edges(const std::vector<std::uint32_t>& welded, unsigned threads) {
  struct Edge {
    std::uint32_t low, high;  // its vertices
    std::uint32_t waiting;    // the last corner at which it starts and that has no partner, or no_index
    bool upwards;             // whether it starts at `low` there
  };
  std::vector<std::uint32_t> opposite(welded.size(), no_index);
  in_parallel(threads, threads, [&](std::size_t part) {
    std::vector<Edge> edges;
    DistinctTable table(welded.size() / 2 / threads);
    for (std::uint32_t c = 0; c < welded.size(); ++c) {
      const std::uint32_t from = welded[c], to = welded[next_corner(c)];
      const auto [low, high] = std::minmax(from, to);
      const std::uint64_t hash = mix(std::uint64_t{low} << 32 | high);
      if (from == to || part_of(hash, threads) != part) continue;
      const std::uint32_t n =
          table.number(hash, [&](std::uint32_t k) { return edges[k].low == low && edges[k].high == high; });
      if (n == edges.size()) edges.push_back({low, high, no_index, false});
      Edge& edge = edges[n];
      const bool upwards = from == low;
      if (edge.waiting == no_index || edge.upwards == upwards) {
        edge.waiting = c;
        edge.upwards = upwards;
      } else {
        opposite[c] = edge.waiting;
        opposite[edge.waiting] = c;
        edge.waiting = no_index;
      }
    }
  });
  return opposite;
}

/// The group of each corner, or no_index; a group lies around one welded vertex and has one turn.
struct Groups {
  std::vector<std::uint32_t> of_corner;
  std::vector<signed char> turn;
};

Groups group_corners(const std::vector<std::uint32_t>& welded, const std::vector<std::uint32_t>& opposite,
                     std::vector<signed char> turn) {
  Groups groups{std::vector<std::uint32_t>(welded.size(), no_index), {}};
  std::vector<std::size_t> stack;
  for (std::size_t start = 0; start < welded.size(); ++start) {
    if (turn[start / 3] == 0 || groups.of_corner[start] != no_index) continue;
    const auto group = static_cast<std::uint32_t>(groups.turn.size());
    const signed char mine = turn[start / 3];
    groups.turn.push_back(mine);
    stack.push_back(start);
    while (!stack.empty()) {
      const std::size_t corner = stack.back();
      stack.pop_back();
      if (groups.of_corner[corner] != no_index) continue;
      // A triangle without texture area takes the turn of the first group that reaches it.
      if (turn[corner / 3] == 0) turn[corner / 3] = mine;
      if (turn[corner / 3] != mine) continue;
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

/// A triangle's unit T and the weight of its corner, both in the plane of the corner's normal.
glm::dvec3 projected_tangent(const Mesh& mesh, std::size_t corner, const glm::vec3& unit_tangent) {
  const glm::dvec3 normal = mesh.normals[mesh.indices[corner]];
  const auto into_plane = [&normal](const glm::dvec3& v) {
    return glm::cross(glm::cross(normal, v), normal);
  };
  const glm::dvec3 here = mesh.positions[mesh.indices[corner]];
  const glm::dvec3 next = mesh.positions[mesh.indices[next_corner(corner)]];
  const glm::dvec3 previous = mesh.positions[mesh.indices[previous_corner(corner)]];
  const double angle = angle_between(into_plane(next - here), into_plane(previous - here));
  return angle * glm::dvec3(unit_or_zero(into_plane(unit_tangent)));
}

/// The sum of each group's projected tangents, in the order of the corners whatever the number of threads.
std::vector<glm::dvec3> sum_by_group(const Mesh& mesh, const Groups& groups, const Frames& frames,
                                     unsigned threads) {
  std::vector<glm::dvec3> sums(groups.turn.size(), glm::dvec3(0.0));
  in_parallel(threads, threads, [&](std::size_t part) {
    const Share share(sums.size(), part, threads);  // of the groups; no_index is in none
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
      const std::uint32_t* group = &groups.of_corner[3 * t];
      if (std::none_of(group, group + 3, [&](std::uint32_t g) { return share.holds(g); })) continue;
      const glm::vec3 unit = unit_or_zero(frames.of_triangle[t].tangent);
      for (std::size_t k = 0; k < 3; ++k)
        if (share.holds(group[k])) sums[group[k]] += projected_tangent(mesh, 3 * t + k, unit);
    }
  });
  return sums;
}

void mikktspace(Mesh& mesh, const Frames& frames, unsigned threads, TangentReport& report) {
  const std::vector<std::uint32_t> welded = weld_corners(mesh, threads);
  Groups groups = group_corners(welded, opposite_edges(welded, threads), frames.turn);
  const std::vector<glm::dvec3> sums = sum_by_group(mesh, groups, frames, threads);

  // A degenerate triangle that no group reached takes its neighbour's frame.
  if (report.degenerate_triangles > 0) {
    std::vector<std::uint32_t> group_at(mesh.vertex_count(), no_index);  // by welded vertex: the first there
    for (std::size_t c = 0; c < welded.size(); ++c)
      if (group_at[welded[c]] == no_index) group_at[welded[c]] = groups.of_corner[c];
    for (std::size_t c = 0; c < welded.size(); ++c)
      if (groups.of_corner[c] == no_index) groups.of_corner[c] = group_at[welded[c]];
  }
  const std::vector<std::uint32_t> group_of_vertex = split(mesh, groups.of_corner, report);

  std::atomic<std::uint32_t> fallbacks = 0;
  in_parallel(threads, threads, [&](std::size_t part) {
    const Share share(mesh.vertex_count(), part, threads);
    for (std::size_t v = share.begin; v < share.end; ++v) {
      const std::uint32_t group = group_of_vertex[v];
      glm::vec3 tangent = group == no_index ? glm::vec3(0.0f) : unit_or_zero(sums[group]);
      if (is_zero(tangent)) {
        ++fallbacks;
        tangent = any_orthogonal(mesh.normals[v]);
      }
      mesh.tangents[v] = {tangent, group != no_index && groups.turn[group] < 0 ? -1.0f : 1.0f};
    }
  });
  report.fallback_vertices = fallbacks;
}

}  // namespace

TangentReport compute_tangents(Mesh& mesh, TangentMethod method, unsigned threads) {
  if (mesh.texcoords.size() != mesh.vertex_count())
    throw Error::failed("tangents need texture coordinates, and the mesh has none", {},
                        "give the file vt lines or choose a projection");
  if (mesh.normals.size() != mesh.vertex_count())
    throw Error::failed("tangents need normals, and the mesh has none", {},
                        "generate flat or smooth normals");
  if (threads == 0) threads = parts_for(mesh.triangle_count(), 10'000);
  TangentReport report;
  const Frames frames = triangle_frames(mesh, threads, report);
  mesh.bitangents.clear();
  mesh.tangents.assign(mesh.vertex_count(), glm::vec4(0.0f));
  switch (method) {
    case TangentMethod::averaged:
      store_averages(mesh, sum_by_vertex(mesh, frames), report);
      break;
    case TangentMethod::gram_schmidt:
      split_mirrored(mesh, frames.turn, report);
      store_orthonormal(mesh, sum_by_vertex(mesh, frames), report);
      break;
    case TangentMethod::angle_weighted:
      split_mirrored(mesh, frames.turn, report);
      store_orthonormal(mesh, sum_by_angle(mesh, frames), report);
      break;
    case TangentMethod::mikktspace:
      mikktspace(mesh, frames, threads, report);
      break;
  }
  return report;
}

}  // namespace texel::mesh
