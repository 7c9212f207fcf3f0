// SPDX-License-Identifier: MIT
// The parameters of lab 7. Nothing to do for you here.
#pragma once
#include "app/camera.hpp"
#include "app/environment.hpp"
#include "params/set.hpp"

namespace texel::environment {

enum class Method { inverse_by_factors, inverse_of_product, unproject, analytic_ray };
inline constexpr params::Item kMethods[] = {
    {"inverse-by-factors", "Rotation and projection are inverted separately (worksheet)"},
    {"inverse-of-product",
     "inverse(projection * rotation of the view): one inverse, of a worse-conditioned matrix"},
    {"unproject", "A point of the quad in world space by inverse(projection * view), minus the eye"},
    {"analytic-ray", "From field of view and aspect ratio, rotated by the camera: nothing is inverted"}};

enum class Plane { near_plane, far_plane };
inline constexpr params::Item kPlanes[] = {{"near", "z = -1: the near plane"},
                                           {"far", "z = 1: the far plane"}};

enum class Precision { single_precision, double_precision };
inline constexpr params::Item kPrecisions[] = {{"float", "32 bits: 24 for the digits"},
                                               {"double", "64 bits: 53 for the digits"}};

enum class DepthMethod { test_off, plane_0999, far_plane };
inline constexpr params::Item kDepthMethods[] = {
    {"test-off", "Drawn first, without the depth test (worksheet)"},
    {"plane-0999",
     "At z = 0.999 with the depth test: hides everything farther away, which may be nearly everything"},
    {"far-plane",
     "Drawn last, at z = w with less-or-equal: behind everything, and only where nothing else is"}};

struct EnvironmentParameters {
  Method method{};
  Plane plane{};
  Precision precision{};
  DepthMethod depth_method{};
  float near_plane{}, far_plane{};
  std::string cube_map;
  int rings{}, segments{};
  app::OrbitCamera camera;

  void declare(params::Set& set) {
    set.section("Background");
    set.add(cube_map, {"cube_map", "scene", app::kCubeMaps, "What surrounds the scene (keys K and L)"});
    set.add(method, {"method", Method::analytic_ray, kMethods, "How a pixel finds its direction"});
    set.add(plane, {"plane", Plane::near_plane, kPlanes,
                    "Which points of the quad the matrix turns into directions"});
    set.add(precision, {"precision", Precision::double_precision, kPrecisions,
                        "The precision in which the matrix is inverted"});
    set.add(depth_method, {"depth_method", DepthMethod::far_plane, kDepthMethods,
                           "How the background stays behind the spheres"});
    set.section("Projection");
    set.add(near_plane,
            {"near", 0.0001, 1e-5, 2, "units", "Distance of the near plane", params::Scale::logarithmic});
    set.add(far_plane,
            {"far", 100, 20, 1000, "units", "Distance of the far plane", params::Scale::logarithmic});
    set.section("Spheres");
    set.add(rings, {"rings", 32, 2, 256, "", "Bands from pole to pole"});
    set.add(segments, {"segments", 64, 3, 512, "", "Quads around each band"});
    camera.declare<app::Look{.yaw = 0, .pitch = 0, .distance = 2.5F, .field_of_view = 90}>(set);
  }
};

}  // namespace texel::environment
