// SPDX-License-Identifier: MIT
// The parameters of lab 1. Nothing to do for you here.
#pragma once
#include "app/camera.hpp"
#include "params/set.hpp"

namespace texel::texture_quad {

enum class Method { nearest, bilinear, trilinear, anisotropic, supersampled };
inline constexpr params::Item kMethods[] = {
    {"nearest", "The texel under the pixel's centre (the slides)"},
    {"bilinear", "Four texels of the full picture, weighted by distance; skips texels when far away"},
    {"trilinear", "Bilinear in the two nearest mipmap levels, weighted by level of detail"},
    {"anisotropic",
     "Several trilinear samples along the longer side of the pixel's footprint; the driver's filter"},
    {"supersampled", "Four trilinear samples in each pixel, each half as wide"}};

enum class Wrap { repeat, mirrored, clamp };
inline constexpr params::Item kWraps[] = {
    {"repeat", "Only the coordinate's fraction counts: the picture is tiled"},
    {"mirrored", "Every second tile is mirrored"},
    {"clamp", "The border texels are repeated"}};

enum class Minify {
  by_method,
  nearest,
  linear,
  nearest_mipmap_nearest,
  linear_mipmap_nearest,
  nearest_mipmap_linear,
  linear_mipmap_linear
};
inline constexpr params::Item kMinify[] = {{"by-method", "As the method says"},
                                           {"nearest", "GL_NEAREST"},
                                           {"linear", "GL_LINEAR"},
                                           {"nearest-mipmap-nearest", "One texel of the nearest level"},
                                           {"linear-mipmap-nearest", "Four texels of the nearest level"},
                                           {"nearest-mipmap-linear", "One texel of each of two levels"},
                                           {"linear-mipmap-linear", "Four texels of each of two levels"}};

enum class Magnify { by_method, nearest, linear };
inline constexpr params::Item kMagnify[] = {
    {"by-method", "As the method says"}, {"nearest", "GL_NEAREST"}, {"linear", "GL_LINEAR"}};

inline constexpr params::Item kTextures[] = {
    {"brick", "A brick wall, 512x512"},
    {"brick_32", "The same wall in 32x32 texels"},
    {"label_grid", "Cells with letters: shows every flip and swap"},
    {"checker", "Black and white squares: the hardest case for filters"},
    {"sine_sweep", "Waves that get finer towards the limit of the texels"},
    {"stripes", "Stripes along t: a filter as narrow as the footprint keeps them sharp"},
    {"wood", "Wooden planks"},
    {"scales", "A reptile's scales"},
    {"smile", "A face"},
    {"label_npot", "100x75 texels in RGB: the sizes are no powers of two"},
    {"noise", "Noise of all frequencies"},
    {"hard_1x1", "A single texel"},
    {"hard_grey_33x17", "Grey, odd size"},
    {"hard_grey16_67x13", "Grey with 16 bits"},
    {"hard_grey_alpha_31x19", "Grey and alpha"},
    {"hard_rgb_35x21", "RGB, odd size"},
    {"hard_rgba_37x23", "RGBA, odd size"}};

struct TextureQuadParameters {
  Method method{};
  std::string texture;
  Wrap wrap{};
  Minify minify{};
  Magnify magnify{};
  bool flip_v{}, linear_light{};
  float texture_scale{}, texture_offset{}, tilt{};
  app::OrbitCamera camera;

  void declare(params::Set& set) {
    set.section("Texture");
    set.add(texture, {"texture", "brick", kTextures, "The picture on the square"});
    set.add(flip_v, {"flip_v", false, "Upload the picture's top row first: upside down in OpenGL"});
    set.add(wrap, {"wrap", Wrap::repeat, kWraps, "What texture coordinates outside 0 to 1 show"});
    set.add(texture_scale, {"texture_scale", 1, 0.01, 100, "", "How often the picture repeats on the square",
                            params::Scale::logarithmic});
    set.add(texture_offset, {"texture_offset", 0, 0, 1e7, "",
                             "Added to the coordinates; at 1e6 a float32 has only 4 bits for the fraction"});
    set.section("Filter");
    set.add(method, {"method", Method::supersampled, kMethods, "How texels become a pixel"});
    set.add(minify, {"minify", Minify::by_method, kMinify, "Filter where a pixel covers several texels"});
    set.add(magnify, {"magnify", Magnify::by_method, kMagnify, "Filter where a texel covers several pixels"});
    set.add(linear_light,
            {"linear_light", true, "Average linear light; off: average encoded values, as the slides do"});
    set.section("Square");
    set.add(tilt, {"tilt", 0, -89, 89, "degrees", "Leans the square back"});
    // At this distance the half-size 0.7 fills 0.7 of the picture's half height, as in the slides.
    camera.declare<app::Look{.yaw = 0, .pitch = 0, .distance = 2.4142135F, .field_of_view = 45}>(set);
  }
};

}  // namespace texel::texture_quad
