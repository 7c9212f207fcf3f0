// SPDX-License-Identifier: MIT
// The parameters of lab 2. Nothing to do for you here.
#pragma once
#include "app/camera.hpp"
#include "params/set.hpp"

namespace texel::multi_texture {

enum class Method { encoded, linear, premultiplied };
inline constexpr params::Item kMethods[] = {
    {"encoded", "Filter and combine the file's encoded values (the slides)"},
    {"linear", "Decode to linear light, combine, encode again; decals have straight alpha"},
    {"premultiplied", "Linear light; a decal's colour is multiplied by its alpha before filtering"}};

enum class Combine { multiply, mix, add, decal };
inline constexpr params::Item kCombines[] = {
    {"multiply", "color * Tex0 * Tex1 (the slides): the second picture is a filter or a light"},
    {"mix", "A mean of both, weighted by mix-factor"},
    {"add", "The second picture's light is added"},
    {"decal", "The second picture covers the first where its alpha says so"}};

enum class Minify {
  nearest,
  linear,
  nearest_mipmap_nearest,
  linear_mipmap_nearest,
  nearest_mipmap_linear,
  linear_mipmap_linear
};
inline constexpr params::Item kMinify[] = {
    {"nearest", "GL_NEAREST: one texel of the full picture"},
    {"linear", "GL_LINEAR: four texels of the full picture"},
    {"nearest-mipmap-nearest", "One texel of the nearest level"},
    {"linear-mipmap-nearest", "Four texels of the nearest level"},
    {"nearest-mipmap-linear", "One texel of each of two levels (the slides)"},
    {"linear-mipmap-linear", "Four texels of each of two levels: trilinear"}};

enum class Magnify { nearest, linear };
inline constexpr params::Item kMagnify[] = {{"nearest", "GL_NEAREST: texels are squares (the slides)"},
                                            {"linear", "GL_LINEAR: texels are blended"}};

enum class Mipmaps { driver, own };
inline constexpr params::Item kMipmaps[] = {
    {"driver", "glGenerateMipmap (the slides): the driver decides how to average"},
    {"own", "Made by the lab: exact averages of the area, rounded once"}};

inline constexpr params::Item kTextures[] = {{"brick", "A brick wall, 512x512"},
                                             {"brick_32", "The same wall in 32x32 texels"},
                                             {"wood", "Wooden planks"},
                                             {"scales", "A reptile's scales"},
                                             {"smile", "A face"},
                                             {"label_grid", "Cells with letters"},
                                             {"checker", "Black and white squares"},
                                             {"noise", "Grey clouds"},
                                             {"light_map", "The light of a lamp on a wall"},
                                             {"decal", "A badge; alpha is 0 around it"}};

struct MultiTextureParameters {
  std::string texture0, texture1;
  bool unit0_on{}, unit1_on{};
  int second_unit{};
  Method method{};
  Combine combine{};
  Minify minify{};
  Magnify magnify{};
  Mipmaps mipmaps{};
  float mix_factor{}, red{}, green{}, blue{}, texture_scale{}, tilt{};
  app::OrbitCamera camera;

  void declare(params::Set& set) {
    set.section("Texture units");
    set.add(texture0, {"texture0", "brick", kTextures, "The picture that Tex0 reads"});
    set.add(unit0_on, {"unit0_on", true, "Read the first unit; off: use white instead"});
    set.add(texture1, {"texture1", "light_map", kTextures, "The picture that Tex1 reads"});
    set.add(unit1_on, {"unit1_on", true, "Read the second unit; off: show only the first picture"});
    set.add(second_unit, {"second_unit", 1, 1, 255, "",
                          "Number of the second picture's texture unit, at most the driver's highest"});
    set.section("Combination");
    set.add(method, {"method", Method::premultiplied, kMethods, "In which values the pictures are combined"});
    set.add(combine, {"combine", Combine::multiply, kCombines, "How two colours become one"});
    set.add(mix_factor, {"mix_factor", 0.5, 0, 1, "", "Share of the second picture for combine mix"});
    set.add(red, {"red", 1, 0, 1, "", "Red of the colour that multiplies the first picture"});
    set.add(green, {"green", 1, 0, 1, "", "Green of that colour"});
    set.add(blue, {"blue", 1, 0, 1, "", "Blue of that colour"});
    set.section("Filter");
    set.add(minify,
            {"minify", Minify::linear_mipmap_linear, kMinify, "Filter where a pixel covers several texels"});
    set.add(magnify, {"magnify", Magnify::linear, kMagnify, "Filter where a texel covers several pixels"});
    set.add(mipmaps, {"mipmaps", Mipmaps::own, kMipmaps, "Who makes the smaller levels"});
    set.section("Square");
    set.add(texture_scale, {"texture_scale", 1, 0.01, 100, "", "How often the pictures repeat on the square",
                            params::Scale::logarithmic});
    set.add(tilt, {"tilt", 0, -89, 89, "degrees", "Leans the square back"});
    // At this distance the half-size 0.7 fills 0.7 of the picture's half height, as in the slides.
    camera.declare<app::Look{.yaw = 0, .pitch = 0, .distance = 2.4142135F, .field_of_view = 45}>(set);
  }
};

}  // namespace texel::multi_texture
