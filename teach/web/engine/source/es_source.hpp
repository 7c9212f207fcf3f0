// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace texel::gl {

/// A shader in GLSL 3.30, as ShaderSource::text gives it, in the language of OpenGL ES 3.0 and WebGL 2. The
/// lines keep their numbers.
///
/// OpenGL ES cannot write into an sRGB picture without encoding. So a fragment shader that writes a colour
/// `picture` gets a uniform kKeepsBytes: where it is set, the colour is decoded first. With `encodes` the
/// target is of 8 bits as they are (Target::Kind::encoded): where the uniform is not set, the shader encodes.
///
/// A renderer rounds a vertex's place in the picture to so many bits of a pixel: SwiftShader to 4, and the
/// limits of cases were measured with 8. What is interpolated is then off by up to 1/32 of its change to the
/// next pixel. With fewer than 8 bits the vertex shader passes on by how much it was rounded (it gets the
/// picture's size, kPictureSize), and the fragment shader moves each of its inputs back. Which triangle
/// covers a pixel is not mended so: for that a picture can be drawn several times, each with the vertices
/// moved by another part of a pixel (kShift).
///
/// Loops end after kMostRounds rounds, all of one vertex or pixel together. A pixel that got so far is
/// magenta, with an alpha of one half.
///
/// All uniforms that it adds begin with gl::kAddedUniforms.
std::string es_source(const std::string& text, bool is_fragment, int subpixel_bits, bool encodes = false);
inline constexpr const char* kKeepsBytes = "texel_keeps_bytes";
inline constexpr const char* kPictureSize = "texel_picture_size";
inline constexpr const char* kShift = "texel_shift";
/// Four times what a pixel of a 16x16 supersampled picture needs. On two cores SwiftShader draws 512x512
/// pixels with 4096 rounds of a sine in 6.4 s.
inline constexpr int kMostRounds = 1024;
/// So many bits are as good as the renderers have with which the limits were measured.
inline constexpr int kEnoughSubpixelBits = 8;

/// A compiler's message, with what to do about it where only OpenGL ES refuses a line: numbers are not
/// converted from int to float.
std::string es_message(const std::string& log);

}  // namespace texel::gl
