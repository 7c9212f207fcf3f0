// SPDX-License-Identifier: MIT
// The parameters of lab 8. Nothing to do for you here.
#pragma once
#include "app/camera.hpp"
#include "app/environment.hpp"
#include "params/set.hpp"

namespace texel::reflection {

enum class Method { constant_eye, per_fragment };
inline constexpr params::Item kMethods[] = {
    {"constant-eye", "The same ray for every pixel, as if the ball were very far away (worksheet)"},
    {"per-fragment", "From the eye to the visible point"}};

enum class NormalMethod { interpolated, renormalized, analytic };
inline constexpr params::Item kNormalMethods[] = {
    {"interpolated", "As the rasteriser interpolates it: too short between the vertices"},
    {"renormalised", "Made a unit vector again in each pixel"},
    {"analytic", "The true sphere's normal where the ray meets it"}};

enum class Evaluate { vertex, fragment };
inline constexpr params::Item kEvaluate[] = {
    {"vertex", "Rays at the vertices, interpolated between them: cheap, but wrong on large triangles"},
    {"fragment", "Rays in each pixel"}};

enum class NormalMatrix { model, inverse_transpose };
inline constexpr params::Item kNormalMatrices[] = {
    {"model", "Transforms normals like edges: wrong as soon as the ball is stretched"},
    {"inverse-transpose", "Keeps normals perpendicular to the surface"}};

enum class Surface { mirror, refraction, fresnel, schlick };
inline constexpr params::Item kSurfaces[] = {
    {"mirror", "All light is reflected"},
    {"refraction", "All light is refracted once, where it enters; reflected where it cannot enter"},
    {"fresnel", "Both, in exact shares for unpolarised light between two dielectrics"},
    {"schlick", "Both, in the shares of Schlick's approximation"}};

enum class Lookup { cube, sphere_map, equirectangular };
inline constexpr params::Item kLookups[] = {
    {"cube", "The cube map"},
    {"sphere-map", "A picture of a mirror ball from +z: coarse and distorted towards -z"},
    {"equirectangular", "One picture by two angles, as in lab 6: fine at the poles, coarse at the horizon"}};

struct ReflectionParameters {
  Method method{};
  NormalMethod normal_method{};
  Evaluate evaluate{};
  NormalMatrix normal_matrix{};
  Surface surface{};
  float index{};
  Lookup lookup{};
  std::string cube_map;
  int rings{}, segments{};
  float stretch{}, tilt{}, turn{};
  app::OrbitCamera camera;

  void declare(params::Set& set) {
    set.section("Rays");
    set.add(method, {"method", Method::per_fragment, kMethods, "The ray that arrives at the surface"});
    set.add(normal_method,
            {"normal_method", NormalMethod::analytic, kNormalMethods, "The normal at which it is reflected"});
    set.add(evaluate, {"evaluate", Evaluate::fragment, kEvaluate, "Where the rays are computed"});
    set.add(normal_matrix, {"normal_matrix", NormalMatrix::inverse_transpose, kNormalMatrices,
                            "How the normal follows the ball's stretch and turn"});
    set.section("Surface");
    set.add(surface, {"surface", Surface::mirror, kSurfaces, "What happens to the light"});
    set.add(index, {"index", 1.5, 0.4, 3, "", "Index of refraction inside, relative to outside: glass 1.5"});
    set.section("Environment");
    set.add(cube_map, {"cube_map", "scene", app::kCubeMaps, "What is reflected (keys K and L)"});
    set.add(lookup, {"lookup", Lookup::cube, kLookups, "Where the rays' colours come from"});
    set.section("Ball");
    set.add(rings, {"rings", 32, 2, 256, "", "Bands from pole to pole"});
    set.add(segments, {"segments", 64, 3, 512, "", "Quads around each band"});
    set.add(stretch, {"stretch", 1, 0.25, 4, "", "Scales the ball along its axis"});
    set.add(tilt, {"tilt", 0, -180, 180, "degrees", "Leans the ball's axis forward"});
    set.add(turn, {"turn", 0, -360, 360, "degrees", "Turns the ball about the vertical axis"});
    camera.declare<app::Look{.yaw = 0, .pitch = 0, .distance = 2.5F, .field_of_view = 60}>(set);
  }
};

}  // namespace texel::reflection
