// SPDX-License-Identifier: MIT
// Google Benchmark's program; its options apply, --benchmark_filter=obj/ for one kernel alone. Exits with 1
// when a result was wrong and with 2 for wrong usage.
#include "kernels.hpp"

#include <malloc.h>

namespace texel::bench {
namespace {
bool any_wrong = false;
}

void wrong_result(benchmark::State& state, const std::string& what) {
  any_wrong = true;
  state.SkipWithError(what.c_str());
}

void set_triangles(benchmark::State& state, std::size_t triangles) {
  const auto count = static_cast<double>(triangles);
  state.counters["triangles"] = count;
  state.counters["triangles_per_second"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * count, benchmark::Counter::kIsRate);
}

}  // namespace texel::bench

int main(int argc, char** argv) {
  // What a repetition has freed the next one gets: the method is measured, not how fast the system clears new
  // pages, which is half of the time for the heap of 4 million triangles, and nothing for small meshes.
  ::mallopt(M_MMAP_MAX, 0);
  ::mallopt(M_TRIM_THRESHOLD, -1);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  texel::bench::register_obj();
  texel::bench::register_tangents();
  texel::bench::register_flip();
  benchmark::RunSpecifiedBenchmarks();
  return texel::bench::any_wrong ? 1 : 0;
}
