// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

namespace texel::assets {

/// Writes the course's models into `folder` (made when missing): cube, cube_before, cube_split, quad, sphere,
/// torus, ship, gator, and the hard meshes in folder/hard; text OBJ with its materials beside it.
/// Right-handed, y up, inside the unit sphere (but for some hard ones), the same bytes on every run. Throws
/// Error (exit 3) when a file cannot be written.
void make_models(const std::filesystem::path& folder);

}  // namespace texel::assets
