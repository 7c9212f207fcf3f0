// SPDX-License-Identifier: MIT
// The parameters of lab 5. Nothing to do for you here.
#pragma once
#include "app/camera.hpp"
#include "app/models.hpp"
#include "mesh/texcoords.hpp"
#include "params/set.hpp"

namespace texel::normal_map {

enum class Method {
  per_vertex,
  raw,
  screen_axes,
  cotangent,
  averaged,
  gram_schmidt,
  angle_weighted,
  mikktspace,
  analytic
};
inline constexpr params::Item kMethods[] = {
    {"per-vertex", "The map is read once per vertex and replaces its normal (the report's first attempt)"},
    {"raw", "The map's normal without a frame (report 3.4): wrong as soon as the model turns"},
    {"screen-axes", "Frame from dFdx and dFdy of the position (report 3.3): follows the screen, not s and t"},
    {"cotangent", "Frame from derivatives of position and texcoord in each pixel: needs no tangents"},
    {"averaged", "T and B of each triangle, averaged per vertex and interpolated, not orthogonal (slides)"},
    {"gram-schmidt", "Averaged tangents made orthogonal to the normal, with the sign of the bitangent"},
    {"angle-weighted", "The same, each triangle weighted by its angle at the vertex"},
    {"mikktspace", "Mikkelsen's rules, which programs that bake normal maps use"},
    {"analytic", "Exact tangents of sphere and torus; mikktspace elsewhere, exact on flat faces"}};

enum class Decode { standard, exact_flat };
inline constexpr params::Item kDecodes[] = {
    {"standard", "0 becomes -1 and 1 becomes 1: a flat 128, 128, 255 tilts by 0.32 degrees"},
    {"exact-flat", "The byte 128 becomes exactly 0: flat is exactly (0, 0, 1)"}};

enum class Filter { anisotropic, bilinear };
inline constexpr params::Item kFilters[] = {
    {"anisotropic", "Up to 8 samples along a long footprint, in two mipmap levels; the driver decides how"},
    {"bilinear", "Four texels of the full picture, exactly as OpenGL defines it; steps are checked with it"}};

inline constexpr params::Item kNormalMaps[] = {
    {"matching", "The map that belongs to the texture; flat if there is none"},
    {"brick", "Bricks and mortar"},
    {"wood", "Grain and joints"},
    {"scales", "Overlapping scales"},
    {"bump", "Smooth bumps"},
    {"flat", "No relief"}};

struct NormalMapParameters {
  std::string model, texture, normal_map;
  bool normal_mapping{};
  Method method{};
  Decode decode{};
  Filter filter{};
  float bump_strength{}, texture_scale{};
  mesh::TextureLayout layout;
  app::Tessellation tessellation;
  app::Light light;
  float turn{}, stretch{};
  app::OrbitCamera camera;

  void declare(params::Set& set) {
    set.section("Normal mapping");
    set.add(normal_mapping,
            {"normal_mapping", true, "Light with the map's normals; off: with the surface's own (key M)"});
    set.add(method,
            {"method", Method::mikktspace, kMethods, "The frame in which the map's normals are read"});
    set.add(decode, {"decode", Decode::standard, kDecodes, "How a colour becomes a normal"});
    set.add(bump_strength,
            {"bump_strength", 1, 0, 4, "", "Steepness of the relief: multiplies the normal's x and y"});
    set.section("Textures");
    set.add(texture, {"texture", "brick", app::kTextures, "Colour of the surface (keys K and L)"});
    set.add(normal_map, {"normal_map", "matching", kNormalMaps, "Relief of the surface"});
    set.add(filter, {"filter", Filter::anisotropic, kFilters, "How both textures are filtered"});
    set.add(texture_scale,
            {"texture_scale", 1, 0.1, 20, "", "How often the texture repeats", params::Scale::logarithmic});
    set.add(layout.shear, {"texture_shear", 0, -2, 2, "",
                           "Shears the texture: adds this much of t to s; 1 is 45 degrees on a square"});
    set.add(layout.stretch, {"texture_stretch", 1, 0.1, 10, "", "Repeats along s only: squeezes the texture",
                             params::Scale::logarithmic});
    set.add(layout.mirror, {"mirror", false, "s runs the other way, so the frame is left-handed"});
    set.section("Model");
    set.add(model, {"model", "cube", app::kModels, "What is drawn"});
    set.add(tessellation.segments,
            {"segments", 0, 0, 256, "",
             "Squares along the longer side; 0: sphere 64, torus 96, cube and quad 1. Not for files"});
    set.add(tessellation.jitter,
            {"jitter", 0, 0, 1, "", "Moves the vertices along the exact surface: irregular triangles"});
    set.add(turn, {"turn", 0, -360, 360, "degrees", "Turns the model about the vertical axis"});
    set.add(stretch,
            {"stretch", 1, 0.25, 4, "", "Scales the model along y; normals do not move like points"});
    light.declare<app::Lighting{.yaw = 70, .pitch = 35, .ambient = 0.2F, .specular = 0.2F}>(set);
    camera.declare<app::Look{.yaw = 32, .pitch = 24, .distance = 3}>(set);
  }
};

}  // namespace texel::normal_map
