// SPDX-License-Identifier: MIT
// obj_peak [FILE.obj]: loads a file (else a torus of 2 million triangles, 130 MB) into a finished mesh in a
// fresh process, and prints the peak of its resident memory beside the mesh's and the file's size, as JSON.
#include <fmt/format.h>

#include <fstream>
#include <span>
#include <string>

#include "core/error.hpp"
#include "core/files.hpp"
#include "mesh/obj.hpp"
#include "mesh/weld.hpp"
#include "torus_file.hpp"

namespace {

/// The most memory that was resident so far, in bytes, with the pages of mapped files.
std::uint64_t peak_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (std::uint64_t kibibytes = 0; word == "VmHWM:" && status >> kibibytes) return 1024 * kibibytes;
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2) {
    fmt::print(stderr, "usage: obj_peak [FILE.obj]\n");
    return 2;
  }
  try {
    const texel::ScratchFolder folder;
    std::filesystem::path path = argc == 2 ? std::filesystem::path(argv[1]) : folder.path() / "torus.obj";
    if (argc == 1) texel::bench::write_torus(path, 1000, 1000);
    const std::uint64_t before = peak_bytes();
    const texel::mesh::Mesh mesh = texel::mesh::weld(texel::mesh::load_obj(path));
    const std::uint64_t peak = peak_bytes(), file = std::filesystem::file_size(path);
    std::uint64_t own = std::span(mesh.indices).size_bytes();
    texel::mesh::for_each_attribute(mesh, [&](const auto& list) { own += std::span(list).size_bytes(); });
    fmt::print(R"({{"file_bytes": {}, "mesh_bytes": {}, "triangles": {}, "vertices": {}, )", file, own,
               mesh.triangle_count(), mesh.vertex_count());
    fmt::print(R"("peak_before_bytes": {}, "peak_bytes": {}, "meshes_beside_the_file": {:.3f}, "limit": 2}})"
               "\n",
               before, peak,
               (static_cast<double>(peak) - static_cast<double>(file)) / static_cast<double>(own));
  } catch (const texel::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 3;
  }
  return 0;
}
