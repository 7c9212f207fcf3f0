// SPDX-License-Identifier: MIT
#include "plain_tangents.hpp"

#include <array>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mesh/vectors.hpp"

namespace texel::mesh {
namespace {

/// A corner is numbered 3 * triangle + (0, 1, 2); the edge of a corner leads to the next one of its triangle.
using CornerNumber = std::size_t;

CornerNumber next_of(CornerNumber corner) {
  return corner / 3 * 3 + (corner + 1) % 3;
}
CornerNumber previous_of(CornerNumber corner) {
  return corner / 3 * 3 + (corner + 2) % 3;
}

class Plain {
 public:
  explicit Plain(Mesh& mesh) : mesh_(mesh) {}

  TangentReport compute() {
    find_frames();
    find_points();
    find_neighbours();
    find_groups();
    add_up();
    give_each_group_its_vertices();
    return report_;
  }

 private:
  /// T of each triangle, and +1 or -1 as the texture turns; 0 for triangles without area.
  void find_frames() {
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      std::array<glm::vec3, 3> positions;
      std::array<glm::vec2, 3> texcoords;
      for (std::size_t k = 0; k < 3; ++k) {
        positions[k] = mesh_.positions[mesh_.indices[3 * t + k]];
        texcoords[k] = mesh_.texcoords[mesh_.indices[3 * t + k]];
      }
      const double area = texture_area(texcoords);
      TriangleFrame frame;
      if (area != 0) frame = triangle_frame(positions, texcoords);
      if (is_zero(unit_or_zero(glm::cross(glm::dvec3(frame.tangent), glm::dvec3(frame.bitangent))))) {
        ++report_.degenerate_triangles;
        tangents_.emplace_back(0.0f);
        turns_.push_back(0);
      } else {
        tangents_.push_back(frame.tangent);
        turns_.push_back(area > 0 ? 1 : -1);
      }
    }
  }

  /// Corners are at one point that agree in position, normal and texture coordinate.
  void find_points() {
    std::map<std::array<float, 8>, std::uint32_t> points;
    for (const std::uint32_t v : mesh_.indices) {
      const glm::vec3 p = mesh_.positions[v], n = mesh_.normals[v];
      const glm::vec2 st = mesh_.texcoords[v];
      const auto number = static_cast<std::uint32_t>(points.size());
      point_.push_back(points.try_emplace({p.x, p.y, p.z, n.x, n.y, n.z, st.s, st.t}, number).first->second);
    }
  }

  /// Two corners' edges that join the same points, in opposite directions.
  void find_neighbours() {
    std::unordered_map<std::uint64_t, CornerNumber> alone;  // by both points: the last edge without a partner
    const auto key = [](std::uint64_t from, std::uint64_t to) { return from << 32U | to; };
    across_.resize(point_.size());
    for (CornerNumber corner = 0; corner < point_.size(); ++corner) {
      const std::uint32_t from = point_[corner], to = point_[next_of(corner)];
      if (from == to) continue;
      const auto partner = alone.find(key(to, from));
      if (partner == alone.end()) {
        alone[key(from, to)] = corner;
      } else {
        across_[corner] = partner->second;
        across_[partner->second] = corner;
        alone.erase(partner);
      }
    }
  }

  /// Corners around a point that edges join and that turn the same way are one group. A triangle without area
  /// belongs to the turn that reaches it first.
  void find_groups() {
    group_.resize(point_.size());
    std::vector<CornerNumber> reached;
    for (CornerNumber first = 0; first < point_.size(); ++first) {
      if (turns_[first / 3] == 0 || group_[first]) continue;
      const int turn = turns_[first / 3];
      const auto group = static_cast<std::uint32_t>(group_turns_.size());
      group_turns_.push_back(turn);
      reached = {first};
      while (!reached.empty()) {
        const CornerNumber corner = reached.back();
        reached.pop_back();
        int& its_turn = turns_[corner / 3];
        if (its_turn == 0) its_turn = turn;
        if (group_[corner] || its_turn != turn) continue;
        group_[corner] = group;
        // The neighbour's edge runs the other way: it ends at this point, or begins at it.
        if (across_[corner]) reached.push_back(next_of(*across_[corner]));
        if (const auto neighbour = across_[previous_of(corner)]) reached.push_back(*neighbour);
      }
    }
  }

