// SPDX-License-Identifier: MIT
// Lab 2: two pictures on one square. Each is a texture object on its own unit, read by its own
// sampler. The fragment shader combines the two colours. The result depends on the values that it combines:
// the file's encoded values, or the linear light that they stand for.
#include <tuple>

#include "app/lab.hpp"
#include "gl/upload.hpp"
#include "image/color.hpp"
#include "image/mipmaps.hpp"
#include "mesh/primitives.hpp"
#include "parameters.hpp"

namespace texel::multi_texture {

namespace {

/// Colour times alpha, multiplied in linear light: a transparent texel then adds nothing to an average.
image::Image8 premultiplied(image::Image8 picture) {
  if (picture.channels != 4) return picture;  // opaque
  for (std::size_t i = 0; i < picture.samples.size(); i += 4) {
    const float alpha = static_cast<float>(picture.samples[i + 3]) / 255.0F;
    for (std::size_t c = i; c < i + 3; ++c)
      picture.samples[c] = image::to_encoding8(alpha * image::from_encoding8(picture.samples[c]));
  }
  return picture;
}

}  // namespace

struct MultiTexture : app::Lab<MultiTextureParameters> {
  static constexpr app::View kViews[] = {app::View::color, app::View::texcoord, app::View::lod,
                                         app::View::depth, app::View::mask};
  static constexpr app::Info info{2, "multi_texture", "Multi-texture",
                                  "Combine two pictures on one square, each from its own texture unit.",
                                  kViews};

  explicit MultiTexture(const app::Assets& assets) : assets_(assets) {}

  void draw(const Parameters& p, app::Frame& frame) override {
    gl::Program& program = frame.program("02_multi_texture/multi_texture");
    const glm::mat4 world_from_object = app::tilt_about_x(-p.tilt);
    program.set("clip_from_object", p.camera.clip_from_world(frame.aspect()) * world_from_object);
    const int second = std::min(p.second_unit, gl::texture_units() - 1);  // at most the driver's highest

    // A picture whose unit is off is not even loaded.
    const gl::Texture* object0 = p.unit0_on ? &texture_object(p, p.texture0, false) : nullptr;
    const bool premultiply = p.method == Method::premultiplied && p.combine == Combine::decal;
    //@step 2.1 begin
    const gl::Texture* object1 = p.unit1_on ? &texture_object(p, p.texture1, premultiply) : nullptr;
    //@starter
    // const gl::Texture* object1 = p.unit1_on ? &texture_object(p, p.texture0, premultiply) : nullptr;
    //@end
    if (p.unit0_on) {
      gl::bind(0, GL_TEXTURE_2D, *object0);
      set_filter(p);
      program.set("Tex0", 0);
    }
    if (p.unit1_on) {
      //@step 2.2 begin
      // The object goes to the second unit, and the second sampler reads that unit.
      gl::bind(second, GL_TEXTURE_2D, *object1);
      set_filter(p);
      program.set("Tex1", second);
      //@starter
      // // Both samplers read unit 0, where there is room for one picture.
      // if (!p.unit0_on) gl::bind(0, GL_TEXTURE_2D, *object1);
      // set_filter(p);
      // program.set("Tex1", 0);
      //@end
    }
    // For encoded arithmetic, reading does not decode and writing does not encode.
    if (p.method == Method::encoded) glDisable(GL_FRAMEBUFFER_SRGB);
    square_.draw(program);
  }

  std::optional<app::Preparation> preparation(const Parameters& p) override {
    const image::Image8 picture = gl::expand_gray(assets_.texture(p.texture0));
    return app::Preparation{
        "texel", picture.samples.size() / static_cast<std::size_t>(picture.channels), [picture, p] {
          const image::Encoding encoding =
              p.method == Method::encoded ? image::Encoding::linear : image::Encoding::srgb;
          upload(picture, encoding, is_mipmapped(p), p.mipmaps);
          glFinish();
        }};
  }

 private:
  /// A texture object with its levels.
  const gl::Texture& texture_object(const Parameters& p, const std::string& name, bool premultiply) {
    const bool is_linear = p.method != Method::encoded;
    const auto load = [&] {
      image::Image8 picture = gl::expand_gray(assets_.texture(name));
      if (premultiply) picture = premultiplied(std::move(picture));
      // With an sRGB format the sampler decodes before it filters.
      return upload(picture, is_linear ? image::Encoding::srgb : image::Encoding::linear, is_mipmapped(p),
                    p.mipmaps);
    };
    const gl::Texture& texture =
        textures_.get({name, is_linear, premultiply, is_mipmapped(p), p.mipmaps}, load);
    gl::forget_sampling(texture);
    return texture;
  }

  static bool is_mipmapped(const Parameters& p) {
    return p.minify != Minify::nearest && p.minify != Minify::linear;
  }

  static gl::Texture upload(const image::Image8& picture, image::Encoding encoding, bool mipmapped,
                            Mipmaps mipmaps) {
    gl::Texture texture;
    const gl::ScopedBinding binding(GL_TEXTURE_2D, texture);  // no unit keeps it: that is for draw to say
    gl::upload_level(GL_TEXTURE_2D, 0, picture, encoding);
    if (!mipmapped) return texture;  // no filter reads smaller levels
    //@step 2.4 begin
    if (mipmaps == Mipmaps::driver) {
      glGenerateMipmap(GL_TEXTURE_2D);
    } else {
      GLint level = 0;
      for (const image::Image8& smaller : image::mip_chain(picture, encoding))
        gl::upload_level(GL_TEXTURE_2D, level++, smaller, encoding);
    }
    //@starter
    // glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);  // no smaller levels yet
    //@end
    return texture;
  }

  /// How the texture that is bound to the active unit is read.
  static void set_filter(const Parameters& p) {
    gl::set_sampling(GL_TEXTURE_2D, {.minify = gl::kFilters[static_cast<int>(p.minify)],
                                     .magnify = gl::kFilters[static_cast<int>(p.magnify)]});
  }

  const app::Assets& assets_;
  app::Cache<std::tuple<std::string, bool, bool, bool, Mipmaps>, gl::Texture> textures_;
  gl::MeshBuffers square_{mesh::quad(0.7F)};
};

}  // namespace texel::multi_texture

int main(int argc, char** argv) {
  return texel::app::run<texel::multi_texture::MultiTexture>(argc, argv);
}
