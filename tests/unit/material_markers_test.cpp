// SPDX-License-Identifier: MIT
#include "course/markers.hpp"
#include "material/starter.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "../support/picture_files.hpp"
#include "../support/said.hpp"
#include "core/error.hpp"
#include "core/files.hpp"

namespace texel::course {
namespace {

namespace fs = std::filesystem;
using material::with_step_alone;
using test::error_of;
using test::replaced;
using Steps = std::set<std::string>;
using test::put;
using test::TemporaryFolder;

const std::string kText =
    "int before;\n"
    "  //@step 5.1 begin\n"
    "  return 2 * c - 1;\n"
    "  //@starter\n"
    "  // return c;  // as it is\n"
    "  //\n"
    "  //@end\n"
    "int after;\n";

bool nothing(const std::string&) {
  return false;
}

TEST(Markers, give_the_solution_or_the_starter_with_the_markers_around_it) {
  const std::string starter =
      "int before;\n  //@step 5.1 begin\n  return c;  // as it is\n\n  //@end\nint after;\n";
  EXPECT_EQ(with_steps(kText, "f.cpp", [](const std::string& step) { return step == "5.1"; }),
            "int before;\n  //@step 5.1 begin\n  return 2 * c - 1;\n  //@end\nint after;\n");
  EXPECT_EQ(with_steps(kText, "f.cpp", nothing), starter);
  EXPECT_EQ(with_steps("//@step 1.1 begin\r\na\r\n//@starter\r\n// b\r\n//@end", "f", nothing),
            "//@step 1.1 begin\r\nb\r\n//@end")
      << "carriage returns, and a last line without an end";
  for (const std::string& text : {kText, starter}) {
    const std::vector<StepPart> parts = parts_of(text);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(parts[0].step, "5.1");
    EXPECT_EQ(parts[0].line, 2);
  }
  EXPECT_EQ(step_texts(starter + "//@step 5.2 begin\n//@end\n//@step 5.1 begin\nmore\n//@end\n"),
            (std::map<std::string, std::string>{{"5.1", "  return c;  // as it is\n\nmore\n"}, {"5.2", ""}}));
}

/// Two places of one step, and one of another.
const std::string kStudents =
    "a\n//@step 5.1 begin\nmine\n//@end\nb\n//@step 5.2 begin\nother\n//@end\n//@step 5.1 begin\nmine "
    "too\n//@end\n";
const std::string kFirst =
    "a\n//@step 5.1 begin\nstub\n//@end\nb\n//@step 5.2 begin\nother\n//@end\n//@step 5.1 begin\n//@end\n";

TEST(Markers, let_one_step_be_taken_from_another_text) {
  EXPECT_EQ(with_step_from(kStudents, "f.cpp", "5.1", kFirst), kFirst);
  EXPECT_EQ(with_step_from(kFirst, "f.cpp", "5.1", kStudents), kStudents);
  EXPECT_EQ(with_step_from(kStudents, "f.cpp", "5.2", kFirst), kStudents);
  // What stands outside stays, whatever it is.
  EXPECT_EQ(with_step_from("mine\n" + kStudents, "f.cpp", "5.1", kFirst), "mine\n" + kFirst);
  // The markers must be the same.
  const std::string one_place = "//@step 5.1 begin\nmine\n//@end\n";
  for (const auto& [text, first] : {std::pair(one_place, kFirst), std::pair(kFirst, one_place)})
    for (const char* step : {"5.1", "5.3"}) EXPECT_THROW(with_step_from(text, "f.cpp", step, first), Error);
}

TEST(Markers, let_one_step_stand_among_the_solutions_others) {
  const auto text = [](const std::string& first, const std::string& second, const std::string& third) {
    return "mine\n//@step 5.1 begin\n" + first + "\n//@end\nhelper\n//@step 5.2 begin\n" + second +
           "\n//@end\n//@step 5.1 begin\n" + third + "\n//@end\n";
  };
  const std::string students = text("wrong", "own", "wrong too");
  // Of 5.2 the own part and all lines outside of markers stay; both parts of 5.1 are the solution's.
  EXPECT_EQ(with_step_alone(students, "f.cpp", "5.2", kStudents), text("mine", "own", "mine too"));
  EXPECT_EQ(with_step_alone(students, "f.cpp", "5.1", kStudents), text("wrong", "other", "wrong too"));
  // Its own markers are needed.
  for (const char* without : {"//@step 5.1 begin\nown\n//@end\n", "//@step 5.2 begin\nown\n"})
    EXPECT_THROW(with_step_alone(without, "f.cpp", "5.2", kStudents), Error);
}

/// Three steps with lines around them, as `one`, `two` and `three`.
std::string three(const std::string& one, const std::string& two, const std::string& three) {
  return fmt::format(
      "a\n//@step 1.1 begin\n{}\n//@end\nb\n//@step 1.2 begin\n{}\n//@end\nc\n//@step 1.3 "
      "begin\n{}\n//@end\nd\n",
      one, two, three);
}

const Steps kAllThree = {"1.1", "1.2", "1.3"};

TEST(Markers, are_told_from_comments_of_a_students_own) {
  const std::string solution = three("1", "2", "3"), own = three("x", "y", "z");
  for (const std::string word :
       {"//@todo", "//@{", "//@author me", "#@x", "//@starter", "//@teacher begin", "//@step one begin",
        "//@endif", "//@end of it", "//@step 1.1", "//@step 1.4 begin x"}) {
    const auto noted = [&](const std::string& text) { return word + "\n" + text + word; };
    const std::string text = noted(three(word + "\nx", "y", "z"));  // within a step too
    EXPECT_TRUE(marker_faults(text, solution, "f.cpp").empty()) << word;
    EXPECT_EQ(with_step_alone(text, "f.cpp", "1.1", solution), noted(three(word + "\nx", "2", "3")));
    EXPECT_EQ(with_step_from(text, "f.cpp", "1.1", solution), noted(three("1", "y", "z")));
    // The other sign is code to a compiler.
    EXPECT_EQ(untouched_steps(text, own) == kAllThree, word[0] == '/') << word;
  }
}

TEST(Markers, that_are_damaged_cost_their_own_step_alone) {
  const std::string solution = three("1", "2", "3"), own = three("x", "y", "z");
  const std::tuple<std::string, std::string, std::string, std::string> rows[] = {
      {"1.1", "//@step 1.1 begin", "", "f.cpp: the marker '//@step 1.1 begin' is missing"},
      {"1.2", "//@step 1.2 begin", "//@step 1,2 begin", "f.cpp: the marker '//@step 1.2 begin' is missing"},
      {"1.2", "y\n//@end", "y", "f.cpp:6: step 1.2 has no '//@end' of its own"},
      {"1.3", "z\n//@end", "z\n//@ende", "f.cpp:10: step 1.3 has no '//@end' of its own"},
      {"1.2", "//@end\nc", "//@end\n//@step 1.2 begin\n//@end\nc",
       "f.cpp: step 1.2 has its markers in 2 places"}};
  for (const auto& [damaged, what, by, says] : rows) {
    SCOPED_TRACE(says);
    const std::string text = replaced(own, what, by);
    const std::map<std::string, std::string> faults = marker_faults(text, solution, "f.cpp");
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_TRUE(faults.at(damaged).starts_with(says)) << faults.at(damaged);
    EXPECT_EQ(untouched_steps(text, own).size(), 2U);
    for (const std::string& step : kAllThree) {
      if (step == damaged) {
        EXPECT_THROW(with_step_alone(text, "f.cpp", step, solution), Error);
        EXPECT_THROW(with_step_from(text, "f.cpp", step, solution), Error);
        continue;
      }
      EXPECT_EQ(with_step_alone(text, "f.cpp", step, solution),
                three(step == "1.1" ? "x" : "1", step == "1.2" ? "y" : "2", step == "1.3" ? "z" : "3"));
      EXPECT_NO_THROW(with_step_from(text, "f.cpp", step, solution));
    }
  }
}

TEST(Markers, may_stand_in_another_order) {
  const auto text = [](char third, char first, char second) {
    return fmt::format(
        "//@step 1.3 begin\n{}\n//@end\nmine\n//@step 1.1 begin\n{}\n//@end\n//@step 1.2 begin\n{}\n//@end\n",
        third, first, second);
  };
  EXPECT_EQ(with_step_alone(text('z', 'x', 'y'), "f.cpp", "1.1", three("1", "2", "3")), text('3', 'x', '2'));
}

TEST(Markers, tell_which_steps_have_the_code_as_it_was_at_first) {
  EXPECT_EQ(untouched_steps(kStudents, kFirst), Steps{"5.2"});
  EXPECT_EQ(untouched_steps(kFirst, kFirst), (Steps{"5.1", "5.2"}));
  EXPECT_TRUE(untouched_steps("//@step 5.1 begin\nstub\n", kFirst).empty());
  const std::string first =
      replaced(three("", "return 2.0 * x;  // as it is", "it = 'c';"), "1.1 begin\n\n", "1.1 begin\n");
  std::string windows = first;
  for (std::size_t at = 0; (at = windows.find('\n', at)) != windows.npos; at += 2) windows.insert(at, "\r");
  for (const std::string& text :
       {replaced(first, "//@end", "// my plan\n\n/* x */\n//@end"),
        replaced(replaced(first, "return", "\treturn"), "2.0 *", "2.0\t*"), windows})
    EXPECT_EQ(untouched_steps(text, first), kAllThree) << text;
  EXPECT_FALSE(untouched_steps(replaced(first, "2.0", "2.5"), first).contains("1.2"));
}

TEST(Markers, that_do_not_fit_are_errors_with_their_line) {
  const std::pair<const char*, const char*> rows[] = {
      {"a\n//@end\n", "f.cpp:2: '//@end' without a 'begin' before it"},
      {"//@starter\n", "f.cpp:1: 'starter' does not follow 'begin'"},
      {"//@step 1.1 begin\n//@step 1.2 begin\n", "f.cpp:2: a step begins inside another"},
      {"\n//@step 1.1 begin\n//@starter\n", "f.cpp:2: this step has no end"},
      {"//@step 1.1 begin\na\n//@end\n", "f.cpp:3: this step has no '//@starter' part"},
      {"//@step one begin\n", "f.cpp:1: there is no marker '//@step one begin'"},
      {"  //@stepp 1.1 begin\n", "f.cpp:1: there is no marker"},
      {"text //@end in a line is no marker\n", ""}};
  for (const auto& [text, says] : rows) {
    const std::string message = error_of([&, text = text] { with_steps(text, "f.cpp", nothing); });
    EXPECT_TRUE(message.starts_with(says) && message.empty() == std::string(says).empty()) << message;
  }
}

TEST(Starter, has_no_solution_no_tests_and_no_right_answers) {
  const TemporaryFolder tree, folder;
  const fs::path out = folder / "starter";
  put(tree.path(), {{"labs/05_x/lab.cpp", kText},
                    {"labs/05_x/lab.toml", "lab = \"05_x\"\n"},
                    {"common/core/core.cpp", "for all\n"},
                    {"teach/truth/ray.cpp", "the answer\n"},
                    {"tests/unit/a_test.cpp", "a test\n"},
                    {"run", "#!/bin/sh\n"},
                    {"labs/05_x/lab.cpp.orig", kText},
                    {"labs/05_x/lab (1).cpp", kText},
                    {"labs/05_old/lab.cpp", kText},
                    {"labs/05_old/lab.toml", "lab = \"05_x\"\n"}});
  for (const char* file : {"run", "labs/05_x/lab.cpp"})
    fs::permissions(tree / file, fs::perms::owner_exec, fs::perm_options::add);
  const std::vector<material::StarterFile> files = material::starter_files(tree.path());
  material::write_files(files, out);
  EXPECT_EQ(read_file(out / "labs/05_x/lab.cpp"), with_steps(kText, "", nothing));
  EXPECT_EQ(read_file(out / "labs/05_x/lab.toml"), "lab = \"05_x\"\n");
  for (const char* file :
       {"teach", "tests", "labs/05_x/lab.cpp.orig", "labs/05_x/lab (1).cpp", "labs/05_old"})
    EXPECT_FALSE(fs::exists(out / file)) << file;
  EXPECT_EQ(step_files(tree.path()), std::vector<std::string>{"labs/05_x/lab.cpp"});
  for (const char* file : {"run", "labs/05_x/lab.cpp"})
    EXPECT_NE(fs::status(out / file).permissions() & fs::perms::owner_exec, fs::perms::none) << file;
  EXPECT_THROW(material::write_files(files, out), Error) << "over what is there";
  EXPECT_THROW(material::starter_files(tree / "nowhere"), Error);
}

TEST(Steps, of_a_students_tree_are_found_in_the_files_that_its_starter_had_as_they_are_now) {
  const std::string first = "//@step 5.1 begin\n//@end\n//@step 5.2 begin\n//@end\n";
  const TemporaryFolder tree;
  put(tree.path(), {{".starter/labs/05_x/lab.cpp", first},
                    {"labs/05_x/lab.cpp", "//@step 5.1 begin\none\ntwo\n//@end\n//@step 5.2 begin\n//@end\n"},
                    {"labs/05_x/lab.cpp.before-reset", first}});
  EXPECT_EQ(step_files(tree.path()), std::vector<std::string>{"labs/05_x/lab.cpp"});
  EXPECT_EQ(step_places(tree.path()).at("5.2").line, 5);
  write_file(tree / "labs/05_x/lab.cpp", "//@step 5.1 begin\n//@end\n");
  EXPECT_EQ(step_places(tree.path()).at("5.2").line, 3) << "without its marker: as at first";
}

TEST(Steps, of_the_courses_tree_have_places_of_its_own_and_those_of_a_starter) {
  const TemporaryFolder tree;
  put(tree.path(), {{"labs/05_x/lab.cpp",
                     "//@step 5.1 begin\nsolution\n//@starter\n// a\n// b\n//@end\n"
                     "//@step 5.2 begin\n//@starter\n//@end\n"}});
  EXPECT_EQ(step_places(tree.path()).at("5.2").line, 7);
  EXPECT_EQ(material::first_places(tree.path()).at("5.2").line, 5);
}

/// An editor that saves with other line ends or tabs, and comments alone, begin no step, in any file of the
/// course.
TEST(Steps, are_not_begun_by_line_ends_tabs_blank_lines_and_comments) {
  for (const std::string& file : step_files(".")) {
    const std::string first = with_steps(read_file(file), file, nothing);
    for (const std::string& text :
         {std::regex_replace(first, std::regex("\n"), "\r\n"),
          std::regex_replace(first, std::regex("\n +"), "\n\t"),
          std::regex_replace(first, std::regex("\n( *//@end)"), "\n\n  // it's my plan\n$1")}) {
      ASSERT_NE(text, first);
      EXPECT_EQ(untouched_steps(text, first).size(), step_texts(first).size()) << file;
    }
  }
}

using Pair = std::pair<const char*, const char*>;

TEST(SameCode, differs_in_comments_and_white_space_alone) {
  for (const auto& [a, b] : {Pair{"return color * 2.0 - 1.0;", "return color*2.0-1.0;  // from 0 … 1\n"},
                             {"a = b;\n/* it's\n two */ c = d;", "a=b; c=d;"},
                             {"#define N 3\nint n = N;", "\n#define N 3  // three\n\n  int n=N;\n"},
                             {"#include \"lib/a.glsl\"\nx;", "#include \"lib/a.glsl\"\n\nx;"},
                             {"it = '\\n';", "it = '\\n';"},
                             {"it = '\\'';\n\n", "it = '\\'';  // a quote\r\n"},
                             {"say(\"\\\" // b\");  // c", "say(\"\\\" // b\");"}})
    EXPECT_TRUE(is_same_code(a, b)) << a << "\nand\n" << b;
}

TEST(SameCode, tells_apart_what_a_compiler_does) {
  for (const auto& [a, b] : {Pair{"return color * 2.0 - 1.0;", "return color * 2.0 - 0.9;"},
                             {"int a;", "inta;"},
                             {"int/**/a;", "inta;"},
                             {"a + +b", "a ++b"},
                             {"a / *b", "a /*b"},
                             {"x = 1 .5;", "x = 1.5;"},
                             {"x = 1e -5;", "x = 1e-5;"},
                             {"x = 0x1p -5;", "x = 0x1p-5;"},
                             {"x = \"a\" s;", "x = \"a\"s;"},
                             {"x = u \"a\";", "x = u\"a\";"},
                             {"#define F (x)\n", "#define F(x)\n"},
                             {"#define N 3\n+ 4", "#define N 3 + 4\n"},
                             {"a = b; // c\nd = e;", "a = b; // c d = e;"},
                             {"// /\\\nb = c;", "b = c;"},
                             {"say(\"a  b\");", "say(\"a b\");"},
                             {"say(\"a // b\");", "say(\"a \");"},
                             {"x = u 'a';", "x = u'a';"},
                             {"it = ' ';", "it = '  ';"},
                             {"a /* b", "a"}})
    EXPECT_FALSE(is_same_code(a, b)) << a << "\nand\n" << b;
}

TEST(SameCode, needs_equal_bytes_where_more_than_a_look_is_needed) {
  for (const auto& [a, b] : {Pair{"// a \\\r\nb = c;", "b = c;"},
                             {"// a \\ \nb = c;", "b = c;"},
                             {"it = 'x' ;", "it = 'x';"},
                             {"n = 1'000 ;", "n = 1'000;"},
                             {"say(R\"(a\" // b)\");", "say(R\"(a\" // c)\");"}})
    EXPECT_FALSE(is_same_code(a, b)) << a << "\nand\n" << b;
}

}  // namespace
}  // namespace texel::course
