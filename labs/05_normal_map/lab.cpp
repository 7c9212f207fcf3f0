// SPDX-License-Identifier: MIT
// Lab 5: a normal map. Each texel holds a normal in the frame of the surface: tangent T where s grows,
// bitangent B where t grows, normal N. Lighting happens in world space, so each pixel needs that frame. The
// methods differ in how they make it.
#include <glm/gtc/matrix_transform.hpp>

#include <tuple>

#include "app/lab.hpp"
#include "gl/upload.hpp"
#include "model.hpp"
#include "normal_matrix.hpp"
#include "parameters.hpp"

namespace texel::normal_map {

struct NormalMap : app::Lab<NormalMapParameters> {
  static constexpr app::View kViews[] = {app::View::color,    app::View::normal, app::View::tangent,
                                         app::View::texcoord, app::View::depth,  app::View::mask};
  static constexpr app::Info info{5, "normal_map", "Normal map",
                                  "Light a flat surface as if it were a relief.", kViews};

  explicit NormalMap(const app::Assets& assets) : assets_(assets) {}

  void draw(const Parameters& p, app::Frame& frame) override {
    auto& [buffers, notes] = drawn(p);
    frame.note(notes);
    const bool bilinear = p.filter == Filter::bilinear;
    const gl::Sampling sampling =
        bilinear ? gl::Sampling{.minify = GL_LINEAR} : gl::Sampling{.anisotropy = 8};
    const gl::Texture& color_map = textures_.get({"color " + p.texture, p.filter}, [&] {
      return gl::make_texture_2d(assets_.texture(p.texture), image::Encoding::srgb, sampling);
    });
    const glm::mat4 world_from_object = glm::scale(app::turn_about_y(p.turn), glm::vec3(1, p.stretch, 1));
    gl::Program& program = frame.program("05_normal_map/normal_map");
    program.set("clip_from_world", p.camera.clip_from_world(frame.aspect()));
    program.set("world_from_object", world_from_object);
    program.set("normal_from_object", normal_matrix(world_from_object));
    program.set("eye", p.camera.eye());
    program.set("light", p.light.direction());
    gl::bind(0, GL_TEXTURE_2D, color_map);
    program.set("color_map", 0);
    if (p.normal_mapping && p.method != Method::per_vertex) {
      // Numbers, not colours: stored linear. So 128 means 128/255, and nothing is decoded.
      gl::bind(1, GL_TEXTURE_2D, textures_.get({"normal " + normal_map_name(p), p.filter}, [&] {
        return gl::make_texture_2d(assets_.normal_map(normal_map_name(p)), image::Encoding::linear, sampling);
      }));
      program.set("normal_map", 1);
    }
    buffers.draw(program);
  }

  const mesh::Mesh* mesh(const Parameters& p) override { return &drawn(p).buffers.mesh(); }

 private:
  struct Drawn {
    gl::MeshBuffers buffers;
    app::Notes notes;
  };

  /// The model with the method's tangents. Only some methods store them in the vertices.
  Drawn& drawn(const Parameters& p) {
    const bool reads_map = p.method == Method::per_vertex && p.normal_mapping;
    const std::string map = reads_map ? normal_map_name(p) : "";
    const float repeats = reads_map ? p.texture_scale : 0;
    return meshes_.get({p.model, p.method, map, repeats, p.tessellation, p.layout}, [&] {
      app::Model model = textured_model(assets_, p);
      if (const auto method = kept_tangents(p.method); method && model.mesh.tangents.empty())
        mesh::compute_tangents(model.mesh, *method);
      if (reads_map) model.mesh.normals = normals_at_vertices(model.mesh, assets_.normal_map(map), p);
      return Drawn{gl::MeshBuffers(std::move(model.mesh)), model.notes};
    });
  }

  /// The report's first attempt: the map's normal at each vertex's texture coordinate replaces the
  /// vertex's normal.
  static std::vector<glm::vec3> normals_at_vertices(const mesh::Mesh& mesh, const image::Image8& map,
                                                    const Parameters& p) {
    std::vector<glm::vec3> normals;
    for (const glm::vec2& texcoord : mesh.texcoords) {
      const glm::vec2 tile = glm::fract(texcoord * p.texture_scale);
      const int x = std::min(static_cast<int>(tile.x * static_cast<float>(map.width)), map.width - 1);
      const int y = std::min(static_cast<int>(tile.y * static_cast<float>(map.height)), map.height - 1);
      normals.push_back(
          glm::normalize(glm::vec3(map.at(x, y, 0), map.at(x, y, 1), map.at(x, y, 2)) / 127.5F - 1.0F));
    }
    return normals;
  }

  const app::Assets& assets_;
  app::Cache<std::tuple<std::string, Method, std::string, float, app::Tessellation, mesh::TextureLayout>,
             Drawn>
      meshes_;
  app::Cache<std::pair<std::string, Filter>, gl::Texture> textures_;
};

}  // namespace texel::normal_map

int main(int argc, char** argv) {
  return texel::app::run<texel::normal_map::NormalMap>(argc, argv);
}
