// SPDX-License-Identifier: MIT
// Google Benchmark's program; its options apply, --benchmark_filter=obj/ for one kernel alone. Exits with 1
// when a result was wrong and with 2 for wrong usage.
#include "kernels.hpp"

#include <malloc.h>

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
