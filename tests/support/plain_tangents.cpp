// SPDX-License-Identifier: MIT
#include "plain_tangents.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mesh/vectors.hpp"
#include "mesh/weld.hpp"

namespace texel::mesh {
namespace {

using glm::vec2;
using glm::vec3;

/// A corner is numbered 3 * triangle + (0, 1, 2); the edge of a corner leads to the next one of its triangle.
using CornerNumber = std::size_t;

CornerNumber next_of(CornerNumber corner) {
  return corner / 3 * 3 + (corner + 1) % 3;
}
CornerNumber previous_of(CornerNumber corner) {
  return corner / 3 * 3 + (corner + 2) % 3;
}

bool counts(float x) {
  return std::abs(x) > std::numeric_limits<float>::min();
}
bool counts(const vec3& v) {
  return counts(v.x) || counts(v.y) || counts(v.z);
}

class Plain {
 public:
  explicit Plain(Mesh& mesh) : mesh_(mesh) {}

  void compute() {
    find_triangles();
    find_points();
    find_neighbours();
    find_groups();
    find_tangents();
    give_each_tangent_its_vertices();
  }

 private:
  struct Triangle {
    vec3 tangent{0.0F}, bitangent{0.0F};  // unit
    bool takes_part = true;               // no two corners at one place
    int turn = 0;                         // +1 or -1 as the texture turns; 0 without a tangent of its own
  };

  void find_triangles() {
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      const std::array<vec3, 3> p = of_triangle(mesh_, mesh_.positions, t);
      const std::array<vec2, 3> st = of_triangle(mesh_, mesh_.texcoords, t);
      Triangle triangle;
      triangle.takes_part = p[0] != p[1] && p[0] != p[2] && p[1] != p[2];
      const vec2 a = st[1] - st[0], b = st[2] - st[0];
      const float area = a.x * b.y - a.y * b.x;
      if (triangle.takes_part && counts(area)) {
        // Twice the area times T and times B, solved for as in step 5.2.
        const vec3 s = b.y * (p[1] - p[0]) - a.y * (p[2] - p[0]);
        const vec3 t_up = a.x * (p[2] - p[0]) - b.x * (p[1] - p[0]);
        const float sign = area > 0 ? 1.0F : -1.0F;
        if (counts(glm::length(s))) triangle.tangent = sign / glm::length(s) * s;
        if (counts(glm::length(t_up))) triangle.bitangent = sign / glm::length(t_up) * t_up;
        if (counts(glm::length(s) / std::abs(area)) && counts(glm::length(t_up) / std::abs(area)))
          triangle.turn = area > 0 ? 1 : -1;
      }
      triangles_.push_back(triangle);
    }
  }

  /// Corners are at one point that agree in position, normal and texture coordinate.
  void find_points() {
    std::map<std::array<float, 8>, std::uint32_t> points;
    for (const std::uint32_t v : mesh_.indices) {
      const vec3 p = mesh_.positions[v], n = mesh_.normals[v];
      const vec2 st = mesh_.texcoords[v];
      const auto number = static_cast<std::uint32_t>(points.size());
      point_.push_back(points.try_emplace({p.x, p.y, p.z, n.x, n.y, n.z, st.s, st.t}, number).first->second);
    }
  }

  /// Two corners' edges that join the same points, in opposite directions: each takes the first that waits.
  void find_neighbours() {
    std::unordered_map<std::uint64_t, std::deque<CornerNumber>> waiting;  // by both points
    const auto key = [](std::uint64_t from, std::uint64_t to) { return from << 32U | to; };
    across_.resize(point_.size());
    for (CornerNumber corner = 0; corner < point_.size(); ++corner) {
      if (!triangles_[corner / 3].takes_part) continue;
      const std::uint32_t from = point_[corner], to = point_[next_of(corner)];
      const auto partners = waiting.find(key(to, from));
      if (partners == waiting.end()) {
        waiting[key(from, to)].push_back(corner);
        continue;
      }
      across_[corner] = partners->second.front();
      across_[partners->second.front()] = corner;
      partners->second.pop_front();
      if (partners->second.empty()) waiting.erase(partners);
    }
  }

