// SPDX-License-Identifier: MIT
// OBJ files that nobody has seen.
#include "material/unseen_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>

#include "../support/said.hpp"
#include "core/error.hpp"
#include "core/process.hpp"
#include "mesh/obj.hpp"
#include "mesh/polygon.hpp"
#include "mesh/vectors.hpp"
#include "mesh/weld.hpp"

namespace texel::material {
namespace {

const std::uint64_t seeds = std::getenv("CI") != nullptr ? 100 : 30;

/// Of each seed. Made at once: to start the script for each takes longer than what it does.
const std::vector<std::string>& unseen_models(const std::string& kind) {
  static std::map<std::string, std::vector<std::string>> all;
  std::vector<std::string>& models = all[kind];
  if (!models.empty()) return models;
  std::vector<std::string> command = {"python3", "teach/material/unseen_model.py", kind};
  for (std::uint64_t seed = 0; seed < seeds; ++seed) command.push_back(std::to_string(seed));
  const std::string texts = run_program(command).output;
  for (std::size_t begin = 0, end = 0; end != texts.npos; begin = end + 2) {
    end = texts.find("#\n", begin);
    models.push_back(texts.substr(begin, end - begin));
  }
  return models;
}

/// A file's lists and faces as they are written.
struct Lines {
  std::vector<glm::dvec3> positions;
  std::map<std::string, std::vector<std::string>> words;  ///< by keyword, without it
  std::vector<std::vector<std::size_t>> faces;            ///< positions from 0
};

Lines read(const std::string& text) {
  Lines lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string keyword, rest;
    words >> keyword;
    std::getline(words, rest);
    lines.words[keyword].push_back(rest);
    std::istringstream values(rest);
    if (keyword == "v") {
      glm::dvec3& p = lines.positions.emplace_back();
      values >> p.x >> p.y >> p.z;
    }
    if (keyword != "f") continue;
    lines.faces.emplace_back();
    for (std::string corner; values >> corner;) {
      const int index = std::stoi(corner);
      lines.faces.back().push_back(index > 0 ? static_cast<std::size_t>(index) - 1
                                             : lines.positions.size() - static_cast<std::size_t>(-index));
    }
  }
  return lines;
}

using Outline = std::vector<glm::dvec2>;

/// Newell's normal of a face, twice its area long.
glm::dvec3 normal_of(const std::vector<glm::dvec3>& corners) {
  glm::dvec3 normal(0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    normal += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return normal;
}

Outline flattened(const std::vector<glm::dvec3>& corners) {
  const glm::dvec3 normal = glm::normalize(normal_of(corners));
  const glm::dvec3 x = glm::normalize(corners[1] - corners[0]), y = glm::cross(normal, x);
  Outline outline;
  for (const glm::dvec3& corner : corners)
    outline.emplace_back(glm::dot(corner - corners[0], x), glm::dot(corner - corners[0], y));
  return outline;
}

bool cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
  return mesh::area(a, b, c) * mesh::area(a, b, d) <= 0 && mesh::area(c, d, a) * mesh::area(c, d, b) <= 0;
}

bool is_simple(const Outline& outline) {
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && cross(outline[i], outline[i + 1], outline[j], outline[(j + 1) % n]))
        return false;
  return true;
}

class EachKind : public testing::TestWithParam<std::string> {};

TEST_P(EachKind, is_sound_and_follows_from_the_seed) {
  for (const std::uint64_t seed : {0, 7})
    EXPECT_EQ(unseen_model(GetParam(), seed), unseen_models(GetParam())[seed]);
  std::set<std::string> texts;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    SCOPED_TRACE(seed);
    const std::string text = unseen_models(GetParam())[seed];
    EXPECT_TRUE(texts.insert(text).second);
    // No two lines are equal, so that equal values are equal indices.
    const Lines lines = read(text);
    for (const auto& [keyword, rest] : lines.words)
      EXPECT_EQ(std::set<std::string>(rest.begin(), rest.end()).size(), rest.size()) << keyword;
    const mesh::ObjData data = mesh::parse_obj(text, GetParam());
    EXPECT_EQ(data.warnings.size(), GetParam() == "numbers" ? 1U : 0U) << "of the weights of v";
    EXPECT_GE(lines.faces.size(), 30U);
    EXPECT_LE(lines.faces.size(), GetParam() == "shared" ? 2000U : 200U);
    EXPECT_EQ(data.texcoords.empty(), GetParam() == "no_vt");
    for (const glm::vec3& p : data.positions)
      for (int c = 0; c < 3; ++c) EXPECT_TRUE(p[c] >= 0 && p[c] <= 1) << p[c];
    // Faces show the side to which their normals point. One of "shared" and one of "faces" has no area.
    std::size_t flat = 0;
    for (std::size_t i = 0; i < data.corners.size(); i += 3) {
      const auto at = [&](std::size_t k) { return glm::dvec3(data.positions[data.corners[i + k].position]); };
      const glm::dvec3 normal = glm::cross(at(1) - at(0), at(2) - at(0));
      if (normal == glm::dvec3(0))
        ++flat;
      else
        EXPECT_GT(glm::dot(normal, glm::dvec3(data.normals[data.corners[i].normal])), 0);
    }
    EXPECT_EQ(flat, (std::set<std::string>{"faces", "shared"}.count(GetParam())));
  }
}

INSTANTIATE_TEST_SUITE_P(Unseen, EachKind,
                         testing::ValuesIn(std::vector<std::string>(std::begin(kUnseenKinds),
                                                                    std::end(kUnseenKinds))),
                         [](const auto& kind) { return kind.param; });

