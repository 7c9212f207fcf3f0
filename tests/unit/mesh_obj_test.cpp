// SPDX-License-Identifier: MIT
#include "mesh/obj.hpp"

#include <gtest/gtest.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "../support/said.hpp"
#include "mesh/distinct.hpp"
#include "mesh/weld.hpp"

namespace texel::mesh {
namespace {

using test::has;

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string lists = triangle + "vt 0 0\nvt 1 1\nvn 0 0 1\nvn 1 0 0\n";

ObjData parse(const std::string& text) {
  return parse_obj(text, "test.obj");
}

/// All corners as an OBJ file would write them, counted from 1.
std::string corners_of(const ObjData& data) {
  const auto index = [](std::uint32_t n) { return n == no_index ? "" : std::to_string(n + 1); };
  std::string text;
  for (const Corner& corner : data.corners) {
    text += (text.empty() ? "" : " ") + index(corner.position);
    if (corner.texcoord != no_index || corner.normal != no_index) text += "/" + index(corner.texcoord);
    if (corner.normal != no_index) text += "/" + index(corner.normal);
  }
  return text;
}

/// As many warnings as parts, and each has its part.
void expect_warnings(const ObjData& data, const std::vector<std::string>& parts) {
  const std::vector<std::string>& warnings = data.warnings;
  ASSERT_EQ(warnings.size(), parts.size()) << testing::PrintToString(warnings);
  for (std::size_t i = 0; i < parts.size(); ++i) EXPECT_TRUE(has(warnings[i], parts[i])) << warnings[i];
}

TEST(Obj, reads_corners_and_tells_of_what_it_repairs_or_leaves_out) {
  const std::tuple<std::string, std::string, std::vector<std::string>> rows[] = {
      {lists + "f 1 2 3\n", "1 2 3", {}},
      {lists + "f 1/1 2/2 3/2\n", "1/1 2/2 3/2", {}},
      {lists + "f 1//1 2//1 3//2\n", "1//1 2//1 3//2", {}},
      {lists + "f 1/1/1 2/1/1 3/2/2\n", "1/1/1 2/1/1 3/2/2", {}},
      {lists + "f -3/-2/-2 -2/-1/-1 -1/-2/-1\n", "1/1/1 2/2/2 3/1/2", {}},
      {lists + "f 1/ 2/ 3/\nf 1// 2// 3//\n", "1 2 3 1 2 3", {}},
      {lists + "f 1/1/ 2/1/ 3/2/\n", "1/1 2/1 3/2", {}},
      {lists + "f 1 2/1 3//2\n", "1 2/1 3//2", {"2 corners without vt", "2 corners without vn"}},
      {lists + "f +1 +2 +3\nfo 3 2 1\n\t f\t1  2\t 3 \t\n", "1 2 3 3 2 1 1 2 3", {}},
      // Negative indices count from the lines above the face.
      {triangle + "f -3 -2 -1\nv 9 9 9\nv 8 8 8\nf -5 -2 -1\n", "1 2 3 1 4 5", {}},
      // A comment begins at a word, and a backslash joins lines with a blank between.
      {"v 0 0 0 #1\nv 1 0 0\nv 0 1 0\ns 1 #2\nf 1 2 3 #4\nf 1 2 3 # 4\n", "1 2 3 1 2 3", {}},
      {"v 0 0 \\\n 0\r\nv 1 0 0\nv 0 1 0\n# C:\\models\\\nf 1 \\\r\n 2 \\\n 3\n", "1 2 3", {}},
      {triangle + "f 1\\\n2\\\n3\n", "1 2 3", {}},
      {triangle + "f 1 \\ \n2 \\\t\r\n3\\ ", "1 2 3", {}},  // blanks behind it, and the file's end
      {triangle + "f 1 2 3\\", "1 2 3", {}},
      // Faces without three corners, and what is no face.
      {triangle + "v 1 1 0\np 1\nl 1 2 3\ncurv 0 1\nparm u 0\n"
                  "f 1\nf 1 2\nf 1 2 2\nf 1 1 1 1\nf 1 2 2 3\nf 1 2 3 1\nf 1 2 4 3\n",
       "1 2 3 1 2 3 1 2 4 1 4 3",
       {"2 points and lines", "2 lines with an unknown keyword, ignored; the first is 'curv'",
        "4 faces with fewer than three", "6 corners that repeat"}},
      // Index 0 of vt is none. One of vn may also be of a list that is too short or not there, as in the
      // Catmull-Clark models that come with a well-known viewer.
      {lists + "f 1/0/0 2/0/0 3/0/0\n", "1 2 3", {"3 corners whose vn is not"}},
      {lists + "f 1/0 2/1 3/1\n", "1 2/1 3/1", {"1 corners without vt"}},
      {triangle + "f 1//1 2//2 3//3\n", "1 2 3", {"3 corners whose vn is not"}},
      {triangle + "vn 0 0 1\nf 1//1 2//0 3//-2\n",
       "1//1 2 3",
       {"2 corners whose vn is not", "2 corners without vn"}},
      // A texture coordinate beyond what has fractions in float32.
      {triangle + "vt 1e30 -3.4e38\nvt 16777216 -16777216\nf 1/1 2/2 3/2\n",
       "1/1 2/2 3/2",
       {"1 vt beyond 16777216"}},
  };
  for (const auto& [text, corners, warnings] : rows) {
    SCOPED_TRACE(text);
    const ObjData data = parse(text);
    EXPECT_EQ(corners_of(data), corners);
    expect_warnings(data, warnings);
    // A list that no face uses is not there.
    const auto uses = [&](std::uint32_t Corner::*index) {
      return std::ranges::any_of(data.corners,
                                 [=](const Corner& corner) { return corner.*index != no_index; });
    };
    EXPECT_EQ(data.texcoords.empty(), !uses(&Corner::texcoord));
    EXPECT_EQ(data.normals.empty(), !uses(&Corner::normal));
  }
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
    EXPECT_EQ(corners_of(data), "1 2 3");
    expect_warnings(data, {});
  }
}

TEST(Obj, rounds_numbers_to_the_nearest_float_and_repairs_unusual_ones) {
  const std::string zeros(6000, '0');  // more than the exponent of any type
  struct Row {
    std::string text;
    float value;
    bool repaired = false;
  };
  std::vector<Row> rows = {
      {"0.1", 0.1F},
      {"+2.5", 2.5F},
      {"-1e-3", -1e-3F},
      {"1.5E+2", 150.0F},
      {".5", 0.5F},
      {"5.", 5.0F},
      {"16777217", 16777216.0F},             // halfway: to even
      {"16777217.0000000001", 16777218.0F},  // just above halfway: a parser by double rounds it down
      {"3.4028235e38", 3.4028235e38F},       // the largest
      {"1e-45", std::numeric_limits<float>::denorm_min()},
      {"-0", -0.0F},
      {"0." + zeros + "1e6001", 1.0F},
      {"3.1+e2", 3.1F, true},  // the part that other programs read
      {"-1.5-E3", -1.5F, true},
      {"+2+e", 2.0F, true},
      {"1,5", 1.5F, true},  // of a country with a decimal comma
      {"-0,25", -0.25F, true},
      {"1,5e-2", 0.015F, true},
      {"3,", 3.0F, true},
      {"1.5D+02", 150.0F, true},  // Fortran
      {"0.1d0", 0.1F, true},
      {"-2D-1", -0.2F, true},
  };
  for (const std::string sign : {"", "-"})  // too small, for a double too
    for (const std::string& text :
         {std::string("1e-46"), std::string("1e-400"), "0." + zeros + "1", "." + zeros + "1e+999",
          "0." + zeros + "1e-99999999999999999999", zeros + "e7", std::string("1e-99999999999999999999"),
          "0." + zeros + "e99999999999999999999"})
      rows.push_back({sign + text, sign.empty() ? 0.0F : -0.0F});
  for (const Row& row : rows) {
    SCOPED_TRACE(row.text.substr(0, 20));
    const ObjData data = parse("v 0 " + row.text + " 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(data.positions[0].y, row.value);
    EXPECT_EQ(std::signbit(data.positions[0].y), std::signbit(row.value));
    if (row.repaired)
      expect_warnings(data, {"1 numbers in an unusual spelling; the first is '" + row.text});
    else
      expect_warnings(data, {});
  }
}

TEST(Obj, reads_over_weights_and_colors_and_takes_one_to_three_texture_numbers) {
  const ObjData data = parse(
      "v 0 2 3\nv 1 0 0 0.5\nv 0 1 0 0.25 0.5 0.75\nv 1 1 0 1 0.1 0.2 0.3\nv 0 0 0 nan 0 0\nv 0 0 1\n"
      "vt 0.25\nvt 0.25 0.75\nvt 2 -1 0.5\nvt 0.5 0.5 nan\nvt 1e30 -3.4e38\nf 1/1 2/2 3/3\nf 1/4 2/5 4/5\n");
  EXPECT_EQ(data.positions[0], glm::vec3(0, 2, 3));
  EXPECT_EQ(data.positions[3], glm::vec3(1, 1, 0));
  EXPECT_EQ(data.texcoords, (std::vector<glm::vec2>{
                                {0.25F, 0}, {0.25F, 0.75F}, {2, -1}, {0.5F, 0.5F}, {16777216, -16777216}}));
  EXPECT_EQ(data.corners[3].texcoord, 3U) << "the third number does not matter";
}

TEST(Obj, keeps_runs_of_materials_groups_and_smoothing) {
  const auto runs = [](const std::vector<NamedRun>& all) {
    std::string text;
    for (const NamedRun& run : all) text += std::to_string(run.first_triangle) + " " + run.name + "; ";
    return text;
  };
  const ObjData data =
      parse(triangle +
            "mtllib a.mtl b.mtl\nmtllib c d.mtl\nusemtl unused\nusemtl red paint #1 \ng Part #1\n"
            "f 1 2 3\nusemtl blue\no tail\ns 1\nf 1 2 3\nusemtl blue\nf 1 2 3\ns off\nf 1 2 3\n");
  EXPECT_EQ(data.libraries, (std::vector<std::string>{"a.mtl b.mtl", "c d.mtl"}));
  EXPECT_EQ(runs(data.material_runs), "0 red paint #1; 1 blue; ");
  EXPECT_EQ(runs(data.group_runs), "0 Part #1; 1 tail; ");
  ASSERT_EQ(data.smoothing.size(), 3U);
  EXPECT_EQ(data.smoothing[0].group, 0U);
  EXPECT_EQ(data.smoothing[1].first_triangle, 1U);
  EXPECT_EQ(data.smoothing[2].first_triangle, 3U);
  EXPECT_TRUE(parse(triangle + "s off\nf 1 2 3\ns 0\n").smoothing.empty()) << "never switched on";
}

TEST(Obj, takes_any_smoothing_group) {
  const std::tuple<std::vector<std::string>, bool, std::vector<std::string>> rows[] = {
      {{"s on", "s ON", "s 1 # a comment", "s -1", "s 2147483648", "s 4294967296", "s 18446744073709551615"},
       true,
       {}},
      {{"s off", "s Off", "s OFF", "s 0"}, false, {}},
      {{"s", "s null", "s # off"}, false, {"1 smoothing groups (s) that are no number"}}};
  for (const auto& [written, is_smooth, warnings] : rows)
    for (const std::string& line : written) {
      SCOPED_TRACE(line);
      // After a group, so that off is seen.
      const ObjData data = parse(triangle + "s 7\nf 1 2 3\n" + line + "\nf 1 2 3\n");
      ASSERT_EQ(data.smoothing.size(), 2U);
      EXPECT_EQ(data.smoothing[1].group != 0, is_smooth);
      EXPECT_NE(data.smoothing[1].group, 7U);
      expect_warnings(data, warnings);
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
        triangle + "v 0 " + bad + " 0\nvt 0 0\nvt 1 " + bad + "\nvn 0 0 1\nvn " + bad + " 0 0\n";
    const std::string told = "3 lines of v, vt and vn with NaN, infinity or more than a 32-bit float";
    expect_warnings(parse(lines + "f 1/1/1 2/1/1 3/1/1\nf 1 4 4\n"),
                    {told, "1 corners that repeat", "1 faces with fewer"});
    // Now one face uses the v, another the vt and the vn.
    const ObjData used = parse(lines + "f 1/1/1 2/1/1 4/1/1\nf 1/1/1 2/1/1 3/2/2\n");
    EXPECT_EQ(corners_of(used), "1/1/1 2/1/1 3//2");
    expect_warnings(used, {told, "1 faces that use such a v", "1 corners without vt"});
    EXPECT_TRUE(has(used.warnings[0], "the first is line 4"));
    for (const glm::vec3& normal : weld(used).normals) EXPECT_EQ(normal, glm::vec3(0.0F, 0.0F, 1.0F));
  }
}

/// The text is refused with these words, at this line, and with a remedy.
void expect_refused(const std::string& text, int line, const std::string& what) {
  SCOPED_TRACE(text.substr(0, 200));
  try {
    parse(text);
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), Exit::failed);
    EXPECT_EQ(error.place().line, line) << error.what();
    EXPECT_EQ(error.place().file, "test.obj");
    EXPECT_TRUE(has(error.what(), what)) << error.what();
    EXPECT_TRUE(has(error.what(), "; ")) << "no remedy: " << error.what();
  }
}

