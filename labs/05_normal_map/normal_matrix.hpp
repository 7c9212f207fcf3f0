// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>

namespace texel::normal_map {

/// The matrix for normals, whose length does not matter. `world_from_object`: the surface's.
glm::mat3 normal_matrix(const glm::mat4& world_from_object);

}  // namespace texel::normal_map
