// SPDX-License-Identifier: MIT
#include "app/environment.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "gl/make_cube_map.hpp"
#include "gl/upload.hpp"
#include "image/colour.hpp"
#include "mesh/primitives.hpp"
#include "procedural/cube.hpp"

namespace texel::app {

Environment::Environment(const Assets& assets) : assets_(assets), quad_(mesh::quad(1.0F)) {}

void Environment::bind(int unit, const std::string& cube_map) {
  gl::bind(unit, GL_TEXTURE_CUBE_MAP, cube_maps_.get(cube_map, [&] {
    return gl::make_cube_map(assets_.cube_map(cube_map), image::Encoding::srgb,
                             {.wrap_s = GL_CLAMP_TO_EDGE, .wrap_t = GL_CLAMP_TO_EDGE});
  }));
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

void set_view_ray(gl::Program& program, const OrbitCamera& camera, const Frame& frame) {
  program.set("world_from_view", glm::transpose(glm::mat3(camera.view_from_world())));
  program.set("aspect", frame.aspect());
}

void Environment::draw_background(Frame& frame, const OrbitCamera& camera, int unit) {
  if (frame.view() != View::color) return;
  gl::Program& program = frame.program("app/background");
  set_view_ray(program, camera, frame);
  program.set("cube_map", unit);
  glDepthFunc(GL_LEQUAL);  // the quad lies exactly where the cleared depth buffer says "nothing yet"
  quad_.draw(program);
}

namespace {

/// Linear-light RGB of a cube map in a direction: bilinear within one face.
glm::vec3 look_up(const std::array<image::Image8, 6>& faces, const glm::dvec3& direction) {
  const procedural::FaceCoordinate at = procedural::face_coordinate(direction);
  const image::Image8& face = faces[static_cast<std::size_t>(at.face)];
  const auto last = static_cast<double>(face.width - 1);
  const double x = std::clamp(at.s * face.width - 0.5, 0.0, last);
  const double y = std::clamp(at.t * face.width - 0.5, 0.0, last);
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, face.width - 1), y1 = std::min(y0 + 1, face.width - 1);
  const auto texel = [&](int i, int j) {
    return glm::vec3(image::from_encoding8(face.at(i, j, 0)), image::from_encoding8(face.at(i, j, 1)),
                     image::from_encoding8(face.at(i, j, 2)));
  };
  const auto fx = static_cast<float>(x - x0), fy = static_cast<float>(y - y0);
  return glm::mix(glm::mix(texel(x0, y0), texel(x1, y0), fx), glm::mix(texel(x0, y1), texel(x1, y1), fx), fy);
}

/// A picture whose texel at (u, v), both 0..1 with v = 0 in row 0, shows what lies in direction_of(u, v).
template <class DirectionOf>
image::Image8 resampled(const std::array<image::Image8, 6>& faces, int width, int height,
                        DirectionOf direction_of) {
  image::Image8 result(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const glm::vec3 colour = look_up(faces, direction_of((x + 0.5) / width, (y + 0.5) / height));
      for (int c = 0; c < 3; ++c) result.at(x, y, c) = image::to_encoding8(colour[c]);
    }
  return result;
}

}  // namespace

image::Image8 equirectangular_map(const std::array<image::Image8, 6>& faces) {
  const int side = faces[0].width;
  return resampled(faces, 4 * side, 2 * side, [](double u, double v) {
    const double longitude = -2 * glm::pi<double>() * u, from_pole = glm::pi<double>() * v;
    return glm::dvec3(std::sin(from_pole) * std::sin(longitude), std::cos(from_pole),
                      std::sin(from_pole) * std::cos(longitude));
  });
}

image::Image8 sphere_map(const std::array<image::Image8, 6>& faces) {
  const int side = 2 * faces[0].width;
  return resampled(faces, side, side, [](double u, double v) {
    glm::dvec2 on_ball(2 * u - 1, 2 * v - 1);
    const double radius = glm::length(on_ball);
    if (radius > 1) on_ball /= radius;
    const glm::dvec3 normal(on_ball, std::sqrt(std::max(1 - glm::dot(on_ball, on_ball), 0.0)));
    return glm::reflect(glm::dvec3(0, 0, -1), normal);
  });
}

}  // namespace texel::app
