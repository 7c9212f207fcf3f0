// SPDX-License-Identifier: MIT
// The quad, the three cubes, the sphere and the torus.
#include <array>

#include "models_list.hpp"
#include "models_shapes.hpp"

namespace texel::assets {

namespace {

const std::string made = "\nMade by make_assets (assets/make/models_basic.cpp). CC0 1.0.";

constexpr double half_edge = 0.575;  // the corners of the cube lie just inside the unit sphere

// The report's order: front bottom left, upper left, upper right, bottom right, then the same at the back.
constexpr std::array<dvec3, 8> cube_corners{
    {{-1, -1, 1}, {-1, 1, 1}, {1, 1, 1}, {1, -1, 1}, {-1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {1, -1, -1}}};

// Each face from its bottom left corner, counter-clockwise seen from outside: front, back, left, right, top,
// bottom.
constexpr std::array<std::array<int, 4>, 6> cube_faces{
    {{0, 3, 2, 1}, {7, 4, 5, 6}, {4, 0, 1, 5}, {3, 7, 6, 2}, {1, 2, 6, 5}, {4, 7, 3, 0}}};

}  // namespace

std::string quad() {
  Part part;
  const auto corner = [](double x, double y) {
    return Corner{{0.7 * x, 0.7 * y, 0}, {0.5 + 0.5 * x, 0.5 + 0.5 * y}, {0, 0, 1}};
  };
  part.add({corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)});
  ObjText obj("quad.obj: a square of half size 0.7 that faces +z, one copy of the texture." + made, "");
  obj.group("quad", "");
  obj.add(part);
  return obj.text();
}

std::string cube(CubeTexcoords texcoords) {
  const bool before = texcoords == CubeTexcoords::before;
  std::string text = before ? "# cube_before.obj: eight vertices with one texture coordinate each, before "
                              "the report's adjustment: the front\n"
                              "# is right, the back mirrored, the other four faces are smeared.\n"
                            : "# cube.obj: eight vertices with one texture coordinate each, the report's "
                              "table: every face is covered, but\n"
                              "# stretched, turned or mirrored.\n";
  text += "# Made by make_assets (assets/make/models_basic.cpp). CC0 1.0.\n";
  for (const dvec3& corner : cube_corners)
    for (int i = 0; i < 3; ++i)
      text += (i == 0 ? "v " : " ") + std::string(corner[i] < 0 ? "-" : "") + "0.575" + (i == 2 ? "\n" : "");
  text += before ? "vt 0 0\nvt 0 1\nvt 1 1\nvt 1 0\nvt 0 0\nvt 0 1\nvt 1 1\nvt 1 0\n"
                 : "vt 1 1\nvt 1 0\nvt 0 0\nvt 0 1\nvt 0 0\nvt 0 1\nvt 1 1\nvt 1 0\n";
  for (const auto& face : cube_faces) {
    text += "f";
    for (const int i : face) text += " " + std::to_string(i + 1) + "/" + std::to_string(i + 1);
    text += "\n";
  }
  return text;
}

std::string cube_split() {
  constexpr std::array<dvec2, 4> upright{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  Part part;
  for (const auto& corners : cube_faces) {
    Face face;
    for (std::size_t i = 0; i < 4; ++i)
      face.push_back({half_edge * cube_corners[std::size_t(corners[i])], upright[i], dvec3(0)});
    for (Corner& corner : face) corner.normal = face_normal(face);
    part.add(face);
  }
  ObjText obj("cube_split.obj: every face has its own upright copy of the texture and its own normal." + made,
              "");
  obj.group("cube", "");
  obj.add(part);
  return obj.text();
}

std::string sphere() {
  ObjText obj(
      "sphere.obj: the unit sphere, 64 x 32; u eastwards from the far side (-z, so that +z has u = 0.5), v "
      "from\n"
      "pole to pole; exact normals." +
          made,
      "");
  obj.group("sphere", "");
  obj.add(sphere_part(64, 32));
  return obj.text();
}

std::string torus() {
  ObjText obj(
      "torus.obj: radii 0.7 and 0.3 about the y axis, 64 x 32; u eastwards from the far side (-z), v upwards "
      "round\n"
      "the tube from its inner side; exact normals." +
          made,
      "");
  obj.group("torus", "");
  obj.add(torus_part(0.7, 0.3, 64, 32));
  return obj.text();
}

}  // namespace texel::assets
