// SPDX-License-Identifier: MIT
// Lab 1: a picture on a square. An image becomes a texture object, the object is bound to a texture
// unit, and a sampler in the shader reads that unit at interpolated texture coordinates. A filter decides
// which colour a pixel gets between texels, and from many texels.
#include <tuple>

#include "app/lab.hpp"
#include "image/mipmaps.hpp"
#include "parameters.hpp"

namespace texel::texture_quad {

namespace {

// OpenGL's constants for the parameters' choices, in the same order.
constexpr GLenum kWrapModes[] = {GL_REPEAT, GL_MIRRORED_REPEAT, GL_CLAMP_TO_EDGE};
constexpr GLenum kMinifyByMethod[] = {GL_NEAREST, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR_MIPMAP_LINEAR,
                                      GL_LINEAR_MIPMAP_LINEAR};

}  // namespace

struct TextureQuad : app::Lab<TextureQuadParameters> {
  static constexpr app::View kViews[] = {app::View::color, app::View::texcoord, app::View::lod,
                                         app::View::depth, app::View::mask};
  static constexpr app::Info info{1, "texture_quad", "Texture quad",
                                  "Paste a picture on a square, and filter it.", kViews};

  explicit TextureQuad(const app::Assets&) {
    // Positions and texture coordinates of the four corners, and the two triangles between them.
    constexpr float s = 0.7F;
    constexpr float positions[] = {-s, -s, 0, s, -s, 0, s, s, 0, -s, s, 0};
    constexpr float texcoords[] = {0, 0, 1, 0, 1, 1, 0, 1};
    constexpr GLuint indices[] = {0, 1, 2, 0, 2, 3};

    glBindVertexArray(vertex_array_.id());
    fill_attribute(gl::Attribute::position, position_buffer_, positions, 3);
    fill_attribute(gl::Attribute::texcoord, texcoord_buffer_, texcoords, 2);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer_.id());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices, GL_STATIC_DRAW);
  }

  void draw(const Parameters& p, app::Frame& frame) override {
    const GLenum minify = minify_filter(p);
    const bool mipmapped = minify != GL_NEAREST && minify != GL_LINEAR;
    const gl::Texture& texture = textures_.get({p.texture, p.flip_v, p.linear_light, mipmapped}, [&] {
      image::Image8 picture = gl::expand_gray(frame.assets().texture(p.texture));
      if (p.flip_v) picture = image::flipped(picture);
      return upload(picture, p.linear_light ? image::Encoding::srgb : image::Encoding::linear, mipmapped);
    });
    gl::forget_sampling(texture);
    gl::Program& program = frame.program("01_texture_quad/texture_quad");
    const glm::mat4 world_from_object = app::tilt_about_x(-p.tilt);
    program.set("clip_from_object", p.camera.clip_from_world(frame.aspect()) * world_from_object);

    //@step 1.2 begin
    // The texture object goes to unit 0, and the sampler reads unit 0.
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture.id());
    program.set("color_map", 0);
    //@starter
    // glBindTexture(GL_TEXTURE_2D, texture.id());
    // program.set("color_map", 1);
    //@end
    set_parameters(p);

    // For encoded arithmetic, reading does not decode and writing does not encode.
    if (!p.linear_light) glDisable(GL_FRAMEBUFFER_SRGB);
    glBindVertexArray(vertex_array_.id());
    glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, nullptr);
  }

 private:
  /// One attribute in its own buffer, `components` floats per vertex.
  static void fill_attribute(gl::Attribute attribute, const gl::Buffer& buffer, std::span<const float> values,
                             GLint components) {
    const auto location = static_cast<GLuint>(attribute);
    glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size_bytes()), values.data(),
                 GL_STATIC_DRAW);
    glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(location);
  }

  /// A texture object with all its mipmap levels; for a filter that is not `mipmapped` the picture is enough.
  static gl::Texture upload(const image::Image8& picture, image::Encoding encoding, bool mipmapped) {
    gl::Texture texture;
    glBindTexture(GL_TEXTURE_2D, texture.id());
    //@step 1.4 begin
    // By default OpenGL expects each row to begin at a multiple of four bytes. Ours follow without a gap.
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const gl::Format format = gl::format_of(picture.channels, encoding);
    GLint level = 0;
    for (const image::Image8& smaller : image::mip_chain(picture, encoding)) {
      glTexImage2D(GL_TEXTURE_2D, level++, static_cast<GLint>(format.internal), smaller.width, smaller.height,
                   0, format.external, GL_UNSIGNED_BYTE, smaller.samples.data());
      if (!mipmapped) break;
    }
    //@starter
    // // Only the full picture, and grey unless it has four channels.
    // image::Image8 shown(picture.width, picture.height, 4);
    // std::fill(shown.samples.begin(), shown.samples.end(), std::uint8_t{128});
    // if (picture.channels == 4) shown = picture;
    // glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);  // there are no smaller levels yet
    // const GLint internal = encoding == image::Encoding::srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8;
    // glTexImage2D(GL_TEXTURE_2D, 0, internal, shown.width, shown.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
    //              shown.samples.data());
    //@end
    glBindTexture(GL_TEXTURE_2D, 0);  // which texture is read is for draw to say
    return texture;
  }

  /// How the bound texture is read between its texels and outside 0 to 1.
  static void set_parameters(const Parameters& p) {
    //@step 1.5 begin
    const GLenum wrap = wrap_mode(p);
    const float anisotropy = p.method == Method::anisotropic ? 16.0F : 1.0F;
    gl::set_sampling(GL_TEXTURE_2D, {.minify = minify_filter(p),
                                     .magnify = magnify_filter(p),
                                     .wrap_s = wrap,
                                     .wrap_t = wrap,
                                     .anisotropy = anisotropy});
    //@starter
    // gl::set_sampling(GL_TEXTURE_2D, {});  // always trilinear and repeated
    //@end
  }

  // The parameters as OpenGL's constants.
  static GLenum wrap_mode(const Parameters& p) { return kWrapModes[static_cast<int>(p.wrap)]; }
  static GLenum minify_filter(const Parameters& p) {
    return p.minify == Minify::by_method ? kMinifyByMethod[static_cast<int>(p.method)]
                                         : gl::kFilters[static_cast<int>(p.minify) - 1];
  }
  static GLenum magnify_filter(const Parameters& p) {
    if (p.magnify == Magnify::by_method) return p.method == Method::nearest ? GL_NEAREST : GL_LINEAR;
    return p.magnify == Magnify::nearest ? GL_NEAREST : GL_LINEAR;
  }

  // By picture, flip_v, linear_light and whether it has levels.
  app::Cache<std::tuple<std::string, bool, bool, bool>, gl::Texture> textures_;
  gl::VertexArray vertex_array_;
  gl::Buffer position_buffer_, texcoord_buffer_, index_buffer_;
};

}  // namespace texel::texture_quad

int main(int argc, char** argv) {
  return texel::app::run<texel::texture_quad::TextureQuad>(argc, argv);
}
