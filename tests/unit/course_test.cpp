// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>

#include "../support/picture_files.hpp"
#include "../support/said.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "course/lab_file.hpp"

namespace texel::course {
namespace {

using test::error_of;
using test::replaced;

/// A folder with labs/05_normal_map/lab.toml of the given text.
class LabFile {
 public:
  explicit LabFile(const std::string& text) { test::put(path().parent_path(), {{"lab.toml", text}}); }
  [[nodiscard]] std::filesystem::path path() const { return folder_ / "labs/05_normal_map/lab.toml"; }
  [[nodiscard]] std::filesystem::path labs() const { return folder_ / "labs"; }

 private:
  test::TemporaryFolder folder_;
};

const std::string kHead =
    "lab = \"05_normal_map\"\ntitle = \"Normal map\"\nlesson = \"Light by a picture\"\n";
const std::string kLook = "[[look]]\nname = \"a\"\ncaption = \"A\"\n";
const std::string kStep =
    "[[step]]\nid = \"5.1\"\ntitle = \"Decode\"\npoints = 2\nhints = [\"Look\", \"Twice\"]\n";
const std::string kCase = "[[case]]\nname = \"flat\"\nstep = \"5.1\"\nlimit = 0.5\nwhy = \"measured\"\n";

using Words = std::vector<std::string>;

Lab lab_of(const std::string& text) {
  return read_lab(LabFile(text).path());
}

/// What reading the text says from the line on, or "".
std::string refusal(const std::string& text) {
  const LabFile file(text);
  const std::string message = error_of([&] { read_lab(file.path()); });
  const std::size_t name = message.find("lab.toml:");
  return name == std::string::npos ? message : message.substr(name + 9);
}

TEST(LabFile, has_looks) {
  const Lab lab = lab_of(kHead + R"(choice = "The first"
[[look]]
name = "bricks"
caption = "Bricks"
set = { normal_map = false, method = "mikktspace", turn = 30, bump_strength = 0.7 }
view = "normal"
size = "640x480"
source = "Report, section 3.4"
hero = true
[[opening]]
caption = "Wrong and right"
set = { method = "raw" }
right = { method = "mikktspace" }
sides = ["raw", "in the frame"]
)" + kLook);
  ASSERT_EQ(lab.openings.size(), 1U);
  EXPECT_EQ(lab.openings[0].right, (Setting{"method", "mikktspace"}));
  EXPECT_EQ(lab.openings[0].sides, (Words{"raw", "in the frame"}));
  EXPECT_EQ(lab.number, 5);
  EXPECT_EQ(lab.program(), "lab05_normal_map");
  EXPECT_EQ(lab.title, "Normal map");
  EXPECT_EQ(lab.lesson, "Light by a picture");
  ASSERT_EQ(lab.looks.size(), 2U);
  const std::vector<Setting> settings = {
      {"normal_map", "off"}, {"method", "mikktspace"}, {"turn", "30"}, {"bump_strength", "0.7"}};
  EXPECT_EQ(lab.looks[0].settings, settings);
  EXPECT_EQ(lab.looks[0].source, "Report, section 3.4");
  EXPECT_TRUE(lab.looks[0].hero);
  EXPECT_EQ(command(lab, lab.looks[0]),
            "./run lab 5 --normal-map off --method mikktspace --turn 30 --bump-strength 0.7 --view normal "
            "--size 640x480 --snapshot bricks.png");
  EXPECT_EQ(lab.looks[1].view, View::color);
  EXPECT_FALSE(lab.looks[1].hero);
  EXPECT_EQ(command(lab, lab.looks[1]), "./run lab 5 --snapshot a.png");
}

TEST(LabFile, has_steps_and_the_cases_that_judge_them) {
  const std::string look = "set = { model = \"torus\" }\nview = \"tangent\"\nseen_with = [\"5.2\"]\n";
  const Lab lab =
      lab_of(kHead + kStep + look + replaced(kStep, "5.1", "5.2") + "needs = [\"5.1\"]\n" +
             replaced(kStep, "5.1", "5.3") + "needs = [\"5.2\"]\n" + kCase +
             "view = \"normal\"\nset = { turn = 30 }\nhidden = { yaw = [-180, 180], normal_map = [\"brick\", "
             "\"wood\"] }\n" +
             replaced(replaced(kCase, "flat", "other"), "5.1", "5.2") +
             replaced(replaced(kCase, "flat", "third"), "5.1", "5.3"));
  ASSERT_EQ(lab.steps.size(), 3U);
  const Step& step = lab.steps[0];
  EXPECT_EQ(step.id, "5.1");
  EXPECT_EQ(step.points, 2);
  EXPECT_EQ(step.hints, (Words{"Look", "Twice"}));
  EXPECT_EQ(step.see.settings, (std::vector<Setting>{{"model", "torus"}}));
  EXPECT_EQ(step.see.view, View::tangent);
  EXPECT_EQ(lab.steps[1].see.view, View::color);
  EXPECT_EQ(lab.steps[2].needs, (Words{"5.1", "5.2"})) << "through others too";
  ASSERT_EQ(lab.cases.size(), 3U);
  const Case& c = lab.cases[0];
  EXPECT_EQ(c.step, "5.1");
  EXPECT_EQ(c.view, View::normal);
  EXPECT_EQ(c.file, c.name + ".pfm");
  EXPECT_TRUE(c.hidden);
  EXPECT_EQ(c.limit, 0.5);
  EXPECT_EQ(c.settings, (std::vector<Setting>{{"turn", "30"}}));
  ASSERT_EQ(c.hidden_settings.size(), 2U);
  EXPECT_EQ(c.hidden_settings[0].values, (Words{"-180", "180"}));
  EXPECT_EQ(c.hidden_settings[1].values, (Words{"brick", "wood"}));
}

TEST(LabFile, is_refused_with_place_and_remedy) {
  const std::string mesh = "a mesh is no picture: only a [[case]] has the view 'mesh'";
  std::vector<std::pair<std::string, std::string>> rows = {
      {kLook + "heros = true\n", "7:9: there is no key 'heros'; did you mean 'hero'?"},
      {"colour = 1\n",
       "4:10: there is no key 'colour'; the keys are lab, title, lesson, choice, look, opening, step, case, "
       "bench, claim, driver_methods"},
      {replaced(kLook, "\"A\"", "5"), "6:11: 'caption' is a text in quotes"},
      {replaced(kLook, "look", "opening") + "sides = [\"one\"]\n",
       "7:9: an opening has a value 'right' of the line, and the names of two sides"},
      {kLook + "hero = 1\n", "7:8: 'hero' is true or false"},
      {kLook + "set = { a = [1] }\n", "7:13: a parameter's value must be a text, number or boolean"},
      {"look = 1\n", "4:8: looks are written as [[look]] tables"},
      {"[[look]]\nname = \"a\"\n", "4:1: 'caption' is missing or empty"},
      {kLook + kLook, "8:8: two looks are called 'a'"},
      {replaced(kLook, "\"a\"", "\"../a\""),
       "5:8: '../a' is not a valid look name; use lower-case letters, digits, '_' and '-'"},
      {kLook + "view = \"mesh\"\n", "7:8: " + mesh},
      {kStep + "view = \"mesh\"\n" + kCase, "9:8: " + mesh},
      {kStep + kCase + "view = \"mesh\"\n", ""},
      {kStep, "4:1: no case judges step '5.1'"},
      {replaced(kStep, "5.1", "5.2") + kCase, "5:6: this is step '5.2', but the next one must be '5.1'"},
      {replaced(kStep, "[\"Look\", \"Twice\"]", "[]") + kCase, "8:9: a step must have one to three hints"},
      {kStep + "hint_of = { flat = 3 }\n" + kCase, "9:20: 'flat' must name one of the step's hints, from 1"},
      {replaced(kStep, "points = 2", "points = -2") + kCase, "7:10: 'points' must be a number, 0 or larger"},
      {kStep + replaced(kCase, "5.1", "5.9"), "11:8: there is no step '5.9'"},
      {kStep + kCase + kCase, "15:8: two cases are called 'flat'"},
      {kStep + kCase + "hidden = { yaw = 3 }\n", "14:18: 'yaw' must be a list of values"}};
  for (const std::string step : {"5.1", "5.2", "4.1"})
    rows.emplace_back(kStep + "needs = [\"" + step + "\"]\n" + kCase,
                      "9:9: there is no step '" + step + "' before this one");
  for (const auto& [text, expected] : rows) EXPECT_EQ(refusal(kHead + text), expected) << text;

  EXPECT_EQ(refusal("title = \"Normal map\"\n"), "1:1: 'lab' is missing or empty");
  EXPECT_EQ(refusal("lab = \"06_cube_map\"\n"),
            "1:7: '06_cube_map' is not the name of the file's folder; rename one of them");
  EXPECT_EQ(refusal(kHead + "[[look]\n").substr(0, 2), "4:");
  EXPECT_NE(refusal(std::string("\0\xff", 2)), "");
}

// What a student and the grader read beside each figure.
TEST(View, is_judged_in_the_unit_of_what_it_shows) {
  const std::pair<const char*, const char*> units[] = {
      {"color", "8-bit steps"},       {"normal", "degrees"}, {"tangent", "degrees"},
      {"direction", "degrees"},       {"mesh", "degrees"},   {"lod", "levels"},
      {"texcoord", "texture widths"}, {"depth", "units"}};
  for (const auto& [view, unit] : units)
    EXPECT_STREQ(name_of(unit_of(find_view(view).value())), unit) << view;
}

TEST(Size, has_two_sides_of_1_to_16384_pixels) {
  for (const char* text : {"1x1", "640x480", "16384x16384"})
    EXPECT_EQ(as_text(find_size(text).value()), text);
  for (const char* text : {"", "640", "640x", "x480", "640x480x", "640 x 480", "0x1", "1x-1", "16385x1",
                           "1x16385", "1x99999999999"})
    EXPECT_FALSE(find_size(text)) << text;
}

TEST(Labs, are_found_below_their_folder_without_what_was_copied_or_left_beside_them) {
  const LabFile file(kHead);
  EXPECT_THROW(read_labs(file.path().parent_path()), Error);
  EXPECT_THROW(read_labs("no/such/folder"), Error);
  test::put(file.labs(), {{"05_old/lab.toml", kHead}, {"05_normal_map - Copy/lab.toml", kHead}});
  std::filesystem::create_directories(file.labs() / "10_mine");
  write_file(file.labs() / ".DS_Store", "");
  const std::vector<Lab> labs = read_labs(file.labs());
  ASSERT_EQ(labs.size(), 1U);
  EXPECT_EQ(std::set<std::string>(labs[0].copies.begin(), labs[0].copies.end()),
            std::set<std::string>({"05_old", "05_normal_map - Copy"}));
  // Without the lab that it was copied from, nobody knows which is meant.
  std::filesystem::remove_all(file.path().parent_path());
  EXPECT_THROW(read_labs(file.labs()), Error);
}

TEST(LeftOver, is_a_file_with_a_name_that_only_programs_give) {
  for (const char* name : {"lab (1).cpp", "lab - Copy.cpp", "Copy of lab.cpp", "lab.cpp.orig", "lab.cpp~",
                           "lab.cpp.before-reset", ".#lab.cpp", "#lab.cpp#", ".lab.cpp.swp",
                           "lab_BACKUP_12.cpp", "bump.glsl.rej"})
    EXPECT_TRUE(is_left_over(name)) << name;
  for (const char* name :
       {"lab.cpp", "decode_normal.glsl", "Own-2.hpp", "README.md", "lab.toml", "embedded.hpp.in"})
    EXPECT_FALSE(is_left_over(name)) << name;
}

}  // namespace
}  // namespace texel::course