TEST(UnseenPolygons, are_planar_simple_and_mostly_not_what_a_fan_makes_of_them) {
  std::map<std::size_t, int> corners, fans;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const Lines lines = read(unseen_models("polygons")[seed]);
    for (const std::vector<std::size_t>& face : lines.faces) {
      std::vector<glm::dvec3> points;
      for (const std::size_t v : face) points.push_back(lines.positions[v]);
      const glm::dvec3 normal = glm::normalize(normal_of(points));
      // Six decimals: each coordinate is off by half a millionth, and the polygon by that over its width.
      for (const glm::dvec3& p : points) EXPECT_NEAR(glm::dot(p - points[0], normal), 0, 1e-5);
      const Outline outline = flattened(points);
      EXPECT_TRUE(is_simple(outline)) << "seed " << seed;
      ++corners[face.size()];
      bool fan_fits = true;
      for (std::size_t i = 1; i + 1 < outline.size(); ++i)
        fan_fits = fan_fits && mesh::area(outline[0], outline[i], outline[i + 1]) > 0;
      fans[face.size()] += fan_fits ? 1 : 0;
    }
  }
  ASSERT_EQ(corners.size(), 8U);
  EXPECT_EQ(corners.begin()->first, 3U);
  EXPECT_EQ(corners.rbegin()->first, 11U) << "a comb";
  for (const auto& [count, faces] : corners) EXPECT_EQ(fans[count], count == 3 ? faces : 0) << count;
}

TEST(UnseenPolygons, have_texture_coordinates_linear_in_their_plane) {
  // Any other three corners of the polygon give the same coordinate at a corner.
  const mesh::ObjData data = mesh::parse_obj(unseen_models("polygons")[7], "unseen");
  std::map<std::uint32_t, std::vector<mesh::Corner>> by_polygon;  // each has its own vn
  for (const mesh::Corner& corner : data.corners) by_polygon[corner.normal].push_back(corner);
  for (const auto& polygon : by_polygon) {
    const std::vector<mesh::Corner>& corners = polygon.second;
    const auto position = [&](std::size_t i) { return glm::dvec3(data.positions[corners[i].position]); };
    const auto texcoord = [&](std::size_t i) { return glm::dvec2(data.texcoords[corners[i].texcoord]); };
    const glm::dvec3 a = position(1) - position(0), b = position(2) - position(0), n = glm::cross(a, b);
    for (std::size_t i = 3; i < corners.size(); ++i) {
      const glm::dvec3 p = position(i) - position(0);
      const double s = glm::dot(glm::cross(p, b), n) / glm::dot(n, n);
      const double t = glm::dot(glm::cross(a, p), n) / glm::dot(n, n);
      const glm::dvec2 expected =
          texcoord(0) + s * (texcoord(1) - texcoord(0)) + t * (texcoord(2) - texcoord(0));
      // Six decimals of a position are 1e-5 of a polygon, more where the first triangle is narrow.
      EXPECT_NEAR(glm::distance(texcoord(i), expected), 0, 5e-4) << polygon.first;
    }
  }
}

TEST(UnseenNegative, counts_from_the_front_and_from_the_back_in_every_list) {
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    std::array<std::array<int, 2>, 3> counted{};
    Lines lines = read(unseen_models("negative")[seed]);
    for (const std::string& face : lines.words["f"]) {
      std::istringstream corners(face);
      for (std::string corner; corners >> corner;) {
        std::istringstream indices(corner);
        std::string index;
        for (auto& list : counted)
          if (std::getline(indices, index, '/')) ++list[index[0] == '-' ? 1 : 0];
      }
    }
    for (const auto& list : counted)
      for (const int count : list) EXPECT_GT(count, 20) << "seed " << seed;
  }
}

TEST(UnseenShared, has_corners_that_differ_in_v_alone_in_vt_alone_in_vn_alone_and_in_nothing) {
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const mesh::ObjData data = mesh::parse_obj(unseen_models("shared")[seed], "unseen");
    std::set<std::pair<std::uint32_t, std::uint32_t>> with_texcoord, with_normal, without_place;
    std::set<std::uint32_t> places;
    for (const mesh::Corner& corner : data.corners) {
      places.insert(corner.position);
      with_texcoord.emplace(corner.position, corner.texcoord);
      with_normal.emplace(corner.position, corner.normal);
      without_place.emplace(corner.texcoord, corner.normal);
    }
    const std::size_t vertices = mesh::weld(data).vertex_count();
    EXPECT_GT(with_texcoord.size(), places.size());
    EXPECT_GT(with_normal.size(), places.size());
    EXPECT_GT(vertices, with_texcoord.size());
    EXPECT_GT(vertices, with_normal.size());
    EXPECT_GT(vertices, without_place.size());
    EXPECT_LT(vertices, data.corners.size());
  }
}

TEST(UnseenNumbers, has_every_count_of_numbers) {
  std::map<std::string, std::set<std::ptrdiff_t>> counts;
  Lines lines = read(unseen_models("numbers")[3]);
  for (const char* list : {"v", "vt"})
    for (const std::string& rest : lines.words[list])
      counts[list].insert(std::count(rest.begin(), rest.end(), '.'));
  EXPECT_EQ(counts["v"], (std::set<std::ptrdiff_t>{3, 4, 6, 7}));
  EXPECT_EQ(counts["vt"], (std::set<std::ptrdiff_t>{1, 2, 3}));
}

TEST(UnseenModel, of_an_unknown_kind_is_an_error_that_names_a_near_one) {
  const std::string said = test::error_of([] { unseen_model("polygon", 1); }, Exit::usage);
  EXPECT_TRUE(test::has(said, "did you mean 'polygons'?")) << said;
}

}  // namespace
}  // namespace texel::material
