// SPDX-License-Identifier: MIT
// What labs 2, 3 and 4 draw and say of the pictures and models that they are given.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "../support/tolerance.hpp"
#include "core/files.hpp"
#include "image/difference.hpp"
#include "image/load.hpp"
#include "labs.hpp"

namespace texel::test {
namespace {

TEST(UnitsOfLab2, are_told_from_each_other) {
  const Settings right = {{"texture0", "label_grid"}, {"texture1", "decal"}, {"combine", "decal"}};
  const Settings swapped = {{"texture0", "decal"}, {"texture1", "label_grid"}, {"combine", "decal"}};
  TemporaryFolder folder("error_of_lab_2_swapped");
  draw("lab02_multi_texture", {{"right", right}, {"swapped", swapped}}, folder);
  const double apart =
      image::compare(image::load8(folder / "right.png"), image::load8(folder / "swapped.png")).mean;
  // The picture of swapped units is 21 steps from the right one in the mean over the whole frame, of which
  // the square is half. tests/figures holds the right one to 15 steps from the truth.
  EXPECT_ABOVE(apart, 15);
}

TEST(FileOfLab2, has_no_truth) {
  TemporaryFolder folder("error_of_lab_2_file");
  write_file(folder / "own.png", png(1, 1, 8, 0, bytes({0, 128})));
  const Result result =
      run_lab("lab02_multi_texture", "--measure - --texture1 " + shell_word((folder / "own.png").string()));
  expect_error(result, 3, "lab02_multi_texture", {"no exact answer", "choose"});
}

TEST(StretchOfLab3, is_told_for_each_projection) {
  // The table in the lab's README. Exact by hand for planar on the quad: even, no shear.
  const auto stretch = [](const char* model, const char* projection) {
    const std::vector<std::string> notes =
        stats_of("lab03_obj_texcoords", fmt::format("--model {} --projection {}", model, projection)).notes;
    const auto line = std::find_if(notes.begin(), notes.end(),
                                   [](const std::string& note) { return has(note, "stretch"); });
    return line == notes.end() ? "" : *line;
  };
  EXPECT_TRUE(has(stretch("quad", "planar"), "1.000 on average (L2), 1.000 at most"));
  EXPECT_TRUE(has(stretch("torus", "planar"), "10.195 on average (L2), 132.414 at most"));
  EXPECT_TRUE(has(stretch("torus", "box"), "1.020 on average (L2), 1.461 at most"));
  EXPECT_TRUE(has(stretch("torus", "cylindrical"), "1.918 on average (L2), 3.089 at most"));
  EXPECT_TRUE(has(stretch("torus", "spherical"), "2.060 on average (L2), 9.948 at most"));
}

TEST(ObjOfLab3, draws_a_file_with_vertex_colors_as_one_without) {
  // `v x y z r g b` is read, and not drawn: the color buffer is the picture's alone.
  TemporaryFolder folder("vertex_colours_of_lab_3");
  const char* faces = "vt 0.1 0.1\nvt 0.9 0.1\nvt 0.5 0.9\nf 1/1 2/2 3/3\n";
  write_file(folder / "colours.obj", std::string("v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\n") + faces);
  write_file(folder / "plain.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\n") + faces);
  for (const char* method : {"per-vertex", "per-fragment"}) {
    std::vector<Shot> shots;
    for (const char* name : {"colours", "plain"})
      shots.push_back({name, {{"model", (folder / name).string() + ".obj"}, {"method", method}}});
    draw("lab03_obj_texcoords", shots, folder);
    EXPECT_EQ(image::compare(image::load8(folder / "colours.png"), image::load8(folder / "plain.png")).max, 0)
        << method;
  }
}

TEST(ObjOfLab3, gives_each_part_its_own_material_s_color) {
  const TemporaryFolder folder(fmt::format("materials_of_lab_3_{}", ::getpid()));
  write_file(folder / "two.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
  write_file(folder / "two.obj",
             "mtllib two.mtl\nv -1 -1 0\nv 0 -1 0\nv 0 1 0\nv -1 1 0\nv 1 -1 0\nv 1 1 0\n"
             "usemtl red\nf 1 2 3 4\nusemtl blue\nf 2 5 6 3\n");
  draw("lab03_obj_texcoords",
       {{"two", {{"model", (folder / "two.obj").string()}, {"yaw", "0"}, {"pitch", "0"}}}}, folder);
  const image::Image8 picture = image::load8(folder / "two.png");
  const auto has_only = [&](int x, int channel) {
    for (int c = 0; c < 3; ++c) EXPECT_EQ(picture.at(x, 64, c) > 0, c == channel) << x << " " << c;
  };
  has_only(50, 0);
  has_only(78, 2);
}

TEST(CubeOfLab4, counts_its_vertices_bytes_and_smeared_triangles) {
  const auto notes = [](const char* method) {
    return fmt::format(
        "{}", fmt::join(stats_of("lab04_cube_wrap", fmt::format("--method {}", method)).notes, "\n"));
  };
  // 32 bytes a vertex, three of 4 a triangle.
  const std::string before = notes("before"), stretched = notes("stretched"), split = notes("split"),
                    weld = notes("weld");
  EXPECT_TRUE(has(before, "8 vertices, 400 bytes")) << before;
  EXPECT_TRUE(has(before, "8 of 12 triangles are smeared (no texture area), 2 mirrored")) << before;
  EXPECT_TRUE(has(stretched, "8 vertices, 400 bytes")) << stretched;
  EXPECT_TRUE(has(stretched, "0 of 12 triangles are smeared (no texture area), 6 mirrored")) << stretched;
  for (const std::string& each : {split, weld}) {
    EXPECT_TRUE(has(each, "24 vertices, 912 bytes")) << each;
    EXPECT_TRUE(has(each, "0 of 12 triangles are smeared (no texture area), 0 mirrored")) << each;
  }
}

TEST(CubeOfLab4, welds_corners_only_where_all_of_their_indices_mean_the_same) {
  TemporaryFolder folder("weld_of_lab_4");
  // A square of two triangles. With one normal the corners on the diagonal are shared: 4 vertices. With two
  // normals, or two texture coordinates that differ, each triangle keeps its own 3.
  const std::string lists =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 2 2\nvt 2 3\nvn 0 0 1\nvn 0 1 "
      "0\n";
  const auto vertices = [&](const char* name, const char* faces, const char* method) {
    write_file(folder / name, lists + faces);
    return stats_of("lab04_cube_wrap",
                    fmt::format("{} --method {}", shell_word((folder / name).string()), method))
        .vertices;
  };
  const char* equal = "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/4/1\n";
  const char* other_normal = "f 1/1/1 2/2/1 3/3/1\nf 1/1/2 3/3/2 4/4/2\n";
  const char* other_texcoord = "f 1/1/1 2/2/1 3/3/1\nf 1/5/1 3/6/1 4/4/1\n";
  EXPECT_EQ(vertices("equal.obj", equal, "weld"), 4);
  EXPECT_EQ(vertices("other_normal.obj", other_normal, "weld"), 6);
  EXPECT_EQ(vertices("other_texcoord.obj", other_texcoord, "weld"), 6);
  EXPECT_EQ(vertices("equal.obj", equal, "split"), 6);
  EXPECT_EQ(vertices("other_normal.obj", other_normal, "stretched"), 4);
}

TEST(CubeOfLab4, counts_mirrored_triangles_of_a_file) {
  TemporaryFolder folder("mirrored_of_lab_4");
  // The second triangle's texture runs the other way round.
  write_file(folder / "mirrored.obj",
             "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/2\n");
  const Stats stats = stats_of("lab04_cube_wrap", shell_word((folder / "mirrored.obj").string()));
  EXPECT_TRUE(has(fmt::format("{}", fmt::join(stats.notes, "\n")),
                  "0 of 2 triangles are smeared (no texture area), 1 mirrored"));
}

}  // namespace
}  // namespace texel::test
