// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>

#include "../support/picture_files.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "course/lab_file.hpp"

namespace texel::course {
namespace {

/// A folder with labs/05_normal_map/lab.toml of the given text.
class LabFile {
 public:
  explicit LabFile(const std::string& text) : folder_("course") {
    std::filesystem::create_directories(path().parent_path());
    write_file(path(), text);
  }
  /// Another lab beside it.
  void add(const std::string& lab, const std::string& text) const {
    std::filesystem::create_directories(labs() / lab);
    write_file(labs() / lab / "lab.toml", text);
  }
  [[nodiscard]] std::filesystem::path path() const { return folder_ / "labs/05_normal_map/lab.toml"; }
  [[nodiscard]] std::filesystem::path labs() const { return folder_ / "labs"; }

 private:
  test::TemporaryFolder folder_;
};

const std::string kHead =
    "lab = \"05_normal_map\"\ntitle = \"Normal map\"\nlesson = \"Light by a picture\"\n";

std::string refusal(const std::string& text) {
  const LabFile file(text);
  try {
    read_lab(file.path());
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), Exit::failed);
    const std::string message = error.what();
    const std::size_t name = message.find("lab.toml:");
    return name == std::string::npos ? message : message.substr(name + 9);
  }
  return "it was read";
}

TEST(LabFile, is_read_in_full) {
  const LabFile file(kHead + R"(
[[look]]
name = "bricks"
caption = "Bricks"
set = { normal_map = false, method = "mikktspace", turn = 30, bump_strength = 0.7 }
view = "normal"
size = "640x480"
source = "Report, section 3.4"
hero = true
[[look]]
name = "plain"
caption = "As it opens"
)");
  const Lab lab = read_lab(file.path());
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
  EXPECT_EQ(command(lab, lab.looks[1]), "./run lab 5 --snapshot plain.png");
}

TEST(LabFile, refuses_an_unknown_key_with_its_line) {
  EXPECT_EQ(refusal(kHead + "[[look]]\nname = \"a\"\ncaption = \"A\"\nheros = true\n"),
            "7:9: there is no key 'heros'; did you mean 'hero'?");
  EXPECT_EQ(refusal(kHead + "colour = 1\n"),
            "4:10: there is no key 'colour'; the keys are lab, title, lesson, look, bench, claim, choice, "
            "driver_methods, step, case");
}

TEST(LabFile, refuses_a_wrong_type_with_its_line) {
  EXPECT_EQ(refusal(kHead + "[[look]]\nname = \"a\"\ncaption = 5\n"), "6:11: 'caption' is a text in quotes");
  EXPECT_EQ(refusal(kHead + "[[look]]\nname = \"a\"\ncaption = \"A\"\nhero = 1\n"),
            "7:8: 'hero' is true or false");
  EXPECT_EQ(refusal(kHead + "[[look]]\nname = \"a\"\ncaption = \"A\"\nset = { a = [1] }\n"),
            "7:13: a parameter's value must be a text, number or boolean");
  EXPECT_EQ(refusal(kHead + "look = 1\n"), "4:8: looks are written as [[look]] tables");
}

TEST(LabFile, has_the_cases_of_the_benchmark) {
  const LabFile file(kHead + R"(choice = "The first"
[[bench]]
case = "jittered torus"
teaches = "Weights matter"
hard = true
set = { model = "torus", jitter = 0.5 }
vary = { method = [], segments = [16, 32] }
)");
  const Lab lab = read_lab(file.path());
  EXPECT_EQ(lab.choice, "The first");
  ASSERT_EQ(lab.bench.size(), 1U);
  const BenchCase& bench = lab.bench[0];
  EXPECT_EQ(bench.name, "jittered torus");
  EXPECT_EQ(bench.teaches, "Weights matter");
  EXPECT_TRUE(bench.hard);
  EXPECT_EQ(bench.settings, (std::vector<Setting>{{"model", "torus"}, {"jitter", "0.5"}}));
  EXPECT_EQ(bench.variations, (std::vector<Variation>{{"method", {}}, {"segments", {"16", "32"}}}));
  EXPECT_EQ(as_text(bench.size), "256x256");
}

TEST(LabFile, has_what_the_sources_say) {
  const std::string claim = "[[claim]]\nsource = \"Slides\"\nsays = \"Small\"\nfound = \"True\"\n";
  const LabFile file(kHead + claim + "see = \"./run bench 5\"\n");
  const Lab lab = read_lab(file.path());
  ASSERT_EQ(lab.claims.size(), 1U);
  EXPECT_EQ(lab.claims[0].source, "Slides");
  EXPECT_EQ(lab.claims[0].says, "Small");
  EXPECT_EQ(lab.claims[0].found, "True");
  EXPECT_EQ(lab.claims[0].see, "./run bench 5");
  EXPECT_EQ(refusal(kHead + claim), "4:1: 'see' is missing or empty");
}

