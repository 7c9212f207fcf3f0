// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "app/assets.hpp"
#include "mesh/mesh.hpp"
#include "params/set.hpp"

namespace texel::app {

/// The built-in models, for a parameter `model`; the path of an OBJ or PLY file works too.
inline constexpr params::Item kModels[] = {{"cube", "Six faces, each with its own copy of the texture"},
                                           {"sphere", "64 x 32 quads, exact normals"},
                                           {"torus", "96 x 48 quads, exact normals"},
                                           {"ship", "An ocean liner"},
                                           {"gator", "An alligator"},
                                           {"quad", "A square that faces +z"}};

/// Pictures for these, for a parameter `texture`.
inline constexpr params::Item kTextures[] = {{"label_grid", "Cells with letters: shows every flip and swap"},
                                             {"brick", "A brick wall"},
                                             {"wood", "Wooden planks"},
                                             {"scales", "A reptile's scales"},
                                             {"smile", "A face"},
                                             {"checker", "Black and white squares: shows stretch and shear"}};

/// A mesh that is ready to be drawn, and what was repaired in it.
struct Model {
  mesh::Mesh mesh;
  Notes notes;
  bool is_revolution = false;  ///< sphere or torus: mesh::revolution_tangents are exact
};

/// How the built-in shapes are cut into triangles.
struct Tessellation {
  /// Quads along the longer direction of sphere and torus (half as many along the other) and along each side
  /// of a square; 0: 64 on the sphere, 96 on the torus, 1 on quad and cube.
  int segments = 0;
  /// 0 to 1: irregular triangles with exact vertices (mesh::Jitter); at 1 just short of turning one over.
  float jitter = 0;
  bool operator==(const Tessellation&) const = default;
};

/// If float32 has lost the mesh's shape (mesh::lost_shape), says why in the notes and on standard error:
/// the picture is blank, and a snapshot has no panel that would show the notes.
void warn_of_lost_shape(const mesh::Mesh& mesh, const std::string& file, Notes& notes);

/// A built-in model or a file, centred, its farthest vertex at distance 1. Bundled files are meshes (PLY)
/// that the course has read already, so they do not depend on what a student has of the OBJ reader. A file
/// that is named goes through that reader: normals (smooth, by angle) and texture coordinates (box
/// projection) are generated where it has none; its triangles stay as they are. A PLY file is taken as it is.
/// Errors as mesh::load_obj and mesh::parse_ply.
Model load_model(const Assets& assets, const std::string& name, Tessellation tessellation = {});

}  // namespace texel::app
