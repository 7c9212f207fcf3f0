// SPDX-License-Identifier: MIT
// Lab 4: a texture around a cube. A vertex has one texture coordinate and one normal. Three faces meet
// at a cube's corner, and each needs another pair: eight shared vertices cannot give every face its own copy
// of the picture, nor its own light. Either the picture is stretched over them, or the vertices are split.
#include <fmt/format.h>

#include <tuple>

#include "app/lab.hpp"
#include "app/models.hpp"
#include "cube.hpp"
#include "gl/upload.hpp"
#include "mesh/normals.hpp"
#include "mesh/stretch.hpp"
#include "mesh/weld.hpp"
#include "parameters.hpp"
#include "shared_vertices.hpp"
#include "steps.hpp"

namespace texel::cube_wrap {

namespace {

mesh::Mesh wrapped_cube(Method method) {
  if (method == Method::before) return cube_shared(cube_before, kHalfSize);
  if (method == Method::stretched) return cube_shared(cube_stretched, kHalfSize);
  return split_cube();
}

/// The cost of the wrapping, and the two faults that the report names.
std::vector<std::string> figures(const mesh::Mesh& mesh) {
  const std::size_t bytes_a_vertex = 2 * sizeof(glm::vec3) + sizeof(glm::vec2);
  std::vector<std::string> lines = mesh::describe_stretch(mesh);
  lines.push_back(fmt::format("{} vertices, {} bytes with indices", mesh.vertex_count(),
                              mesh.vertex_count() * bytes_a_vertex + mesh.indices.size() * 4));
  return lines;
}

}  // namespace

struct CubeWrap : app::Lab<CubeWrapParameters> {
  static constexpr app::View kViews[] = {app::View::color, app::View::normal, app::View::texcoord,
                                         app::View::lod,   app::View::depth,  app::View::mask};
  static constexpr app::Info info{4, "cube_wrap", "Cube wrap",
                                  "Give every face of a cube its own copy of a picture.", kViews};

  explicit CubeWrap(const app::Assets& assets) : assets_(assets) {}

  void draw(const Parameters& p, app::Frame& frame) override {
    auto& [buffers, notes] = drawn(p);
    frame.note(notes);
    const gl::Texture& color_map = textures_.get(
        p.texture, [&] { return gl::make_texture_2d(assets_.texture(p.texture), image::Encoding::srgb); });
    gl::Program& program = frame.program("04_cube_wrap/cube_wrap");
    program.set("clip_from_world", p.camera.clip_from_world(frame.aspect()));
    program.set("world_from_object", app::turn_about_y(p.turn));
    program.set("eye", p.camera.eye());
    program.set("light", p.light.direction());
    gl::bind(0, GL_TEXTURE_2D, color_map);
    program.set("color_map", 0);
    buffers.draw(program);
  }

  const mesh::Mesh* mesh(const Parameters& p) override { return &drawn(p).buffers.mesh(); }
  std::optional<app::Preparation> preparation(const Parameters& p) override {
    return app::Preparation{"triangle", mesh(p)->triangle_count(), [this, p] { static_cast<void>(wrap(p)); }};
  }

 private:
  struct Drawn {
    gl::MeshBuffers buffers;
    app::Notes notes;
  };

  Drawn& drawn(const Parameters& p) {
    return meshes_.get({p.model, p.method, p.normals}, [&] {
      app::Model model = wrap(p);
      if (p.normals == Normals::shared) mesh::smooth_normals(model.mesh, mesh::Weighting::angle, face_normal);
      if (p.normals == Normals::face) mesh::flat_normals(model.mesh, face_normal);
      for (std::string& figure : figures(model.mesh)) model.notes.facts.push_back(std::move(figure));
      return Drawn{gl::MeshBuffers(std::move(model.mesh)), std::move(model.notes)};
    });
  }

  /// The report's two ways share the vertices; the others give each face its own, and may merge equal ones.
  app::Model wrap(const Parameters& p) {
    if (p.model == "cube" && p.method != Method::weld) return {wrapped_cube(p.method), {}, false};
    app::Model model = app::load_model(assets_, p.model);
    if (p.method == Method::before || p.method == Method::stretched) {
      model.mesh = shared_vertices(model.mesh, p.method);
    } else {
      model.mesh = mesh::split(model.mesh);
      if (p.method == Method::weld) model.mesh = weld(model.mesh);
    }
    return model;
  }

  const app::Assets& assets_;
  app::Cache<std::tuple<std::string, Method, Normals>, Drawn> meshes_;
  app::Cache<std::string, gl::Texture> textures_;
};

}  // namespace texel::cube_wrap

int main(int argc, char** argv) {
  return texel::app::run<texel::cube_wrap::CubeWrap>(argc, argv);
}
