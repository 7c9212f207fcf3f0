// SPDX-License-Identifier: MIT
// Lab 7: the environment behind the scene. A quad fills the picture in clip space, and a matrix turns each of
// its points into the direction in which the camera sees it. The other task is to keep the quad behind
// everything.
#include <glm/gtc/matrix_transform.hpp>

#include "app/environment.hpp"
#include "app/lab.hpp"
#include "mesh/primitives.hpp"
#include "parameters.hpp"
#include "scene.hpp"

namespace texel::environment {

struct Environment : app::Lab<EnvironmentParameters> {
  static constexpr app::View kViews[] = {app::View::color, app::View::direction, app::View::depth,
                                         app::View::mask};
  static constexpr app::Info info{7, "environment", "Environment",
                                  "Surround the scene with a cube map behind everything.", kViews};

  explicit Environment(const app::Assets& assets) : environment_(assets), quad_(make_quad()) {}

  void draw(const Parameters& p, app::Frame& frame) override {
    environment_.bind(0, p.cube_map);
    if (p.depth_method == DepthMethod::far_plane) {
      //@step 7.4 begin
      draw_spheres(p, frame);
      glDepthFunc(GL_LEQUAL);  // the quad has depth 1, and so has the cleared buffer
      draw_background(p, frame);
      //@starter
      // glDisable(GL_DEPTH_TEST);
      // draw_spheres(p, frame);
      // draw_background(p, frame);
      //@end
    } else {
      // The worksheet's two ways.
      if (p.depth_method == DepthMethod::test_off) glDisable(GL_DEPTH_TEST);  // neither tested nor written
      draw_background(p, frame);
      glEnable(GL_DEPTH_TEST);
      draw_spheres(p, frame);
    }
  }

 private:
  /// The corners of the picture in clip space; the shader adds z and w.
  static gl::MeshBuffers make_quad() {
    mesh::Mesh quad;
    //@step 7.1 begin
    quad.positions = {{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}, {1, 1, 0}};
    //@starter
    // quad.positions = {{-0.5F, -0.5F, 0}, {0.5F, -0.5F, 0}, {-0.5F, 0.5F, 0}, {0.5F, 0.5F, 0}};
    //@end
    quad.indices = {0, 1, 2, 2, 1, 3};
    return gl::MeshBuffers(std::move(quad));
  }

  void draw_background(const Parameters& p, app::Frame& frame) {
    gl::Program& program = frame.program("07_environment/background");
    app::set_view_ray(program, p.camera, frame);
    const bool exact = p.precision == Precision::double_precision;
    program.set("direction_from_clip", exact ? glm::mat4(direction_from_clip<double>(p, frame.aspect()))
                                             : direction_from_clip<float>(p, frame.aspect()));
    program.set("eye", p.camera.eye());
    program.set("cube_map", 0);
    quad_.draw(program);
  }

  /// The worksheet's M_tex: world-space directions (with the method unproject: points) from clip space.
  template <class Real>
  static glm::mat<4, 4, Real> direction_from_clip(const Parameters& p, float aspect) {
    using Matrix = glm::mat<4, 4, Real>;
    const Matrix projection = glm::perspective(glm::radians(Real{p.camera.field_of_view}), Real{aspect},
                                               Real{p.near_plane}, Real{p.far_plane});
    const Matrix view(p.camera.view_from_world());
    //@step 7.2 begin
    // The surroundings are far away: only the camera's rotation matters, not its position.
    const Matrix rotation{glm::mat<3, 3, Real>(view)};
    //@starter
    // const Matrix rotation = view;
    //@end
    if (p.method == Method::unproject) return glm::inverse(projection * view);
    if (p.method == Method::inverse_of_product) return glm::inverse(projection * rotation);
    //@step 7.3 begin
    return glm::inverse(rotation) * glm::inverse(projection);
    //@starter
    // return -rotation;
    //@end
  }

  void draw_spheres(const Parameters& p, app::Frame& frame) {
    gl::MeshBuffers& sphere = spheres_.get(
        {p.rings, p.segments}, [&] { return gl::MeshBuffers(mesh::sphere(p.rings, p.segments)); });
    gl::Program& program = frame.program("07_environment/sphere");
    const glm::mat4 clip_from_world =
        p.camera.clip_from_view(frame.aspect(), p.near_plane, p.far_plane) * p.camera.view_from_world();
    program.set("clip_from_world", clip_from_world);
    program.set("cube_map", 0);
    for (const glm::vec4& place : kSpheres) {
      program.set("place", place);
      sphere.draw(program);
    }
  }

  app::Environment environment_;
  gl::MeshBuffers quad_;
  app::Cache<std::pair<int, int>, gl::MeshBuffers> spheres_;
};

}  // namespace texel::environment

int main(int argc, char** argv) {
  return texel::app::run<texel::environment::Environment>(argc, argv);
}
