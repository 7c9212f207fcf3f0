// SPDX-License-Identifier: MIT
// The parameters of lab 9. Nothing to do for you here.
#pragma once
#include "app/camera.hpp"
#include "app/environment.hpp"
#include "params/set.hpp"

namespace texel::bump {

enum class Method { rotate_to_normal, sign_corrected, duff, hughes_moller, cross_up, uv_aligned, blinn };
inline constexpr params::Item kMethods[] = {
    {"rotate-to-normal",
     "Frisvad 2012, without making the result a unit vector (worksheet): imprecise near -z"},
    {"sign-corrected", "The same with |n.z|, mirrored for the other half: precise everywhere"},
    {"duff", "Duff et al. 2017: one formula for both halves"},
    {"hughes-moller", "Hughes and Moeller 1999: swaps two components, one square root"},
    {"cross-up", "Tangent perpendicular to n and to +y: along u, but undefined at the poles"},
    {"uv-aligned", "Tangent where u grows: the bumps follow the texture everywhere"},
    {"blinn", "Blinn 1978: the map's slopes as a height field on this sphere"}};

enum class Incident { constant_eye, per_fragment };
inline constexpr params::Item kIncidents[] = {{"constant-eye", "The same ray for every pixel (worksheet)"},
                                              {"per-fragment", "From the eye to the visible point"}};

enum class MipFilter { plain, toksvig, none };
inline constexpr params::Item kMipFilters[] = {
    {"plain", "Averaged normals as they are: from far away the relief is gone and the mirror smooth"},
    {"toksvig",
     "The shorter the averaged normal, the rougher the mirror: reads a smaller level of the cube map"},
    {"none", "No averages, four texels of the full map: noise from far away"}};

inline constexpr params::Item kNormalMaps[] = {{"bump", "Smooth bumps"},
                                               {"brick", "Bricks and mortar"},
                                               {"wood", "Grain and joints"},
                                               {"scales", "Overlapping scales"},
                                               {"flat", "No relief: 8 bits cannot hold it exactly"}};

struct BumpParameters {
  bool normal_mapping{};
  Method method{};
  std::string normal_map, cube_map;
  float bump_strength{};
  int repeats{};
  MipFilter mip_filter{};
  Incident incident{};
  int rings{}, segments{};
  float tilt{}, turn{};
  app::OrbitCamera camera;

  void declare(params::Set& set) {
    set.section("Bumps");
    set.add(normal_mapping,
            {"normal_mapping", true, "Reflect at the map's normals; off: at the ball's own (key M)"});
    set.add(method,
            {"method", Method::uv_aligned, kMethods, "The frame in which the map's normals are read"});
    set.add(normal_map, {"normal_map", "bump", kNormalMaps, "Relief of the ball"});
    set.add(bump_strength,
            {"bump_strength", 0.4, 0, 100, "", "Steepness of the relief: multiplies the normal's x and y"});
    set.add(repeats,
            {"repeats", 2, 1, 64, "", "How often the map repeats around the ball, and from pole to pole"});
    set.add(mip_filter, {"mip_filter", MipFilter::plain, kMipFilters, "How averaged normals are used"});
    set.section("Mirror");
    set.add(cube_map, {"cube_map", "scene", app::kCubeMaps, "What is reflected (keys K and L)"});
    set.add(incident,
            {"incident", Incident::per_fragment, kIncidents, "The ray that arrives at the surface (lab 8)"});
    set.section("Ball");
    set.add(rings, {"rings", 64, 2, 256, "", "Bands from pole to pole"});
    set.add(segments, {"segments", 128, 3, 512, "", "Quads around each band"});
    set.add(tilt, {"tilt", 0, -180, 180, "degrees", "Leans the ball forward: 90 shows its north pole"});
    set.add(turn, {"turn", 0, -360, 360, "degrees", "Turns the ball about its poles: 180 shows the seam"});
    camera.declare<app::Look{.yaw = 0, .pitch = 0, .distance = 2.5F, .field_of_view = 60}>(set);
  }
};

}  // namespace texel::bump
