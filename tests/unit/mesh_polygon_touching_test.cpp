// SPDX-License-Identifier: MIT
// Polygons on a small grid, where corners lie on the edges of the ears that might be cut.
#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/polygon.hpp"

namespace texel::mesh {
namespace {

using Points = std::vector<glm::ivec2>;

int twice_area(const glm::ivec2& a, const glm::ivec2& b, const glm::ivec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// In whole numbers, so that nothing is rounded: no triangle turns over, and together they are as large as
/// the polygon.
void expect_covered(const Points& polygon) {
  std::vector<glm::vec3> corners;
  for (const glm::ivec2& p : polygon) corners.emplace_back(p, 0);
  int area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    area += twice_area({0, 0}, polygon[i], polygon[(i + 1) % polygon.size()]);
  std::vector<Triangle> triangles;
  EXPECT_NE(triangulate(corners, triangles), Cut::approximate);
  ASSERT_EQ(triangles.size(), polygon.size() - 2);
  int covered = 0;
  for (const Triangle& t : triangles) {
    const int part = twice_area(polygon[t[0]], polygon[t[1]], polygon[t[2]]);
    EXPECT_GE(part * area, 0) << t[0] << " " << t[1] << " " << t[2] << " turns over";
    covered += part;
  }
  EXPECT_EQ(covered, area);
}

TEST(Polygon, is_covered_where_a_corner_lies_on_the_edge_of_an_ear) {
  // (1, 1) and (2, 1) lie on the lines between other corners.
  for (const Points& polygon : {Points{{0, 0}, {1, 1}, {1, 3}, {2, 1}, {3, 1}},
                                Points{{0, 3}, {3, 2}, {2, 1}, {1, 1}, {2, 2}, {1, 2}},
                                Points{{5, 0}, {5, 5}, {0, 5}, {3, 4}, {4, 2}, {2, 4}},
                                Points{{5, 1}, {3, 0}, {2, 4}, {3, 3}, {4, 2}, {3, 4}}})
    for (std::size_t turn = 0; turn < polygon.size(); ++turn) {
      SCOPED_TRACE(turn);
      Points turned = polygon;
      std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(turn), turned.end());
      expect_covered(turned);
      std::reverse(turned.begin(), turned.end());
      expect_covered(turned);
    }
}

}  // namespace
}  // namespace texel::mesh
