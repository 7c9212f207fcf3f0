// SPDX-License-Identifier: MIT
// What the grader gives for pictures of which everybody knows how wrong they are. docs/instructor.md has the
// same table.
#include <algorithm>
#include <cmath>
#include <random>

#include "check/check.hpp"
#include "core/files.hpp"
#include "image/load.hpp"
#include "image/save.hpp"
#include "labs.hpp"

namespace texel::test {
namespace {

using check::ExpectedFiles;
using course::Case;
using image::Image8;
using judge::Verdict;

/// Pictures of different kinds: a texture on a square, a lit relief, a ball in its surroundings.
struct Scene {
  const char* lab;
  Settings look;
};
const Scene kScenes[] = {
    {"lab01_texture_quad", {{"texture", "brick"}, {"tilt", "20"}, {"distance", "1.8"}}},
    {"lab05_normal_map", {{"model", "torus"}, {"texture", "scales"}, {"distance", "2.2"}}},
    {"lab08_reflection", {{"distance", "3"}}}};

/// Scores of changed pictures of one scene.
class ScoreOf : public testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    const Scene& scene = kScenes[GetParam()];
    draw(scene.lab, {{"reference", scene.look}, {"mask", scene.look, "mask"}}, folder_);
    of_.name = "picture", of_.size = {128, 128}, of_.limit = 2;
    expected_ = {file("reference"), file("mask")};
    reference_ = image::load8(file("reference"), 3);
    // As most starters do: the object is there, and grey.
    const Image8 mask = image::load8(file("mask"));
    image::save_png(file("starter"),
                    changed([&](int x, int y, int c) { return mask.at(x, y) > 127 ? 128 : at(x, y, c); }));
  }

  std::filesystem::path file(const std::string& name) { return folder_ / (name + ".png"); }
  Verdict verdict_of(const std::string& name) { return check::judge(of_, expected_, file(name)); }
  double score(const std::string& name) {
    const Verdict verdict = verdict_of(name);
    EXPECT_EQ(verdict.passed, verdict.score == 1) << verdict.message;
    return verdict.score;
  }
  double score(const Image8& picture) {
    image::save_png(file("picture"), picture);
    return score("picture");
  }
  /// The reference with each sample replaced by what `change(x, y, channel)` gives.
  template <class Change>
  Image8 changed(Change change) {
    Image8 picture = reference_;
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x)
        for (int c = 0; c < 3; ++c)
          picture.at(x, y, c) = static_cast<std::uint8_t>(std::clamp<int>(change(x, y, c), 0, 255));
    return picture;
  }
  int at(int x, int y, int c) const {
    return reference_.at(std::clamp(x, 0, reference_.width - 1), std::clamp(y, 0, reference_.height - 1), c);
  }

  TemporaryFolder folder_;
  Case of_;
  ExpectedFiles expected_;
  Image8 reference_;
};

TEST_P(ScoreOf, the_reference_and_one_step_more_or_less_is_full_marks) {
  EXPECT_EQ(score(reference_), 1);
  EXPECT_EQ(score(changed([&](int x, int y, int c) { return at(x, y, c) + 1; })), 1);
  EXPECT_EQ(score(changed([&](int x, int y, int c) { return at(x, y, c) + (x + y) % 3 - 1; })), 1);
}

TEST_P(ScoreOf, pictures_that_show_nothing_of_it_is_zero) {
  EXPECT_EQ(score(changed([](int, int, int) { return 0; })), 0) << "black";
  EXPECT_EQ(score(changed([](int, int, int) { return 255; })), 0) << "white";
  EXPECT_EQ(score(changed([&](int, int, int c) { return at(0, 0, c); })), 0) << "the background";
  std::mt19937 random(1);
  EXPECT_EQ(score(changed([&](int, int, int) { return static_cast<int>(random() & 255U); })), 0) << "noise";
  EXPECT_EQ(score("starter"), 0) << "the starter's own";
}

TEST_P(ScoreOf, another_labs_picture_is_zero) {
  for (const Scene& other : kScenes) {
    if (other.lab == std::string(kScenes[GetParam()].lab)) continue;
    draw(other.lab, {{"other", other.look}}, folder_);
    EXPECT_EQ(score("other"), 0) << other.lab;
  }
}

TEST_P(ScoreOf, a_missing_broken_or_wrongly_sized_picture_is_zero) {
  EXPECT_EQ(score("nowhere"), 0);
  EXPECT_TRUE(std::isnan(verdict_of("nowhere").error));
  image::save_png(file("small"), Image8(64, 64, 3));
  EXPECT_EQ(score("small"), 0);
  EXPECT_NE(verdict_of("small").message.find("64x64"), std::string::npos) << verdict_of("small").message;
  write_file(file("broken"), "no picture");
  EXPECT_EQ(score("broken"), 0);
}

TEST_P(ScoreOf, a_mirrored_picture_one_upside_down_half_a_picture_or_one_shifted_by_a_pixel_is_zero) {
  const int last = reference_.width - 1, half = reference_.width / 2;
  EXPECT_EQ(score(changed([&](int x, int y, int c) { return at(last - x, y, c); })), 0) << "mirrored";
  EXPECT_EQ(score(changed([&](int x, int y, int c) { return at(x, last - y, c); })), 0) << "upside down";
  EXPECT_EQ(score(changed([&](int x, int y, int c) { return y < half ? at(x, y, c) : at(0, 0, c); })), 0);
  for (const auto& shift : {std::pair(1, 0), {0, 1}, {-1, 0}})
    EXPECT_EQ(score(changed([&](int x, int y, int c) { return at(x + shift.first, y + shift.second, c); })),
              0)
        << shift.first << shift.second;
}

/// Limit 2: three steps are 1.5 times the limit, five are 2.5 times, nine are 4.5 times, ten are 5 times.
TEST_P(ScoreOf, a_recolored_picture_falls_with_the_steps) {
  for (const auto& [steps, expected] :
       {std::pair(3, 0.4375), {-3, 0.4375}, {5, 0.3125}, {-5, 0.3125}, {9, 0.0625}, {10, 0.0}, {-40, 0.0}})
    EXPECT_NEAR(score(changed([&, by = steps](int x, int y, int c) {
                  const int more = at(x, y, c) + by;
                  return more < 0 || more > 255 ? at(x, y, c) - by : more;
                })),
                expected, 1e-9)
        << steps;
}

INSTANTIATE_TEST_SUITE_P(Scene, ScoreOf, testing::Range(0, 3), [](const testing::TestParamInfo<int>& scene) {
  return std::string(kScenes[scene.param].lab).substr(0, 5);
});

}  // namespace
}  // namespace texel::test