  /// Each group's sum of unit tangents in the plane of the normal, by the corner's angle in that plane.
  void add_up() {
    sums_.resize(group_turns_.size(), glm::dvec3(0.0));
    for (CornerNumber corner = 0; corner < point_.size(); ++corner) {
      if (!group_[corner]) continue;
      const glm::dvec3 normal = mesh_.normals[mesh_.indices[corner]];
      const auto in_plane = [&](const glm::dvec3& v) { return glm::cross(glm::cross(normal, v), normal); };
      const auto place = [&](CornerNumber c) { return glm::dvec3(mesh_.positions[mesh_.indices[c]]); };
      const glm::dvec3 here = place(corner);
      const double angle =
          angle_between(in_plane(place(next_of(corner)) - here), in_plane(place(previous_of(corner)) - here));
      const glm::vec3 tangent = unit_or_zero(in_plane(unit_or_zero(tangents_[corner / 3])));
      sums_[*group_[corner]] += angle * glm::dvec3(tangent);
    }
  }

  /// A vertex stays with the first group that uses it; each further group gets a copy. A corner without a
  /// group takes the first one at its point, and else its vertex keeps any direction.
  void give_each_group_its_vertices() {
    std::map<std::uint32_t, std::uint32_t> first_group;  // by point
    for (CornerNumber corner = 0; corner < point_.size(); ++corner)
      if (group_[corner]) first_group.try_emplace(point_[corner], *group_[corner]);
    std::vector<std::optional<std::uint32_t>> group_of_vertex(mesh_.vertex_count());
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> copies;  // by vertex and group
    for (CornerNumber corner = 0; corner < point_.size(); ++corner) {
      if (!group_[corner]) {
        const auto found = first_group.find(point_[corner]);
        if (found == first_group.end()) continue;
        group_[corner] = found->second;
      }
      const std::uint32_t group = *group_[corner];
      std::uint32_t& vertex = mesh_.indices[corner];
      if (!group_of_vertex[vertex]) group_of_vertex[vertex] = group;
      if (group_of_vertex[vertex] == group) continue;
      const auto [copy, is_new] = copies.try_emplace({vertex, group}, 0);
      if (is_new) {
        copy->second = duplicate_vertex(mesh_, vertex);
        group_of_vertex.emplace_back(group);
        ++report_.split_vertices;
      }
      vertex = copy->second;
    }
    mesh_.bitangents.clear();
    mesh_.tangents.assign(mesh_.vertex_count(), glm::vec4(0.0f));
    for (std::size_t v = 0; v < mesh_.vertex_count(); ++v) {
      const auto group = group_of_vertex[v];
      glm::vec3 tangent = group ? unit_or_zero(sums_[*group]) : glm::vec3(0.0f);
      if (is_zero(tangent)) {
        ++report_.fallback_vertices;
        tangent = any_orthogonal(mesh_.normals[v]);
      }
      mesh_.tangents[v] = {tangent, group && group_turns_[*group] < 0 ? -1.0f : 1.0f};
    }
  }

  Mesh& mesh_;
  TangentReport report_;
  std::vector<glm::vec3> tangents_;  // of each triangle
  std::vector<int> turns_;
  std::vector<std::uint32_t> point_;  // of each corner, and the next two
  std::vector<std::optional<CornerNumber>> across_;
  std::vector<std::optional<std::uint32_t>> group_;
  std::vector<int> group_turns_;  // of each group, and the next
  std::vector<glm::dvec3> sums_;
};

}  // namespace

TangentReport plain_mikktspace(Mesh& mesh) {
  mesh.tangents.clear();
  mesh.bitangents.clear();
  return Plain(mesh).compute();
}

}  // namespace texel::mesh
