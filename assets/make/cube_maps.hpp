// SPDX-License-Identifier: MIT
#pragma once
#include "progress.hpp"

namespace texel::assets {

/// Writes folder/cube_maps/<name>/{px,nx,py,ny,pz,nz}.png for labelled, smooth and scene. Each file's first
/// (top) row is t = 0 of the face: what is to be uploaded first, as the OpenGL specification lays faces out.
void make_cube_maps(const std::filesystem::path& folder, const Progress& progress);

}  // namespace texel::assets
