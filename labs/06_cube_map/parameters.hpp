// SPDX-License-Identifier: MIT
// The parameters of lab 6. Nothing to do for you here.
#pragma once
#include "app/camera.hpp"
#include "app/environment.hpp"
#include "app/models.hpp"
#include "params/set.hpp"

namespace texel::cube_map {

enum class Mapping { sphere_2d, cube };
inline constexpr params::Item kMappings[] = {
    {"sphere-2d", "One picture by two angles: a seam at the back, and pinched at the poles"},
    {"cube", "Six pictures by the direction of the normal"}};

enum class Method { worksheet, nearest, linear, linear_seamless, mipmapped };
inline constexpr params::Item kMethods[] = {
    {"worksheet", "Left picture on +X, right on -X, all flipped on upload, nearest when minified"},
    {"nearest", "One texel"},
    {"linear", "Four texels of one face: the cube's edges are visible if the picture is enlarged"},
    {"linear-seamless", "Four texels, from the neighbouring faces too"},
    {"mipmapped", "The same in the two nearest mipmap levels"}};

enum class Faces { by_method, specification, sides_swapped, upside_down };
inline constexpr params::Item kFaces[] = {
    {"by-method", "The worksheet's order for the method worksheet, else the specification's"},
    {"specification", "Each picture on its own face, top row first"},
    {"sides-swapped", "The left picture on +X and the right one on -X"},
    {"upside-down", "Each picture on its own face, bottom row first"}};

enum class SeamMethod { naive, select, wrapped, analytic };
inline constexpr params::Item kSeamMethods[] = {
    {"naive", "Differences of the coordinates: at the seam a pixel seems to cover the whole picture"},
    {"select", "Counts u from -1/2 or from 0, whichever does not jump here"},
    {"wrapped", "Takes the difference of u the short way round"},
    {"analytic", "Derivative of the formula instead of differences"}};

struct CubeMapParameters {
  Mapping mapping{};
  Method method{};
  Faces faces{};
  SeamMethod seam_method{};
  std::string cube_map, picture;
  int rings{}, segments{};
  float tilt{}, turn{};
  app::OrbitCamera camera;

  void declare(params::Set& set) {
    set.section("Texture");
    set.add(mapping, {"mapping", Mapping::cube, kMappings, "How the sphere finds its colour"});
    set.section("Cube map");
    set.add(cube_map, {"cube_map", "scene", app::kCubeMaps, "The six pictures (keys K and L)"});
    set.add(method, {"method", Method::mipmapped, kMethods, "How the cube map is uploaded and filtered"});
    set.add(faces, {"faces", Faces::by_method, kFaces, "Which picture is on which face, and which way up"});
    set.section("Picture by angles");
    set.add(picture, {"picture", "label_grid", app::kTextures, "The picture for mapping sphere-2d"});
    set.add(seam_method, {"seam_method", SeamMethod::analytic, kSeamMethods,
                          "How the level of detail is found where u jumps (for mapping sphere-2d)"});
    set.section("Sphere");
    set.add(tilt, {"tilt", 0, -180, 180, "degrees", "Leans the sphere forward: 90 shows its north pole"});
    set.add(turn, {"turn", 0, -360, 360, "degrees", "Turns the sphere about its poles: 180 shows the seam"});
    set.add(rings, {"rings", 32, 2, 256, "", "Bands from pole to pole"});
    set.add(segments, {"segments", 64, 3, 512, "", "Quads around each band"});
    camera.declare<app::Look{.yaw = 0, .pitch = 0, .distance = 3}>(set);
  }
};

}  // namespace texel::cube_map
