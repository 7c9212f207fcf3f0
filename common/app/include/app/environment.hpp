// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <string>

#include "app/lab.hpp"
#include "image/image.hpp"

namespace texel::app {

/// The bundled cube maps, for a parameter `cube_map`; the path of a folder of six files works too.
inline constexpr params::Item kCubeMaps[] = {
    {"scene", "A landscape with mountains, a lake, a village and the sun"},
    {"labelled", "Each face with its name and the directions of u and v: shows every flip and swap"},
    {"smooth", "Colours that change smoothly over all directions: shows every edge"}};

/// A cube map around a scene, read in the best way (lab 6) and drawn in the best way (lab 7).
class Environment {
 public:
  explicit Environment(const Assets& assets);

  /// Binds the cube map of that name to a texture unit: mipmapped, filtered across the edges of its faces.
  void bind(int unit, const std::string& cube_map);
  /// Draws the cube map on `unit` wherever the frame is still empty. Data views show only the objects: there
  /// it does nothing. Another program is in use afterwards, and the depth test is less-or-equal.
  void draw_background(Frame& frame, const OrbitCamera& camera, int unit);

 private:
  const Assets& assets_;
  Cache<std::string, gl::Texture> cube_maps_;
  gl::MeshBuffers quad_;
};

/// Sets the camera's uniforms for shaders/lib/view_ray.glsl.
void set_view_ray(gl::Program& program, const OrbitCamera& camera, const Frame& frame);

/// A cube map (faces as Assets::cube_map gives them) as one picture with 4 x 2 times the side of
/// a face: u and v as shaders/lib/sphere_coordinates.glsl has them, row 0 at v = 0. Bilinear, in linear
/// light. Faces of more than 2048 texels a side are halved first, to bound time and memory.
image::Image8 equirectangular_map(std::array<image::Image8, 6> faces);

/// The same as a picture of a mirror ball, seen from far away on the +z axis: a square of twice the side
/// of a face, row 0 at the bottom. The corners outside the ball repeat the rim, which shows -z all around.
/// Source: OpenGL 2.1 specification, section 2.11.4, GL_SPHERE_MAP, in world space.
image::Image8 sphere_map(std::array<image::Image8, 6> faces);

}  // namespace texel::app