const std::string kStep =
    "[[step]]\nid = \"5.1\"\ntitle = \"Decode\"\npoints = 2\nhints = [\"Look\", \"Twice\"]\n";
const std::string kCase = "[[case]]\nname = \"flat\"\nstep = \"5.1\"\nlimit = 0.5\nwhy = \"measured\"\n";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

TEST(LabFile, has_steps_and_the_cases_that_judge_them) {
  const LabFile file(kHead + kStep + kCase +
                     "view = \"normal\"\nset = { turn = 30 }\nhidden = { yaw = [-180, 180], normal_map = "
                     "[\"brick\", \"wood\"] }\n");
  const Lab lab = read_lab(file.path());
  ASSERT_EQ(lab.steps.size(), 1U);
  EXPECT_EQ(lab.steps[0].id, "5.1");
  EXPECT_EQ(lab.steps[0].points, 2);
  EXPECT_EQ(lab.steps[0].hints, (std::vector<std::string>{"Look", "Twice"}));
  ASSERT_EQ(lab.cases.size(), 1U);
  const GradedCase& c = lab.cases[0];
  EXPECT_EQ(c.step, "5.1");
  EXPECT_EQ(c.view, View::normal);
  EXPECT_EQ(c.file, c.name + ".pfm");
  EXPECT_TRUE(c.hidden);
  EXPECT_EQ(c.limit, 0.5);
  EXPECT_EQ(c.settings, (std::vector<Setting>{{"turn", "30"}}));
  ASSERT_EQ(c.hidden_settings.size(), 2U);
  EXPECT_EQ(c.hidden_settings[0].least, -180);
  EXPECT_EQ(c.hidden_settings[0].most, 180);
  EXPECT_EQ(c.hidden_settings[1].values, (std::vector<std::string>{"brick", "wood"}));
}

TEST(LabFile, has_the_look_in_which_one_sees_a_step) {
  const std::string second = replaced(kStep, "5.1", "5.2"), second_case = replaced(kCase, "flat", "other");
  const std::string look = "set = { model = \"torus\" }\nview = \"tangent\"\nseen_with = [\"5.2\"]\n";
  const LabFile file(kHead + kStep + look + second + kCase + replaced(second_case, "5.1", "5.2"));
  const Lab lab = read_lab(file.path());
  EXPECT_EQ(lab.steps[0].see.settings, (std::vector<Setting>{{"model", "torus"}}));
  EXPECT_EQ(lab.steps[0].see.view, View::tangent);
  EXPECT_EQ(lab.steps[0].seen_with, (std::vector<std::string>{"5.2"}));
  EXPECT_EQ(lab.steps[1].see.view, View::color);
  for (const std::string other : {"5.1", "5.3", "4.1"})
    EXPECT_EQ(refusal(kHead + kStep + "seen_with = [\"" + other + "\"]\n" + kCase),
              "4:1: step '5.1' cannot be seen with '" + other + "'; seen_with names other steps of this lab");
}

TEST(LabFile, refuses_a_mesh_where_a_picture_is_shown) {
  const std::string fault = "a mesh is no picture: only a [[case]] has the view 'mesh'";
  EXPECT_EQ(refusal(kHead + kStep + "view = \"mesh\"\n" + kCase), "9:8: " + fault);
  EXPECT_EQ(refusal(kHead + "[[look]]\nname = \"a\"\ncaption = \"A\"\nview = \"mesh\"\n"), "7:8: " + fault);
  EXPECT_EQ(refusal(kHead + kStep + kCase + "view = \"mesh\"\n"), "it was read");
}

TEST(LabFile, refuses_steps_and_cases_that_do_not_fit) {
  EXPECT_EQ(refusal(kHead + kStep), "4:1: no case judges step '5.1'");
  EXPECT_EQ(refusal(kHead + replaced(kStep, "5.1", "5.2") + kCase),
            "5:6: this is step '5.2', but the next one must be '5.1'");
  EXPECT_EQ(refusal(kHead + kStep + "needs = [\"5.3\"]\n" + kCase),
            "9:9: there is no step '5.3' before this one");
  EXPECT_EQ(refusal(kHead + replaced(kStep, "[\"Look\", \"Twice\"]", "[]") + kCase),
            "8:9: a step must have one to three hints");
  EXPECT_EQ(refusal(kHead + replaced(kStep, "points = 2", "points = -2") + kCase),
            "7:10: 'points' must be a number, 0 or larger");
  EXPECT_EQ(refusal(kHead + kStep + replaced(kCase, "5.1", "5.9")), "11:8: there is no step '5.9'");
  EXPECT_EQ(refusal(kHead + kStep + kCase + kCase), "15:8: two cases are called 'flat'");
  EXPECT_EQ(refusal(kHead + kStep + kCase + "hidden = { yaw = [3, 3] }\n"),
            "14:18: 'yaw' must be a range [least, most] of numbers, or a list of two texts or more");
}

