// SPDX-License-Identifier: MIT
#include "mesh/obj.hpp"

#include <tiny_obj_loader.h>

#include "core/files.hpp"
#include "kernels.hpp"
#include "mesh/weld.hpp"
#include "torus_file.hpp"

namespace texel::bench {
namespace {

using Path = std::filesystem::path;

/// A file of this process's scratch folder, written when it is first asked for.
Path torus_file(const std::string& name, int segments, int sides, bool quads) {
  static const ScratchFolder folder;
  Path path = folder.path() / (name + ".obj");
  if (!std::filesystem::exists(path)) write_torus(path, segments, sides, quads);
  return path;
}

std::size_t load_texel(const Path& path) {
  return mesh::load_obj(path).triangle_count();
}

std::size_t load_texel_mesh(const Path& path) {
  return mesh::weld(mesh::load_obj(path)).triangle_count();
}

std::size_t load_tinyobjloader(const Path& path) {
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  const std::string folder = path.parent_path().string();
  if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, path.c_str(), folder.c_str()))
    return 0;
  std::size_t corners = 0;
  for (const tinyobj::shape_t& shape : shapes) corners += shape.mesh.indices.size();
  return corners / 3;
}

using Load = std::size_t (*)(const Path&);

void register_load(const std::string& name, const std::function<Path()>& path, Load load) {
  const auto measure = [path, load](benchmark::State& state) {
    const Path file = path();
    const std::size_t expected = load_texel(file);
    for (auto _ : state) {
      if (load(file) != expected) return wrong_result(state, "another number of triangles");
    }
    set_triangles(state, expected);
    state.counters["bytes_per_second"] = benchmark::Counter(
        static_cast<double>(state.iterations()) * static_cast<double>(std::filesystem::file_size(file)),
        benchmark::Counter::kIsRate);
  };
  benchmark::RegisterBenchmark(name.c_str(), measure)->Unit(benchmark::kMillisecond)->UseRealTime();
}

void register_file(const std::string& name, const std::function<Path()>& path) {
  register_load("obj/" + name + "/texel", path, load_texel);
  register_load("obj/" + name + "/texel_mesh", path, load_texel_mesh);
  register_load("obj/" + name + "/tinyobjloader", path, load_tinyobjloader);
}

}  // namespace

void register_obj() {
  for (const char* name : {"cube", "torus", "gator"})
    register_file(name, [=] { return Path(TEXEL_SOURCE) / "assets/models" / (std::string(name) + ".obj"); });
  const auto quads_2m = [] { return torus_file("quads_2m", 1000, 1000, true); };           // 130 MB
  const auto triangles_2m = [] { return torus_file("triangles_2m", 1000, 1000, false); };  // 170 MB
  const auto quads_10m = [] { return torus_file("quads_10m", 2500, 2000, true); };         // 700 MB
  register_file("quads_2m", quads_2m);
  register_file("triangles_2m", triangles_2m);
  register_load("growth/obj/small", quads_2m, load_texel_mesh);
  register_load("growth/obj/large", quads_10m, load_texel_mesh);
}

}  // namespace texel::bench
