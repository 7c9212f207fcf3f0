// SPDX-License-Identifier: MIT
// The parameters of lab 3. Nothing to do for you here.
#pragma once
#include "app/camera.hpp"
#include "params/set.hpp"

namespace texel::obj_texcoords {

enum class Method { per_vertex, per_fragment };
inline constexpr params::Item kMethods[] = {
    {"per-vertex", "At import, each vertex gets the colour of its texel (the report's first attempt)"},
    {"per-fragment", "Each pixel reads the texture at its interpolated texture coordinate"}};

enum class Projection { from_file, planar, box, cylindrical, spherical, triplanar };
inline constexpr params::Item kProjections[] = {
    {"from-file", "The file's vt; box if it has none"},
    {"planar", "Along z, like a slide projector: the sides are smeared"},
    {"box", "Each triangle along the axis that it faces most: little stretch, but seams"},
    {"cylindrical", "Around the vertical axis, like a label on a tin: top and bottom are smeared"},
    {"spherical", "By longitude and latitude from the centre: squeezed at the poles"},
    {"triplanar", "Three planar projections blended in the shader by the normal: no seams, no vt needed"}};

enum class Normals { from_file, flat, smooth_area, smooth_angle };
inline constexpr params::Item kNormals[] = {
    {"from-file", "The file's vn; smooth-angle if it has none"},
    {"flat", "Each triangle's own normal: facets"},
    {"smooth-area", "The mean of the triangles around a vertex, weighted by area"},
    {"smooth-angle", "The same, weighted by angle: how faces are cut into triangles does not matter"}};

enum class Tint { none, materials, groups, vertices };
inline constexpr params::Item kTints[] = {
    {"none", "Only the picture"},
    {"materials", "A colour for each usemtl"},
    {"groups", "A colour for each g and o"},
    {"vertices", "A colour for each vertex of the stream: it runs on where triangles share a vertex"}};

inline constexpr params::Item kModels[] = {{"gator", "An alligator, six materials"},
                                           {"ship", "An ocean liner, eight materials"},
                                           {"cube", "The report's cube: eight v and eight vt"},
                                           {"cube_before", "The same before the report's adjustment"},
                                           {"cube_split", "A cube with a copy of the picture on each face"},
                                           {"sphere", "64 x 32 quads"},
                                           {"torus", "64 x 32 quads"},
                                           {"quad", "A square"}};

inline constexpr params::Item kTextures[] = {
    {"material", "The file's own map_Kd; label_grid if it names no picture"},
    {"brick", "A brick wall"},
    {"wood", "Wooden planks"},
    {"scales", "A reptile's scales"},
    {"smile", "A face"},
    {"label_grid", "Cells with letters: shows every flip, swap and seam"},
    {"checker", "Black and white squares: shows stretch and shear"}};

struct ObjTexcoordsParameters {
  std::string model, texture;
  Method method{};
  Projection projection{};
  Normals normals{};
  Tint tint{};
  bool flip_v{}, linear_light{};
  float texture_scale{};
  app::Light light;
  float turn{};
  app::OrbitCamera camera;

  void declare(params::Set& set) {
    set.section("File");
    set.add(model, {"model", "ship", kModels, "The OBJ file"});
    set.add(projection,
            {"projection", Projection::from_file, kProjections, "Where texture coordinates (vt) come from"});
    set.add(normals, {"normals", Normals::from_file, kNormals, "Where normals (vn) come from"});
    set.section("Texture");
    set.add(method, {"method", Method::per_fragment, kMethods, "Where the texture is read"});
    set.add(texture, {"texture", "material", kTextures, "The picture on the model (keys K and L)"});
    set.add(texture_scale,
            {"texture_scale", 1, 0.1, 20, "", "How often the picture repeats", params::Scale::logarithmic});
    set.add(flip_v, {"flip_v", false, "Use the picture's top row for t = 0: upside down in OpenGL"});
    set.add(tint, {"tint", Tint::none, kTints, "Colour the parts of the file, or the vertices"});
    set.add(linear_light, {"linear_light", true,
                           "Light and filter in linear light; off: with encoded values, as the report does"});
    light.declare<app::Lighting{.ambient = 0.35F, .specular = 0.05F}>(set);
    set.section("Turn");
    set.add(turn, {"turn", 0, -360, 360, "degrees", "Turns the model about the vertical axis"});
    camera.declare<app::Look{.yaw = 28, .pitch = 20, .distance = 2.7F}>(set);
  }
};

}  // namespace texel::obj_texcoords