TEST(Obj, refuses_bad_input_with_the_line_and_a_remedy) {
  expect_refused("", 0, "empty");
  expect_refused("hello\nworld\n", 0, "2 lines not understood");
  const std::string joined = "v 1 \\\n 0 \\\n x\n";  // counts as the first of its lines
  // The texts come after the three lines of the triangle.
  const std::tuple<const char*, int, std::vector<std::string>> rows[] = {
      {"no face", 0, {"", "f 1\nf 2 3\n"}},
      {"index 0", 4, {"f 0 1 2\n"}},
      {"index 4 of v is out of range: 3 so far", 4, {"f 1 2 4\n", "f 1 2 4\nv 1 1 1\n"}},
      {"index -4 of v is out of range", 4, {"f 1 2 -4\n"}},
      {"index 1 of vt is out of range: 0 so far", 4, {"f 1/1 2/1 3/1\n", "f 1/1/1/1 2 3\n"}},
      {"out of range", 4, {"f 1 2 999999999999999999\n", "f 1 2 -999999999999999999\n"}},
      {"'18446744073709551617' is not an index of v", 4, {"f 1 2 18446744073709551617\n"}},
      {"'x' is not an index", 4, {"f 1 2 x\n"}},
      {"not an index", 4, {"f 1 2 99999999999999999999\n", "f 1 2 /1\n", "f 1 2 -\n"}},
      {"stray", 4, {"f 1 2 3x\n", "f 1 2 3.5\n"}},
      {"more than three", 6, {"vt 0\nvn 0 0 1\nf 1/1/1/1 2 3\n"}},
      {"all faces use a v that is not finite or too large", 4, {"v 0 0 -inf\nf 1 2 -1\n"}},
      {"too large",
       4,
       {"v 0 0 1e39\nf 1 2 -1\n", "v 0 0 " + std::string(6000, '1') + "\nf 1 2 4\n",
        "v 0 0 0." + std::string(40, '0') + "1e99\nf 1 2 4\n"}},
      {"'1,2,3' is not a number", 4, {"v 1,2,3 0 0\n"}},
      {"'0,5' is not a number", 4, {"vt 0,5\n"}},  // or u and v?
      {"not a number",
       4,
       {"v 1.000,5 0 0\n", "v 0 0 info\n", "v 0 0 1e\n", "v 0 0 +-1\n", "v 0 0 +\n", "v 0 0 0x10\n",
        "v 0 0 3.1e+\n", "v 0 0 3.1+2\n", joined}},
      {"not a number", 5, {"v 0 0 0\r\nv 1 0 x\r\n"}},
      {"needs 3", 4, {"v 0 0\n", "v 0 0 # 0\n", "vn 0 0\n"}},
      {"5 numbers", 4, {"v 0 0 0 1 1\n"}},
      {"more than 7", 4, {"v 0 0 0 1 1 1 1 1\n"}},
      {"needs 1", 4, {"vt\n"}},
      {"more than 3", 4, {"vt 0 0 0 0\n"}},
      {"binary",
       4,
       {std::string("\x7F"
                    "ELF\2\0\0\1\n\0\0\n",
                    12),
        std::string("v\0 \0\x31\0\n\0", 8)}},                // UTF-16
      {"binary", 5, {"f 1 2 3\n" + std::string(40, '\0')}},  // a tail of zeros
  };
  for (const auto& [what, line, texts] : rows)
    for (const std::string& text : texts) expect_refused(triangle + text, line, what);
}

