// SPDX-License-Identifier: MIT
#include "course/markers.hpp"
#include "material/starter.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "core/error.hpp"
#include "core/files.hpp"

namespace texel::course {
namespace {

namespace fs = std::filesystem;

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

/// What is wrong, with the line.
std::string fault_of(const std::string& text) {
  try {
    with_steps(text, "f.cpp", nothing);
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

TEST(Markers, give_the_solution_or_the_starter_with_the_markers_around_it) {
  EXPECT_EQ(with_steps(kText, "f.cpp", [](const std::string& step) { return step == "5.1"; }),
            "int before;\n  //@step 5.1 begin\n  return 2 * c - 1;\n  //@end\nint after;\n");
  EXPECT_EQ(with_steps(kText, "f.cpp", nothing),
            "int before;\n  //@step 5.1 begin\n  return c;  // as it is\n\n  //@end\nint after;\n");
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
}

TEST(Markers, must_be_the_same_where_a_step_is_taken_from_another_text) {
  const std::string one_place = "//@step 5.1 begin\nmine\n//@end\n";
  for (const auto& [text, first] : {std::pair(one_place, kFirst), std::pair(kFirst, one_place)}) {
    EXPECT_THROW(with_step_from(text, "f.cpp", "5.1", first), Error);
    EXPECT_THROW(with_step_from(text, "f.cpp", "5.3", first), Error);
  }
}

TEST(Markers, let_one_step_stand_among_the_solutions_others) {
  const std::string students =
      "mine\n//@step 5.1 begin\nwrong\n//@end\nhelper\n//@step 5.2 begin\nown\n//@end\n"
      "//@step 5.1 begin\nwrong too\n//@end\n";
  // Of 5.2 the own part and all lines outside of markers stay; both parts of 5.1 are the solution's.
  EXPECT_EQ(with_step_alone(students, "f.cpp", "5.2", kStudents),
            "mine\n//@step 5.1 begin\nmine\n//@end\nhelper\n//@step 5.2 begin\nown\n//@end\n"
            "//@step 5.1 begin\nmine too\n//@end\n");
  EXPECT_EQ(with_step_alone(students, "f.cpp", "5.1", kStudents),
            "mine\n//@step 5.1 begin\nwrong\n//@end\nhelper\n//@step 5.2 begin\nother\n//@end\n"
            "//@step 5.1 begin\nwrong too\n//@end\n");
  // Only its own markers are needed.
  EXPECT_THROW(with_step_alone("//@step 5.1 begin\nown\n//@end\n", "f.cpp", "5.2", kStudents), Error);
  EXPECT_THROW(with_step_alone("//@step 5.2 begin\nown\n", "f.cpp", "5.2", kStudents), Error);
}

/// Three steps with lines around them, as `one`, `two` and `three`.
std::string three(const std::string& one, const std::string& two, const std::string& three) {
  return fmt::format(
      "a\n//@step 1.1 begin\n{}\n//@end\nb\n//@step 1.2 begin\n{}\n//@end\nc\n//@step 1.3 "
      "begin\n{}\n//@end\nd\n",
      one, two, three);
}

std::string changed(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

TEST(Markers, that_are_damaged_cost_their_own_step_alone) {
  const std::string solution = three("1", "2", "3"), own = three("x", "y", "z");
  const std::vector<std::string> steps = {"1.1", "1.2", "1.3"};
  // A comment of the student's own is no marker, also within a step.
  for (const char* word :
       {"//@todo", "//@{", "//@author me", "#@x", "//@starter", "//@teacher begin", "//@step one begin",
        "//@endif", "//@end of it", "//@step 1.1", "//@step 1.4 begin x"}) {
    const std::string noted = word + ("\n" + three(std::string(word) + "\nx", "y", "z")) + word;
    EXPECT_TRUE(marker_faults(noted, solution, "f.cpp").empty()) << word;
    EXPECT_EQ(with_step_alone(noted, "f.cpp", "1.1", solution),
              word + ("\n" + three(std::string(word) + "\nx", "2", "3")) + word);
    EXPECT_EQ(with_step_from(noted, "f.cpp", "1.1", solution), word + ("\n" + three("1", "y", "z")) + word);
    // The other sign is code to a compiler.
    if (word[0] == '/') {
      EXPECT_EQ(untouched_steps(noted, own), (std::set<std::string>{"1.1", "1.2", "1.3"})) << word;
    }
  }
  struct Damage {
    std::string step, what, by, says;
  };
  for (const Damage& damage : std::vector<Damage>{
           {"1.1", "//@step 1.1 begin", "", "f.cpp: the marker '//@step 1.1 begin' is missing"},
           {"1.2", "//@step 1.2 begin", "//@step 1,2 begin",
            "f.cpp: the marker '//@step 1.2 begin' is missing"},
           {"1.2", "y\n//@end", "y", "f.cpp:6: step 1.2 has no '//@end' of its own"},
           {"1.3", "z\n//@end", "z\n//@ende", "f.cpp:10: step 1.3 has no '//@end' of its own"},
           {"1.2", "//@end\nc", "//@end\n//@step 1.2 begin\n//@end\nc",
            "f.cpp: step 1.2 has its markers in 2 places"}}) {
    SCOPED_TRACE(damage.says);
    const std::string text = changed(own, damage.what, damage.by);
    const std::map<std::string, std::string> faults = marker_faults(text, solution, "f.cpp");
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_TRUE(faults.at(damage.step).starts_with(damage.says)) << faults.at(damage.step);
    EXPECT_EQ(untouched_steps(text, own).size(), 2U);
    for (const std::string& step : steps) {
      if (step == damage.step) {
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
  const std::string solution = three("1", "2", "3");
  const std::string own = "//@step 1.3 begin\nz\n//@end\nmine\n//@step 1.1 begin\nx\n//@end\n";
  const std::string last = "//@step 1.2 begin\ny\n//@end\n";
  EXPECT_EQ(
      with_step_alone(own + last, "f.cpp", "1.1", solution),
      "//@step 1.3 begin\n3\n//@end\nmine\n//@step 1.1 begin\nx\n//@end\n//@step 1.2 begin\n2\n//@end\n");
}

TEST(Markers, tell_which_steps_are_untouched) {
  EXPECT_EQ(untouched_steps(kStudents, kFirst), std::set<std::string>{"5.2"});
  EXPECT_EQ(untouched_steps(kFirst, kFirst), (std::set<std::string>{"5.1", "5.2"}));
  EXPECT_TRUE(untouched_steps("//@step 5.1 begin\nstub\n", kFirst).empty());
}

TEST(Markers, tell_that_nobody_began_the_same_code) {
  const std::string first =
      changed(three("", "return 2.0 * x;  // as it is", "it = 'c';"), "1.1 begin\n\n", "1.1 begin\n");
  const std::string commented = changed(first, "//@end", "// my plan\n\n/* x */\n//@end");
  const std::string tabs = changed(changed(first, "return", "\treturn"), "2.0 *", "2.0\t*");
  std::string windows = first;
  for (std::size_t at = 0; (at = windows.find('\n', at)) != windows.npos; at += 2) windows.insert(at, "\r");
  for (const std::string& text : {commented, tabs, windows})
    EXPECT_EQ(untouched_steps(text, first), (std::set<std::string>{"1.1", "1.2", "1.3"})) << text;
  EXPECT_FALSE(untouched_steps(changed(first, "2.0", "2.5"), first).contains("1.2"));
}

TEST(Markers, are_found_with_their_lines_in_solution_and_starter) {
  for (const std::string& text : {kText, with_steps(kText, "f.cpp", nothing)}) {
    const std::vector<Marker> markers = markers_of(text, "f.cpp");
    ASSERT_EQ(markers.size(), 1U);
    EXPECT_EQ(markers[0].step, "5.1");
    EXPECT_EQ(markers[0].line, 2);
  }
}

TEST(Markers, have_a_text_between_them_for_each_step) {
  const std::string text =
      with_steps(kText, "f.cpp", nothing) + "//@step 5.2 begin\n//@end\n//@step 5.1 begin\nmore\n//@end\n";
  const std::map<std::string, std::string> texts = step_texts(text);
  EXPECT_EQ(texts,
            (std::map<std::string, std::string>{{"5.1", "  return c;  // as it is\n\nmore\n"}, {"5.2", ""}}));
}

TEST(Markers, survive_carriage_returns_and_a_last_line_without_an_end) {
  EXPECT_EQ(with_steps("//@step 1.1 begin\r\na\r\n//@starter\r\n// b\r\n//@end", "f", nothing),
            "//@step 1.1 begin\r\nb\r\n//@end");
}

TEST(Markers, that_do_not_fit_are_errors_with_their_line) {
  EXPECT_TRUE(fault_of("a\n//@end\n").starts_with("f.cpp:2: '//@end' without a 'begin' before it"))
      << fault_of("a\n//@end\n");
  EXPECT_TRUE(fault_of("//@starter\n").starts_with("f.cpp:1: 'starter' does not follow 'begin'"));
  EXPECT_TRUE(fault_of("//@step 1.1 begin\n//@step 1.2 begin\n")
                  .starts_with("f.cpp:2: a step begins inside another"));
  EXPECT_TRUE(fault_of("\n//@step 1.1 begin\n//@starter\n").starts_with("f.cpp:2: this step has no end"));
  EXPECT_TRUE(
      fault_of("//@step 1.1 begin\na\n//@end\n").starts_with("f.cpp:3: this step has no '//@starter' part"));
  EXPECT_TRUE(fault_of("//@step one begin\n").starts_with("f.cpp:1: there is no marker '//@step one begin'"));
  EXPECT_TRUE(fault_of("  //@stepp 1.1 begin\n").starts_with("f.cpp:1: there is no marker"));
  EXPECT_EQ(fault_of("text //@end in a line is no marker\n"), "none");
}

class Folder {
 public:
  Folder() { fs::remove_all(path_); }
  ~Folder() { fs::remove_all(path_); }
  fs::path operator/(const std::string& name) const { return path_ / name; }

 private:
  fs::path path_ = fs::temp_directory_path() / ("texel_markers_" + std::to_string(::getpid()));
};

void put(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  write_file(file, text);
}

TEST(Starter, has_no_solution_no_tests_and_no_right_answers) {
  const Folder folder;
  put(folder / "tree/labs/05_x/lab.cpp", kText);
  put(folder / "tree/labs/05_x/lab.toml", "lab = \"05_x\"\n");
  put(folder / "tree/common/core/core.cpp", "for all\n");
  put(folder / "tree/teach/truth/ray.cpp", "the answer\n");
  put(folder / "tree/tests/unit/a_test.cpp", "a test\n");
  put(folder / "tree/run", "#!/bin/sh\n");
  for (const char* copy : {"labs/05_x/lab.cpp.orig", "labs/05_x/lab (1).cpp", "labs/05_old/lab.cpp"})
    put(folder / "tree" / copy, kText);
  put(folder / "tree/labs/05_old/lab.toml", "lab = \"05_x\"\n");
  for (const char* file : {"run", "labs/05_x/lab.cpp"})
    fs::permissions(folder / "tree" / file, fs::perms::owner_exec, fs::perm_options::add);
  const std::vector<material::StarterFile> files = material::starter_files(folder / "tree");
  material::write_files(files, folder / "out");
  EXPECT_EQ(read_file(folder / "out/labs/05_x/lab.cpp"), with_steps(kText, "", nothing));
  EXPECT_EQ(read_file(folder / "out/labs/05_x/lab.toml"), "lab = \"05_x\"\n");
  EXPECT_FALSE(fs::exists(folder / "out/teach"));
  EXPECT_FALSE(fs::exists(folder / "out/tests"));
  for (const char* copy : {"labs/05_x/lab.cpp.orig", "labs/05_x/lab (1).cpp", "labs/05_old"})
    EXPECT_FALSE(fs::exists(folder / "out" / copy)) << copy;
  EXPECT_EQ(step_files(folder / "tree"), std::vector<std::string>{"labs/05_x/lab.cpp"});
  for (const char* file : {"run", "labs/05_x/lab.cpp"})
    EXPECT_NE(fs::status(folder / "out" / file).permissions() & fs::perms::owner_exec, fs::perms::none)
        << file;
  EXPECT_THROW(material::write_files(files, folder / "out"), Error) << "over what is there";
  EXPECT_THROW(material::starter_files(folder / "nowhere"), Error);
}

TEST(StepPlaces, are_those_of_the_file_as_it_is_now) {
  const Folder folder;
  const std::string first = "//@step 5.1 begin\n//@end\n//@step 5.2 begin\n//@end\n";
  put(folder / "tree/.starter/labs/05_x/lab.cpp", first);
  put(folder / "tree/labs/05_x/lab.cpp", "//@step 5.1 begin\none\ntwo\n//@end\n//@step 5.2 begin\n//@end\n");
  EXPECT_EQ(step_places(folder / "tree").at("5.2").line, 5);
  put(folder / "tree/labs/05_x/lab.cpp", "//@step 5.1 begin\n//@end\n");
  EXPECT_EQ(step_places(folder / "tree").at("5.2").line, 3) << "without its marker: as at first";
}

TEST(StepPlaces, of_the_courses_tree_are_its_own_and_first_places_those_of_a_starter) {
  const Folder folder;
  put(folder / "tree/labs/05_x/lab.cpp",
      "//@step 5.1 begin\nsolution\n//@starter\n// a\n// b\n//@end\n//@step 5.2 begin\n//@starter\n//@end\n");
  EXPECT_EQ(step_places(folder / "tree").at("5.2").line, 7);
  EXPECT_EQ(first_places(folder / "tree").at("5.2").line, 5);
}

TEST(StepFiles, of_a_students_tree_are_those_that_its_starter_had) {
  const Folder folder;
  const std::string text = "//@step 5.1 begin\n//@end\n";
  for (const char* file :
       {".starter/labs/05_x/lab.cpp", "labs/05_x/lab.cpp", "labs/05_x/lab.cpp.before-reset"})
    put(folder / "tree" / file, text);
  EXPECT_EQ(step_files(folder / "tree"), std::vector<std::string>{"labs/05_x/lab.cpp"});
}

}  // namespace
}  // namespace texel::course
