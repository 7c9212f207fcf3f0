// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/assets.hpp"
#include "app/notes.hpp"
#include "mesh/mesh.hpp"
#include "params/set.hpp"

namespace texel::app {

/// The built-in models, for a parameter `model`; a path to an OBJ file is taken as well.
inline constexpr params::Item kModels[] = {{"cube", "Six faces, each with its own copy of the texture"},
                                           {"sphere", "64 x 32 quads, exact normals"},
                                           {"torus", "96 x 48 quads, exact normals"},
                                           {"ship", "An ocean liner"},
                                           {"gator", "An alligator"},
                                           {"quad", "A square that faces +z"}};

/// A mesh that is ready to be drawn, and what was mended on the way.
struct Model {
  mesh::Mesh mesh;
  Notes notes;
  bool is_revolution = false;  ///< sphere or torus: mesh::revolution_tangents are exact
};

/// A built-in model or an OBJ file, centred, its farthest vertex at distance 1. Normals (smooth, by angle)
/// and texture coordinates (box projection) are generated where the file has none. Errors as mesh::load_obj.
Model load_model(const Assets& assets, const std::string& name);

}  // namespace texel::app
