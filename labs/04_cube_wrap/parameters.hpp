// SPDX-License-Identifier: MIT
// The parameters of lab 4. Nothing to do for you here.
#pragma once
#include "app/camera.hpp"
#include "app/models.hpp"
#include "params/set.hpp"

namespace texel::cube_wrap {

enum class Method { before, stretched, split, weld };
inline constexpr params::Item kMethods[] = {
    {"before", "One vertex per corner of the cube, the report's first table: four faces are smeared"},
    {"stretched",
     "One vertex per corner of the cube, the report's workaround: one copy stretched around all sides"},
    {"split", "Each face has its own vertices: 24 for the cube; other models have three per triangle"},
    {"weld", "One vertex for each distinct position, texcoord and normal: as few as possible"}};

enum class Normals { by_method, shared, face };
inline constexpr params::Item kNormals[] = {
    {"by-method", "Shared if vertices are shared (before, stretched), else the model's own"},
    {"shared", "One normal for all faces that meet at a point: smooth, and wrong at a cube's edge"},
    {"face", "Each triangle's own: triangles that face different ways cannot share vertices"}};

struct CubeWrapParameters {
  std::string model, texture;
  Method method{};
  Normals normals{};
  float texture_scale{};
  app::Light light;
  float turn{};
  app::OrbitCamera camera;

  void declare(params::Set& set) {
    set.section("Wrapping");
    set.add(method,
            {"method", Method::weld, kMethods, "Which faces share a vertex and its texture coordinate"});
    set.add(normals, {"normals", Normals::by_method, kNormals, "Which faces share a normal"});
    set.add(model, {"model", "cube", app::kModels, "What is wrapped"});
    set.add(texture, {"texture", "label_grid", app::kTextures, "The picture on it (keys K and L)"});
    set.add(texture_scale,
            {"texture_scale", 1, 0.1, 20, "", "How often the picture repeats", params::Scale::logarithmic});
    light.declare<app::Lighting{}>(set);
    set.section("Turn");
    set.add(turn, {"turn", 0, -360, 360, "degrees", "Turns the model about the vertical axis"});
    camera.declare<app::Look{.yaw = 32, .pitch = 24, .distance = 2.7F}>(set);
  }
};

}  // namespace texel::cube_wrap
