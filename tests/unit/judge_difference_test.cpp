// SPDX-License-Identifier: MIT
// What is said of a wrong picture or vertex stream that no catalogue holds.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>

#include "core/files.hpp"
#include "image/color.hpp"
#include "image/save.hpp"
#include "judge/mistakes.hpp"
#include "mesh/ply.hpp"
#include "mesh/primitives.hpp"

namespace texel::judge {
namespace {

using course::View;
using glm::dvec3;

/// What is said of one case's picture of 64 x 64 pixels: of a sphere's normals, a plane's texture coordinates
/// or their colours. A border of 8 pixels around it is background.
class Differences : public testing::Test {
 protected:
  static constexpr int kSide = 64, kBorder = 8;

  static dvec3 expected(View view, int x, int y) {
    const double s = (x - kBorder) / 48.0, t = (y - kBorder) / 48.0;
    if (view == View::texcoord) return {1.5 * s, 2 * t, 0};
    if (view == View::color) return {40 + 160 * s, 220 - 150 * t, 30 + 90 * s * t};
    return glm::normalize(dvec3(1.2 * s - 0.6, 1.2 * t - 0.6, 0.7));
  }

  [[nodiscard]] std::string said(View view, const std::function<dvec3(dvec3)>& becomes,
                                 bool is_secret = false) {
    course::Lab plan;
    course::Case& one = plan.cases.emplace_back();
    one.name = "a", one.step = "1.1", one.view = view, one.size = {kSide, kSide};
    one.limit = view == View::color ? 3 : view == View::texcoord ? 1e-4 : 0.05;
    std::array<std::string, 2> files;
    image::Image8 mask(kSide, kSide, 1);
    for (const std::size_t is_own : {0U, 1U}) {
      image::Image8 colors(kSide, kSide, 3);
      image::ImageF values(kSide, kSide, 3);
      for (int y = kBorder; y < kSide - kBorder; ++y)
        for (int x = kBorder; x < kSide - kBorder; ++x) {
          const dvec3 value = is_own == 1 ? becomes(expected(view, x, y)) : expected(view, x, y);
          mask.at(x, y) = 255;
          for (int c = 0; c < 3; ++c) {
            values.at(x, y, c) = static_cast<float>(value[c]);
            colors.at(x, y, c) = static_cast<std::uint8_t>(std::lround(std::clamp(value[c], 0.0, 255.0)));
          }
        }
      image::save_pfm(folder_.path() / "values.pfm", values);
      files.at(is_own) = view == View::color ? image::encode_png(colors, "colors")
                                             : read_file(folder_.path() / "values.pfm");
    }
    const auto seen = explain({}, plan, "1.1",
                              {{"a", {files[1], "", files[0], image::encode_png(mask, "mask"), is_secret}}});
    return seen.empty() ? "" : seen.at("a").says.substr(0, seen.at("a").says.find(':'));
  }

