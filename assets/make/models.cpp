// SPDX-License-Identifier: MIT
#include "models.hpp"

#include "core/files.hpp"
#include "models_list.hpp"

namespace texel::assets {

void make_models(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder / "hard");
  const auto write = [&](const std::string& name, const std::string& text) {
    write_file(folder / name, text);
  };
  write("quad.obj", quad());
  write("cube.obj", cube(CubeTexcoords::stretched));
  write("cube_before.obj", cube(CubeTexcoords::before));
  write("cube_split.obj", cube_split());
  write("sphere.obj", sphere());
  write("torus.obj", torus());
  write("ship.obj", ship());
  write("ship.mtl", ship_materials());
  write("gator.obj", gator());
  write("gator.mtl", gator_materials());
  for (const auto& [name, text] : hard_models()) write("hard/" + name + ".obj", text);
}

}  // namespace texel::assets
