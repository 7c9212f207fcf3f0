// SPDX-License-Identifier: MIT
#include "mesh/obj.hpp"

#include <gtest/gtest.h>
#include <tiny_obj_loader.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>

#include "core/error.hpp"
#include "core/files.hpp"
#include "mesh/distinct.hpp"
#include "mesh/weld.hpp"

namespace texel::mesh {
namespace {

const std::string obj_triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

ObjData parse(const std::string& text) {
  return parse_obj(text, "test.obj");
}

/// A folder of its own for one test, removed at its end.
class Folder {
 public:
  explicit Folder(const std::string& name)
      : path_(std::filesystem::temp_directory_path() / ("texel_" + name)) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  [[nodiscard]] std::filesystem::path operator/(const std::string& file) const { return path_ / file; }

 private:
  std::filesystem::path path_;
};

TEST(Obj, reads_every_form_of_a_corner) {
  struct Row {
    const char* face;
    Corner last;
  };
  const Row rows[] = {
      {"f 1 2 3", {2, no_index, no_index}},
      {"f 1/1 2/2 3/2", {2, 1, no_index}},
      {"f 1//1 2//1 3//2", {2, no_index, 1}},
      {"f 1/1/1 2/1/1 3/2/2", {2, 1, 1}},
      {"f -3/-2/-2 -2/-1/-1 -1/-2/-1", {2, 0, 1}},
      {"f 1/ 2/ 3/", {2, no_index, no_index}},
      {"f 1// 2// 3//", {2, no_index, no_index}},
      {"f 1/1/ 2/1/ 3/2/", {2, 1, no_index}},
      {"f 1 2/1 3//2", {2, no_index, 1}},
      {"f +1 +2 +3", {2, no_index, no_index}},
      {"fo 1 2 3", {2, no_index, no_index}},
      {"\t f\t1  2\t 3 \t", {2, no_index, no_index}},
      {"f 1 2 3 # a comment", {2, no_index, no_index}},
  };
  for (const Row& row : rows) {
    const ObjData data = parse(obj_triangle + "vt 0 0\nvt 1 1\nvn 0 0 1\nvn 1 0 0\n" + row.face + "\n");
    ASSERT_EQ(data.corners.size(), 3u) << row.face;
    EXPECT_EQ(data.corners[2], row.last) << row.face;
  }
}

TEST(Obj, counts_negative_indices_from_the_lines_above_the_face) {
  const ObjData data = parse(obj_triangle + "f -3 -2 -1\nv 9 9 9\nv 8 8 8\nf -5 -2 -1\n");
  EXPECT_EQ(data.corners[3].position, 0u);
  EXPECT_EQ(data.corners[4].position, 3u);
  EXPECT_EQ(data.corners[5].position, 4u);
}

TEST(Obj, rounds_numbers_to_the_nearest_float) {
  struct Row {
    const char* text;
    float value;
  };
  const Row rows[] = {
      {"0.1", 0.1f},
      {"+2.5", 2.5f},
      {"-1e-3", -1e-3f},
      {"1.5E+2", 150.0f},
      {".5", 0.5f},
      {"5.", 5.0f},
      {"16777217", 16777216.0f},             // halfway: to even
      {"16777217.0000000001", 16777218.0f},  // just above halfway: a parser by double rounds it down
      {"3.4028235e38", 3.4028235e38f},       // the largest
      {"1e-46", 0.0f},                       // too small
      {"1e-400", 0.0f},                      // too small for a double too
      {"1e-45", std::numeric_limits<float>::denorm_min()},
      {"-0", -0.0f},
  };
  for (const Row& row : rows) {
    const ObjData data = parse("v " + std::string(row.text) + " 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(data.positions[0].x, row.value) << row.text;
    EXPECT_EQ(std::signbit(data.positions[0].x), std::signbit(row.value)) << row.text;
  }
}

TEST(Obj, reads_weights_colors_and_one_to_three_texture_numbers) {
  const ObjData data = parse(
      "v 0 0 0\nv 1 0 0 0.5\nv 0 1 0 0.25 0.5 0.75\nv 1 1 0 1 0.1 0.2 0.3\n"
      "vt 0.25\nvt 0.25 0.5\nvt 0.25 0.5 0.75\nf 1/1 2/2 3/3\n");
  EXPECT_EQ(data.report.ignored_weights, 1u);
  ASSERT_EQ(data.colors.size(), 4u);
  EXPECT_EQ(data.colors[0], glm::vec3(1.0f));
  EXPECT_EQ(data.colors[2], glm::vec3(0.25f, 0.5f, 0.75f));
  EXPECT_EQ(data.colors[3], glm::vec3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(data.texcoords[0], glm::vec2(0.25f, 0.0f));
  EXPECT_EQ(data.texcoords[1], glm::vec2(0.25f, 0.5f));
  EXPECT_EQ(data.texcoords[2], glm::vec2(0.25f, 0.5f));
}

TEST(Obj, reads_the_same_whatever_the_line_ends) {
  const std::string text = "# c\nv 0 0 0\n\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const auto with = [&text](const std::string& end) {
    std::string changed;
    for (const char c : text) changed += c == '\n' ? end : std::string(1, c);
    return changed;
  };
  for (const std::string& variant :
       {text, with("\r\n"), with("\r"), "\xEF\xBB\xBF" + text, text.substr(0, text.size() - 1)}) {
    const ObjData data = parse(variant);
    EXPECT_EQ(data.positions.size(), 3u);
    EXPECT_EQ(data.corners.size(), 3u);
    EXPECT_EQ(data.report.lines, 6u);
    EXPECT_TRUE(data.report.warnings.empty());
  }
}

TEST(Obj, joins_lines_that_end_in_a_backslash) {
  const ObjData data = parse("v 0 0 \\\n 0\r\nv 1 0 0\nv 0 1 0\n# C:\\models\\\nf 1 \\\r\n 2 \\\n 3\n");
  EXPECT_EQ(data.corners.size(), 3u);
  EXPECT_EQ(data.report.lines, 8u);
  EXPECT_EQ(parse(obj_triangle + "f 1 2 3\\").corners.size(), 3u) << "a continuation at the end of the file";
  EXPECT_EQ(parse(obj_triangle + "f 1 \\ \n2 \\\t\r\n3\\ ").corners.size(), 3u) << "blanks behind it";
}

TEST(Obj, keeps_runs_of_materials_groups_and_smoothing) {
  const ObjData data =
      parse(obj_triangle +
            "mtllib a.mtl b.mtl\nmtllib c d.mtl\nusemtl unused\nusemtl red paint #1 \ng body\n"
            "f 1 2 3\nusemtl blue\no tail\ns 1\nf 1 2 3\nusemtl blue\nf 1 2 3\ns off\nf 1 2 3\n");
  ASSERT_EQ(data.libraries.size(), 2u);
  EXPECT_EQ(data.libraries[1], "c d.mtl");
  ASSERT_EQ(data.material_runs.size(), 2u);
  EXPECT_EQ(data.material_runs[0].name, "red paint #1");
  EXPECT_EQ(data.material_runs[1].first_triangle, 1u);
  ASSERT_EQ(data.group_runs.size(), 2u);
  EXPECT_EQ(data.group_runs[1].name, "tail");
  ASSERT_EQ(data.smoothing.size(), 3u);
  EXPECT_EQ(data.smoothing[0].group, 0u);
  EXPECT_EQ(data.smoothing[1].first_triangle, 1u);
  EXPECT_EQ(data.smoothing[2].first_triangle, 3u);
  EXPECT_TRUE(parse(obj_triangle + "s off\nf 1 2 3\ns 0\n").smoothing.empty()) << "never switched on";
}

TEST(Obj, counts_what_it_repairs_or_leaves_out) {
  const ObjData data = parse(obj_triangle +
                             "v 1 1 0\np 1\nl 1 2 3\ncurv 0 1\nparm u 0\n"
                             "f 1\nf 1 2\nf 1 2 2\nf 1 1 1 1\nf 1 2 2 3\nf 1 2 3 1\nf 1 2 4 3\n");
  EXPECT_EQ(data.report.points_and_lines, 2u);
  EXPECT_EQ(data.report.unknown_lines, 2u);
  EXPECT_EQ(data.report.faces, 7u);
  EXPECT_EQ(data.report.dropped_faces, 4u);
  EXPECT_EQ(data.report.dropped_corners, 6u);  // 1 + 3 + 1 + 1
  EXPECT_EQ(data.report.polygons, 1u);
  EXPECT_EQ(data.triangle_count(), 4u);
  EXPECT_EQ(data.report.warnings.size(), 4u);
}

TEST(Obj, tells_of_corners_without_vt_or_vn_among_others) {
  const ObjData data = parse(obj_triangle + "vt 0.5 0.5\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\nf 1 2/1 3\n");
  EXPECT_EQ(data.report.missing_texcoords, 2u);
  EXPECT_EQ(data.report.missing_normals, 3u);
  EXPECT_TRUE(parse(obj_triangle + "vt 0 0\nvn 0 0 1\nf 1 2 3\n").texcoords.empty()) << "no face uses them";
}

TEST(Obj, takes_an_index_of_a_vn_that_is_not_there_as_none) {
  // As the Catmull-Clark models that come with a well-known viewer have it: all vn, and no list.
  const ObjData without = parse(obj_triangle + "f 1//1 2//2 3//3\n");
  EXPECT_EQ(without.report.lost_normals, 3u);
  EXPECT_TRUE(without.normals.empty());
  ASSERT_EQ(without.report.warnings.size(), 1u);
  EXPECT_NE(without.report.warnings[0].find("3 corners whose vn is not"), std::string::npos);
  const ObjData shorter = parse(obj_triangle + "vn 0 0 1\nf 1//1 2//0 3//-2\n");
  EXPECT_EQ(shorter.report.lost_normals, 2u);
  EXPECT_EQ(shorter.report.missing_normals, 2u);
  EXPECT_EQ(shorter.corners[0].normal, 0u);
  const Mesh mesh = weld(shorter);
  for (const glm::vec3& normal : mesh.normals) EXPECT_EQ(normal, glm::vec3(0.0f, 0.0f, 1.0f));
}

TEST(Obj, takes_index_0_of_vt_as_none) {
  EXPECT_TRUE(parse(obj_triangle + "vt 0 0\nf 1/0/0 2/0/0 3/0/0\n").texcoords.empty());
  EXPECT_EQ(parse(obj_triangle + "vt 0 0\nf 1/0 2/1 3/1\n").report.missing_texcoords, 1u);
}

TEST(Obj, takes_any_smoothing_group) {
  struct Row {
    const char* line;
    bool smooth, warned;
  };
  const Row rows[] = {{"s on", true, false},
                      {"s ON", true, false},
                      {"s 1 # a comment", true, false},
                      {"s -1", true, false},
                      {"s 2147483648", true, false},
                      {"s 4294967296", true, false},
                      {"s 18446744073709551615", true, false},
                      {"s off", false, false},
                      {"s Off", false, false},
                      {"s OFF", false, false},
                      {"s 0", false, false},
                      {"s", false, true},
                      {"s null", false, true},
                      {"s # off", false, true}};
  for (const Row& row : rows) {
    // After a group, so that off is seen.
    const ObjData data = parse(obj_triangle + "s 7\nf 1 2 3\n" + row.line + "\nf 1 2 3\n");
    ASSERT_EQ(data.smoothing.size(), 2u) << row.line;
    EXPECT_EQ(data.smoothing[1].group != 0, row.smooth) << row.line;
    EXPECT_NE(data.smoothing[1].group, 7u) << row.line;
    EXPECT_EQ(data.report.warnings.size(), row.warned ? 1u : 0u) << row.line;
  }
}

TEST(Obj, takes_what_is_not_finite_as_missing_in_every_spelling) {
  for (const char* text : {"nan",          "NaN",     "-nan",    "nan(ind)",      "-nan(ind)",  "nan(snan)",
                           "NaNQ",         "1.#QNAN", "-1.#IND", "1.#QNAN0",      "1.#INF",     "-1.#INF00",
                           "1.#J",         "inf",     "-inf",    "+Inf",          "Infinity",   "-Infinity",
                           "\xE2\x88\x9E", "1e39",    "-1e308",  "1.797693e+308", "1e999999999"}) {
    SCOPED_TRACE(text);
    const std::string bad = text;
    // A line each of v, vt and vn. First, no face uses them.
    const std::string lines =
        obj_triangle + "v 0 " + bad + " 0\nvt 0 0\nvt 1 " + bad + "\nvn 0 0 1\nvn " + bad + " 0 0\n";
    const ObjData unused = parse(lines + "f 1/1/1 2/1/1 3/1/1\nf 1 4 4\n");
    EXPECT_EQ(unused.report.not_finite_lines, 3u);
    EXPECT_EQ(unused.report.not_finite_faces, 0u);
    // Now one face uses the v, another the vt and the vn.
    const ObjData used = parse(lines + "f 1/1/1 2/1/1 4/1/1\nf 1/1/1 2/1/1 3/2/2\n");
    EXPECT_EQ(used.report.not_finite_lines, 3u);
    EXPECT_EQ(used.report.not_finite_faces, 1u);
    ASSERT_EQ(used.triangle_count(), 1u);
    EXPECT_EQ(used.corners[2].texcoord, no_index);
    EXPECT_NE(used.report.warnings.at(1).find("3 lines of v, vt and vn"), std::string::npos);
    EXPECT_NE(used.report.warnings.at(1).find("line 4"), std::string::npos);
    for (const glm::vec3& normal : weld(used).normals) EXPECT_EQ(normal, glm::vec3(0.0f, 0.0f, 1.0f));
  }
  // What is not used of a line does not matter.
  const ObjData rest = parse("v 0 0 0 nan 0 0\nv 1 0 0 1\nv 0 1 0\nvt 0.5 0.5 nan\nf 1/1 2/1 3/1\n");
  EXPECT_EQ(rest.triangle_count(), 1u);
  EXPECT_EQ(rest.colors[0], glm::vec3(1.0f));
  EXPECT_EQ(rest.texcoords[rest.corners[0].texcoord], glm::vec2(0.5f));
}

TEST(Obj, reads_numbers_in_an_unusual_spelling) {
  struct Row {
    const char* text;
    glm::vec3 position;
  };
  const Row rows[] = {{"3.1+e2 -1.5-E3 +2+e", {3.1f, -1.5f, 2.0f}},  // the part that other programs read
                      {"1,5 -0,25 1,5e-2", {1.5f, -0.25f, 0.015f}},  // of a country with a decimal comma
                      {"1, 2, 3,", {1.0f, 2.0f, 3.0f}},
                      {"1.5D+02 0.1d0 -2D-1", {150.0f, 0.1f, -0.2f}}};  // Fortran
  for (const Row& row : rows) {
    const ObjData data = parse("v " + std::string(row.text) + "\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(data.positions[0], row.position) << row.text;
    EXPECT_EQ(data.report.repaired_numbers, 3u) << row.text;
    ASSERT_EQ(data.report.warnings.size(), 1u);
    EXPECT_NE(data.report.warnings[0].find("'" + std::string(row.text, 2)), std::string::npos);
  }
}

TEST(Obj, reads_a_number_of_many_zeros_as_what_it_is) {
  const std::string zeros(6000, '0');  // more than the exponent of any type
  for (const char* sign : {"", "-"})
    for (const std::string& text :
         {"0." + zeros + "1", "." + zeros + "1e+999", "0." + zeros + "1e-99999999999999999999", zeros + "e7",
          std::string("1e-99999999999999999999"), "0." + zeros + "e99999999999999999999"}) {
      const float value = parse(obj_triangle + "v 0 0 " + sign + text + "\nf 1 2 4\n").positions[3].z;
      EXPECT_EQ(value, 0.0f) << text;
      EXPECT_EQ(std::signbit(value), *sign == '-') << text;
    }
  EXPECT_EQ(parse(obj_triangle + "v 0 0 0." + zeros + "1e6001\nf 1 2 4\n").positions[3].z, 1.0f);
}

TEST(Obj, keeps_texture_coordinates_where_floats_have_fractions) {
  const ObjData data = parse(obj_triangle + "vt 1e30 -3.4e38\nvt 16777216 -16777216\nf 1/1 2/2 3/2\n");
  EXPECT_EQ(data.texcoords[0], glm::vec2(16777216.0f, -16777216.0f));
  EXPECT_EQ(data.texcoords[1], data.texcoords[0]);
  EXPECT_EQ(data.report.great_texcoords, 1u);
  ASSERT_EQ(data.report.warnings.size(), 1u);
  EXPECT_NE(data.report.warnings[0].find("1 vt beyond 16777216"), std::string::npos)
      << data.report.warnings[0];
}

TEST(Obj, refuses_a_face_of_more_corners_than_can_be_drawn) {
  std::string face = "f";
  for (std::size_t i = 0; i < max_face_corners; ++i) face += i % 2 == 0 ? " 1" : " 2";
  EXPECT_EQ(parse(obj_triangle + face + "\n").triangle_count(), max_face_corners - 2);
  try {
    parse(obj_triangle + face + " 3\n");
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("more than 65536 corners"), std::string::npos) << error.what();
    EXPECT_EQ(error.place().line, 4);
  }
}

TEST(Obj, refuses_bad_input_with_the_line_and_a_remedy) {
  struct Row {
    std::string text;
    int line;
    const char* what;
  };
  const Row rows[] = {
      {"", 0, "empty"},
      {obj_triangle, 0, "no face"},
      {"hello\nworld\n", 0, "2 lines not understood"},
      {obj_triangle + "f 1\nf 2 3\n", 0, "no face"},
      {obj_triangle + "f 0 1 2\n", 4, "index 0"},
      {obj_triangle + "f 1 2 4\n", 4, "index 4 of v is out of range: 3 so far"},
      {obj_triangle + "f 1 2 -4\n", 4, "index -4 of v is out of range"},
      {obj_triangle + "f 1/1 2/1 3/1\n", 4, "index 1 of vt is out of range: 0 so far"},
      {obj_triangle + "f 1 2 18446744073709551617\n", 4, "'18446744073709551617' is not an index of v"},
      {obj_triangle + "f 1 2 4\nv 1 1 1\n", 4, "so far"},  // a face uses a line below it
      {obj_triangle + "f 1 2 99999999999999999999\n", 4, "not an index"},
      {obj_triangle + "f 1 2 999999999999999999\n", 4, "out of range"},
      {obj_triangle + "f 1 2 -999999999999999999\n", 4, "out of range"},
      {obj_triangle + "f 1 2 3x\n", 4, "stray"},
      {obj_triangle + "f 1 2 x\n", 4, "'x' is not an index"},
      {obj_triangle + "f 1 2 /1\n", 4, "not an index"},
      {obj_triangle + "f 1/1/1/1 2 3\n", 4, "out of range"},
      {obj_triangle + "vt 0\nvn 0 0 1\nf 1/1/1/1 2 3\n", 6, "more than three"},
      {obj_triangle + "f 1 2 3.5\n", 4, "stray"},
      {obj_triangle + "f 1 2 -\n", 4, "not an index"},
      {obj_triangle + "v 0 0 -inf\nf 1 2 -1\n", 4, "all faces use a v that is not finite"},
      {obj_triangle + "v 0 0 1e39\nf 1 2 -1\n", 4, "or too large"},
      {"v 1,2,3 0 0\n", 1, "'1,2,3' is not a number"},
      {"v 1.000,5 0 0\n", 1, "not a number"},
      {"vt 0,5\n", 1, "not a number"},  // or u and v?
      {"v 0 0 info\n", 1, "not a number"},
      {"v 0 0 1e\n", 1, "not a number"},
      {"v 0 0 +-1\n", 1, "not a number"},
      {"v 0 0 +\n", 1, "not a number"},
      {"v 0 0 0x10\n", 1, "not a number"},
      {"v 0 0\n", 1, "needs 3"},
      {"v 0 0 # 0\n", 1, "needs 3"},
      {"v 0 0 0 1 1\n", 1, "5 numbers"},
      {"v 0 0 0 1 1 1 1 1\n", 1, "more than 7"},
      {"vt\n", 1, "needs 1"},
      {"vt 0 0 0 0\n", 1, "more than 3"},
      {"vn 0 0\n", 1, "needs 3"},
      {"v 0 0 3.1e+\n", 1, "not a number"},
      {"v 0 0 3.1+2\n", 1, "not a number"},
      {obj_triangle + "v 0 0 " + std::string(6000, '1') + "\nf 1 2 4\n", 4, "too large"},
      {obj_triangle + "v 0 0 0." + std::string(40, '0') + "1e99\nf 1 2 4\n", 4, "too large"},
      {"v 0 0 0\nv 1 \\\n 0 \\\n x\n", 2, "not a number"},  // the first of the joined lines
      {"v 0 0 0\r\nv 1 0 x\r\n", 2, "not a number"},
      {std::string("\x7f"
                   "ELF\x02\0\0\x01\n\0\0\n",
                   12),
       1, "binary"},
      {std::string("v\0 \0\x31\0\n\0", 8), 1, "binary"},                  // UTF-16
      {obj_triangle + "f 1 2 3\n" + std::string(40, '\0'), 5, "binary"},  // a tail of zeros
  };
  for (const Row& row : rows) {
    try {
      parse(row.text);
      ADD_FAILURE() << "accepted: " << row.text;
    } catch (const Error& error) {
      EXPECT_EQ(error.exit_code(), Exit::failed);
      EXPECT_EQ(error.place().line, row.line) << error.what();
      EXPECT_EQ(error.place().file, "test.obj");
      EXPECT_NE(std::string(error.what()).find(row.what), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("; "), std::string::npos) << "no remedy: " << error.what();
    }
  }
}

TEST(Obj, refuses_a_file_cut_off_in_a_number_or_face) {
  const std::string text = obj_triangle + "f 1 2 3\nf 3 2 1\n";
  // Each cut either parses (a line's end) or says where it stopped.
  for (std::size_t length = 0; length < text.size(); ++length) {
    try {
      EXPECT_GE(parse(text.substr(0, length)).triangle_count(), 1u);
      EXPECT_GE(length, obj_triangle.size() + 7);
    } catch (const Error& error) {
      EXPECT_EQ(error.exit_code(), Exit::failed);
    }
  }
}

TEST(Obj, shows_progress_that_grows_on_a_long_file) {
  std::string text = obj_triangle;
  while (text.size() < (3u << 20)) text += "f 1 2 3\n";
  std::vector<double> parts;
  parse_obj(text, "long.obj", {[&parts](double part) { parts.push_back(part); }});
  ASSERT_GE(parts.size(), 2u);
  for (std::size_t i = 1; i < parts.size(); ++i) EXPECT_GT(parts[i], parts[i - 1]);
  EXPECT_LE(parts.back(), 1.0);
}

TEST(Obj, reads_material_libraries_beside_the_file) {
  const Folder folder("obj_materials");
  write_file(folder / "my paints.mtl", "newmtl red\nKd 1 0 0\nmap_Kd -s 1 1 -clamp off red brick.png\n");
  write_file(folder / "b.mtl", "newmtl blue\nnorm n.png\nmap_Bump -bm 0.5 h.png\n");
  write_file(folder / "model.obj", obj_triangle +
                                       "mtllib my paints.mtl\nmtllib missing.mtl b.mtl\nusemtl red\nf 1 2 3\n"
                                       "usemtl green\nf 1 2 3\n");
  const ObjData data = load_obj(folder / "model.obj");
  ASSERT_EQ(data.materials.size(), 2u);
  EXPECT_EQ(find_material(data, "red")->color_map, "");
  EXPECT_EQ(find_material(data, "blue")->normal_map, "n.png");
  EXPECT_EQ(find_material(data, "green"), nullptr);
  ASSERT_EQ(data.report.warnings.size(), 3u);
  EXPECT_NE(data.report.warnings[0].find("red brick.png"), std::string::npos) << "the picture is missing";
  EXPECT_NE(data.report.warnings[1].find("missing.mtl"), std::string::npos);
  EXPECT_NE(data.report.warnings[2].find("'green'"), std::string::npos);
}

TEST(Obj, finds_pictures_beside_the_library_then_beside_the_model) {
  const Folder folder("obj_pictures");
  std::filesystem::create_directories(folder / "lib/maps");
  for (const char* picture :
       {"both.png", "lib/both.png", "model only.png", "lib/maps/sub.png", "lib/wall #2.png", "lib/wall"})
    write_file(folder / picture, "");
  struct Row {
    const char* written;
    const char* found;
  };
  const Row rows[] = {{"both.png", "lib/both.png"},
                      {"-s 1 1 1 model only.png", "model only.png"},
                      {"maps\\sub.png", "lib/maps/sub.png"},
                      {"C:\\Users\\me\\model only.png", "model only.png"},  // of another machine
                      {"/home/me/both.png", "lib/both.png"},
                      {"wall #2.png", "lib/wall #2.png"},
                      {"wall #2.png # the wall", "lib/wall #2.png"},
                      {"wall # the wall", "lib/wall"},
                      {"maps", nullptr},  // a folder
                      {"none.png", nullptr}};
  for (const Row& row : rows) {
    write_file(folder / "lib/my #1.mtl", "newmtl m\nmap_Kd " + std::string(row.written) + "\n");
    write_file(folder / "model.obj", obj_triangle + "mtllib lib/my #1.mtl # a note\nusemtl m\nf 1 2 3\n");
    const ObjData data = load_obj(folder / "model.obj");
    ASSERT_EQ(data.materials.size(), 1u) << row.written;
    EXPECT_EQ(data.materials[0].color_map, row.found ? (folder / row.found).string() : "") << row.written;
    EXPECT_EQ(data.report.warnings.size(), row.found ? 0u : 1u) << row.written;
  }
}

TEST(Obj, names_run_to_the_end_of_their_line) {
  struct Row {
    const char *first_material, *second_material;
    const char* uses[2];
    const char* found[2];  // materials, or nullptr
  };
  const Row rows[] = {
      {"Grey #1", "Grey #2", {"Grey #1", "Grey #2"}, {"Grey #1", "Grey #2"}},
      {"Grey", "Grey #2", {"Grey #1", "Grey #2"}, {"Grey", "Grey #2"}},
      {"Grey #1", "Grey", {"Grey #1 # note", "Grey"}, {"Grey #1", "Grey"}},
      {"red", "blue", {"red # the roof", "blue"}, {"red", "blue"}},
      {"red", "blue", {"red#2", "blue"}, {nullptr, "blue"}},
      {"red # the roof", "blue", {"red", "blue"}, {"red", "blue"}},
      {"red # the roof", "blue", {"red # of tiles", "blue # sky"}, {"red", "blue"}},
      {"red", "green", {"red", "blue # sky"}, {"red", nullptr}},
  };
  const Folder folder("obj_names");
  for (const Row& row : rows) {
    SCOPED_TRACE(std::string(row.uses[0]) + ", " + row.uses[1]);
    write_file(folder / "a.mtl",
               std::string("newmtl ") + row.first_material + "\nnewmtl " + row.second_material + "\n");
    std::string text = obj_triangle + "mtllib a.mtl # note\n";
    for (const char* use : row.uses) text += std::string("usemtl ") + use + "\nf 1 2 3\n";
    write_file(folder / "model.obj", text);
    const ObjData data = load_obj(folder / "model.obj");
    ASSERT_EQ(data.material_runs.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
      const Material* material = find_material(data, data.material_runs[i].name);
      ASSERT_EQ(material != nullptr, row.found[i] != nullptr) << i;
      if (material != nullptr) {
        EXPECT_EQ(material->name, row.found[i]);
      }
    }
  }
  const ObjData groups = parse(obj_triangle + "g Part #1\nf 1 2 3\ng Part #2\nf 1 2 3\no Body #3\nf 1 2 3\n");
  ASSERT_EQ(groups.group_runs.size(), 3u);
  EXPECT_EQ(groups.group_runs[1].name, "Part #2");
  EXPECT_EQ(groups.group_runs[2].name, "Body #3");
}

TEST(Obj, says_when_a_file_cannot_be_read) {
  const Folder folder("obj_unreadable");
  EXPECT_THROW(load_obj(folder / "none.obj"), Error);
  EXPECT_THROW(load_obj(folder / ""), Error);
}

/// The materials of a text, and what is warned of: nothing, where that is not asked for.
std::vector<Material> parse_lines(const std::string& text, std::vector<std::string>* warnings = nullptr) {
  std::vector<std::string> none;
  std::vector<Material> materials = parse_mtl(text, "a.mtl", warnings != nullptr ? *warnings : none);
  EXPECT_TRUE(none.empty()) << text;
  return materials;
}

TEST(Mtl, reads_maps_with_their_options_and_leaves_the_rest) {
  struct Row {
    const char* line;
    const char* color_map;
    const char* normal_map;
  };
  const Row rows[] = {
      {"map_Kd a.png", "a.png", ""},
      {"map_kd -s 1 1 1 -o 0 a.png", "a.png", ""},
      {"map_Kd -blendu off -mm 0 1 -texres 512 my file.png", "my file.png", ""},
      {"map_Kd sub\\dir\\a.png", "sub/dir/a.png", ""},
      {"map_Kd -s 1 1 1", "", ""},
      {"bump -bm 1.5 b.png", "", "b.png"},
      {"map_bump b.png", "", "b.png"},
      {"norm n.png", "", "n.png"},
      {"\tNs 96\nillum 2\nd 1\nmap_Ks s.png\nnonsense 1 2", "", ""},
  };
  for (const Row& row : rows) {
    const auto materials = parse_lines("# c\nnewmtl m\n" + std::string(row.line) + "\n");
    ASSERT_EQ(materials.size(), 1u);
    EXPECT_EQ(materials[0].color_map, row.color_map) << row.line;
    EXPECT_EQ(materials[0].normal_map, row.normal_map) << row.line;
  }
  EXPECT_EQ(parse_lines("newmtl m\nKd 0.25 0.5 1\n")[0].diffuse, glm::vec3(0.25f, 0.5f, 1.0f));
  EXPECT_EQ(parse_lines("newmtl m\nKd 0.5\n")[0].diffuse, glm::vec3(0.5f));
  EXPECT_EQ(parse_lines("newmtl m\nKd spectral a.rfl\n")[0].diffuse, glm::vec3(1.0f));
  EXPECT_TRUE(parse_lines("").empty());
}

TEST(Mtl, loses_a_bad_line_and_keeps_the_rest) {
  for (const char* text : {"newmtl m\nKd 0.5 x 1\n", "newmtl m\nKd 0.5 0.5\n", "newmtl m\nKd 1.#QNAN 0 0\n",
                           "newmtl m\nKd\n", "# c\nmap_Kd a.png\nnewmtl m\n"}) {
    std::vector<std::string> warnings;
    const auto materials = parse_lines(std::string(text) + "map_Kd b.png\nnewmtl n\nKd 0,5 0 1\n", &warnings);
    ASSERT_EQ(materials.size(), 2u) << text;
    EXPECT_EQ(materials[0].diffuse, glm::vec3(1.0f)) << text;
    EXPECT_EQ(materials[0].color_map, "b.png") << text;
    EXPECT_EQ(materials[1].diffuse, glm::vec3(0.5f, 0.0f, 1.0f)) << text;
    ASSERT_EQ(warnings.size(), 1u) << text;
    EXPECT_NE(warnings[0].find("a.mtl: 1 lines ignored; the first is line 2"), std::string::npos)
        << warnings[0];
  }
}

TEST(Mtl, says_which_options_of_a_picture_are_not_followed) {
  for (const char* options : {"-s 1 1 1 -o 0 0 0", "-s 1", "-clamp off -mm 0 1", "-t 0 0 0 -blendu on", ""})
    EXPECT_EQ(parse_lines("newmtl m\nmap_Kd " + std::string(options) + " a.png\n")[0].color_map, "a.png");
  for (const char* options :
       {"-s 2 2 1", "-s 1 0.5", "-o 0.25", "-clamp on", "-mm 0 2", "-s 1 1 1 -t 0 1 0"}) {
    std::vector<std::string> warnings;
    parse_lines("newmtl m\nmap_Kd " + std::string(options) + " a.png\nbump -s 2 2 2 b.png\n", &warnings);
    ASSERT_EQ(warnings.size(), 1u) << options;
    EXPECT_NE(warnings[0].find("not followed"), std::string::npos) << warnings[0];
    EXPECT_NE(warnings[0].find("of material 'm'"), std::string::npos) << warnings[0];
  }
}

/// A text with random numbers, triangles and convex quads in every form of corner.
std::string generated(std::uint64_t seed, bool texcoords, bool normals) {
  std::uint64_t state = seed;
  const auto random = [&state](std::uint64_t below) { return (state = mix(state)) % below; };
  std::ostringstream text;
  text.precision(9);
  const auto number = [&] {
    return (static_cast<double>(random(2'000'001)) - 1e6) * std::pow(10.0, -double(random(9)));
  };
  const int count = 40;
  for (int i = 0; i < count; ++i) {
    text << "v " << number() << ' ' << number() << ' ' << number() << '\n';
    if (texcoords) text << "vt " << number() << ' ' << number() << '\n';
    if (normals) text << "vn " << number() << ' ' << number() << ' ' << number() << '\n';
  }
  for (int f = 0; f < 60; ++f) {
    if (f % 20 == 10) text << "usemtl m" << f << "\ng part" << f << '\n';
    const auto first = static_cast<long>(random(count - 3)) + 1;
    text << 'f';
    for (int k = 0; k < 3; ++k) {
      const long v = random(2) == 0 ? first + k : first + k - count - 1;
      text << ' ' << v;
      if (texcoords) text << '/' << random(count) + 1;
      if (normals) text << (texcoords ? "/" : "//") << random(count) + 1;
    }
    text << '\n';
  }
  return text.str();
}

TEST(Obj, agrees_with_tinyobjloader_on_generated_files) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const bool texcoords = seed % 2 == 1, normals = seed % 4 >= 2;
    const std::string text = generated(seed, texcoords, normals);
    tinyobj::ObjReader reader;
    tinyobj::ObjReaderConfig config;
    config.vertex_color = false;
    ASSERT_TRUE(reader.ParseFromString(text, "", config)) << reader.Error();
    const ObjData data = parse(text);

    const tinyobj::attrib_t& theirs = reader.GetAttrib();
    ASSERT_EQ(theirs.vertices.size(), 3 * data.positions.size());
    ASSERT_EQ(theirs.texcoords.size(), 2 * data.texcoords.size());
    ASSERT_EQ(theirs.normals.size(), 3 * data.normals.size());
    // Theirs adds up digits in double and rounds twice, so the last bit may differ: relative 2^-23.
    const auto near = [](float ours, float other) {
      return std::abs(ours - other) <= 0x1p-23f * std::abs(ours) + 1e-30f;
    };
    for (std::size_t i = 0; i < data.positions.size(); ++i)
      for (int k = 0; k < 3; ++k)
        EXPECT_TRUE(near(data.positions[i][k], theirs.vertices[3 * i + static_cast<std::size_t>(k)]));
    std::vector<tinyobj::index_t> corners;
    for (const tinyobj::shape_t& shape : reader.GetShapes())
      corners.insert(corners.end(), shape.mesh.indices.begin(), shape.mesh.indices.end());
    ASSERT_EQ(corners.size(), data.corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto index = [](std::uint32_t n) { return n == no_index ? -1 : static_cast<int>(n); };
      EXPECT_EQ(index(data.corners[i].position), corners[i].vertex_index);
      EXPECT_EQ(index(data.corners[i].texcoord), corners[i].texcoord_index);
      EXPECT_EQ(index(data.corners[i].normal), corners[i].normal_index);
    }
  }
}

}  // namespace
}  // namespace texel::mesh