TEST(Obj, refuses_a_face_of_more_corners_than_can_be_drawn) {
  std::string face = "f";
  for (std::size_t i = 0; i < max_face_corners; ++i) face += i % 2 == 0 ? " 1" : " 2";
  EXPECT_EQ(parse(triangle + face + "\n").triangle_count(), max_face_corners - 2);
  expect_refused(triangle + face + " 3\n", 4, "more than 65536 corners");
}

/// A text with random numbers and triangles in every form of corner.
std::string generated(std::uint64_t seed, bool texcoords, bool normals) {
  std::uint64_t state = seed;
  const auto random = [&state](std::uint64_t below) { return (state = mix(state)) % below; };
  std::ostringstream text;
  text.precision(9);
  const auto line = [&](const char* keyword, int numbers) {
    text << '\n' << keyword;
    for (int i = 0; i < numbers; ++i)
      text << ' ' << (static_cast<double>(random(2'000'001)) - 1e6) * std::pow(10.0, -double(random(9)));
  };
  const int count = 40;
  for (int i = 0; i < count; ++i) {
    line("v", 3);
    if (texcoords) line("vt", 2);
    if (normals) line("vn", 3);
  }
  for (int f = 0; f < 60; ++f) {
    const auto first = static_cast<long>(random(count - 3)) + 1;
    text << (f % 20 == 10 ? "\nusemtl m\ng part\nf" : "\nf");
    for (int k = 0; k < 3; ++k) {
      text << ' ' << (random(2) == 0 ? first + k : first + k - count - 1);
      if (texcoords) text << '/' << random(count) + 1;
      if (normals) text << (texcoords ? "/" : "//") << random(count) + 1;
    }
  }
  return text.str();
}

