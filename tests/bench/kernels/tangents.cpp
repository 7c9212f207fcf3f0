// SPDX-License-Identifier: MIT
#include "mesh/tangents.hpp"

#include <fmt/format.h>

#include "../../support/plain_tangents.hpp"
#include "kernels.hpp"
#include "mesh/normals.hpp"
#include "mesh/primitives.hpp"
#include "mesh/weld.hpp"

namespace texel::bench {
namespace {

using mesh::Mesh;

/// A torus, its vertices moved at random.
Mesh rough_torus(std::size_t triangles) {
  const int side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(triangles) / 2)));
  return mesh::torus(1.0F, 0.4F, side, side, {0.5F, 1});
}

/// The same with three vertices for each triangle, which welding has to find.
Mesh soup(std::size_t triangles) {
  return mesh::split(rough_torus(triangles));
}

/// Each texture coordinate the same: no triangle has a direction, and all are neighbours.
Mesh degenerate(std::size_t triangles) {
  Mesh torus = rough_torus(triangles);
  torus.texcoords.assign(torus.vertex_count(), glm::vec2(0.5F));
  return torus;
}

/// One vertex in the middle and all triangles around it.
Mesh fan(std::size_t triangles) {
  Mesh mesh;
  const auto count = static_cast<std::uint32_t>(triangles);
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
Mesh heap(std::size_t triangles) {
  Mesh triangle;
  triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.texcoords = {{0, 0}, {1, 0}, {0, 1}};
  triangle.normals.assign(3, {0, 0, 1});
  for (std::size_t i = 0; i < triangles; ++i) triangle.indices.insert(triangle.indices.end(), {0, 1, 2});
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

using Make = Mesh (*)(std::size_t triangles);
using Compute = Mesh (*)(Mesh);

/// Held to the result of `other` before it is measured, where there is one.
void register_tangents_of(const std::string& name, Make make, std::size_t triangles, Compute compute,
                          Compute other) {
  const auto measure = [=](benchmark::State& state) {
    const Mesh mesh = make(triangles);
    if (other != nullptr) {
      const Mesh a = compute(mesh), b = other(mesh);
      if (a.tangents != b.tangents || a.indices != b.indices || a.positions != b.positions)
        return wrong_result(state, "other tangents than by the other version");
    }
    for (auto _ : state) {
      state.PauseTiming();
      Mesh copy = mesh;
      state.ResumeTiming();
      benchmark::DoNotOptimize(compute(std::move(copy)));
    }
    set_triangles(state, mesh.triangle_count());
  };
  benchmark::RegisterBenchmark(name.c_str(), measure)->Unit(benchmark::kMillisecond)->UseRealTime();
}

}  // namespace

void register_tangents() {
  constexpr std::size_t few = 500'000, many = 4'000'000;
  const std::pair<const char*, Make> meshes[] = {
      {"torus", rough_torus}, {"soup", soup}, {"degenerate", degenerate}, {"fan", fan}, {"heap", heap}};
  for (const auto& [name, make] : meshes) {
    register_tangents_of(fmt::format("tangents/{}/texel", name), make, few, texel, plain);
    register_tangents_of(fmt::format("tangents/{}/plain", name), make, few, plain, texel);
    register_tangents_of(fmt::format("growth/tangents of {}/small", name), make, few, texel, nullptr);
    register_tangents_of(fmt::format("growth/tangents of {}/large", name), make, many, texel, nullptr);
  }
}

}  // namespace texel::bench
