// SPDX-License-Identifier: MIT
// The kernels' benchmarks. Each is registered as <kernel>/<input>/<version>, so that the ratio of two
// versions is that of two results whose names differ at the end; growth/<kernel>/{small,large} is the same
// work on more triangles.
#pragma once
#include <benchmark/benchmark.h>

#include <string>

namespace texel::bench {

/// Registers obj/<file>/{texel,texel_mesh,tinyobjloader}: from a file on disk to the parsed lists, ours to
/// the finished mesh too; and growth/obj, to the finished mesh. Counters: set_triangles, and bytes a second.
void register_obj();

/// Registers tangents/<mesh>/{texel,plain}: MikkTSpace's rules; and growth/tangents of <mesh>. Counters:
/// set_triangles.
void register_tangents();

/// Registers flip/<size>/{texel,plain}. Counter: megapixels a second.
void register_flip();

/// The counters `triangles`, of one iteration, and `triangles_per_second`.
inline void set_triangles(benchmark::State& state, std::size_t triangles) {
  const auto count = static_cast<double>(triangles);
  state.counters["triangles"] = count;
  state.counters["triangles_per_second"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * count, benchmark::Counter::kIsRate);
}

inline bool any_wrong = false;

/// Stops a benchmark whose result is wrong, and has the program end with exit code 1.
inline void wrong_result(benchmark::State& state, const std::string& what) {
  any_wrong = true;
  state.SkipWithError(what.c_str());
}

}  // namespace texel::bench
