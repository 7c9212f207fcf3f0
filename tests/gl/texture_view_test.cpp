// SPDX-License-Identifier: MIT
// What the window shows of the textures at a pixel: which level is read, its texels, and the face of a cube
// map.
#include "../../common/window/texture_view.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "../support/picture_files.hpp"
#include "gl/upload.hpp"
#include "image/mipmaps.hpp"

namespace texel::window {
namespace {

constexpr const char* kVertexShader = R"(#version 330 core
void main() { gl_Position = vec4(vec2(gl_VertexID % 2, gl_VertexID / 2) * 4.0 - 1.0, 0.0, 1.0); }
)";
// Each pixel covers 1/16 of the texture from left to right and 1/32 from below; the cube map is seen towards
// -y. The lowest row of pixels shows the background.
constexpr const char* kFragmentShader = R"(#version 330 core
uniform sampler2D color_map;
uniform samplerCube cube_map;
out vec4 picture;
void main() {
  if (gl_FragCoord.y < 1.0) discard;
  vec2 texcoord = gl_FragCoord.xy * vec2(0.0625, 0.03125);
  vec3 direction = vec3(0.1, -1.0, 0.02 * gl_FragCoord.y);
#if VIEW == VIEW_TEXCOORD
  picture = vec4(texcoord, 0.0, 1.0);
#elif VIEW == VIEW_DIRECTION
  picture = vec4(direction, 1.0);
#else
  picture = texture(color_map, texcoord) + texture(cube_map, direction);
#endif
}
)";
constexpr glm::ivec2 kSize(8, 8), kPixel(2, 5);

image::Image8 picture(int width, int height, int seed) {
  image::Image8 result(width, height, 3);
  for (std::size_t i = 0; i < result.samples.size(); ++i)
    result.samples[i] = static_cast<std::uint8_t>((i * 37 + static_cast<std::size_t>(seed) * 11) % 251);
  return result;
}

struct NoParameters {
  static inline GLenum minify = GL_LINEAR_MIPMAP_LINEAR;
  void declare(params::Set&) {}
};
struct TwoTextures : app::Lab<NoParameters> {
  static constexpr app::View kViews[] = {app::View::color, app::View::texcoord, app::View::direction};
  static constexpr app::Info info{1, "two", "Two", "Two textures.", kViews};
  explicit TwoTextures(const app::Assets&)
      : color_map_(gl::make_texture_2d(picture(64, 64, 0), image::Encoding::srgb)) {
    const gl::ScopedBinding binding(GL_TEXTURE_2D, color_map_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(NoParameters::minify));
    std::array<image::Image8, 6> faces;
    for (int i = 0; i < 6; ++i) faces[static_cast<std::size_t>(i)] = picture(16, 16, i);
    cube_map_ = gl::make_cube_map(faces, image::Encoding::srgb, {.minify = GL_LINEAR});
  }
  void draw(const Parameters&, app::Frame& frame) override {
    gl::Program& program = frame.program("two");
    gl::bind(0, GL_TEXTURE_2D, color_map_);
    gl::bind(1, GL_TEXTURE_CUBE_MAP, cube_map_);
    if (program.find("color_map") != nullptr) program.set("color_map", 0), program.set("cube_map", 1);
    glBindVertexArray(vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  gl::Texture color_map_, cube_map_;
  gl::VertexArray vertices_;
};

std::vector<std::uint8_t> texels_of(const gl::Texture& texture, int level) {
  const gl::ScopedBinding binding(GL_TEXTURE_2D, texture);
  GLint width = 0, height = 0;
  glGetTexLevelParameteriv(GL_TEXTURE_2D, level, GL_TEXTURE_WIDTH, &width);
  glGetTexLevelParameteriv(GL_TEXTURE_2D, level, GL_TEXTURE_HEIGHT, &height);
  std::vector<std::uint8_t> texels(static_cast<std::size_t>(3 * width * height));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTexImage(GL_TEXTURE_2D, level, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
  return texels;
}

class TexturesAt : public testing::Test {
 protected:
  TexturesAt() {
    std::filesystem::create_directories(root_.path() / "assets");
    test::put(root_.path(), {{"shaders/two.vert", kVertexShader}, {"shaders/two.frag", kFragmentShader}});
  }
  std::vector<TextureView> at(glm::ivec2 pixel, GLenum minify = GL_LINEAR_MIPMAP_LINEAR) {
    NoParameters::minify = minify;
    const app::Assets assets(root_.path());
    app::LabOf<TwoTextures> lab;
    app::Canvas canvas(*context_, assets, lab);
    return textures_at(canvas, lab, kSize, pixel);
  }
  ScratchFolder root_;
  std::unique_ptr<gl::Context> context_ = gl::create_headless();
};

TEST_F(TexturesAt, have_the_level_that_the_footprint_needs) {
  const std::vector<TextureView> views = at(kPixel);
  ASSERT_EQ(views.size(), 2U);
  const TextureView& view = views[0];
  EXPECT_EQ(view.name, "color_map");
  EXPECT_EQ(view.size_of(0), glm::ivec2(64));
  EXPECT_EQ(view.levels, 7);
  // All of these are exact in a float: 1/16 of 64 texels is 2^2.
  EXPECT_EQ(view.footprint.place, glm::dvec2(2.5 / 16, 5.5 / 32));
  EXPECT_EQ(view.level_of_detail, 2);
  EXPECT_EQ(view.first_read, 2);
  EXPECT_EQ(view.last_read, 2);
  const image::Image8 level2 = image::mip_chain(picture(64, 64, 0), image::Encoding::srgb)[2];
  EXPECT_EQ(texels_of(view.read, 0), level2.samples);
  ASSERT_EQ(view.chain.size(), 7U);
  EXPECT_EQ(texels_of(view.chain[6], 0).size(), 3U);
  EXPECT_EQ(view.wrap_s, static_cast<unsigned>(GL_REPEAT));
}

TEST_F(TexturesAt, have_level_0_without_mipmaps) {
  const TextureView view = std::move(at(kPixel, GL_LINEAR)[0]);
  EXPECT_FALSE(view.is_mipmapped);
  EXPECT_EQ(view.levels, 7);
  EXPECT_EQ(view.level_of_detail, 2) << "the footprint is the same";
  EXPECT_EQ(view.first_read, 0);
  EXPECT_EQ(texels_of(view.read, 0), picture(64, 64, 0).samples);
}

TEST_F(TexturesAt, have_the_face_that_the_direction_meets) {
  const TextureView view = std::move(at(kPixel)[1]);
  EXPECT_EQ(view.name, "cube_map");
  EXPECT_EQ(view.footprint.face, 3) << "-Y";
  ASSERT_EQ(view.whole.size(), 6U);
  for (int face = 0; face < 6; ++face)
    EXPECT_EQ(texels_of(view.whole[static_cast<std::size_t>(face)], 0), picture(16, 16, face).samples);
  EXPECT_EQ(texels_of(view.read, 0), picture(16, 16, 3).samples);
}

TEST_F(TexturesAt, are_none_at_the_background) {
  EXPECT_TRUE(at({2, 0}).empty());
}

}  // namespace
}  // namespace texel::window
