// SPDX-License-Identifier: MIT
// Lab 6: a cube map. A sphere can show one picture, found by two angles, with a seam at the back and a pinch
// at each pole. Or it shows six pictures on the faces of a cube, found by the direction, with neither.
#include <tuple>

#include "app/lab.hpp"
#include "gl/upload.hpp"
#include "mesh/primitives.hpp"
#include "parameters.hpp"
#include "upload_faces.hpp"

namespace texel::cube_map {

struct CubeMap : app::Lab<CubeMapParameters> {
  static constexpr app::View kViews[] = {app::View::color,    app::View::normal, app::View::direction,
                                         app::View::texcoord, app::View::lod,    app::View::depth,
                                         app::View::mask};
  static constexpr app::Info info{6, "cube_map", "Cube map",
                                  "Cover a sphere with six pictures, without seams or poles.", kViews};

  explicit CubeMap(const app::Assets& assets) : assets_(assets) {}

  void draw(const Parameters& p, app::Frame& frame) override {
    gl::MeshBuffers& sphere = spheres_.get(
        {p.rings, p.segments}, [&] { return gl::MeshBuffers(mesh::sphere(p.rings, p.segments)); });
    const glm::mat4 tilted = app::tilt_about_x(p.tilt);

    gl::Program& program = frame.program("06_cube_map/cube_map");
    program.set("clip_from_world", p.camera.clip_from_world(frame.aspect()));
    program.set("world_from_object", tilted * app::turn_about_y(p.turn));
    if (p.mapping == Mapping::cube) {
      gl::bind(0, GL_TEXTURE_CUBE_MAP, cube_map(p));
      set_filter(p.method);
      program.set("cube_map", 0);
    } else {
      gl::bind(0, GL_TEXTURE_2D, pictures_.get(p.picture, [&] {
        return gl::make_texture_2d(assets_.texture(p.picture), image::Encoding::srgb,
                                   {.wrap_s = GL_REPEAT, .wrap_t = GL_CLAMP_TO_EDGE});
      }));
      program.set("color_map", 0);
    }
    sphere.draw_closed(program, glm::length(p.camera.eye()) > 1);
  }

 private:
  /// The pictures on their faces. The worksheet exchanges the sides, and turns each picture upside down.
  const gl::Texture& cube_map(const Parameters& p) {
    const bool mipmapped = p.method == Method::mipmapped;
    const bool worksheet = p.method == Method::worksheet && p.faces == Faces::by_method;
    const bool swap = worksheet || p.faces == Faces::sides_swapped;
    const bool flip = worksheet || p.faces == Faces::upside_down;
    return cube_maps_.get({p.cube_map, swap, flip, mipmapped}, [&] {
      std::array<image::Image8, 6> faces = assets_.cube_map(p.cube_map);
      if (swap) std::swap(faces[0], faces[1]);
      if (flip)
        for (image::Image8& face : faces) face = image::flipped(face);
      gl::Texture texture;
      glBindTexture(GL_TEXTURE_CUBE_MAP, texture.id());
      upload_faces(faces, mipmapped);
      return texture;
    });
  }

  /// How the bound cube map is read between its texels, and whether across the edges of its faces.
  static void set_filter(Method method) {
    const GLenum magnify = method == Method::nearest ? GL_NEAREST : GL_LINEAR;
    const GLenum minify = method == Method::mipmapped                                ? GL_LINEAR_MIPMAP_LINEAR
                          : method == Method::worksheet || method == Method::nearest ? GL_NEAREST
                                                                                     : GL_LINEAR;
    gl::set_sampling(
        GL_TEXTURE_CUBE_MAP,
        {.minify = minify, .magnify = magnify, .wrap_s = GL_CLAMP_TO_EDGE, .wrap_t = GL_CLAMP_TO_EDGE});
    // The worksheet's WebGL 1 cannot filter across the edges.
    if (method == Method::linear_seamless || method == Method::mipmapped)
      glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  }

  const app::Assets& assets_;
  app::Cache<std::pair<int, int>, gl::MeshBuffers> spheres_;
  app::Cache<std::tuple<std::string, bool, bool, bool>, gl::Texture> cube_maps_;
  app::Cache<std::string, gl::Texture> pictures_;
};

}  // namespace texel::cube_map

int main(int argc, char** argv) {
  return texel::app::run<texel::cube_map::CubeMap>(argc, argv);
}
