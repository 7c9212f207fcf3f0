// SPDX-License-Identifier: MIT
// How much each shader program of a batch draws: what decides whether optimising it pays.
#include "../../common/app/batch.hpp"

#include <gtest/gtest.h>

namespace texel::app {
namespace {

enum class Method { nearest, linear };
constexpr params::Item kMethods[] = {{"nearest", "One texel"}, {"linear", "Four texels"}};

class PixelsPerProgram : public testing::Test {
 protected:
  PixelsPerProgram() {
    parameters_.add(method_, {"method", Method::nearest, kMethods, "The filter"});
    parameters_.add(flip_, {"flip", false, "Upside down"});
    parameters_.add(tilt_, {"tilt", 0, -90, 90, "degrees", "How far it leans"});
  }
  void expect(double pixels, const Batch& batch) const {
    EXPECT_DOUBLE_EQ(pixels_per_program(batch, parameters_), pixels);
  }

 private:
  Method method_{};
  bool flip_{};
  float tilt_{};
  params::Set parameters_;
};

TEST_F(PixelsPerProgram, are_all_of_a_turning_model) {
  expect(3 * 64 * 48, {{"a.png", View::color, {64, 48}, {}},
                       {"b.png", View::color, {64, 48}, {{"tilt", "10"}}},
                       {"c.png", View::color, {64, 48}, {{"tilt", "20"}}}});
}

TEST_F(PixelsPerProgram, are_shared_among_methods_toggles_and_views) {
  expect(100 * 100, {{"a.png", View::color, {100, 100}, {}},
                     {"b.png", View::color, {100, 100}, {{"method", "linear"}}},
                     {"c.png", View::color, {100, 100}, {{"flip", "on"}}},
                     {"d.png", View::depth, {100, 100}, {}}});
  // In whichever order they are named.
  expect(2 * 100 * 100, {{"a.png", View::color, {100, 100}, {{"flip", "on"}, {"method", "linear"}}},
                         {"b.png", View::color, {100, 100}, {{"method", "linear"}, {"flip", "on"}}}});
}

TEST_F(PixelsPerProgram, are_none_of_a_vertex_stream) {
  expect(0, {});
  expect(0, {{"a.ply", View::color, {512, 512}, {}}});
  expect(64, {{"a.ply", View::color, {512, 512}, {}}, {"b.pfm", View::depth, {8, 8}, {}}});
}

}  // namespace
}  // namespace texel::app
