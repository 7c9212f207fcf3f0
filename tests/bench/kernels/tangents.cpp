// SPDX-License-Identifier: MIT
#include "mesh/tangents.hpp"

#include <functional>

#include "../../support/plain_tangents.hpp"
#include "kernels.hpp"
#include "mesh/normals.hpp"
#include "mesh/primitives.hpp"
#include "mesh/weld.hpp"

namespace texel::bench {
namespace {

using mesh::Mesh;

/// A torus of 500 thousand triangles, its vertices moved at random.
Mesh rough_torus() {
  return mesh::torus(1.0f, 0.4f, 500, 500, {0.5f, 1});
}

/// The same with three vertices for each triangle, which welding has to find.
Mesh soup() {
  return mesh::split(rough_torus());
}

/// Each texture coordinate the same: no triangle has a direction, and all are neighbours.
Mesh degenerate() {
  Mesh torus = rough_torus();
  torus.texcoords.assign(torus.vertex_count(), glm::vec2(0.5f));
  return torus;
}

/// One vertex in the middle with 500 thousand triangles around it.
Mesh fan() {
  Mesh mesh;
  constexpr std::uint32_t count = 500'000;
  mesh.positions = {{0, 0, 0}};
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * i / count;
    mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    mesh.indices.insert(mesh.indices.end(), {0, 1 + i, 1 + (i + 1) % count});
  }
  for (const glm::vec3& p : mesh.positions) mesh.texcoords.emplace_back(p.x, p.y);
  mesh.normals.assign(mesh.vertex_count(), {0, 0, 1});
  return mesh;
}

/// All triangles at the same place, each with vertices of its own.
Mesh heap() {
  Mesh triangle;
  triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.texcoords = {{0, 0}, {1, 0}, {0, 1}};
  triangle.normals.assign(3, {0, 0, 1});
  for (int i = 0; i < 500'000; ++i) triangle.indices.insert(triangle.indices.end(), {0, 1, 2});
  return mesh::split(triangle);
}

Mesh plain(Mesh mesh) {
  mesh::plain_mikktspace(mesh);
  return mesh;
}

Mesh texel(Mesh mesh) {
  compute_tangents(mesh, mesh::TangentMethod::mikktspace);
  return mesh;
}

bool same(const Mesh& a, const Mesh& b) {
  return a.tangents == b.tangents && a.indices == b.indices && a.positions == b.positions;
}

void register_mesh(const std::string& name, Mesh (*make)()) {
  const auto version = [&](const char* end, Mesh (*compute)(Mesh)) {
    const auto measure = [make, compute](benchmark::State& state) {
      const Mesh mesh = make();
      if (!same(compute(mesh), compute == plain ? texel(mesh) : plain(mesh)))
        return wrong_result(state, "other tangents than by the other version");
      for (auto _ : state) {
        state.PauseTiming();
        Mesh copy = mesh;
        state.ResumeTiming();
        benchmark::DoNotOptimize(compute(std::move(copy)));
      }
      state.counters["triangles_per_second"] = benchmark::Counter(
          static_cast<double>(state.iterations()) * static_cast<double>(mesh.triangle_count()),
          benchmark::Counter::kIsRate);
    };
    benchmark::RegisterBenchmark(("tangents/" + name + "/" + end).c_str(), measure)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
  };
  version("texel", texel);
  version("plain", plain);
}

}  // namespace

void register_tangents() {
  register_mesh("torus", rough_torus);
  register_mesh("soup", soup);
  register_mesh("degenerate", degenerate);
  register_mesh("fan", fan);
  register_mesh("heap", heap);
}

}  // namespace texel::bench
