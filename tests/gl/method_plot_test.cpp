// SPDX-License-Identifier: MIT
// Error and cost of a lab's methods, as the window measures them: the right figures for each, anew for
// another look.
#include "bench/method_plot.hpp"
#include "answers/answer.hpp"
#include "bench/bench.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "core/files.hpp"

namespace texel::bench {
namespace {

enum class Method { right, two_off, not_finite };
constexpr params::Item kMethods[] = {{"right", "The level"}, {"two-off", "Two more"}, {"not-finite", "NaN"}};

struct LevelParameters {
  Method method{};
  float level{};
  void declare(params::Set& set) {
    set.add(method, {"method", Method::two_off, kMethods, "How it is found"});
    set.add(level, {"level", 1, 0, 10, "", "Everywhere; above 9 there is no right answer"});
  }
};
/// Fills the picture with a level of detail.
struct Level : app::Lab<LevelParameters> {
  static constexpr app::View kViews[] = {app::View::color, app::View::lod};
  static constexpr app::Info info{1, "level", "Level", "One level.", kViews};
  explicit Level(const app::Assets&) {}
  void draw(const Parameters& p, app::Frame&) override {
    ++draws;
    const float wrong = p.method == Method::not_finite ? std::numeric_limits<float>::quiet_NaN() : 2;
    glClearColor(p.method == Method::right ? p.level : p.level + wrong, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
  }
  static inline int draws = 0;
};
struct LevelAnswer final : answers::Answer<LevelParameters> {
  [[nodiscard]] app::Measure measure(const LevelParameters& /*parameters*/) const override {
    return {app::View::lod, app::Unit::levels, "the level"};
  }
  [[nodiscard]] answers::Truth truth(const LevelParameters& p, glm::ivec2 /*size*/) const override {
    if (p.level > 9) return {};
    return [level = p.level](glm::dvec2) { return glm::dvec3(level, 0, 0); };
  }
};
const bool known = answers::know<LevelParameters, LevelAnswer>();

class MethodPlots : public testing::Test {
 protected:
  static void finish(MethodPlot& plot, glm::ivec2 size) {
    for (int i = 0; i < 10'000 && plot.share() < 1 && plot.fault().empty(); ++i) plot.measure_next(size);
  }
  struct Root : ScratchFolder {
    Root() {
      for (const char* folder : {"assets", "shaders"}) std::filesystem::create_directories(path() / folder);
    }
  } root_;
  std::unique_ptr<gl::Context> context_ = gl::create_headless();
  const app::Assets assets_{root_.path()};
  app::LabOf<Level> lab_;
  MethodPlot plot_{*context_, assets_, lab_};
};

TEST_F(MethodPlots, have_error_and_cost_of_each_method) {
  ASSERT_TRUE(MethodPlot::is_for(lab_));
  finish(plot_, {640, 320});
  EXPECT_EQ(plot_.size(), glm::ivec2(512, 256)) << "the picture's shape";
  ASSERT_EQ(plot_.points().size(), 3U);
  // Small whole numbers are exact in a float picture.
  EXPECT_EQ(plot_.points()[0].error.mean, 0);
  EXPECT_EQ(plot_.points()[1].error.mean, 2);
  EXPECT_EQ(plot_.points()[2].error.non_finite, 512 * 256);
  for (const MethodPlot::Point& point : plot_.points()) {
    EXPECT_TRUE(point.has_error);
    EXPECT_GT(point.milliseconds, 0);
    EXPECT_EQ(point.frame_ns.size(), static_cast<std::size_t>(MethodPlot::kRounds));
  }
  EXPECT_EQ(lab_.parameters().at("method").text(), "two-off") << "the parameters stay as they are";
}

TEST_F(MethodPlots, are_measured_again_for_another_look_only) {
  finish(plot_, {640, 320});
  const int before = Level::draws;
  lab_.parameters().at("method").set("right");
  plot_.measure_next({640, 320});
  EXPECT_EQ(Level::draws, before) << "another method is no other look";
  lab_.parameters().at("level").set("3");
  plot_.measure_next({640, 320});
  EXPECT_LT(plot_.share(), 1);
  EXPECT_GT(plot_.points()[2].milliseconds, 0) << "what was known is still there";
  EXPECT_FALSE(plot_.points()[2].has_error);
  finish(plot_, {640, 320});
  EXPECT_EQ(plot_.points()[0].error.mean, 0);
  plot_.forget();
  plot_.measure_next({640, 320});
  EXPECT_LT(plot_.share(), 1) << "shaders or files have changed";
}

TEST_F(MethodPlots, say_why_there_is_nothing_to_measure) {
  lab_.parameters().at("level").set("10");
  plot_.measure_next({640, 320});
  EXPECT_NE(plot_.fault().find("no exact answer"), std::string::npos);
  EXPECT_EQ(lab_.parameters().at("method").text(), "two-off");
  lab_.parameters().at("level").set("1");
  plot_.measure_next({640, 320});
  EXPECT_EQ(plot_.fault(), "");
}

TEST(Bench, is_what_the_list_says) {
  const BenchList read = parse_bench(
      R"({"seconds": 0.5, "cases": [{"case": "jittered torus", "size": "32x16", "set": {"model": "torus"},
          "vary": {"method": [], "segments": [8, "16"]}}]})");
  EXPECT_EQ(read.seconds, 0.5);
  ASSERT_EQ(read.cases.size(), 1U);
  EXPECT_EQ(read.cases[0].name, "jittered torus");
  EXPECT_EQ(read.cases[0].size, (course::Size{32, 16}));
  EXPECT_EQ(read.cases[0].settings, (std::vector<course::Setting>{{"model", "torus"}}));
  EXPECT_EQ(read.cases[0].variations, (std::vector<Variation>{{"method", {}}, {"segments", {"8", "16"}}}));
}

}  // namespace
}  // namespace texel::bench
