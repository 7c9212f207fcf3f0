// SPDX-License-Identifier: MIT
// `./run mutants` on a tiny tree.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "../support/picture_files.hpp"
#include "../support/places.hpp"
#include "../support/process.hpp"
#include "../support/said.hpp"
#include "core/files.hpp"
#include "core/json.hpp"

namespace texel {
namespace {

using test::has;
using test::Result;

// ---- A project of one function, with a test that sees one of its two branches.

class MutantEngine : public testing::Test {
 protected:
  MutantEngine() {
    std::filesystem::create_directories(folder_ / "tree/tests/mutants");
    write("CMakeLists.txt",
          "cmake_minimum_required(VERSION 3.25)\nproject(tiny CXX)\nenable_testing()\n"
          "add_executable(clamp_test clamp.cpp)\nadd_test(NAME Clamp.keeps_small_numbers COMMAND "
          "clamp_test)\n");
    write("CMakePresets.json",
          R"({"version": 6, "configurePresets": [{"name": "release", "generator": "Ninja"}]})");
    write("clamp.cpp", kClamp);
    write("tests/mutants/clamp.toml",
          mutant("wrong-branch", "return x;", "return -x;", "Small numbers stay as they are.") +
              mutant("wrong-limit", "return 9;", "return 8;", "The limit is 9."));
  }

  static std::string mutant(const std::string& name, const std::string& what, const std::string& by,
                            const std::string& says, const std::string& rest = {}) {
    return fmt::format(
        "[[mutant]]\nname = \"{}\"\nfile = \"clamp.cpp\"\nwhat = \"{}\"\nby = \"{}\"\nsays = \"{}\"\n{}",
        name, what, by, says, rest);
  }

  void write(const std::string& file, const std::string& text) const {
    write_file(folder_ / ("tree/" + file), text);
  }

  [[nodiscard]] Result mutants(const std::string& arguments = {}) const {
    return test::shell(fmt::format("{}/teach/commands/mutants.py --root '{}' --work '{}' {}", test::kSource,
                                   (folder_ / "tree").string(), (folder_ / "work").string(), arguments));
  }

