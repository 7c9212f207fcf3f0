// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <glm/vec4.hpp>

/// Colour textures as functions: they give a picture of any size, and the true colour at any point.
namespace texel::procedural {

enum class Texture {
  brick,       ///< a wall that fits HeightField::brick
  wood,        ///< planks that fit HeightField::wood
  scales,      ///< a reptile's skin that fits HeightField::scales
  smile,       ///< a friendly face
  label_grid,  ///< 8 x 8 named cells; A red, B green, C blue, D yellow in the corners; arrows along +s and +t
  checker,     ///< 8 x 8 fields, black in the lower left corner, white beside it
  sine_sweep,  ///< rings whose frequency grows from the middle to 256 a texture width at the corners
  stripes,     ///< 8 waves along s, the same all along t
  noise,       ///< grey clouds
  decal,       ///< a badge with soft edges; alpha 0 around it
  light_map    ///< the grey pool of a spotlight
};
inline constexpr std::array<Texture, 11> textures{Texture::brick,      Texture::wood,       Texture::scales,
                                                  Texture::smile,      Texture::label_grid, Texture::checker,
                                                  Texture::sine_sweep, Texture::stripes,    Texture::noise,
                                                  Texture::decal,      Texture::light_map};

/// The enumerator's name, which is the file's name in assets/textures too.
const char* name(Texture texture);

/// The colour at (u, v), repeating on the unit square: linear-light RGB and straight alpha, each in 0..1. All
/// are opaque except the decal.
glm::dvec4 color(Texture texture, double u, double v);

}  // namespace texel::procedural
