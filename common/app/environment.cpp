// SPDX-License-Identifier: MIT
#include "app/environment.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <vector>

#include "core/parallel.hpp"
#include "core/stages.hpp"
#include "gl/upload.hpp"
#include "image/color.hpp"
#include "image/cube_faces.hpp"
#include "image/mipmaps.hpp"
#include "mesh/primitives.hpp"

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

/// The picture is 4 times as wide: 8192 texels are read by nearly every OpenGL 3.3, and need 0.2 GB.
constexpr int kLargestSide = 2048;

/// Linear-light RGB of a cube map in a direction: bilinear within one face.
glm::vec3 look_up(const std::array<image::Image8, 6>& faces, const glm::dvec3& direction) {
  const image::FaceCoordinate at = image::face_coordinate(direction);
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

/// The faces, halved as mipmaps are until no side is longer than kLargestSide.
std::array<image::Image8, 6> bounded(std::array<image::Image8, 6> faces) {
  for (image::Image8& face : faces)
    while (face.width > kLargestSide) face = std::move(image::mip_chain(face, image::Encoding::srgb)[1]);
  return faces;
}

/// A picture whose texel at column x and row y shows what lies in direction_of(x, y).
template <class DirectionOf>
image::Image8 resampled(const std::array<image::Image8, 6>& faces, int width, int height,
                        DirectionOf direction_of) {
  const Stage stage("resample");
  image::Image8 result(width, height, 3);
  in_parallel(processors(), static_cast<std::size_t>(height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < width; ++x) {
      const glm::vec3 color = look_up(faces, direction_of(x, y));
      for (int c = 0; c < 3; ++c) result.at(x, y, c) = image::to_encoding8(color[c]);
    }
  });
  return result;
}

/// Sine and cosine of the angles in the middles of `count` equal parts of `whole`.
std::vector<glm::dvec2> sines_and_cosines(int count, double whole) {
  std::vector<glm::dvec2> list;
  for (int i = 0; i < count; ++i) {
    const double angle = whole * ((i + 0.5) / count);
    list.emplace_back(std::sin(angle), std::cos(angle));
  }
  return list;
}

}  // namespace

image::Image8 equirectangular_map(std::array<image::Image8, 6> faces) {
  faces = bounded(std::move(faces));
  const int width = 4 * faces[0].width, height = 2 * faces[0].width;
  const std::vector<glm::dvec2> longitude = sines_and_cosines(width, -2 * glm::pi<double>());
  const std::vector<glm::dvec2> from_pole = sines_and_cosines(height, glm::pi<double>());
  return resampled(faces, width, height, [&](int x, int y) {
    const glm::dvec2 &along = longitude[static_cast<std::size_t>(x)],
                     &down = from_pole[static_cast<std::size_t>(y)];
    return glm::dvec3(down.x * along.x, down.y, down.x * along.y);
  });
}

image::Image8 sphere_map(std::array<image::Image8, 6> faces) {
  faces = bounded(std::move(faces));
  const int side = 2 * faces[0].width;
  return resampled(faces, side, side, [side](int x, int y) {
    glm::dvec2 on_ball(2 * ((x + 0.5) / side) - 1, 2 * ((y + 0.5) / side) - 1);
    const double radius = glm::length(on_ball);
    if (radius > 1) on_ball /= radius;
    const glm::dvec3 normal(on_ball, std::sqrt(std::max(1 - glm::dot(on_ball, on_ball), 0.0)));
    return glm::reflect(glm::dvec3(0, 0, -1), normal);
  });
}

}  // namespace texel::app
