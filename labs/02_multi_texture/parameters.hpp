// SPDX-License-Identifier: MIT
// What can be chosen in lab 2. Nothing to do for you here.
#pragma once
#include "app/camera.hpp"
#include "params/set.hpp"

namespace texel {

enum class Method { encoded, linear, premultiplied };
inline constexpr params::Item kMethods[] = {
    {"encoded", "Filter and combine the numbers as they stand in the file (the slides)"},
    {"linear", "Decode to linear light, combine, encode again; a decal's alpha is straight"},
    {"premultiplied", "Linear light, and a decal's colour is multiplied by its alpha before any filter"}};

enum class Combine { multiply, mix, add, decal };
inline constexpr params::Item kCombines[] = {
    {"multiply", "color * Tex0 * Tex1 (the slides): the second picture is a filter or a light"},
    {"mix", "So much of the one and so much of the other, by mix-factor"},
    {"add", "The second picture's light comes on top"},
    {"decal", "The second picture lies on the first where its alpha says so"}};

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
                                            {"linear", "GL_LINEAR: texels run into each other"}};

enum class Mipmaps { driver, own };
inline constexpr params::Item kMipmaps[] = {
    {"driver", "glGenerateMipmap (the slides): how it averages is up to the driver"},
    {"own", "Made by us: exact averages of the area, rounded once"}};

inline constexpr params::Item kTextures[] = {{"brick", "A brick wall, 512x512"},
                                             {"brick_32", "The same wall in 32x32 texels"},
                                             {"wood", "Wooden planks"},
                                             {"scales", "A reptile's scales"},
                                             {"smile", "A face"},
                                             {"label_grid", "Cells with letters"},
                                             {"checker", "Black and white squares"},
                                             {"noise", "Grey clouds"},
                                             {"light_map", "The pool of light of a lamp"},
                                             {"decal", "A badge; its alpha is 0 outside"}};

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
    set.add(unit0_on, {"unit0_on", true, "Read the first unit; off: as if its picture were white"});
    set.add(texture1, {"texture1", "light_map", kTextures, "The picture that Tex1 reads"});
    set.add(unit1_on, {"unit1_on", true, "Read the second unit; off: the first picture alone"});
    set.add(second_unit,
            {"second_unit", 1, 1, 255, "",
             "Number of the second picture's unit; beyond the driver's highest, the highest is taken"});
    set.section("Combination");
    set.add(method,
            {"method", Method::premultiplied, kMethods, "In which numbers the pictures are combined"});
    set.add(combine, {"combine", Combine::multiply, kCombines, "How two colours become one"});
    set.add(mix_factor, {"mix_factor", 0.5, 0, 1, "", "Part of the second picture when they are mixed"});
    set.add(red, {"red", 1, 0, 1, "", "Red part of the colour by which the first picture is multiplied"});
    set.add(green, {"green", 1, 0, 1, "", "Its green part"});
    set.add(blue, {"blue", 1, 0, 1, "", "Its blue part"});
    set.section("Filter");
    set.add(minify,
            {"minify", Minify::linear_mipmap_linear, kMinify, "Filter where a pixel covers several texels"});
    set.add(magnify, {"magnify", Magnify::linear, kMagnify, "Filter where a texel covers several pixels"});
    set.add(mipmaps, {"mipmaps", Mipmaps::own, kMipmaps, "Who makes the smaller levels"});
    set.section("Square");
    set.add(texture_scale, {"texture_scale", 1, 0.01, 100, "", "How often the pictures fit on the square",
                            params::Scale::logarithmic});
    set.add(tilt, {"tilt", 0, -89, 89, "degrees", "How far the square leans back"});
    // At this distance the half-size 0.7 fills 0.7 of the picture's half height, as in the slides.
    camera.declare<{.yaw = 0, .pitch = 0, .distance = 2.4142135F, .field_of_view = 45}>(set);
  }
};

}  // namespace texel
