// SPDX-License-Identifier: MIT
// Lab 5 where tangent frames are hard: leaning, squeezed and mirrored textures, coarse and irregular
// triangles, models without texture area, slivers, doubled vertices, sizes and places at which float32 ends.
// What the default method survives, and by how much the others are known to fail.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "../support/meshes.hpp"
#include "../support/oracles.hpp"
#include "../support/tolerance.hpp"
#include "core/files.hpp"
#include "labs.hpp"
#include "mesh/ply.hpp"
#include "mesh/primitives.hpp"
#include "procedural/height_fields.hpp"
#include "truth/ray.hpp"
#include "truth/relief.hpp"

namespace texel::test {
namespace {

using glm::dvec2;
using glm::dvec3;
using image::ImageF;

const char* const kLab5 = "lab05_normal_map";

// ---- Tangents on surfaces with a formula, pixel by pixel.

const truth::Camera kCamera{.yaw = 32, .pitch = 24, .distance = 3};  // the lab's

std::optional<truth::Hit> hit_model(const std::string& model, const truth::Ray& ray) {
  if (model == "quad") return truth::hit_quad(ray, 0.7);
  if (model == "cube") return truth::hit_cube(ray, 0.577);
  return truth::hit_torus(ray, 0.7, 0.3);
}
truth::Surface surface_of(const std::string& model, procedural::Face face) {
  if (model == "quad") return truth::quad(0.7);
  if (model == "cube") return truth::cube_face(face, 0.577);
  return truth::torus(0.7, 0.3);
}

/// Degrees between two directions: mean and 99th percentile over the picture.
struct Spread {
  double mean = 0, p99 = 0;
};

/// Of a picture of unit vectors against what `exact(point, texcoord)` says of the point that a pixel sees.
template <class Exact>
Spread degrees_off(const ImageF& picture, const std::string& model, const truth::TexcoordMap& map,
                   Exact exact) {
  truth::Camera camera = kCamera;
  camera.width = picture.width, camera.height = picture.height;
  std::vector<double> degrees;
  double sum = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const auto hit = hit_model(model, truth::pixel_ray(camera, dvec2(x + 0.5, y + 0.5)).ray);
      const dvec3 drawn(picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2));
      if (!hit || !(glm::length(drawn) > 0.5)) continue;  // at the outline
      const truth::Surface surface = truth::reparameterized(surface_of(model, hit->face), map);
      const dvec2 texcoord = map.texcoord(hit->texcoord);
      const dvec3 right = exact(surface(texcoord), texcoord);
      degrees.push_back(test::angle_in_degrees(drawn, right));
      sum += degrees.back();
    }
  if (degrees.empty()) return {};
  std::sort(degrees.begin(), degrees.end());
  return {sum / static_cast<double>(degrees.size()), degrees[degrees.size() * 99 / 100]};
}

/// Where s grows and t does not.
dvec3 along_s(const truth::SurfacePoint& point, dvec2 /*texcoord*/ = {}) {
  return test::parametric_frame(point).tangent;
}
/// Where s grows fastest.
dvec3 steepest_s(const truth::SurfacePoint& point, dvec2 /*texcoord*/) {
  return truth::surface_gradient(point, {1, 0});
}

struct Layout {
  const char* name;
  Settings settings;
  truth::TexcoordMap map;
};
const Layout kPlain{"plain", {}, {}};
const Layout kMirrored{"mirrored", {{"mirror", "on"}}, test::mirrored()};
const Layout kSqueezed{"squeezed", {{"texture_stretch", "4"}}, test::stretched(4)};
const Layout kLong{"long", {{"texture_stretch", "0.25"}}, test::stretched(0.25)};
const Layout kLeaning{"leaning", {{"texture_shear", "1"}}, test::sheared(std::atan(1.0))};

/// The view `tangent` of a model under a layout.
ImageF tangents(const std::string& model, const Layout& layout, const std::string& method) {
  const Settings look =
      Settings{{"model", model}, {"method", method}, {"normal_map", "flat"}} + layout.settings;
  return float_pictures(kLab5, {{"tangent", look, "tangent", "128x128"}}).at("tangent");
}

TEST(HardCaseOfLab5, derivative_frame_is_exact_where_the_texture_keeps_right_angles) {
  // Position and texture coordinate are linear on a triangle, so that their differences from pixel to pixel
  // are exact but for float32: a step of 0.01 in a position of 1 is good to 1e-5 radians. Measured 0.0005
  // degrees at the 99th percentile; the cube's edges, where a pixel may lie on the other face, are the rest.
  for (const char* model : {"quad", "cube"})
    for (const Layout& layout : {kPlain, kMirrored, kSqueezed, kLong})
      EXPECT_BELOW(degrees_off(tangents(model, layout, "cotangent"), model, layout.map, along_s).p99, 0.002)
          << model << " " << layout.name;
}

