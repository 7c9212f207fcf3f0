// SPDX-License-Identifier: MIT
// Small meshes on which importers, tangent frames and triangulations go wrong.
#include <cmath>
#include <numbers>
#include <utility>

#include "models_list.hpp"
#include "models_shapes.hpp"

namespace texel::assets {

namespace {

constexpr double pi = std::numbers::pi;

std::string made(const std::string& comment) {
  return comment + "\nMade by make_assets (assets/make/models_hard.cpp). CC0 1.0.";
}

std::string head(const std::string& comment) {
  ObjText obj(made(comment), "");
  return obj.text();
}

/// A flat mesh in the plane z = 0 that faces +z; texture coordinates from the position.
template <class Texcoord>
Part flat(const std::vector<std::vector<dvec2>>& faces, const Texcoord& texcoord) {
  Part part;
  for (const auto& points : faces) {
    Face face;
    for (const dvec2 p : points) face.push_back({{p.x, p.y, 0}, texcoord(p), {0, 0, 1}});
    part.add(std::move(face));
  }
  return part;
}

std::vector<dvec2> rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

dvec2 upright(dvec2 p) {
  return 0.5 + p / 1.4;  // one copy on the square
}

std::string text_of(const std::string& comment, const Part& part, const ObjStyle& style = {}) {
  ObjText obj(made(comment), "", style);
  obj.add(part);
  return obj.text();
}

std::string degenerate_uv() {
  Part part = flat({rectangle(-0.7, 0, 0, 0.7), rectangle(0, -0.7, 0.7, 0)}, upright);
  part += flat({rectangle(0, 0, 0.7, 0.7)}, [](dvec2) { return dvec2(0.5); });
  part += flat({rectangle(-0.7, -0.7, 0, 0)}, [](dvec2 p) { return dvec2(0.5 + 0.3 * (p.x + p.y)); });
  return text_of(
      "degenerate_uv.obj: two good quads, one whose texture coordinates are all one point and one where they "
      "lie on\n"
      "a line. Hard for tangents: the zero-area ones must not spread NaN to the vertices that they share.",
      part);
}

std::string slivers() {
  std::vector<std::vector<dvec2>> faces;
  constexpr int count = 48;
  for (int i = 0; i < count; ++i)  // a fan from one corner
    faces.push_back({{-0.8, 0}, {0.8, 0.8 * i / count}, {0.8, 0.8 * (i + 1) / count}});
  for (int i = 0; i < 8; ++i) {  // strips, each three times thinner than the one before
    const double y = -0.1 * i, thin = std::pow(10.0, -1 - 0.5 * i);
    faces.push_back({{-0.8, y - thin}, {0.8, y - thin}, {0.8, y}});
  }
  return text_of(
      "slivers.obj: a fan of thin triangles, and triangles of ratio 16 to 50000. Hard for tangents and "
      "normals that\n"
      "divide by an area, or that weight by it.",
      flat(faces, upright));
}

std::vector<dvec2> star() {
  std::vector<dvec2> points;
  for (int i = 0; i < 10; ++i) {
    const double angle = pi * (0.5 + 0.2 * i), radius = i % 2 == 0 ? 0.9 : 0.36;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return points;
}

std::vector<dvec2> letter_c() {
  return {{0.6, -0.8}, {0.6, -0.5}, {-0.3, -0.5}, {-0.3, 0.5},
          {0.6, 0.5},  {0.6, 0.8},  {-0.6, 0.8},  {-0.6, -0.8}};
}

std::vector<dvec2> letter_l() {
  return {{0.6, -0.8}, {0.6, -0.4}, {-0.2, -0.4}, {-0.2, 0.8}, {-0.6, 0.8}, {-0.6, -0.8}};
}

Part small_torus(double scale, dvec3 offset) {
  Part part = torus_part(0.7, 0.3, 24, 12);
  for (Face& face : part.faces)
    for (Corner& corner : face) corner.position = scale * corner.position + offset;
  return part;
}

std::vector<NamedText> models_for_mikktspace() {
  return {
      {"opposite_tangents",
       head("opposite_tangents.obj: a flat roof of four triangles around its tip; u runs around, v up. Hard "
            "for "
            "MikkTSpace: T is\nexactly opposite in each two that face each other, and these must not be "
            "added up.") +
           "v 0 0 0.3\nv 0.7 -0.7 0\nv 0.7 0.7 0\nv -0.7 0.7 0\nv -0.7 -0.7 0\n"
           "vt 0.5 1\nvt 0 0\nvt 0.25 0\nvt 0.5 0\nvt 0.75 0\nvt 1 0\nvn 0 0 1\n"
           "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/4/1\nf 1/1/1 4/4/1 5/5/1\nf 1/1/1 5/5/1 2/6/1\n"},
      {"three_at_an_edge",
       head("three_at_an_edge.obj: three sheets that meet in one edge; two run along it one way, the third "
            "the other way. Hard for\nMikkTSpace: the third is the neighbour of the first alone.") +
           "v 0 0 0\nv 0 0.7 0\nv -0.7 0.7 0.2\nv -0.7 -0.7 0.4\nv 0.7 0 0\n"
           "vt 0 0\nvt 0 1\nvt -1 0\nvt 1 0\nvn 0 0 1\n"
           "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 2/2/1 4/3/1\nf 2/2/1 1/1/1 5/4/1\n"},
      {"no_texture_area",
       head("no_texture_area.obj: one good triangle, one without texture area at its long edge, one that "
            "only touches its corner,\nand one with two corners at the same place. Hard for MikkTSpace: "
            "which of them take the good one's T?") +
           "v 0 0 0\nv 0.7 0 0\nv 0 0.7 0\nv 0.7 0.7 0\nv -0.7 0 0\nv 0 -0.7 0\nv 0.7 -0.7 0\n"
           "v 0.7 -0.7 0\nvt 0 0\nvt 0 -1\nvt 1 0\nvt 0.5 -0.5\nvt 1 1\nvn 0 0 1\n"
           "f 1/1/1 2/2/1 3/3/1\nf 3/3/1 2/2/1 4/4/1\nf 1/1/1 5/1/1 6/1/1\nf 2/2/1 7/4/1 8/5/1\n"},
  };
}

}  // namespace

std::vector<NamedText> hard_models() {
  const std::vector<std::vector<dvec2>> square{rectangle(-0.7, -0.7, 0.7, 0.7)};
  const auto stripped = [](Part part) {
    for (Face& face : part.faces)
      for (Corner& corner : face) corner.normal = dvec3(0);
    return part;
  };
  std::vector<NamedText> models = {
      {"sheared_quad",
       text_of("sheared_quad.obj: u = x + y, a shear of 45 degrees. Hard for tangent frames: T and B are not "
               "at right\nangles, and Gram-Schmidt must choose which to keep.",
               flat(square, [](dvec2 p) { return dvec2(upright(p).x + upright(p).y, upright(p).y); }))},
      {"stretched_quad",
       text_of("stretched_quad.obj: four copies along u, one along v. Hard for bump heights: equal slopes in "
               "the texture are\nnot equal slopes on the surface.",
               flat(square, [](dvec2 p) { return dvec2(4 * upright(p).x, upright(p).y); }))},
      {"mirrored",
       text_of("mirrored.obj: two halves share one mirrored picture. Hard for handedness: on the left half u "
               "runs to the left,\nand averaging tangents across the middle gives zero.",
               flat({rectangle(-0.7, -0.7, 0, 0.7), rectangle(0, -0.7, 0.7, 0.7)},
                    [](dvec2 p) { return dvec2(std::abs(p.x) / 0.7, upright(p).y); }))},
      {"degenerate_uv", degenerate_uv()},
      {"slivers", slivers()},
      {"duplicate_vertices",
       text_of("duplicate_vertices.obj: a sphere as a soup: each face has v and vt lines of its own, and "
               "there are no vn. Hard for\nsmooth normals, tangents and any count of vertices: equal corners "
               "must be found again by welding.",
               stripped(sphere_part(16, 8)), {.shared = false})},
      {"concave_star", text_of("concave_star.obj: a five-pointed star as one polygon of ten corners. Hard "
                               "for triangulation: a fan leaves the\nstar.",
                               flat({star()}, upright))},
      {"concave_c", text_of("concave_c.obj: a letter C as one polygon of eight corners. Hard for "
                            "triangulation: a fan closes the gap.",
                            flat({letter_c()}, upright))},
      {"concave_l",
       text_of("concave_l.obj: a letter L as one polygon of six corners. Hard for triangulation: a fan fills "
               "the corner from\nsome starting corners and not from others.",
               flat({letter_l()}, upright))},
      {"tiny",
       text_of("tiny.obj: a torus of size 1e-6. Hard for absolute thresholds: every area is below 1e-12.",
               small_torus(1e-6, dvec3(0)), {.unit = 1e-6})},
      {"huge",
       text_of("huge.obj: a torus of size 1e6. Hard for near and far planes and for absolute thresholds.",
               small_torus(1e6, dvec3(0)), {.unit = 1e6})},
      {"far", text_of("far.obj: a torus of size 1 at 1e6 from the origin. Hard for single precision: the "
                      "step there is 1/16.",
                      small_torus(1, {1e6, 0, 0}), {.digits = 12})},
      {"slides_triangle",
       text_of("slides_triangle.obj: the slides' triangle with texture coordinates (0.5, 0), (1, 0.5), (0, "
               "1). Hard for tangents\nread off by eye: neither edge runs along u or v.",
               flat({{{-0.8, -0.6}, {0.8, -0.6}, {0, 0.8}}},
                    [](dvec2 p) {
                      return p.y > 0 ? dvec2(0, 1) : p.x > 0 ? dvec2(1, 0.5) : dvec2(0.5, 0);
                    }))},
      {"negative_indices",
       head("negative_indices.obj: a pyramid whose faces count back from the last vertex read so far. Hard "
            "for an importer that\nresolves them at the end of the file.") +
           "v -0.7 -0.5 0.7\nv 0.7 -0.5 0.7\nv 0 0.7 0\nvt 0 0\nvt 1 0\nvt 0.5 1\nf -3/-3 -2/-2 -1/-1\n"
           "v 0.7 -0.5 -0.7\nf -3/-3 -1/-2 -2/-1\nv -0.7 -0.5 -0.7\nf -2/-3 -1/-2 -3/-1\nf -1/-3 -5/-2 "
           "-3/-1\n"
           "vt 0 1\nvt 1 1\nf -1/-5 -2/-4 -4/-1 -5/-2\n"},
      {"no_vt", text_of("no_vt.obj: a torus whose corners are v//vn. Hard for a parser that expects a number "
                        "between the slashes; texture\ncoordinates must be made.",
                        small_torus(1, dvec3(0)), {.texcoords = false})},
      {"no_vn", text_of("no_vn.obj: a torus with v and vt alone. Hard where normals are expected: they must "
                        "be made, smooth across the seam\nof the texture.",
                        stripped(small_torus(1, dvec3(0))))},
      {"missing_mtllib",
       head("missing_mtllib.obj: groups and materials from a library that is not there. Hard for an importer "
            "that takes a missing\nlibrary for a broken model: it is worth a warning.") +
           "mtllib not_there.mtl\nv -0.7 -0.7 0\nv 0 -0.7 0\nv 0 0.7 0\nv -0.7 0.7 0\nv 0.7 -0.7 0\nv 0.7 "
           "0.7 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
           "o panel\ng left shared\nusemtl oak\ns off\nf 1/1 2/2 3/3 4/4\ng right shared\nusemtl pine\ns "
           "1\nf 2/1 5/2 6/3 3/4\n"},
  };
  for (NamedText& model : models_for_mikktspace()) models.push_back(std::move(model));
  return models;
}

}  // namespace texel::assets
