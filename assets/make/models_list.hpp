// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

/// The text of each model; `make_models` writes them under their names.
namespace texel::assets {

/// The two tables of one texture coordinate for each of the cube's eight vertices.
enum class CubeTexcoords { before, stretched };

std::string quad();
std::string cube(CubeTexcoords texcoords);
std::string cube_split();
std::string sphere();
std::string torus();

std::string ship();
std::string ship_materials();
std::string gator();
std::string gator_materials();

struct NamedText {
  std::string name, text;
};
/// Small meshes, each hard for something that its own comment names.
std::vector<NamedText> hard_models();

}  // namespace texel::assets