TEST(HardCaseOfLab5, under_shear_the_derivative_frame_has_the_steepest_way_of_s_and_the_others_its_line) {
  // T is where s grows fastest, or where s grows and t does not: 45 degrees apart on a square that leans
  // by 45.
  const ImageF cotangent = tangents("quad", kLeaning, "cotangent"),
               mikktspace = tangents("quad", kLeaning, "mikktspace");
  EXPECT_BELOW(degrees_off(cotangent, "quad", kLeaning.map, steepest_s).p99, 0.002);
  EXPECT_WITHIN(degrees_off(cotangent, "quad", kLeaning.map, along_s).mean, 45, 0.01);
  EXPECT_BELOW(degrees_off(mikktspace, "quad", kLeaning.map, along_s).p99, 0.0001);
  EXPECT_WITHIN(degrees_off(mikktspace, "quad", kLeaning.map, steepest_s).mean, 45, 0.01);
}

TEST(HardCaseOfLab5, screen_axes_are_tens_of_degrees_off_and_turned_round_on_a_mirrored_texture) {
  // Measured 20 on the cube, whose walls happen to stand along the screen, 53 on the torus, and 127 mirrored.
  const auto mean = [](const char* model, const Layout& layout) {
    return degrees_off(tangents(model, layout, "screen-axes"), model, layout.map, along_s).mean;
  };
  EXPECT_ABOVE(mean("cube", kPlain), 15);
  EXPECT_ABOVE(mean("torus", kPlain), 40);
  EXPECT_ABOVE(mean("torus", kMirrored), 90);
}

TEST(HardCaseOfLab5, tangents_in_a_pixel_are_those_of_the_triangles_on_the_torus) {
  // Measured in the mean: 0.73 (flat triangles), 0.11, 0.08, 0.08, 0.07 and 0.06: of the latter, the place of
  // the flat triangle's pixel on the round surface, not the tangents.
  for (const auto& [method, limit] : {std::pair("cotangent", 1.0),
                                      {"averaged", 0.15},
                                      {"gram-schmidt", 0.11},
                                      {"angle-weighted", 0.11},
                                      {"mikktspace", 0.1},
                                      {"analytic", 0.09}})
    for (const Layout& layout : {kPlain, kMirrored})
      EXPECT_BELOW(degrees_off(tangents("torus", layout, method), "torus", layout.map, along_s).mean, limit)
          << method << " " << layout.name;
}

// ---- Shading normals against the two truths.

TEST(HardCaseOfLab5, derivative_frame_has_the_slope_of_a_height_field_but_for_one_factor) {
  // It is scaled to the longer of its two vectors. Under shear the gradient of s is sqrt(2) times as long as
  // that of t; squeezed, 4 times. Measured 0.14 and 0.21 where pixels are small: 8 bits and the filter.
  for (const auto& [layout, too_long] : {std::pair(kLeaning, std::sqrt(2.0)), {kSqueezed, 4.0}}) {
    const ImageF normals =
        float_pictures(kLab5, {{"normal",
                                Settings{{"model", "quad"}, {"method", "cotangent"}, {"normal_map", "bump"}} +
                                    layout.settings,
                                "normal", "512x512"}})
            .at("normal");
    const auto relief = [factor = too_long](const truth::SurfacePoint& point, dvec2 texcoord) {
      const procedural::Dual height =
          procedural::height(procedural::HeightField::bump, texcoord.s, texcoord.t);
      return truth::relief_normal(point, 1.4 / factor * dvec2(height.du, height.dv));  // the quad is 1.4 wide
    };
    EXPECT_BELOW(degrees_off(normals, "quad", layout.map, relief).mean, 0.45) << layout.name;
  }
}

// ---- Models that are hard.

/// An OBJ file of 4 x 4 squares from 0 to 1 in the plane z = 0.
template <class Texcoord>
std::string sheet(Texcoord texcoord) {
  std::string obj;
  for (int j = 0; j <= 4; ++j)
    for (int i = 0; i <= 4; ++i) {
      const dvec2 st = texcoord(i / 4.0, j / 4.0);
      obj += fmt::format("v {} {} 0\nvt {} {}\n", i / 4.0, j / 4.0, st.s, st.t);
    }
  for (int j = 0; j < 4; ++j)
    for (int i = 1; i <= 4; ++i) {
      const int a = 5 * j + i;
      obj += fmt::format("f {0}/{0} {1}/{1} {2}/{2} {3}/{3}\n", a, a + 1, a + 6, a + 5);
    }
  return obj;
}