TEST(Obj, agrees_with_tinyobjloader_on_generated_files) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const std::string text = generated(seed, seed % 2 == 1, seed % 4 >= 2);
    tinyobj::ObjReader reader;
    ASSERT_TRUE(reader.ParseFromString(text, "")) << reader.Error();
    const ObjData data = parse(text);
    ObjData theirs;
    for (const tinyobj::shape_t& shape : reader.GetShapes())
      for (const auto& [v, vn, vt] : shape.mesh.indices)  // -1 is none, as our no_index
        theirs.corners.push_back(
            {static_cast<std::uint32_t>(v), static_cast<std::uint32_t>(vt), static_cast<std::uint32_t>(vn)});
    EXPECT_EQ(corners_of(data), corners_of(theirs));
    const auto expect_near = [](const auto& ours, const std::vector<float>& expected) {
      std::size_t at = 0;
      for (const auto& value : ours)
        for (int k = 0; k < value.length(); ++k)
          // Theirs adds up digits in double and rounds twice, so the last bit may differ: relative 2^-23.
          EXPECT_NEAR(value[k], expected.at(at++), 0x1p-23f * std::abs(value[k]) + 1e-30F);
      EXPECT_EQ(at, expected.size());
    };
    expect_near(data.positions, reader.GetAttrib().vertices);
    expect_near(data.texcoords, reader.GetAttrib().texcoords);
    expect_near(data.normals, reader.GetAttrib().normals);
  }
}

}  // namespace
}  // namespace texel::mesh
