// SPDX-License-Identifier: MIT
// Lab 5 where tangent frames are hard: leaning, squeezed and mirrored textures, coarse and irregular triangles, models
// without texture area, slivers, doubled vertices, sizes and places at which float32 ends. What the default method
// survives, and by how much the others are known to fail.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/files.hpp"
#include "image/load.hpp"
#include "labs.hpp"
#include "mesh/ply.hpp"
#include "mesh/primitives.hpp"
#include "truth/ray.hpp"
#include "truth/relief.hpp"

namespace texel::test {
namespace {

using glm::dvec2;
using glm::dvec3;
using image::ImageF;

const char* const kLab5 = "lab05_normal_map";
constexpr int kSide = 128;  // pixels

/// The float pictures of the shots, by name. Drawn in one process.
std::map<std::string, ImageF> float_pictures(std::vector<Shot> shots) {
  const TemporaryFolder folder(fmt::format("lab5_{}", ::getpid()));
  for (Shot& shot : shots) shot.name += ".pfm";
  draw(kLab5, shots, folder);
  std::map<std::string, ImageF> pictures;
  for (const Shot& shot : shots)
    pictures[shot.name.substr(0, shot.name.size() - 4)] = image::load_pfm(folder / shot.name);
  return pictures;
}

[[maybe_unused]] int count_non_finite(const ImageF& picture) {
  int count = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      if (!std::isfinite(picture.at(x, y, 0) + picture.at(x, y, 1) + picture.at(x, y, 2))) ++count;
  return count;
}

/// The number of pixels that the object covers, from the view `mask`.
[[maybe_unused]] int count_covered(const ImageF& mask) {
  int count = 0;
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x) count += mask.at(x, y, 0) > 0.5F ? 1 : 0;
  return count;
}

// ---- Tangents on surfaces with a formula, pixel by pixel.

const truth::Camera kCamera{.yaw = 32, .pitch = 24, .distance = 3, .width = kSide, .height = kSide};  // the lab's

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

/// Of a picture of unit vectors against what `exact` says of the point that a pixel sees.
template <class Exact>
Spread degrees_off(const ImageF& picture, const std::string& model, const truth::TexcoordMap& map, Exact exact) {
  std::vector<double> degrees;
  double sum = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const auto hit = hit_model(model, truth::pixel_ray(kCamera, dvec2(x + 0.5, y + 0.5)).ray);
      const dvec3 drawn(picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2));
      if (!hit || !(glm::length(drawn) > 0.5)) continue;  // at the outline
      const truth::Surface surface = truth::reparameterised(surface_of(model, hit->face), map);
      const dvec3 right = exact(surface(map.texcoord(hit->texcoord)));
      degrees.push_back(glm::degrees(std::atan2(glm::length(glm::cross(drawn, right)), glm::dot(drawn, right))));
      sum += degrees.back();
    }
  if (degrees.empty()) return {};
  std::sort(degrees.begin(), degrees.end());
  return {sum / static_cast<double>(degrees.size()), degrees[degrees.size() * 99 / 100]};
}

dvec3 along_s(const truth::SurfacePoint& point) {
  return truth::parametric_frame(point).tangent;
}
dvec3 steepest_s(const truth::SurfacePoint& point) {
  return truth::surface_gradient(point, {1, 0});
}

struct Layout {
  const char* name;
  Settings settings;
  truth::TexcoordMap map;
};
const Layout kPlain{"plain", {}, {}};
const Layout kMirrored{"mirrored", {{"mirror", "on"}}, truth::mirrored()};
const Layout kSqueezed{"squeezed", {{"texture_stretch", "4"}}, truth::stretched(4)};
const Layout kLong{"long", {{"texture_stretch", "0.25"}}, truth::stretched(0.25)};
const Layout kLeaning{"leaning", {{"texture_shear", "1"}}, truth::sheared(std::atan(1.0))};

/// The view `tangent` of a model under a layout.
ImageF tangents(const std::string& model, const Layout& layout, const std::string& method, const Settings& more = {}) {
  const Settings look = Settings{{"model", model}, {"method", method}, {"normal_map", "flat"}} + layout.settings + more;
  return float_pictures({{"tangent", look, "tangent", fmt::format("{0}x{0}", kSide)}}).at("tangent");
}

TEST(HardCaseOfLab5, measure) {
  for (const char* model : {"quad", "cube", "torus"})
    for (const Layout& layout : {kPlain, kMirrored, kSqueezed, kLong, kLeaning})
      for (const char* method : {"screen-axes", "cotangent", "averaged", "gram-schmidt", "angle-weighted", "mikktspace", "analytic"}) {
        const ImageF p = tangents(model, layout, method);
        const Spread a = degrees_off(p, model, layout.map, along_s), b = degrees_off(p, model, layout.map, steepest_s);
        printf("%s %s %s: T %.5f %.5f  grad %.5f %.5f\n", model, layout.name, method, a.mean, a.p99, b.mean, b.p99);
      }
  for (const char* model : {"torus", "sphere"})
   for (const char* method : {"mikktspace", "angle-weighted", "cotangent", "averaged"})
    for (const char* map : {"flat", "bump"})
    for (const char* j : {"0","1"}) { printf("%s %s %s j%s: ", model, method, map, j);
    for (const char* n : {"16", "32", "64", "128", "256"}) {
      const Figures f = measured(kLab5, {{"model", model}, {"method", method}, {"normal_map", map}, {"decode", "exact-flat"}, {"segments", n}, {"jitter", j}, {"truth", std::string(method)=="cotangent"?"height-field":"baked-map"}});
      printf(" %.4f/%.3f", f.mean, f.p99);
    } puts(""); }
}

}  // namespace
}  // namespace texel::test