/// The mesh as an OBJ file, every vertex moved: position * size + offset.
std::string obj_of(const mesh::Mesh& mesh, double size = 1, double offset = 0) {
  std::string obj;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const dvec3 p = dvec3(mesh.positions[v]) * size + offset;
    const glm::vec3& n = mesh.normals[v];
    obj += fmt::format("v {} {} {}\nvt {} {}\nvn {} {} {}\n", p.x, p.y, p.z, mesh.texcoords[v].s,
                       mesh.texcoords[v].t, n.x, n.y, n.z);
  }
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    obj += fmt::format("f {0}/{0}/{0} {1}/{1}/{1} {2}/{2}/{2}\n", mesh.indices[i] + 1,
                       mesh.indices[i + 1] + 1, mesh.indices[i + 2] + 1);
  return obj;
}

std::map<std::string, std::string> hard_models() {
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
  const std::string plain = sheet([](double x, double y) { return dvec2(x, y); });
  std::string slivers;
  for (int i = 0; i <= 64; ++i)
    for (const double y : {0.0, i % 2 == 0 ? 1.0 : 1e-6})
      slivers += fmt::format("v {0} {1} 0\nvt {0} {1}\n", i / 64.0, y);
  for (int i = 0; i < 64; ++i)
    slivers += fmt::format("f {0}/{0} {1}/{1} {2}/{2}\nf {0}/{0} {2}/{2} {3}/{3}\n", 2 * i + 1, 2 * i + 3,
                           2 * i + 4, 2 * i + 2);
  std::string behind;  // each square once more, from behind: smooth normals cancel
  for (std::size_t at = plain.find("\nf "); at != std::string::npos; at = plain.find("\nf ", at + 1)) {
    std::istringstream face(plain.substr(at + 2, plain.find('\n', at + 1) - at - 2));
    std::string a, b, c, d;
    face >> a >> b >> c >> d;
    behind += fmt::format("f {} {} {} {}\n", d, c, b, a);
  }
  mesh::Mesh one_pole = mesh::sphere(12, 24);  // the last 24 vertices are the north pole's
  for (std::uint32_t& index : one_pole.indices)
    index = std::min(index, static_cast<std::uint32_t>(one_pole.vertex_count()) - 24);
  mesh::Mesh no_seam = mesh::sphere(12, 24);  // the last column's squares run back through the whole texture
  for (std::uint32_t& index : no_seam.indices)
    if (index < 25 * 11 && index % 25 == 24) index -= 24;
  return {{"texture of one point", sheet([](double, double) { return dvec2(0.3, 0.7); })},
          {"texture on a line", sheet([](double x, double y) { return dvec2(x + y, x + y); })},
          {"texture on a part", sheet([](double x, double y) { return dvec2(std::max(x, 0.5), y); })},
          {"mirrored twice",
           sheet([](double x, double y) { return dvec2(std::abs(2 * x - 1), std::abs(2 * y - 1)); })},
          {"texture of 1e-20", sheet([](double x, double y) { return 1e-20 * dvec2(x, y); })},
          {"texture of 1e20", sheet([](double x, double y) { return 1e20 * dvec2(x, y); })},
          {"texture at 1e6", sheet([](double x, double y) { return dvec2(x, y) + 1e6; })},
          {"slivers", slivers},
          {"faces from both sides", plain + behind},
          {"faces twice", plain + plain.substr(plain.find("f "))},
          {"normals opposed", square + "vn 0 0 1\nvn 0 0 -1\nf 1/1/1 2/2/2 3/3/1 4/4/2\n"},
          {"normals of length 0", square + "vn 0 0 0\nf 1/1/1 2/2/1 3/3/1 4/4/1\n"},
          {"palette", square + "vn 0.8 0 0.6\nvn 1 0 0\nf 1/1/1 2/1/1 3/1/1\nf 1/1/2 3/1/2 4/1/2\n"},
          {"normals along s", square + "vn 1 0 0\nf 1/1/1 2/2/1 3/3/1 4/4/1\n"},
          {"one vertex at the pole", obj_of(one_pole)},
          {"no seam", obj_of(no_seam)},
          {"the slides' triangle", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5 0\nvt 1 0.5\nvt 0 1\nf 1/1 2/2 3/3\n"}};
}

constexpr const char* kAllMethods[] = {"per-vertex",     "raw",        "screen-axes",
                                       "cotangent",      "averaged",   "gram-schmidt",
                                       "angle-weighted", "mikktspace", "analytic"};

TEST(HardCaseOfLab5, no_model_makes_a_normal_or_a_tangent_nan) {
  const TemporaryFolder folder("lab5_models");
  std::vector<Shot> shots;
  int number = 0;
  for (const auto& [name, obj] : hard_models()) {
    const std::string file = (folder / fmt::format("{}.obj", number++)).string();
    write_file(file, obj);
    for (const char* method : kAllMethods)
      for (const char* view : {"normal", "tangent"})
        shots.push_back({fmt::format("{} {} {}", name, method, view),
                         {{"model", file}, {"method", method}},
                         view,
                         "64x64"});
    // The default from the front as well, where symmetric values cancel exactly, in a picture with a middle
    // pixel.
    for (const char* view : {"normal", "tangent"})
      shots.push_back({fmt::format("{} front {}", name, view),
                       {{"model", file}, {"yaw", "0"}, {"pitch", "0"}},
                       view,
                       "65x65"});
  }
  for (const auto& [name, picture] : float_pictures(kLab5, shots))
    EXPECT_TRUE(std::all_of(picture.samples.begin(), picture.samples.end(), [](float sample) {
      return std::isfinite(sample);
    })) << name;
}

/// The vertex stream that the lab draws for an OBJ file.
mesh::Mesh drawn_mesh(const std::string& obj, const std::string& method) {
  const TemporaryFolder folder("lab5_mesh");
  const std::string in = (folder / "a.obj").string(), out = (folder / "a.ply").string();
  write_file(in, obj);
  const Result result = run_lab(kLab5, fmt::format("--model {} --method {} --mesh {}", in, method, out));
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  return test::read_ply(out);
}

TEST(HardCaseOfLab5, every_vertex_of_a_hard_model_has_a_unit_tangent_in_the_plane_of_its_normal) {
  for (const auto& [name, obj] : hard_models()) {
    const mesh::Mesh mesh = drawn_mesh(obj, "mikktspace");
    ASSERT_EQ(mesh.tangents.size(), mesh.vertex_count()) << name;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
      const glm::vec3 tangent(mesh.tangents[v]);
      EXPECT_WITHIN(glm::length(tangent), 1, 1e-6) << name;
      EXPECT_WITHIN(glm::dot(tangent, mesh.normals[v]), 0, 2e-6) << name;
    }
  }
}

/// Degrees between the tangents of a drawn torus and the exact ones: the largest away from the seams.
double worst_tangent(const mesh::Mesh& drawn) {
  double worst = 0;
  for (std::size_t v = 0; v < drawn.vertex_count(); ++v) {
    const dvec2 st(drawn.texcoords[v]);
    if (st.s == 0 || st.s == 1 || st.t == 0 || st.t == 1) continue;
    const dvec3 exact = along_s(truth::torus(0.7, 0.3)(st)), tangent(glm::vec3(drawn.tangents[v]));
    worst = std::max(worst, test::angle_in_degrees(exact, tangent));
  }
  return worst;
}

TEST(HardCaseOfLab5, size_and_place_of_a_file_do_not_matter_until_float32_ends) {
  const mesh::Mesh torus = mesh::torus(0.7F, 0.3F, 48, 24);
  const auto worst = [&](double size, double offset) {
    return worst_tangent(drawn_mesh(obj_of(torus, size, offset), "mikktspace"));
  };
  // Moved and scaled to the same size: measured 2e-5 to 4e-5 degrees.
  for (const auto& [size, offset] : {std::pair(1.0, 0.0), {1e-6, 0.0}, {1e6, 0.0}, {1e6, 1e6}, {1e-6, 1e-6}})
    EXPECT_BELOW(worst(size, offset), 1e-4) << size << " at " << offset;
  // A small model far away has lost its digits in the file's own coordinates. At 1000 they count in steps of
  // 6e-5, against triangles of 0.08. Measured, the worst tangent: 0.02, 0.24, 2.8 and 17 degrees.
  EXPECT_BELOW(worst(1, 1e3), 0.05);
  EXPECT_BELOW(worst(1, 1e4), 0.5);
  EXPECT_BELOW(worst(1, 1e5), 5);
  EXPECT_ABOVE(worst(1, 1e6), 5);
}

}  // namespace
}  // namespace texel::test