TEST(LabFile, may_need_steps_of_this_lab_and_of_earlier_ones_but_no_later_ones) {
  const LabFile file(kHead + kStep + "needs = [\"1.3\", \"4.12\"]\n" + kCase);
  EXPECT_EQ(read_lab(file.path()).steps[0].needs, (std::vector<std::string>{"1.3", "4.12"}));
  for (const std::string need : {"5.1", "5.2", "6.1", "4", "4.", ".1", "4.1.2", "4.a", "4,1", "-4.1", "0.1"})
    EXPECT_EQ(refusal(kHead + kStep + "needs = [\"" + need + "\"]\n" + kCase),
              "9:9: there is no step '" + need + "' before this one");
}

TEST(Labs, have_the_steps_that_others_need) {
  const std::string head = "lab = \"04_cube_wrap\"\ntitle = \"Cube\"\nlesson = \"Wrap\"\n";
  const std::string text =
      "[[step]]\nid = \"4.1\"\ntitle = \"Split\"\npoints = 1\nhints = [\"Look\"]\n"
      "[[case]]\nname = \"split\"\nstep = \"4.1\"\nlimit = 0\nwhy = \"exact\"\n";
  const auto needing = [](const std::string& step) {
    return kHead + kStep + "needs = [\"" + step + "\"]\n" + kCase;
  };
  const LabFile found(needing("4.1"));
  found.add("04_cube_wrap", head + text);
  EXPECT_EQ(read_labs(found.labs()).size(), 2U);

  for (const std::string step : {"4.2", "3.1"}) {
    const LabFile file(needing(step));
    file.add("04_cube_wrap", head + text);
    try {
      read_labs(file.labs());
      ADD_FAILURE() << step << " was found";
    } catch (const Error& error) {
      EXPECT_EQ(error.exit_code(), Exit::failed);
      EXPECT_EQ(error.place().file, file.path().string());
      EXPECT_EQ(error.what(),
                file.path().string() + ": step '5.1' needs step '" + step + "', but no lab has it");
    }
  }
}

TEST(LabFile, refuses_a_case_of_the_benchmark_that_varies_nothing_or_has_a_name_twice) {
  const std::string bench = "[[bench]]\ncase = \"a\"\nteaches = \"A\"\n";
  EXPECT_EQ(refusal(kHead + bench),
            "4:1: 'vary' must be a table { parameter = [values], … }; [] stands for all values of a choice");
  EXPECT_EQ(refusal(kHead + bench + "vary = { method = \"all\" }\n"),
            "7:19: 'method' must be a list of values");
  EXPECT_EQ(refusal(kHead + bench + "vary = { a = [] }\n" + bench + "vary = { a = [] }\n"),
            "8:1: two cases are called 'a'");
}

TEST(LabFile, refuses_a_name_that_is_taken_or_no_file_name) {
  const std::string look = "[[look]]\nname = \"a\"\ncaption = \"A\"\n";
  EXPECT_EQ(refusal(kHead + look + look), "7:1: two looks are called 'a'");
  EXPECT_EQ(refusal(kHead + "[[look]]\nname = \"../a\"\ncaption = \"A\"\n"),
            "4:1: '../a' is not a valid picture name; use lower-case letters, digits, '_' and '-'");
}

TEST(LabFile, refuses_what_is_missing_or_broken) {
  EXPECT_EQ(refusal(kHead + "[[look]]\nname = \"a\"\n"), "4:1: 'caption' is missing or empty");
  EXPECT_EQ(refusal("title = \"Normal map\"\n"), "1:1: 'lab' is missing or empty");
  EXPECT_EQ(refusal("lab = \"06_cube_map\"\n"),
            "1:7: '06_cube_map' is not the name of the file's folder; rename one of them");
  EXPECT_EQ(refusal(kHead + "[[look]\n").substr(0, 2), "4:");
  EXPECT_NE(refusal(std::string("\0\xff", 2)), "it was read");
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

TEST(Labs, are_found_below_their_folder) {
  const LabFile file(kHead);
  ASSERT_EQ(read_labs(file.labs()).size(), 1U);
  EXPECT_THROW(read_labs(file.path().parent_path()), Error);
  EXPECT_THROW(read_labs("no/such/folder"), Error);
}

TEST(Labs, are_not_what_was_copied_or_left_beside_them) {
  const LabFile file(kHead);
  file.add("05_old", kHead);
  file.add("05_normal_map - Copy", kHead);
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