  static constexpr const char* kClamp =
      "int clamped(int x) {\n  if (x < 9) return x;\n  return 9;\n}\nint main() { return clamped(3) != 3; "
      "}\n";
  test::TemporaryFolder folder_{"mutants"};
};

TEST_F(MutantEngine, tells_what_the_tests_notice_from_what_they_do_not) {
  const std::string report = (folder_ / "report.json").string();
  const Result result = mutants("--report " + report);
  EXPECT_EQ(result.exit_code, 1) << result.errors;  // 50 % are fewer than 95
  EXPECT_TRUE(has(result.output, "caught by Clamp.keeps_small_numbers")) << result.output;
  EXPECT_TRUE(has(result.output, "SURVIVED")) << result.output;
  EXPECT_TRUE(has(result.output, "survived: wrong-limit (clamp.cpp): the catalogue gives no reason"))
      << result.output;
  EXPECT_TRUE(has(result.output, "1 of 2 caught (50 %); 0 survive for a reason")) << result.output;
  EXPECT_EQ(read_file(folder_ / "tree/clamp.cpp"), kClamp) << "only the copy is changed";
  EXPECT_EQ(read_file(folder_ / "work/tree/clamp.cpp"), kClamp) << "and changed back";
  const auto json = parse_json(read_file(report));
  EXPECT_EQ(json.at("caught"), 1);
  EXPECT_EQ(json.at("mutants"), 2);
  EXPECT_EQ(json.at("results").at(0).at("fate"), "caught");
  EXPECT_EQ(json.at("results").at(1).at("fate"), "survived");

  // One of them again, with a test that sees it: the report keeps the other's result.
  write("clamp.cpp",
        std::string(kClamp).replace(std::string(kClamp).find("!= 3"), 4, "!= 3 || clamped(10) != 9"));
  const std::string page = (folder_ / "report.md").string();
  const Result again = mutants("--only wrong-limit --report " + page);
  EXPECT_EQ(again.exit_code, 0) << again.output << again.errors;
  EXPECT_TRUE(has(again.output, "1 of 1 caught (100 %)")) << again.output;
  EXPECT_TRUE(has(read_file(page), "2 of 2 caught (100 %)")) << read_file(page);
  EXPECT_TRUE(
      has(read_file(page), "| wrong-limit | clamp.cpp | The limit is 9. | Clamp.keeps_small_numbers |"));
}

TEST_F(MutantEngine, tells_what_is_wrong_with_the_catalogue_from_what_is_caught) {
  write("tests/mutants/clamp.toml",
        mutant("no-code", "return x;", "return y;", "There is no y.") +
            mutant("not-there", "return 10;", "return 8;", "The limit is 9.") +
            mutant("known", "return 9;", "return 8;", "The limit is 9.", "survives = \"Nobody asks.\"\n"));
  const Result result = mutants();
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_TRUE(has(result.output, "BROKEN: it does not compile")) << result.output;
  EXPECT_TRUE(has(result.output, "clamp.toml: 'not-there' does not apply: its text is not in clamp.cpp"))
      << result.output;
  EXPECT_TRUE(has(result.output, "survived: known (clamp.cpp): Nobody asks.")) << result.output;
  EXPECT_TRUE(has(result.output, "0 of 1 caught (0 %); 1 survive for a reason")) << result.output;
  EXPECT_TRUE(has(result.errors, "2 mutants do not apply or do not compile")) << result.errors;
}

TEST_F(MutantEngine, says_no_where_a_mutant_is_caught_that_no_test_can_notice) {
  write("tests/mutants/clamp.toml",
        mutant("known", "return x;", "return -x;", "Small numbers stay as they are.",
               "survives = \"Nobody asks.\"\n"));
  const Result result = mutants();
  EXPECT_EQ(result.exit_code, 1) << result.errors;
  EXPECT_TRUE(has(result.output,
                  "caught by Clamp.keeps_small_numbers: known (clamp.cpp), of which the catalogue "
                  "says: Nobody asks."))
      << result.output;
}

TEST_F(MutantEngine, takes_no_test_of_the_tree_for_a_catch_and_fails_where_nothing_is_caught) {
  const std::string tests =
      "cmake_minimum_required(VERSION 3.25)\nproject(tiny CXX)\nenable_testing()\n"
      "add_executable(clamp_test clamp.cpp)\nadd_test(NAME Clamp.keeps COMMAND clamp_test)\n"
      "add_test(NAME Clamp.is_unedited COMMAND ${CMAKE_COMMAND} -E compare_files clamp.cpp "
      "${CMAKE_BINARY_DIR}/copy.cpp WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})\n"
      "if(NOT EXISTS ${CMAKE_BINARY_DIR}/copy.cpp)\n"
      "configure_file(clamp.cpp ${CMAKE_BINARY_DIR}/copy.cpp COPYONLY)\nendif()\n";
  std::string unchanged = mutant("swapped", "if (x < 9)", "if (9 > x)", "The sides are swapped.");
  unchanged.replace(0, 10, "[[equivalent]]");
  write("tests/mutants/clamp.toml",
        unchanged + mutant("wrong-branch", "return x;", "return -x;", "Small numbers stay as they are.") +
            mutant("wrong-limit", "return 9;", "return 8;", "The limit is 9."));
  write("CMakeLists.txt", tests);
  const Result failed = mutants("--only wrong-branch");
  EXPECT_EQ(failed.exit_code, 3) << failed.output;
  EXPECT_TRUE(has(failed.errors, "what changes nothing (swapped) is noticed: Clamp.is_unedited"))
      << failed.errors;

  write("CMakeLists.txt", tests + "set_tests_properties(Clamp.is_unedited PROPERTIES LABELS tree)\n");
  const std::string page = (folder_ / "report.md").string();
  const Result result = mutants("--report " + page);
  EXPECT_EQ(result.exit_code, 1) << result.output << result.errors;
  EXPECT_TRUE(has(result.output, "1 of 2 caught (50 %)")) << result.output;
  EXPECT_FALSE(has(result.output, "is_unedited")) << result.output;
  EXPECT_TRUE(has(read_file(page), "- swapped (clamp.cpp): survived")) << read_file(page);
  EXPECT_TRUE(has(read_file(page), "| Clamp.keeps | 1 | 1 |")) << read_file(page);

  // The same tree once more: nothing is made again.
  const Result resumed = mutants("--resume");
  EXPECT_FALSE(has(resumed.output, "changes that change nothing")) << resumed.output;
  EXPECT_TRUE(has(resumed.output, "(known; ")) << resumed.output;
  EXPECT_TRUE(has(resumed.output, "1 of 2 caught (50 %)")) << resumed.output;
  EXPECT_TRUE(has(mutants("--every 2").output, "1/1 wrong-branch"));
}

TEST_F(MutantEngine, asks_the_tests_of_the_lab_first_and_those_of_other_labs_not_at_all) {
  std::filesystem::create_directories(folder_ / "tree/labs/01_clamp");
  write("labs/01_clamp/clamp.cpp", kClamp);
  write(
      "CMakeLists.txt",
      "cmake_minimum_required(VERSION 3.25)\nproject(tiny CXX)\nenable_testing()\n"
      "add_executable(clamp_test labs/01_clamp/clamp.cpp)\n"
      "foreach(name any in_lab_2 in_lab_1)\nadd_test(NAME Clamp.${name} COMMAND clamp_test)\nendforeach()\n");
  const auto with = [&](const std::string& what, const std::string& by) {
    std::string text = mutant("one", what, by, "It is wrong.");
    write("tests/mutants/clamp.toml", text.replace(text.find("clamp.cpp"), 9, "labs/01_clamp/clamp.cpp"));
  };
  with("return x;", "return -x;");
  EXPECT_TRUE(has(mutants().output, "caught by Clamp.in_lab_1"));
  with("return x;", "return x;  // still right");
  EXPECT_TRUE(has(mutants().output, "SURVIVED"));
  EXPECT_FALSE(has(read_file(folder_ / "work/logs/one.log"), "Clamp.in_lab_2"));
}

TEST_F(MutantEngine, refuses_what_cannot_be_measured) {
  EXPECT_EQ(mutants("--only wrong-limits").exit_code, 2);
  EXPECT_TRUE(has(mutants("--only wrong-limits").errors, "did you mean 'wrong-limit'?"));
  EXPECT_EQ(mutants("--report report.txt").exit_code, 2);
  EXPECT_EQ(mutants("--work " + (folder_ / "tree/copy").string()).exit_code, 2);
  EXPECT_EQ(mutants("--catalogue " + (folder_ / "none").string()).exit_code, 3);
  write("clamp.cpp", "int main() { return 1; }\n");
  write("tests/mutants/clamp.toml", mutant("one", "return 1;", "return 0;", "One is not none."));
  const Result failing = mutants();
  EXPECT_EQ(failing.exit_code, 3);
  EXPECT_TRUE(has(failing.errors, "no test passes in the unchanged tree")) << failing.errors;
}

}  // namespace
}  // namespace texel
