// SPDX-License-Identifier: MIT
// Lab 3: a file says which point of a picture belongs to each corner. The importer (import.hpp) turns an
// OBJ's separate lists of positions, texture coordinates and normals into one stream of vertices; each pixel
// then reads the picture at its interpolated coordinate.
#include <map>
#include <tuple>

#include "app/lab.hpp"
#include "gl/upload.hpp"
#include "import.hpp"
#include "parameters.hpp"

namespace texel::obj_texcoords {

struct ObjTexcoords : app::Lab<ObjTexcoordsParameters> {
  static constexpr app::View kViews[] = {app::View::color, app::View::normal, app::View::texcoord,
                                         app::View::lod,   app::View::depth,  app::View::mask};
  static constexpr app::Info info{3, "obj_texcoords", "OBJ with texture coordinates",
                                  "Read a model with its texture coordinates, or generate them.", kViews};

  explicit ObjTexcoords(const app::Assets& assets) : assets_(assets) {}

  void draw(const Parameters& p, app::Frame& frame) override {
    Model& model = model_for(p);
    frame.note(model.imported.notes);
    gl::MeshBuffers& buffers = p.method == Method::per_vertex ? colored(p, model) : model.buffers;
    gl::Program& program = frame.program("03_obj_texcoords/obj_texcoords");
    program.set("clip_from_world", p.camera.clip_from_world(frame.aspect()));
    program.set("world_from_object", app::turn_about_y(p.turn));
    program.set("eye", p.camera.eye());
    program.set("light", p.light.direction());
    program.set("longest_side", model.longest_side);
    program.set("color_map", 0);
    // For encoded arithmetic, reading does not decode and writing does not encode.
    if (!p.linear_light) glDisable(GL_FRAMEBUFFER_SRGB);

    const std::vector<mesh::Group>& parts = model.imported.parts;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (p.method == Method::per_fragment)
        gl::bind(0, GL_TEXTURE_2D, texture(p, picture_of(p.texture, model.imported, i)));
      glm::vec3 tint = tint_of(p.tint, p.texture, model.imported, i);
      for (int c = 0; c < 3 && p.linear_light; ++c) tint[c] = image::linear_from_srgb(tint[c]);
      program.set("tint", tint);
      buffers.draw(program, parts[i]);
    }
  }

  const mesh::Mesh* mesh(const Parameters& p) override {
    Model& model = model_for(p);
    return p.method == Method::per_vertex ? &colored(p, model).mesh() : &model.buffers.mesh();
  }

 private:
  using ModelKey = std::tuple<std::string, Projection, Normals, Tint>;
  struct Model {
    Imported imported;
    gl::MeshBuffers buffers;
    float longest_side;  // of the box around it
  };

  /// A color buffer has one coordinate per vertex, so triplanar uses box there.
  static Projection projection_of(const Parameters& p) {
    const bool needs_texcoords = p.method == Method::per_vertex && p.projection == Projection::triplanar;
    return needs_texcoords ? Projection::box : p.projection;
  }
  static ModelKey model_key(const Parameters& p) { return {p.model, projection_of(p), p.normals, p.tint}; }

  Model& model_for(const Parameters& p) {
    return models_.get(model_key(p), [&] {
      Imported imported = import_obj(assets_.model(p.model), projection_of(p), p.normals, p.tint);
      gl::MeshBuffers buffers(std::move(imported.mesh));
      const glm::vec3 extent = mesh::bounds(buffers.mesh()).extent();
      return Model{std::move(imported), std::move(buffers), std::max({extent.x, extent.y, extent.z})};
    });
  }

  /// The model with the report's color buffer: at each vertex the texel that getPixelColor(u, v) finds.
  gl::MeshBuffers& colored(const Parameters& p, const Model& model) {
    return colored_.get({model_key(p), p.texture, p.flip_v, p.linear_light, p.texture_scale}, [&] {
      mesh::Mesh mesh = model.buffers.mesh();
      const std::vector<mesh::Group>& parts = model.imported.parts;
      // Two parts may read different pictures, so they share no vertex.
      std::vector<std::uint32_t> part_of_corner(mesh.indices.size());
      for (std::uint32_t i = 0; i < parts.size(); ++i)
        std::fill_n(part_of_corner.begin() + parts[i].first_index, parts[i].index_count, i);
      std::map<std::string, image::Image8> pictures;
      for (const std::uint32_t part : mesh::split_by_label(mesh, part_of_corner)) {
        const std::string name = part == mesh::no_index ? "" : picture_of(p.texture, model.imported, part);
        auto known = pictures.find(name);
        if (known == pictures.end()) known = pictures.emplace(name, picture(name, p.flip_v)).first;
        mesh.colors.push_back(
            pixel_color(known->second, mesh.texcoords[mesh.colors.size()] * p.texture_scale, p.linear_light));
      }
      return gl::MeshBuffers(std::move(mesh));
    });
  }

  [[nodiscard]] image::Image8 picture(const std::string& name, bool flip_v) const {
    if (name.empty()) {
      image::Image8 white(1, 1, 3);
      std::fill(white.samples.begin(), white.samples.end(), std::uint8_t{255});
      return white;
    }
    image::Image8 image = gl::expand_gray(assets_.texture(name));
    return flip_v ? image::flipped(image) : image;
  }

  const gl::Texture& texture(const Parameters& p, const std::string& name) {
    return textures_.get({name, p.flip_v, p.linear_light}, [&] {
      // Trilinear: Mesa's anisotropic filter fails where a projection smears the picture.
      return gl::make_texture_2d(picture(name, p.flip_v),
                                 p.linear_light ? image::Encoding::srgb : image::Encoding::linear);
    });
  }

  const app::Assets& assets_;
  app::Cache<ModelKey, Model> models_;
  app::Cache<std::tuple<ModelKey, std::string, bool, bool, float>, gl::MeshBuffers> colored_;
  app::Cache<std::tuple<std::string, bool, bool>, gl::Texture> textures_;  // by picture, flip_v, linear_light
};

}  // namespace texel::obj_texcoords

int main(int argc, char** argv) {
  return texel::app::run<texel::obj_texcoords::ObjTexcoords>(argc, argv);
}
