// SPDX-License-Identifier: MIT
#pragma once
#include "core/parallel.hpp"
#include "mesh/tangents.hpp"

namespace texel::mesh {

/// TangentMethod::mikktspace for compute_tangents, which has looked at the mesh and chosen the number of
/// threads.
void mikktspace(Mesh& mesh, unsigned threads);

/// Calls `act` with 0 to count - 1; each thread has a run of neighbours.
template <class Act>
void in_runs(unsigned threads, std::size_t count, Act act) {
  in_parallel(threads, threads, [&](std::size_t part) {
    const std::size_t end = count * (part + 1) / threads;
    for (std::size_t i = count * part / threads; i < end; ++i) act(i);
  });
}

}  // namespace texel::mesh
