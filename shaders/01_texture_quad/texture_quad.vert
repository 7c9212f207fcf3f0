#version 330 core
// SPDX-License-Identifier: MIT
// Passes each corner's texture coordinate to the rasteriser, which interpolates it for every pixel.
in vec3 position;
in vec2 texcoord;

uniform mat4 clip_from_object;
uniform float texture_scale;
uniform float texture_offset;

out vec2 fragment_texcoord;

void main() {
  gl_Position = clip_from_object * vec4(position, 1.0);
  //@step 1.1 begin
  fragment_texcoord = texcoord * texture_scale + texture_offset;
  //@starter
  // fragment_texcoord = position.yx * texture_scale + texture_offset;
  //@end
}
