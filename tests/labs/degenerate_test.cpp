// SPDX-License-Identifier: MIT
// Models and settings that are no shape at all: every lab ends with a picture, whatever its size, and no
// number in it is NaN or infinite.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <glm/glm.hpp>

#include "core/files.hpp"
#include "image/load.hpp"
#include "image/save.hpp"
#include "labs.hpp"

namespace texel::test {
namespace {

struct Model {
  const char* name;
  std::string text;
  const char* warning = nullptr;  ///< what standard error says of it
};

const std::string kCorners = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
const std::string kFaces =
    "f 1/1 2/2 3/3 4/4\nf 5/1 6/2 7/3 8/4\nf 1/1 2/2 6/3 5/4\nf 3/1 4/2 8/3 7/4\nf 1/1 4/2 8/3 5/4\n"
    "f 2/1 3/2 7/3 6/4\n";

/// Eight `v` lines from a function of 0 to 7.
template <class Position>
std::string positions(Position position) {
  std::string text;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 p = position(i);
    text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
  }
  return text;
}

/// The corners of a cube, scaled and moved.
std::string cube(double scale, double offset = 0) {
  return positions([=](int i) {
    const double x = (i + 1) / 2 % 2 == 1 ? 1 : -1, y = i / 2 % 2 == 1 ? 1 : -1, z = i / 4 == 1 ? 1 : -1;
    return offset + scale * glm::dvec3(x, y, z);
  });
}

/// Texture coordinates from 0 to `most` in place of the corners 0 and 1.
std::string corners(const char* most) {
  return fmt::format("vt 0 0\nvt {0} 0\nvt {0} {0}\nvt 0 {0}\n", most);
}

std::vector<Model> degenerate_models() {
  const std::string line = positions([](int i) { return glm::dvec3(i, 0.5 * i, 0.25 * i); });
  const std::string nearly =
      positions([](int i) { return glm::dvec3(i, 0.5 * i + 1e-6 * (i % 3), 0.25 * i); });
  const std::string needles =
      positions([](int i) { return glm::dvec3(i % 2, i / 2 % 2 == 1 ? 1e-7 : 0, i / 4 == 1 ? 1e-5 : 0); });
  const std::string plane =
      "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";
  const std::string mixed =
      "v 0 0 0\nv 1e30 0 0\nv 0 1e-30 0\nv 1e30 1e-30 0\nv 0 0 1e-30\nv 1e30 0 1\nv 1e-30 0 1\nv 0 0 0\n";
  return {
      {"line", line + kCorners + kFaces, "points and lines"},
      {"nearly_a_line", nearly + kCorners + kFaces, "points and lines"},
      {"point", positions([](int) { return glm::dvec3(1, 2, 3); }) + kCorners + kFaces, "one point, 1 2 3"},
      {"one_triangle", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + kCorners + "f 1/1 2/2 3/3\n"},
      {"plane", plane + kCorners + kFaces},
      {"needles", needles + kCorners + kFaces},
      {"mixed", mixed + kCorners + kFaces, "points and lines"},
      {"far", cube(1e-3, 1e6) + kCorners + kFaces, "in 32-bit floats"},
      {"too_far", cube(5, 1e6) + kCorners + kFaces, "32-bit floats are 0.0625 apart"},
      {"tiny", cube(1e-30) + kCorners + kFaces},
      {"enormous", cube(1e38) + kCorners + kFaces},
      {"huge_vt", cube(1) + corners("1e30") + kFaces},
      {"largest_vt", cube(1) + "vt -3.4e38 0\nvt 3.4e38 0\nvt 3.4e38 -3.4e38\nvt 0 3.4e38\n" + kFaces},
      {"many_repeats", cube(1) + corners("1e4") + kFaces},
      {"tiny_vt", cube(1) + corners("1e-30") + kFaces},
      {"same_vt", cube(1) + corners("0") + kFaces},
      {"vt_on_a_line", cube(1) + "vt 0 0\nvt 1 1\nvt 2 2\nvt 3 3\n" + kFaces},
      {"nan_vn", cube(1) + "vn nan 0 0\nvn 0 0 0\nf 1//1 2//2 3//1\nf 5//1 6//2 7//9\n"},
  };
}

/// Draws all and expects that each is a picture of finite numbers. What standard error said comes back. An
/// endless loop in the driver is ended after ten times what the longest of these batches takes on a slow
/// machine.
std::string draw_all(const std::string& lab, const std::vector<Shot>& shots, const TemporaryFolder& folder) {
  const Result result = run_batch(lab, shots, folder, "--samples 4", "timeout 600");
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  if (result.exit_code != 0) return result.errors;
  for (const Shot& shot : shots)
    if (shot.name.ends_with(".pfm")) {
      EXPECT_EQ(count_non_finite(image::load_pfm(folder / shot.name)), 0) << shot.name << flags(shot.values);
    }
  return result.errors;
}

/// The looks in colour at the sizes at which triangles once were lines, and in every data view at odd ones.
std::vector<Shot> shots_of(const std::string& lab, const std::string& name, const Settings& look) {
  std::vector<Shot> shots;
  for (const char* size : {"512x512", "960x720", "37x53"})
    shots.push_back({fmt::format("{}_{}", name, size), look, "color", size});
  for (const std::string& view : views_of(lab))
    if (view != "color" && view != "error")
      for (const char* size : {"128x128", "37x53"})
        shots.push_back({fmt::format("{}_{}_{}.pfm", name, view, size), look, view, size});
  return shots;
}

void add(std::vector<Shot>& shots, std::vector<Shot> more) {
  std::move(more.begin(), more.end(), std::back_inserter(shots));
}

class DegenerateModel : public EveryLab {};
INSTANTIATE_TEST_SUITE_P(Labs, DegenerateModel,
                         testing::Values("lab03_obj_texcoords", "lab04_cube_wrap", "lab05_normal_map"),
                         lab_name);

TEST_P(DegenerateModel, is_drawn_and_a_blank_one_is_explained) {
  std::vector<std::string> methods = {""};  // the default, and in lab 5 one without tangents in the vertices
  if (lab() == "lab05_normal_map") methods.emplace_back("cotangent");
  std::vector<Shot> shots;
  for (const Model& model : degenerate_models()) {
    const std::string file = (folder_ / (std::string(model.name) + ".obj")).string();
    write_file(file, model.text);
    for (const std::string& method : methods) {
      Settings look = {{"model", file}};
      if (!method.empty()) look.emplace_back("method", method);
      add(shots, shots_of(lab(), model.name + method, look));
    }
  }
  const std::string said = draw_all(lab(), shots, folder_);
  for (const Model& model : degenerate_models()) {
    const std::string begin = "/" + std::string(model.name) + ".obj: warning: ";
    const std::size_t at = said.find(begin);
    EXPECT_EQ(at != std::string::npos, model.warning != nullptr) << model.name << "\n" << said;
    if (at == std::string::npos || model.warning == nullptr) continue;
    const std::string line = said.substr(at, said.find('\n', at) - at);
    EXPECT_TRUE(has(line, model.warning)) << line;
    const Result result =
        run_lab(lab(), "--stats - --size 64x64 " +
                           shell_word((folder_ / (std::string(model.name) + ".obj")).string()));
    EXPECT_TRUE(has(result.output, line.substr(begin.size()))) << "among the warnings\n" << result.output;
  }
}

class NoDirection : public EveryLab {};
INSTANTIATE_TEST_SUITE_P(Labs, NoDirection,
                         testing::Values("lab03_obj_texcoords", "lab04_cube_wrap", "lab05_normal_map"),
                         lab_name);

TEST_P(NoDirection, is_drawn_with_any_and_said) {
  // Every face with one texture coordinate, as in models with a palette. And normals and tangents that cancel
  // in the middle of a square, where in pictures of odd size the pixels' centres lie.
  const std::string palette = (folder_ / "palette.obj").string(), cancel = (folder_ / "cancel.obj").string();
  write_file(palette,
             cube(1) +
                 "vt 0.3 0.6\nvn 0 0 -1\nvn 0 0 1\nvn 0 -1 0\nvn 0 1 0\nvn -1 0 0\nvn 1 0 0\n"
                 "f 1/1/1 4/1/1 3/1/1 2/1/1\nf 5/1/2 6/1/2 7/1/2 8/1/2\nf 1/1/3 2/1/3 6/1/3 5/1/3\n"
                 "f 3/1/4 4/1/4 8/1/4 7/1/4\nf 1/1/5 5/1/5 8/1/5 4/1/5\nf 2/1/6 3/1/6 7/1/6 6/1/6\n");
  write_file(cancel, "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n" + kCorners +
                         "vn 1 0 0\nvn -1 0 0\nf 1/1/1 2/2/2 3/3/2 4/4/1\n");
  image::Image8 grey(8, 8, 3);
  std::fill(grey.samples.begin(), grey.samples.end(), std::uint8_t{128});
  const std::string map = (folder_ / "grey.png").string();
  image::save_png(map, grey);

  std::vector<Settings> looks;
  for (const Parameter& p : parameters_of(lab()))
    for (const std::string& choice :
         p.name == "method" || p.name == "projection" ? p.choices : std::vector<std::string>{})
      for (const std::string& model : {palette, cancel})
        for (const char* yaw : {"0", "60", "-60"})
          looks.push_back(
              {{"model", model}, {p.name, choice}, {"yaw", yaw}, {"pitch", "0"}, {"distance", "2.5"}});
  if (lab() == "lab05_normal_map")
    for (const Settings& look : std::vector<Settings>(looks))
      for (const char* strength : {"1", "0"})
        looks.push_back(look +
                        Settings{{"normal_map", map}, {"decode", "exact-flat"}, {"bump_strength", strength}});
  std::vector<Shot> shots;
  for (const Settings& look : looks)
    for (const std::string& view : views_of(lab()))
      if (view == "normal" || view == "tangent" || view == "texcoord")
        shots.push_back({fmt::format("{}.pfm", shots.size()), look, view, "33x33"});
  draw_all(lab(), shots, folder_);

  if (lab() != "lab05_normal_map") return;
  const Stats stats = stats_of(lab(), fmt::format("{} --normal-map {} --decode exact-flat", palette, map));
  EXPECT_TRUE(
      has(fmt::format("{}", fmt::join(stats.notes, "\n")), "12 of 12 triangles have no area in the texture"));
  EXPECT_TRUE(has(fmt::format("{}", fmt::join(stats.warnings, "\n")), "64 texels of the normal map"));
}

class ExtremeSettings : public EveryLab {};
INSTANTIATE_TEST_SUITE_P(Labs, ExtremeSettings, each_lab, lab_name);

/// Seen along the surface, a square is a line; the footprint of a pixel then has no end.
std::vector<Settings> edge_on(const std::string& lab) {
  std::vector<Settings> looks;
  for (const char* yaw : {"89.9", "90", "90.001"})
    for (const char* pitch : {"0", "45"}) {
      const Settings camera = {{"yaw", yaw}, {"pitch", pitch}};
      if (lab == "lab01_texture_quad")
        looks.push_back(camera +
                        Settings{{"method", "anisotropic"}, {"texture_scale", "100"}, {"tilt", "30"}});
      else
        looks.push_back(camera);
    }
  return looks;
}

TEST_P(ExtremeSettings, are_drawn) {
  std::vector<Shot> shots;
  const auto take = [&](const Settings& look) {
    add(shots, shots_of(lab(), std::to_string(shots.size()), look));
  };
  for (const Settings& look : edge_on(lab())) take(look);
  // All numbers at once at their ends; what a lab calls too little or too much is its error to tell.
  for (const bool most : {false, true}) {
    Settings look;
    for (const Parameter& p : parameters_of(lab()))
      if ((p.type == "number" || p.type == "integer") && p.name != "near" && p.name != "far" &&
          p.name != "segments")
        look.emplace_back(p.name, fmt::format("{}", most ? p.most : p.least));
    take(look);
  }
  draw_all(lab(), shots, folder_);
}

}  // namespace
}  // namespace texel::test
