// SPDX-License-Identifier: MIT
// Tangent frames and texture coordinates of models from files, as the labs draw them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "../support/meshes.hpp"
#include "../support/tolerance.hpp"
#include "core/files.hpp"
#include "image/load.hpp"
#include "image/save.hpp"
#include "labs.hpp"
#include "mesh/ply.hpp"
#include "mesh/texcoords.hpp"

namespace texel::test {
namespace {

using image::ImageF;

class Frames : public testing::Test {
 protected:
  TemporaryFolder folder_{fmt::format("frames_{}", ::getpid())};
};

/// A pyramid that is lit as if it were round: from corner to corner the normal turns by 55 degrees and more,
/// so that what is interpolated is far from orthonormal.
constexpr const char* kPyramid =
    "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv 0 0 0.7\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.5 0.5\n"
    "vn -1 -1 1\nvn 1 -1 1\nvn 1 1 1\nvn -1 1 1\nvn 0 0 1\n"
    "f 1/1/1 2/2/2 5/5/5\nf 2/2/2 3/3/3 5/5/5\nf 3/3/3 4/4/4 5/5/5\nf 4/4/4 1/1/1 5/5/5\n";

TEST_F(Frames, of_lab_5_are_orthogonal_in_each_pixel_of_a_coarse_model) {
  const std::string model = (folder_ / "pyramid.obj").string();
  write_file(model, kPyramid);
  std::vector<Shot> shots;
  const std::vector<std::string> methods = {"gram-schmidt", "angle-weighted"};
  for (const std::string& method : methods)
    for (const char* view : {"tangent", "normal"})
      shots.push_back({fmt::format("{} {}.pfm", method, view),
                       {{"model", model},
                        {"method", method},
                        {"normal_map", "flat"},
                        {"decode", "exact-flat"},
                        {"yaw", "0"},
                        {"pitch", "0"}},
                       view});
  draw("lab05_normal_map", shots, folder_);
  for (const std::string& method : methods) {
    const ImageF tangent = image::load_pfm(folder_ / (method + " tangent.pfm")),
                 normal = image::load_pfm(folder_ / (method + " normal.pfm"));
    int seen = 0;
    for (int y = 0; y < normal.height; ++y)
      for (int x = 0; x < normal.width; ++x) {
        if (normal.at(x, y, 2) == 0) continue;
        ++seen;
        double along = 0;
        for (int k = 0; k < 3; ++k) along += double{tangent.at(x, y, k)} * normal.at(x, y, k);
        ASSERT_WITHIN(along, 0, 1e-6) << method << " " << x << " " << y;
      }
    EXPECT_GT(seen, normal.width * normal.height / 8);
  }
}

struct Hit {
  std::size_t triangle = 0;
  glm::dvec3 weights{0};  ///< of its three corners
  double distance = 1e9;
};

/// The nearest triangle on a ray from `eye` (Moeller and Trumbore 1997).
Hit first_hit(const mesh::Mesh& mesh, const glm::dvec3& eye, const glm::dvec3& ray) {
  Hit nearest;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto corner = [&](std::size_t k) { return glm::dvec3(mesh.positions[mesh.indices[3 * t + k]]); };
    const glm::dvec3 e1 = corner(1) - corner(0), e2 = corner(2) - corner(0), p = glm::cross(ray, e2);
    const double determinant = glm::dot(e1, p);
    if (determinant <= 0) continue;  // seen from behind
    const glm::dvec3 s = eye - corner(0), q = glm::cross(s, e1);
    const double u = glm::dot(s, p) / determinant, v = glm::dot(ray, q) / determinant;
    const double distance = glm::dot(e2, q) / determinant;
    if (u < 0 || v < 0 || u + v > 1 || distance >= nearest.distance) continue;
    nearest = {t, {1 - u - v, u, v}, distance};
  }
  return nearest;
}

/// The map's normal `n` in the frame that interpolating the three corners gives. Bakers leave its vectors as
/// long as they come; the other methods make them orthonormal again.
glm::dvec3 bent_normal(const mesh::Mesh& mesh, const Hit& hit, const glm::dvec3& n, bool as_it_comes) {
  glm::dvec3 N(0), T(0);
  double side = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t vertex = mesh.indices[3 * hit.triangle + k];
    const double weight = hit.weights[static_cast<int>(k)];
    N += weight * glm::dvec3(mesh.normals[vertex]);
    T += weight * glm::dvec3(mesh.tangents[vertex]);
    side += weight * double{mesh.tangents[vertex].w};
  }
  if (!as_it_comes) {
    N = glm::normalize(N);
    T = glm::normalize(T - glm::dot(T, N) * N);
  }
  return glm::normalize(n.x * T + n.y * side * glm::cross(N, T) + n.z * N);
}