  /// Corners around a point that edges join and that turn the same way are one group. A triangle without a
  /// tangent belongs to the turn that reaches it first.
  void find_groups() {
    group_.resize(point_.size());
    std::vector<CornerNumber> reached;
    std::vector<int> turns;
    for (const Triangle& triangle : triangles_) turns.push_back(triangle.turn);
    for (CornerNumber first = 0; first < point_.size(); ++first) {
      const int turn = triangles_[first / 3].turn;
      if (turn == 0 || group_[first]) continue;
      reached = {first};
      while (!reached.empty()) {
        const CornerNumber corner = reached.back();
        reached.pop_back();
        int& its_turn = turns[corner / 3];
        if (its_turn == 0) its_turn = turn;
        if (group_[corner] || its_turn != turn) continue;
        group_[corner] = group_turns_.size();
        // The neighbour's edge runs the other way: it ends at this point, or begins at it.
        if (across_[corner]) reached.push_back(next_of(*across_[corner]));
        if (const auto neighbour = across_[previous_of(corner)]) reached.push_back(*neighbour);
      }
      group_turns_.push_back(turn);
    }
  }

  /// A triangle's tangents and its corner's angle, in the plane of the normal.
  struct Share {
    vec3 tangent{0.0F}, bitangent{0.0F};
    float angle = 0.0F;
  };

  [[nodiscard]] Share share_of(CornerNumber corner) const {
    const vec3 normal = mesh_.normals[mesh_.indices[corner]];
    const auto in_plane = [&](const vec3& v) {
      const vec3 flat = v - glm::dot(normal, v) * normal;
      return counts(flat) ? 1.0F / glm::length(flat) * flat : flat;
    };
    const auto place = [&](CornerNumber c) { return mesh_.positions[mesh_.indices[c]]; };
    const vec3 before = in_plane(place(previous_of(corner)) - place(corner)),
               after = in_plane(place(next_of(corner)) - place(corner));
    const float cosine = std::clamp(glm::dot(before, after), -1.0F, 1.0F);
    const Triangle& triangle = triangles_[corner / 3];
    const Share share{in_plane(triangle.tangent), in_plane(triangle.bitangent),
                      static_cast<float>(std::acos(double{cosine}))};
    const bool is_finite = std::isfinite(glm::dot(share.tangent, share.tangent) * share.angle);
    return is_finite ? share : Share{vec3(0.0F), share.bitangent, 0.0F};
  }

  /// Each corner's sum over its group, without those whose tangent or bitangent is exactly opposite to its
  /// own. Around more than 4096 triangles all count.
  void find_tangents() {
    std::vector<std::vector<CornerNumber>> members(group_turns_.size());
    for (CornerNumber corner = 0; corner < point_.size(); ++corner)
      if (group_[corner]) members[*group_[corner]].push_back(corner);
    tangent_.resize(point_.size());
    for (std::size_t group = 0; group < members.size(); ++group) {
      std::vector<Share> shares;
      std::vector<CornerNumber> others;  // that pass a tangent on, and have none
      for (const CornerNumber corner : members[group])
        if (triangles_[corner / 3].turn == 0)
          others.push_back(corner);
        else
          shares.push_back(share_of(corner));
      const auto sum = [&](const auto& is_counted) {
        vec3 total(0.0F);
        for (const Share& share : shares)
          if (is_counted(share)) total += share.angle * share.tangent;
        total = 1.0F / glm::length(total) * total;
        const bool is_unit = std::abs(glm::dot(total, total) - 1.0F) < 1e-3F;
        return glm::vec4(is_unit ? total : vec3(0.0F), group_turns_[group] < 0 ? -1.0F : 1.0F);
      };
      const glm::vec4 whole = sum([](const Share&) { return true; });
      for (const CornerNumber corner : members[group]) tangent_[corner] = whole;
      if (shares.size() > 4096) continue;
      auto own = shares.begin();
      for (const CornerNumber corner : members[group]) {
        if (triangles_[corner / 3].turn == 0) continue;
        tangent_[corner] = sum([&](const Share& share) {
          return glm::dot(own->tangent, share.tangent) > -1.0F &&
                 glm::dot(own->bitangent, share.bitangent) > -1.0F;
        });
        ++own;
      }
    }
  }

