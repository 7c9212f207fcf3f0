// SPDX-License-Identifier: MIT
// Material libraries: what is read of them, and how they, their names and their pictures are found.
#include <gtest/gtest.h>

#include <algorithm>

#include <filesystem>

#include "../support/picture_files.hpp"
#include "../support/said.hpp"
#include "core/files.hpp"
#include "mesh/obj.hpp"

namespace texel::mesh {
namespace {

/// The material of that name; null for none.
const Material* find_material(const ObjData& data, std::string_view name) {
  const auto found = std::ranges::find(data.materials, name, &Material::name);
  return found == data.materials.end() ? nullptr : &*found;
}

using test::has;

TEST(Mtl, reads_colors_and_maps_and_tells_of_lines_that_are_lost_and_options_not_followed) {
  struct Row {
    std::string text;  // after "newmtl m"
    glm::vec3 diffuse{1};
    std::string color_map{};
    const char* warning = nullptr;
  };
  const glm::vec3 white(1);
  const char *lost = "a.mtl: 1 lines ignored; the first is line 2", *unfollowed = "of material 'm'";
  const Row rows[] = {
      {""},
      {"Kd 0.25 0.5 1\n", {0.25F, 0.5F, 1}},
      {"Kd 0.5\n", glm::vec3(0.5F)},
      {"Kd 0,5 0 1\n", {0.5F, 0, 1}},
      {"Kd spectral a.rfl\nmap_Kd b.png\n", white, "b.png", lost},
      {"Kd 0.5 x 1\nmap_Kd b.png\n", white, "b.png", lost},
      {"Kd 0.5 0.5\nmap_Kd b.png\n", white, "b.png", lost},
      {"Kd 1.#QNAN 0 0\nmap_Kd b.png\n", white, "b.png", lost},
      {"Kd\nmap_Kd b.png\n", white, "b.png", lost},
      {"map_kd a.png\n", white, "a.png"},
      {"map_Kd sub\\dir\\a.png\n", white, "sub/dir/a.png"},
      {"map_Kd -s 1 1 1\n"},
      {"bump -s 2 2 2 b.png\nnorm n.png\n"},
      {"\tNs 96\nillum 2\nd 1\nmap_Ks s.png\nnonsense 1 2\n"},
      {"map_Kd -blendu off -mm 0 1 -texres 512 my file.png\n", white, "my file.png"},
      {"map_Kd -s 1 1 1 -o 0 0 0 a.png\n", white, "a.png"},
      {"map_Kd -s 1 -o 0 a.png\n", white, "a.png"},
      {"map_Kd -clamp off -mm 0 1 a.png\n", white, "a.png"},
      {"map_Kd -t 0 0 0 -blendu on a.png\n", white, "a.png"},
      {"map_Kd -s 2 2 1 a.png\n", white, "a.png", unfollowed},
      {"map_Kd -s 1 0.5 a.png\n", white, "a.png", unfollowed},
      {"map_Kd -o 0.25 a.png\n", white, "a.png", unfollowed},
      {"map_Kd -clamp on a.png\n", white, "a.png", unfollowed},
      {"map_Kd -mm 0 2 a.png\n", white, "a.png", unfollowed},
      {"map_Kd -s 1 1 1 -t 0 1 0 a.png\n", white, "a.png", unfollowed},
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(row.text);
    std::vector<std::string> warnings;
    const std::vector<Material> materials =
        parse_mtl("newmtl m\n" + row.text + "newmtl n\nKd 0 0 1\n", "a.mtl", warnings);
    ASSERT_EQ(materials.size(), 2U);
    EXPECT_EQ(materials[0].name, "m");
    EXPECT_EQ(materials[0].diffuse, row.diffuse);
    EXPECT_EQ(materials[0].color_map, row.color_map);
    EXPECT_EQ(materials[1].diffuse, glm::vec3(0, 0, 1)) << "the rest is kept";
    ASSERT_EQ(warnings.size(), row.warning != nullptr ? 1U : 0U);
    if (row.warning != nullptr) {
      EXPECT_TRUE(has(warnings[0], row.warning)) << warnings[0];
    }
  }
  std::vector<std::string> warnings;
  EXPECT_TRUE(parse_mtl("", "a.mtl", warnings).empty());
  EXPECT_EQ(parse_mtl("# c\nmap_Kd a.png\nnewmtl m\n", "a.mtl", warnings).size(), 1U);
  ASSERT_EQ(warnings.size(), 1U) << "a map before any material";
  EXPECT_TRUE(has(warnings[0], lost)) << warnings[0];
}

/// A folder of its own for one test, removed at its end, in which models are written and loaded.
class ObjFiles : public testing::Test {
 protected:
  ObjFiles() { std::filesystem::create_directories(folder_ / "lib/maps"); }

