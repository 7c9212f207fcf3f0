// SPDX-License-Identifier: MIT
#include "perception/perception.hpp"

#include <cmath>

#include "../../support/flip_pictures.hpp"
#include "../../support/plain_flip.hpp"
#include "kernels.hpp"

namespace texel::bench {
namespace {

using image::Image8;

std::vector<double> texel(const Image8& a, const Image8& b) {
  const image::ImageF errors = perception::flip_errors(a, b);
  return {errors.samples.begin(), errors.samples.end()};
}

void register_size(int width, int height) {
  const auto version = [&](const char* end, std::vector<double> (*compute)(const Image8&, const Image8&)) {
    const auto measure = [=](benchmark::State& state) {
      const Image8 a = image::scene(width, height), b = image::scene(width, height, 1);
      const std::vector<double> ours = texel(a, b), theirs = perception::plain_flip(a, b);
      for (std::size_t i = 0; i < ours.size(); ++i)
        if (std::abs(ours[i] - theirs[i]) > 1e-4) return wrong_result(state, "further than 1e-4 from plain");
      for (auto _ : state) benchmark::DoNotOptimize(compute(a, b));
      state.counters["megapixels_per_second"] = benchmark::Counter(
          1e-6 * width * height * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
    };
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    benchmark::RegisterBenchmark(("flip/" + size + "/" + end).c_str(), measure)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
  };
  version("texel", texel);
  version("plain", perception::plain_flip);
}

}  // namespace

void register_flip() {
  register_size(64, 64);
  register_size(512, 512);
  register_size(1920, 1080);
}

}  // namespace texel::bench
