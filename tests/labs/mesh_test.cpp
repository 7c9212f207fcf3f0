// SPDX-License-Identifier: MIT
// Models from files, and the vertex stream that --mesh writes.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "../support/meshes.hpp"
#include "core/files.hpp"
#include "labs.hpp"
#include "mesh/ply.hpp"

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
    const Stats stats = stats_of(lab(), arguments);
    EXPECT_EQ(static_cast<double>(mesh.triangle_count()), stats.triangles);
    EXPECT_EQ(static_cast<double>(mesh.vertex_count()), stats.vertices);
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
  const Stats stats = stats_of(lab(), shell_word((folder_ / "house.obj").string()));
  EXPECT_EQ(stats.triangles, 3);
  ASSERT_GE(stats.notes.size(), 2U);
  EXPECT_TRUE(has(stats.notes[0], "no normals")) << stats.notes[0];
  EXPECT_TRUE(has(stats.notes[1], "no texture coordinates")) << stats.notes[1];
}

TEST(Tangents, are_written_by_the_methods_of_lab_5_that_store_them) {
  const TemporaryFolder folder(fmt::format("tangents_{}", ::getpid()));
  const std::string file = (folder / "a.ply").string();
  for (const auto& [method, is_stored] :
       {std::pair("mikktspace", true), {"gram-schmidt", true}, {"cotangent", false}}) {
    const Result result =
        run_lab("lab05_normal_map", fmt::format("--model sphere --method {} --mesh {}", method, file));
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    const mesh::Mesh mesh = test::read_ply(file);
    EXPECT_EQ(mesh.tangents.size(), is_stored ? mesh.vertex_count() : 0) << method;
  }
}

}  // namespace
}  // namespace texel::test
