// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec3.hpp>
#include <utility>

#include "procedural/dual.hpp"

/// Reliefs as functions of the texture coordinate. Heights and (u, v) have the same unit, the texture's
/// width, so that dh/du is the slope of the surface. All repeat on the unit square, and their first
/// derivatives are continuous everywhere. The second derivatives jump where the rounded corner of a brick or
/// plank begins; bump is smooth in all derivatives.
namespace texel::procedural {

enum class HeightField { brick, wood, scales, bump };
/// All of them, by the names of their files in assets/normal_maps.
inline constexpr std::pair<const char*, HeightField> height_fields[] = {{"brick", HeightField::brick},
                                                                        {"wood", HeightField::wood},
                                                                        {"scales", HeightField::scales},
                                                                        {"bump", HeightField::bump}};

/// The height at (u, v) with its exact derivatives by u and v.
Dual height(HeightField field, double u, double v);

/// The unit normal at (u, v) in tangent space: x along +u, y along +v, z out of the surface;
/// normalize(-strength dh/du, -strength dh/dv, 1). Normal maps are baked with strength 1.
glm::dvec3 normal(HeightField field, double u, double v, double strength = 1);

}  // namespace texel::procedural
