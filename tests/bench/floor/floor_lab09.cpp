// SPDX-License-Identifier: MIT
// The floor under lab 9: its default picture, written by hand.
#include "mirror_ball.hpp"

namespace {

void bind_cube_map(const std::string& folder) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_CUBE_MAP, texture);
  const bare::Curve curve(bare::Encoding::srgb);
  GLenum face = GL_TEXTURE_CUBE_MAP_POSITIVE_X;
  for (const char* name : {"px", "nx", "py", "ny", "pz", "nz"})
    bare::upload(face++, bare::read_png(folder + "/" + name + ".png", bare::Rows::top_first), GL_SRGB8,
                 curve);
  bare::sample_by(GL_TEXTURE_CUBE_MAP, GL_CLAMP_TO_EDGE, 1);
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

}  // namespace

int main(int argc, char** argv) {
  const bare::Arguments arguments(argc, argv);
  const bare::Canvas canvas;
  bind_cube_map(arguments.assets + "/cube_maps/scene");
  bare::texture_2d(1, arguments.assets + "/normal_maps/bump.png", bare::Encoding::linear, 1);
  const bare::MirrorBall ball;
  bare::draw_and_save(arguments, canvas, [&] { ball.draw(); });
}