  void write(const std::string& file, const std::string& text) const { write_file(folder_ / file, text); }
  /// A model with a triangle's positions and these lines.
  [[nodiscard]] ObjData load(const std::string& lines) const {
    write("model.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + lines);
    return load_obj(folder_ / "model.obj");
  }

  const std::string face_ = "f 1 2 3\n";
  const test::TemporaryFolder folder_;
};

TEST_F(ObjFiles, material_libraries_are_read_beside_the_file) {
  write("my paints.mtl", "newmtl red\nKd 1 0 0\nmap_Kd -s 1 1 -clamp off red brick.png\n");
  write("b.mtl", "newmtl blue\nKd 0 0 1\nmap_Bump -bm 0.5 h.png\n");
  const ObjData data =
      load("mtllib my paints.mtl\nmtllib missing.mtl b.mtl\nusemtl red\n" + face_ + "usemtl green\n" + face_);
  ASSERT_EQ(data.materials.size(), 2U);
  EXPECT_EQ(find_material(data, "red")->color_map, "");
  EXPECT_EQ(find_material(data, "blue")->diffuse, glm::vec3(0, 0, 1));
  EXPECT_EQ(find_material(data, "green"), nullptr);
  ASSERT_EQ(data.warnings.size(), 3U);
  EXPECT_TRUE(has(data.warnings[0], "red brick.png")) << "the picture is missing";
  EXPECT_TRUE(has(data.warnings[1], "missing.mtl"));
  EXPECT_TRUE(has(data.warnings[2], "'green'"));
  EXPECT_THROW(load_obj(folder_ / "none.obj"), Error);
  EXPECT_THROW(load_obj(folder_ / ""), Error);
}

TEST_F(ObjFiles, pictures_are_found_beside_the_library_then_beside_the_model) {
  for (const char* picture :
       {"both.png", "lib/both.png", "model only.png", "lib/maps/sub.png", "lib/wall #2.png", "lib/wall"})
    write(picture, "");
  const std::pair<std::string, const char*> rows[] = {
      // as written, and what is found
      {"both.png", "lib/both.png"},
      {"-s 1 1 1 model only.png", "model only.png"},
      {"maps\\sub.png", "lib/maps/sub.png"},
      {"C:\\Users\\me\\model only.png", "model only.png"},  // of another machine
      {"/home/me/both.png", "lib/both.png"},
      {"wall #2.png", "lib/wall #2.png"},
      {"wall #2.png # the wall", "lib/wall #2.png"},
      {"wall # the wall", "lib/wall"},
      {"maps", nullptr},  // a folder
      {"none.png", nullptr}};
  for (const auto& [written, found] : rows) {
    write("lib/my #1.mtl", "newmtl m\nmap_Kd " + written + "\n");
    const ObjData data = load("mtllib lib/my #1.mtl # a note\nusemtl m\n" + face_);
    ASSERT_EQ(data.materials.size(), 1U) << written;
    EXPECT_EQ(data.materials[0].color_map, found ? (folder_ / found).string() : "") << written;
    EXPECT_EQ(data.warnings.size(), found ? 0U : 1U) << written;
  }
}

TEST_F(ObjFiles, names_run_to_the_end_of_their_line_but_for_a_comment_that_one_side_has_alone) {
  struct Row {
    std::string defined[2], used[2];
    const char* found[2];  // materials, or nullptr
  };
  const Row rows[] = {
      {{"Grey #1", "Grey #2"}, {"Grey #1", "Grey #2"}, {"Grey #1", "Grey #2"}},
      {{"Grey", "Grey #2"}, {"Grey #1", "Grey #2"}, {"Grey", "Grey #2"}},
      {{"Grey #1", "Grey"}, {"Grey #1 # note", "Grey"}, {"Grey #1", "Grey"}},
      {{"red", "blue"}, {"red # the roof", "blue"}, {"red", "blue"}},
      {{"red", "blue"}, {"red#2", "blue"}, {nullptr, "blue"}},
      {{"red # the roof", "blue"}, {"red", "blue"}, {"red", "blue"}},
      {{"red # the roof", "blue"}, {"red # of tiles", "blue # sky"}, {"red", "blue"}},
      {{"red", "green"}, {"red", "blue # sky"}, {"red", nullptr}},
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(row.used[0] + ", " + row.used[1]);
    write("a.mtl", "newmtl " + row.defined[0] + "\nnewmtl " + row.defined[1] + "\n");
    const ObjData data = load("mtllib a.mtl # note\nusemtl " + row.used[0] + "\n" + face_ + "usemtl " +
                              row.used[1] + "\n" + face_);
    ASSERT_EQ(data.material_runs.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      const Material* material = find_material(data, data.material_runs[i].name);
      ASSERT_EQ(material != nullptr, row.found[i] != nullptr) << i;
      if (material != nullptr) {
        EXPECT_EQ(material->name, row.found[i]);
      }
    }
  }
}

}  // namespace
}  // namespace texel::mesh