  ScratchFolder folder_;
};

TEST_F(Differences, are_said_channel_by_channel) {
  const auto lit = [](double more) {
    return [more](dvec3 c) {
      for (int i = 0; i < 3; ++i)
        c[i] = 255 * image::srgb_from_linear(more + 0.5 * image::linear_from_srgb(c[i] / 255));
      return c;
    };
  };
  const auto exchanged_quarters = [](dvec3 c) {
    const double s = glm::fract((c.x - 40) / 160 + 0.5), t = glm::fract((220 - c.y) / 150 + 0.5);
    return dvec3(40 + 160 * s, 220 - 150 * t, 30 + 90 * s * t);
  };
  const std::tuple<View, std::function<dvec3(dvec3)>, const char*> rows[] = {
      {View::normal, [](dvec3 n) { return n * dvec3(1, -1, 1); }, "The expected normal with y negated"},
      {View::normal, [](dvec3 n) { return -n; }, "The expected normal with x, y and z negated"},
      {View::normal, [](dvec3 n) { return dvec3(n.y, n.x, n.z); },
       "The expected normal with y in place of x and x in place of y"},
      {View::texcoord, [](dvec3 c) { return dvec3(1 - c.x, c.y, 0); },
       "The expected texture coordinate with 1 - s (or u) in place of s (or u)"},
      {View::texcoord, [](dvec3 c) { return c + dvec3(0.5, 0, 0); },
       "The expected texture coordinate with 0.5 added to s (or u)"},
      {View::texcoord, [](dvec3 c) { return dvec3(std::min(c.x, 1.0), c.y, 0); },
       "The expected texture coordinate with s (or u) kept between 0.0312 and 1"},
      {View::texcoord, [](dvec3 c) { return glm::fract(c); },
       "The expected texture coordinate with only the fraction of s (or u) and t (or v)"},
      {View::texcoord, [](dvec3 c) { return dvec3(c.x, c.y * c.y, 0); },
       "The expected texture coordinate with only t (or v) wrong"},
      {View::color, [](dvec3 c) { return dvec3(c.z, c.y, c.x); },
       "The expected picture with blue in place of red and red in place of blue"},
      {View::color, lit(0), "The expected picture with the light of red, green and blue times 0.499"},
      {View::color, lit(0.25),
       "The expected picture with the light of red, green and blue times 0.499 with 0.25 added"},
      {View::color, exchanged_quarters, "The expected picture, but with its colours at other places"},
      {View::color, [](dvec3 c) { return 127.0 + 120.0 * glm::sin(c); }, ""}};  // nothing fits: not a word
  for (const auto& [view, becomes, says] : rows) EXPECT_EQ(said(view, becomes), says);
}

TEST_F(Differences, are_said_of_directions_as_a_whole) {
  const auto turned = [](double degrees, double sign = 1) {
    return [angle = glm::radians(degrees), sign](dvec3 n) {
      return sign * dvec3(std::cos(angle) * n.x + std::sin(angle) * n.z, n.y,
                          std::cos(angle) * n.z - std::sin(angle) * n.x);
    };
  };
  const std::pair<std::function<dvec3(dvec3)>, std::string> rows[] = {
      {turned(40), ", turned by 40 degrees around the axis (0, 1, 0)"},
      {turned(40, -1), ", negated, turned by 40 degrees around the axis (0, 1, 0)"},
      {turned(0.15), " with only x and z wrong"},  // thrice the limit: any small turn is near enough
      {[](dvec3 n) { return glm::normalize(n + dvec3(0, 0.5, 0)); },
       ", with the vector (0, 0.5, 0) added before it was made a unit vector"},
      {[](dvec3 n) { return n.x < 0 ? -n : n; }, " with x, y and z negated in a part of it"},
      {[](dvec3 n) { return glm::normalize(dvec3(n.x * n.y, n.y * n.z, n.x + n.y + n.z * n.x)); },
       ", turned at each place in another way, by about 71 degrees"},
      {[](dvec3) { return dvec3(0); }, ", but nothing is drawn there"}};
  for (const auto& [becomes, says] : rows)
    EXPECT_EQ(said(View::normal, becomes), "The expected normal" + says);
  EXPECT_EQ(said(View::normal, turned(40), true),
            "The expected normal, turned by some degrees around the axis (some numbers)");  // it is secret
}

std::string said_of_stream(const mesh::Mesh& own, const mesh::Mesh& reference) {
  course::Lab plan;
  course::Case& one = plan.cases.emplace_back();
  one.name = "a", one.step = "1.1", one.view = View::mesh, one.limit = 0.05;
  const auto seen = explain({}, plan, "1.1", {{"a", {mesh::to_ply(own), "", mesh::to_ply(reference)}}});
  return seen.empty() ? "" : seen.at("a").says;
}

TEST(StreamDifferences, are_said_attribute_by_attribute) {
  mesh::Mesh reference = mesh::torus(0.7F, 0.3F, 24, 12), own = reference;
  for (glm::vec2& texcoord : own.texcoords) texcoord = {texcoord.x, 1 - texcoord.y};
  for (std::size_t i = 0; i < 30; ++i) own.normals[i] = -own.normals[i];
  EXPECT_EQ(said_of_stream(own, reference),
            "The expected texture coordinate with 1 - t (or v) in place of t (or v) and the expected normal "
            "with x, y and z negated: so it is at 100 % of what is wrong.");
}

TEST(StreamDifferences, tell_of_vertices_that_became_one_or_come_again) {
  // Two squares back to back, and two that are the same.
  const mesh::Mesh once = mesh::quad(1);
  mesh::Mesh other_side = once, again = once;
  for (std::uint32_t i = 0; i < once.vertex_count(); ++i)
    for (mesh::Mesh* both : {&other_side, &again}) {
      both->positions.push_back(once.positions[i]);
      both->texcoords.push_back(once.texcoords[i]);
      both->normals.push_back(both == &again ? once.normals[i] : -once.normals[i]);
    }
  for (const std::uint32_t index : once.indices)
    other_side.indices.push_back(index + 4), again.indices.push_back(index + 4);
  EXPECT_EQ(said_of_stream(once, other_side),
            "The expected normal, but vertices that differ in it alone are one: so it is at 100 % of what is "
            "wrong.");
  EXPECT_EQ(
      said_of_stream(again, once),
      "The expected position, but some vertices come more than once: so it is at 100 % of what is wrong.");
}

}  // namespace
}  // namespace texel::judge
