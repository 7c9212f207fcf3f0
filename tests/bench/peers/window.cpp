// SPDX-License-Identifier: MIT
// window ASSETS FILE.png: lab 9's default picture as a tutorial's program draws it: GLFW, a window of 512x512
// pixels with 4 samples each, stb_image, glGenerateMipmap, the files one after the other. Ends when the first
// picture is shown, and keeps it in the file.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>

#include "../floor/mirror_ball.hpp"

namespace {

void upload(GLenum target, const std::string& path, GLint internal) {
  int width = 0, height = 0, channels = 0;
  unsigned char* samples = stbi_load(path.c_str(), &width, &height, &channels, 3);
  bare::check(samples != nullptr, path.c_str());
  glTexImage2D(target, 0, internal, width, height, 0, GL_RGB, GL_UNSIGNED_BYTE, samples);
  stbi_image_free(samples);
}

void new_texture(GLenum unit, GLenum target) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(target, texture);
}

void load_textures(const std::string& assets) {
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  new_texture(0, GL_TEXTURE_CUBE_MAP);
  GLenum face = GL_TEXTURE_CUBE_MAP_POSITIVE_X;
  for (const char* name : {"px", "nx", "py", "ny", "pz", "nz"})
    upload(face++, assets + "/cube_maps/scene/" + name + ".png", GL_SRGB8);
  glGenerateMipmap(GL_TEXTURE_CUBE_MAP);
  bare::sample_by(GL_TEXTURE_CUBE_MAP, GL_CLAMP_TO_EDGE, 1);
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);

  new_texture(1, GL_TEXTURE_2D);
  stbi_set_flip_vertically_on_load(1);
  upload(GL_TEXTURE_2D, assets + "/normal_maps/bump.png", GL_RGB8);
  glGenerateMipmap(GL_TEXTURE_2D);
  bare::sample_by(GL_TEXTURE_2D, GL_REPEAT, 1);
}

GLFWwindow* open_window() {
  bare::check(glfwInit() != 0, "there is no display");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_SAMPLES, bare::kSamples);
  glfwWindowHint(GLFW_SRGB_CAPABLE, GLFW_TRUE);
  GLFWwindow* window = glfwCreateWindow(bare::kSize, bare::kSize, "mirror ball", nullptr, nullptr);
  bare::check(window != nullptr, "there is no OpenGL 3.3");
  glfwMakeContextCurrent(window);
  glEnable(GL_FRAMEBUFFER_SRGB);
  glEnable(GL_DEPTH_TEST);
  glClearColor(bare::kBackground[0], bare::kBackground[1], bare::kBackground[2], 1);
  return window;
}

}  // namespace

int main(int argc, char** argv) {
  const bare::Arguments arguments(argc, argv);
  GLFWwindow* window = open_window();
  load_textures(arguments.assets);
  const bare::MirrorBall ball;
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  ball.draw();
  std::vector<std::uint8_t> rgba(std::size_t{4} * bare::kSize * bare::kSize);
  glReadPixels(0, 0, bare::kSize, bare::kSize, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  glfwSwapBuffers(window);
  glFinish();
  bare::write_png(arguments.file, rgba);
  glfwTerminate();
}
