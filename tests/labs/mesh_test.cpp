// SPDX-License-Identifier: MIT
// Models from files: the vertex stream that --mesh writes, and their tangent frames as they are drawn.
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
#include "truth/ray.hpp"

namespace texel::test {
namespace {

constexpr const char* kModelLabs[] = {"lab03_obj_texcoords", "lab04_cube_wrap", "lab05_normal_map"};

class Models : public EveryLab {
 protected:
  [[nodiscard]] mesh::Mesh mesh_of(const std::string& arguments) const {
    const std::string file = (folder_ / "a.ply").string();
    const Result result = run_lab(lab(), fmt::format("--mesh {} {}", shell_word(file), arguments));
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_EQ(result.output + result.errors, "");
    return test::read_ply(file);  // which refuses wrong indices, values that are not finite and cut files
  }
};
INSTANTIATE_TEST_SUITE_P(Labs, Models, testing::ValuesIn(kModelLabs), lab_name);

TEST_P(Models, are_written_as_they_are_drawn) {
  for (const char* model : {"cube", "sphere", "gator"}) {
    SCOPED_TRACE(model);
    const std::string arguments = fmt::format("--model {}", model);
    const mesh::Mesh mesh = mesh_of(arguments);
    const Json stats = stats_of(lab(), arguments);
    EXPECT_EQ(mesh.triangle_count(), stats.at("triangles"));
    EXPECT_EQ(mesh.vertex_count(), stats.at("vertices"));
    double farthest = 0;
    for (const glm::vec3& p : mesh.positions)
      farthest = std::max(farthest, static_cast<double>(glm::length(p)));
    EXPECT_NEAR(farthest, 1, 1e-3);  // the built-in cube's half-size is 0.577 for 1/sqrt(3)
    ASSERT_EQ(mesh.normals.size(), mesh.vertex_count());
    ASSERT_EQ(mesh.texcoords.size(), mesh.vertex_count());
    for (const glm::vec3& n : mesh.normals) EXPECT_NEAR(glm::length(n), 1, 1e-5);
    for (const glm::vec4& t : mesh.tangents) EXPECT_EQ(std::abs(t.w), 1);
  }
}

TEST_P(Models, come_from_a_file_that_is_named_alone) {
  // Neither texture coordinates nor normals, negative indices, a polygon, and a bare name without folder.
  write_file(folder_ / "house.obj", "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 3 0\nv 0 2 0\nf -5 -4 -3 -2 -1\n");
  const std::string before = fmt::format("cd {} &&", shell_word((folder_ / "").string()));
  const Result result =
      run_lab(lab(), "house.obj --mesh house.ply --size 64x64 --snapshot house.png", before);
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(test::read_ply(folder_ / "house.ply").triangle_count(), 3U);
  const Json stats = stats_of(lab(), shell_word((folder_ / "house.obj").string()));
  EXPECT_EQ(stats.at("triangles"), 3);
  const auto notes = stats.at("notes").get<std::vector<std::string>>();
  ASSERT_GE(notes.size(), 2U);
  EXPECT_TRUE(has(notes[0], "no normals")) << notes[0];
  EXPECT_TRUE(has(notes[1], "no texture coordinates")) << notes[1];
}

// ---- Tangent frames as they are drawn.

/// A pyramid that is lit as if it were round: from corner to corner the normal turns by 55 degrees and more,
/// so that what is interpolated is far from orthonormal.
constexpr const char* kPyramid =
    "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv 0 0 0.7\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.5 0.5\n"
    "vn -1 -1 1\nvn 1 -1 1\nvn 1 1 1\nvn -1 1 1\nvn 0 0 1\n"
    "f 1/1/1 2/2/2 5/5/5\nf 2/2/2 3/3/3 5/5/5\nf 3/3/3 4/4/4 5/5/5\nf 4/4/4 1/1/1 5/5/5\n";

struct Hit {
  std::size_t triangle = 0;
  glm::dvec3 weights{0};  ///< of its three corners
  double distance = 1e9;
};

/// The nearest triangle on a ray (Moeller and Trumbore 1997).
Hit first_hit(const mesh::Mesh& mesh, const truth::Ray& ray) {
  Hit nearest;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto corner = [&](std::size_t k) { return glm::dvec3(mesh.positions[mesh.indices[3 * t + k]]); };
    const glm::dvec3 e1 = corner(1) - corner(0), e2 = corner(2) - corner(0),
                     p = glm::cross(ray.direction, e2);
    const double determinant = glm::dot(e1, p);
    if (determinant <= 0) continue;  // seen from behind
    const glm::dvec3 s = ray.origin - corner(0), q = glm::cross(s, e1);
    const double u = glm::dot(s, p) / determinant, v = glm::dot(ray.direction, q) / determinant;
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

TEST(Frames, of_lab_5_bend_a_coarse_model_s_normals_as_each_method_interpolates) {
  const TemporaryFolder folder(fmt::format("frames_{}", ::getpid()));
  const std::string model = (folder / "pyramid.obj").string(), map = (folder / "slope.png").string();
  write_file(model, kPyramid);
  image::Image8 slope(1, 1, 3);
  slope.samples = {190, 90, 220};
  image::save_png(map, slope);
  const glm::dvec3 n = 2.0 * glm::dvec3(190, 90, 220) / 255.0 - 1.0;
  for (const std::string method : {"gram-schmidt", "angle-weighted", "mikktspace"}) {
    const Settings look = {{"model", model},       {"normal_map", map},    {"method", method},
                           {"yaw", "0"},           {"pitch", "0"},         {"distance", "3"},
                           {"turn", "0"},          {"stretch", "1"},       {"decode", "standard"},
                           {"bump_strength", "1"}, {"field_of_view", "45"}};
    draw("lab05_normal_map", {{"normal.pfm", look, "normal"}}, folder);
    const std::string file = (folder / "drawn.ply").string();
    ASSERT_EQ(run_lab("lab05_normal_map", "--mesh " + file + flags(look)).exit_code, 0);
    const mesh::Mesh drawn = test::read_ply(file);
    const image::ImageF normal = image::load_pfm(folder / "normal.pfm");
    const truth::Camera camera{
        .distance = 3, .field_of_view = 45, .width = normal.width, .height = normal.height};
    int seen = 0;
    for (int y = 0; y < normal.height; y += 3)
      for (int x = 0; x < normal.width; x += 3) {
        const Hit hit = first_hit(drawn, truth::pixel_ray(camera, {x + 0.5, y + 0.5}).ray);
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

}  // namespace
}  // namespace texel::test
