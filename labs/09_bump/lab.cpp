// SPDX-License-Identifier: MIT
// Lab 9: a bumpy mirror ball. A normal map bends the normals, and with them what the mirror shows. A sphere
// has no given tangents: each pixel builds its frame from the normal alone, in one of seven ways. That is
// done in shaders/09_bump/frame.glsl; here is what the shaders get.
#include "app/lab.hpp"
#include "app/environment.hpp"
#include "gl/upload.hpp"
#include "mesh/primitives.hpp"
#include "parameters.hpp"

namespace texel::bump {

struct Bump : app::Lab<BumpParameters> {
  static constexpr app::View kViews[] = {app::View::color,     app::View::normal,   app::View::tangent,
                                         app::View::direction, app::View::texcoord, app::View::depth,
                                         app::View::mask};
  static constexpr app::Info info{9, "bump", "Bump mapping",
                                  "Bend the mirror ball's normals with a normal map.", kViews};

  explicit Bump(const app::Assets& assets) : assets_(assets), environment_(assets) {}

  void draw(const Parameters& p, app::Frame& frame) override {
    gl::MeshBuffers& ball =
        balls_.get({p.rings, p.segments}, [&] { return gl::MeshBuffers(mesh::sphere(p.rings, p.segments)); });
    const glm::mat4 tilted = app::tilt_about_x(p.tilt);

    environment_.bind(0, p.cube_map);
    gl::Program& program = frame.program("09_bump/bump");
    program.set("clip_from_world", p.camera.clip_from_world(frame.aspect()));
    program.set("world_from_object", tilted * app::turn_about_y(p.turn));
    program.set("eye", p.camera.eye());
    program.set("cube_map", 0);
    if (p.normal_mapping) {
      // Numbers, not colours: stored linear, and nothing is decoded. Unit 0 has the cube map.
      gl::bind(1, GL_TEXTURE_2D, normal_maps_.get({p.normal_map, p.mip_filter == MipFilter::none}, [&] {
        return gl::make_texture_2d(
            assets_.normal_map(p.normal_map), image::Encoding::linear,
            {.minify =
                 p.mip_filter == MipFilter::none ? GLenum{GL_LINEAR} : GLenum{GL_LINEAR_MIPMAP_LINEAR}});
      }));
      program.set("normal_map", 1);
    }
    ball.draw_closed(program, glm::length(p.camera.eye()) > 1);
    environment_.draw_background(frame, p.camera, 0);
  }

 private:
  const app::Assets& assets_;
  app::Environment environment_;
  app::Cache<std::pair<int, int>, gl::MeshBuffers> balls_;
  app::Cache<std::pair<std::string, bool>, gl::Texture> normal_maps_;
};

}  // namespace texel::bump

int main(int argc, char** argv) {
  return texel::app::run<texel::bump::Bump>(argc, argv);
}