  /// A vertex stays with the first tangent of a group that uses it; each further one gets a copy. A corner
  /// without a group has (1, 0, 0) and -1, but in a triangle that takes no part what the first corner at its
  /// point has.
  void give_each_tangent_its_vertices() {
    using Label = std::tuple<std::size_t, float, float, float, float>;
    const Label nothing{group_turns_.size(), 1.0F, 0.0F, 0.0F, -1.0F};
    std::vector<Label> labels;
    std::map<std::uint32_t, Label> first;  // by point
    for (CornerNumber corner = 0; corner < point_.size(); ++corner) {
      const glm::vec4& t = tangent_[corner];
      labels.push_back(group_[corner] ? Label{*group_[corner], t.x, t.y, t.z, t.w} : nothing);
      if (triangles_[corner / 3].takes_part) first.try_emplace(point_[corner], labels.back());
    }
    for (CornerNumber corner = 0; corner < point_.size(); ++corner)
      if (const auto found = first.find(point_[corner]); found != first.end())
        if (!triangles_[corner / 3].takes_part) labels[corner] = found->second;

    std::vector<std::optional<Label>> of_vertex(mesh_.vertex_count());
    std::map<std::pair<std::uint32_t, Label>, std::uint32_t> copies;
    for (CornerNumber corner = 0; corner < point_.size(); ++corner) {
      std::uint32_t& vertex = mesh_.indices[corner];
      if (!of_vertex[vertex]) of_vertex[vertex] = labels[corner];
      if (of_vertex[vertex] == labels[corner]) continue;
      const auto [copy, is_new] = copies.try_emplace({vertex, labels[corner]}, 0);
      if (is_new) {
        copy->second = duplicate_vertex(mesh_, vertex);
        of_vertex.emplace_back(labels[corner]);
      }
      vertex = copy->second;
    }
    // Without an area in the texture, (1, 0, 0) is turned into the plane of the normal.
    std::vector<bool> is_flat(mesh_.vertex_count());
    for (CornerNumber corner = 0; corner < point_.size(); ++corner) {
      const std::array<vec2, 3> st = of_triangle(mesh_, mesh_.texcoords, corner / 3);
      const vec2 a = st[1] - st[0], b = st[2] - st[0];
      if (triangles_[corner / 3].takes_part && !counts(a.x * b.y - a.y * b.x))
        is_flat[mesh_.indices[corner]] = true;
    }
    mesh_.bitangents.clear();
    mesh_.tangents.clear();
    for (std::size_t v = 0; v < mesh_.vertex_count(); ++v) {
      const auto [group, x, y, z, w] = of_vertex[v].value_or(nothing);
      const bool has_none = is_along(vec3(x, y, z), mesh_.normals[v]);
      vec3 tangent(x, y, z);
      if (group == group_turns_.size() && is_flat[v])
        tangent = unit_or_zero(orthogonal_part(tangent, mesh_.normals[v]));
      mesh_.tangents.emplace_back(has_none ? any_orthogonal(mesh_.normals[v]) : tangent, w);
    }
  }

  Mesh& mesh_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> point_;  // of each corner, and the next two
  std::vector<std::optional<CornerNumber>> across_;
  std::vector<std::optional<std::size_t>> group_;
  std::vector<int> group_turns_;    // of each group
  std::vector<glm::vec4> tangent_;  // of each corner that has a group
};

}  // namespace

void plain_mikktspace(Mesh& mesh) {
  mesh.tangents.clear();
  mesh.bitangents.clear();
  Plain(mesh).compute();
}

}  // namespace texel::mesh
