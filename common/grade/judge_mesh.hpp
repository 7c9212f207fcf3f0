// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "grade/judge.hpp"

namespace texel::grade {

/// Judges a vertex stream in a .ply file. Vertices are matched by position and texture coordinate, so that
/// their order does not matter; what is compared are their normals and tangents, and the sum of the angles
/// of the triangles around them, each with its triangle's direction, which is the same however a flat polygon
/// was cut. `limit` is in degrees. A number of vertices other than the reference's fails.
Verdict judge_mesh(double limit, const std::filesystem::path& reference,
                   const std::vector<std::filesystem::path>& worthless, const std::filesystem::path& picture);

}  // namespace texel::grade
