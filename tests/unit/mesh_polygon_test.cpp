// SPDX-License-Identifier: MIT
#include "mesh/polygon.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <map>

namespace texel::mesh {
namespace {

using Outline = std::vector<glm::vec2>;

/// The outline in some plane in space, far from the origin, or in the plane z = 0.
std::vector<glm::vec3> placed(const Outline& outline, bool flat = false) {
  glm::mat4 plane = glm::translate(glm::mat4(1.0F), glm::vec3(3.0F, -5.0F, 7.0F));
  plane = glm::rotate(plane, 1.1F, glm::normalize(glm::vec3(1.0F, 2.0F, -0.5F)));
  if (flat) plane = glm::mat4(1.0F);
  std::vector<glm::vec3> corners;
  for (const glm::vec2& p : outline) corners.emplace_back(plane * glm::vec4(p, 0.0F, 1.0F));
  return corners;
}

double signed_area(const Outline& outline) {
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2 a(outline[i]), b(outline[(i + 1) % outline.size()]);
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * twice;
}

/// Triangles of the outline's winding whose areas add up to its area cannot overlap or leave it.
void expect_exact_cover(const Outline& outline, const std::vector<glm::vec3>& corners) {
  std::vector<Triangle> triangles;
  EXPECT_TRUE(triangulate(corners, triangles));
  EXPECT_EQ(triangles.size(), outline.size() - 2);
  const double whole = signed_area(outline);
  double sum = 0.0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const Triangle& t : triangles) {
    const double area = signed_area({outline[t[0]], outline[t[1]], outline[t[2]]});
    EXPECT_GE(area * whole, -1e-9) << "a triangle turned over";
    sum += area;
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  }
  EXPECT_NEAR(sum, whole, 1e-6 * std::abs(whole));  // float32 corners in 2D: exact but for the sum
  for (std::uint32_t i = 0; i < outline.size(); ++i)
    EXPECT_EQ((edges[{i, (i + 1) % static_cast<std::uint32_t>(outline.size())}]), 1) << "edge " << i;
}

TEST(Polygon, is_covered_exactly_whatever_its_shape) {
  const std::pair<const char*, Outline> rows[] = {
      {"triangle", {{0, 0}, {1, 0}, {0, 1}}},
      {"square", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
      {"arrow head, a fan from its first corner is wrong", {{0, 0}, {2, 1}, {0, 2}, {1, 1}}},
      {"arrow head whose notch comes first, a fan is right", {{1, 1}, {0, 0}, {2, 1}, {0, 2}}},
      {"L from its inner side, a fan is right", {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}},
      {"U", {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}},
      {"corner in the middle of an edge", {{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}},
      {"comb",
       {{0, 0}, {7, 0}, {7, 3}, {6, 3}, {6, 1}, {5, 1}, {5, 3}, {4, 3}, {4, 1}, {3, 1}, {3, 3}, {0, 3}}},
      {"square with a square hole joined by a bridge",
       {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}},
  };
  for (const auto& [name, outline] : rows) {
    SCOPED_TRACE(name);
    expect_exact_cover(outline, placed(outline));
    const Outline reversed(outline.rbegin(), outline.rend());
    expect_exact_cover(reversed, placed(reversed));
  }
}

TEST(Polygon, is_covered_where_a_corner_lies_on_the_edge_of_an_ear) {
  // On a small grid, where nothing is rounded; (1, 1) and (2, 1) lie on the lines between other corners.
  for (Outline outline : {Outline{{0, 0}, {1, 1}, {1, 3}, {2, 1}, {3, 1}},
                          {{0, 3}, {3, 2}, {2, 1}, {1, 1}, {2, 2}, {1, 2}},
                          {{5, 0}, {5, 5}, {0, 5}, {3, 4}, {4, 2}, {2, 4}},
                          {{5, 1}, {3, 0}, {2, 4}, {3, 3}, {4, 2}, {3, 4}}})
    for (std::size_t turn = 0; turn < outline.size(); ++turn) {
      SCOPED_TRACE(turn);
      std::rotate(outline.begin(), outline.begin() + 1, outline.end());
      expect_exact_cover(outline, placed(outline, true));
      const Outline reversed(outline.rbegin(), outline.rend());
      expect_exact_cover(reversed, placed(reversed, true));
    }
}

TEST(Polygon, is_cut_into_two_fewer_triangles_even_when_it_makes_no_sense) {
  std::vector<glm::vec3> zigzag;  // too large to clip
  for (std::size_t i = 0; i <= max_clipped_corners; ++i) zigzag.emplace_back(float(i), float(i % 2), 0.0F);
  zigzag.emplace_back(0.0F, 10.0F, 0.0F);
  const std::vector<std::vector<glm::vec3>> outlines{
      {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},  // crosses itself
      zigzag,
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}},             // on a line
      {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}},  // a point
      {{0, 0, 0}, {3e38F, 0, 0}, {3e38F, 3e38F, 0}, {0, 3e38F, 0}},
  };
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    const bool is_exact = triangulate(outlines[i], triangles);
    EXPECT_EQ(triangles.size(), outlines[i].size() - 2);
    EXPECT_FALSE(is_exact && i < 2) << i;
  }
}

}  // namespace
}  // namespace texel::mesh
