// SPDX-License-Identifier: MIT
// Lab 8: a mirror ball. The ray from the eye is reflected at the surface, and its direction is looked up in
// the cube map. The task is to get the ray and the normal right. Glass then needs only a second ray.
#include <glm/gtc/matrix_transform.hpp>

#include "app/environment.hpp"
#include "app/lab.hpp"
#include "gl/upload.hpp"
#include "mesh/primitives.hpp"
#include "parameters.hpp"

namespace texel::reflection {

struct Reflection : app::Lab<ReflectionParameters> {
  static constexpr app::View kViews[] = {app::View::color, app::View::normal, app::View::direction,
                                         app::View::depth, app::View::mask};
  static constexpr app::Info info{8, "reflection", "Reflection",
                                  "Make the sphere a mirror, then glass, by following one ray.", kViews};

  explicit Reflection(const app::Assets& assets) : assets_(assets), environment_(assets) {}

  void draw(const Parameters& p, app::Frame& frame) override {
    gl::MeshBuffers& ball =
        balls_.get({p.rings, p.segments}, [&] { return gl::MeshBuffers(mesh::sphere(p.rings, p.segments)); });
    const glm::mat4 tilted = app::tilt_about_x(p.tilt);
    const glm::mat4 turned = app::turn_about_y(p.turn) * tilted;
    const glm::mat4 world_from_object = glm::scale(turned, glm::vec3(1, p.stretch, 1));
    const glm::mat4 object_from_world = glm::inverse(world_from_object);
    const glm::vec3 eye_in_object = object_from_world * glm::vec4(p.camera.eye(), 1);
    // Normals do not move like points when the ball is stretched (lab 5): they turn away from the axis while
    // its edges turn towards it.
    const float along_y = p.normal_matrix == NormalMatrix::inverse_transpose ? 1 / p.stretch : p.stretch;
    const glm::mat3 normal_from_object(glm::scale(turned, glm::vec3(1, along_y, 1)));

    environment_.bind(0, p.cube_map);
    gl::Program& program = frame.program("08_reflection/reflection");
    program.set("clip_from_world", p.camera.clip_from_world(frame.aspect()));
    program.set("world_from_object", world_from_object);
    program.set("object_from_world", object_from_world);
    program.set("normal_from_object", normal_from_object);
    program.set("eye", p.camera.eye());
    program.set("eye_inside", glm::length(eye_in_object) <= 1);
    if (p.lookup == Lookup::cube) {
      program.set("cube_map", 0);
    } else {
      gl::bind(1, GL_TEXTURE_2D, pictures_.get({p.lookup, p.cube_map}, [&] { return picture(p); }));
      program.set("picture_map", 1);
    }
    ball.draw_closed(program, glm::length(eye_in_object) > 1);
    environment_.draw_background(frame, p.camera, 0);
  }

 private:
  /// The cube map's six pictures as one picture, by two angles or as a mirror ball shows them.
  gl::Texture picture(const Parameters& p) const {
    std::array<image::Image8, 6> faces = assets_.cube_map(p.cube_map);
    if (p.lookup == Lookup::sphere_map)
      return gl::make_texture_2d(app::sphere_map(std::move(faces)), image::Encoding::srgb,
                                 {.wrap_s = GL_CLAMP_TO_EDGE, .wrap_t = GL_CLAMP_TO_EDGE});
    return gl::make_texture_2d(app::equirectangular_map(std::move(faces)), image::Encoding::srgb,
                               {.wrap_s = GL_REPEAT, .wrap_t = GL_CLAMP_TO_EDGE});
  }

  const app::Assets& assets_;
  app::Environment environment_;
  app::Cache<std::pair<int, int>, gl::MeshBuffers> balls_;
  app::Cache<std::pair<Lookup, std::string>, gl::Texture> pictures_;
};

}  // namespace texel::reflection

int main(int argc, char** argv) {
  return texel::app::run<texel::reflection::Reflection>(argc, argv);
}
