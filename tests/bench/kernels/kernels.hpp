// SPDX-License-Identifier: MIT
// The kernels' benchmarks. Each is registered as <kernel>/<input>/<version>, so that the ratio of two
// versions is that of two results whose names differ at the end.
#pragma once
#include <benchmark/benchmark.h>

#include <string>

namespace texel::bench {

/// Registers obj/<file>/{texel,texel_mesh,tinyobjloader}: from a file on disk to the parsed lists, ours to
/// the finished mesh too. Counters: triangles and bytes a second.
void register_obj();

/// Registers tangents/<mesh>/{texel,plain}: MikkTSpace's rules. Counter: triangles a second.
void register_tangents();

/// Registers flip/<size>/{texel,plain,plain_square}. Counter: megapixels a second.
void register_flip();

/// Stops a benchmark whose result is wrong, and has the program end with exit code 1.
void wrong_result(benchmark::State& state, const std::string& what);

}  // namespace texel::bench