TEST_F(Frames, of_lab_5_bend_a_coarse_model_s_normals_as_each_method_interpolates) {
  const std::string model = (folder_ / "pyramid.obj").string(), map = (folder_ / "slope.png").string();
  write_file(model, kPyramid);
  image::Image8 slope(1, 1, 3);
  slope.samples = {190, 90, 220};
  image::save_png(map, slope);
  const glm::dvec3 n = 2.0 * glm::dvec3(190, 90, 220) / 255.0 - 1.0;
  constexpr double kDistance = 3;
  for (const std::string method : {"gram-schmidt", "angle-weighted", "mikktspace"}) {
    const Settings look = {{"model", model},       {"normal_map", map},    {"method", method},
                           {"yaw", "0"},           {"pitch", "0"},         {"distance", "3"},
                           {"turn", "0"},          {"stretch", "1"},       {"decode", "standard"},
                           {"bump_strength", "1"}, {"field_of_view", "45"}};
    draw("lab05_normal_map", {{"normal.pfm", look, "normal"}}, folder_);
    const std::string file = (folder_ / "drawn.ply").string();
    ASSERT_EQ(run_lab("lab05_normal_map", "--mesh " + file + flags(look)).exit_code, 0);
    const mesh::Mesh drawn = test::read_ply(file);
    const ImageF normal = image::load_pfm(folder_ / "normal.pfm");
    const double half = std::tan(glm::radians(45.0) / 2);
    int seen = 0;
    for (int y = 0; y < normal.height; y += 3)
      for (int x = 0; x < normal.width; x += 3) {
        const glm::dvec3 ray(half * (2 * (x + 0.5) / normal.width - 1),
                             half * (2 * (y + 0.5) / normal.height - 1), -1);
        const Hit hit = first_hit(drawn, {0, 0, kDistance}, ray);
        // At an edge the pixel may belong to its neighbour by rounding.
        if (std::min({hit.weights.x, hit.weights.y, hit.weights.z}) < 0.01) continue;
        ++seen;
        const glm::dvec3 expected = bent_normal(drawn, hit, n, method == "mikktspace");
        for (int k = 0; k < 3; ++k)  // in float32: measured 4.5e-7
          ASSERT_WITHIN(normal.at(x, y, k), expected[k], 2e-6) << method << " " << x << " " << y;
      }
    EXPECT_GT(seen, normal.width * normal.height / 9 / 8);
  }
}

TEST_F(Frames, of_lab_4_wrap_a_model_by_its_own_coordinates_before_and_by_longitude_when_stretched) {
  const auto drawn = [&](const char* method) {
    const std::string file = (folder_ / "drawn.ply").string();
    const Result result =
        run_lab("lab04_cube_wrap", fmt::format("--model quad --method {} --mesh {}", method, file));
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return test::read_ply(file);
  };
  const mesh::Mesh before = drawn("before"), stretched = drawn("stretched");
  ASSERT_EQ(before.vertex_count(), 4U);
  ASSERT_EQ(stretched.vertex_count(), 4U);
  for (std::size_t v = 0; v < 4; ++v) {
    const glm::vec3& p = before.positions[v];
    EXPECT_EQ(before.texcoords[v], glm::vec2(p.x > 0 ? 1 : 0, p.y > 0 ? 1 : 0));
    EXPECT_EQ(stretched.texcoords[v], mesh::spherical_texcoord(stretched.positions[v]));
  }
}

}  // namespace
}  // namespace texel::test
