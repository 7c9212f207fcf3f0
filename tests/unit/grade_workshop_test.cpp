// SPDX-License-Identifier: MIT
// Programs of a tiny tree with changed files: two labs and a library, of which each lab needs one file.
#include "../../teach/grade/workshop.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "../support/picture_files.hpp"
#include "../support/said.hpp"
#include "core/files.hpp"
#include "core/process.hpp"

namespace texel::grade {
namespace {

using test::has;

std::atomic<int> compiled = 0;

/// Counts compilers. One that gets a file with "SLOW" in it takes too long.
Outcome counting(const Confines& confines, const std::vector<std::string>& command) {
  const auto file = std::find(command.begin(), command.end(), "-c");
  if (file == command.end()) return run_plainly(confines, command);
  ++compiled;
  if (!has(read_file(*(file + 1)), "SLOW")) return run_plainly(confines, command);
  Outcome stopped;
  stopped.exit_code = 137, stopped.limit = Limit::cpu, stopped.wall_seconds = 60;
  return stopped;
}

class WorkshopTest : public testing::Test {
 protected:
  WorkshopTest() : tree_{folder_ / "tree", folder_ / "tree/build", "this tree"} {
    const std::string source = tree_.source.string();
    std::string ninja =
        "rule cxx\n command = c++ -o $out -c $in\n"
        "rule link\n command = : && c++ $in -o $out.new && mv $out.new $out && :\n";
    for (const char* file : {"03_obj/a", "03_obj/b", "one", "two"})
      ninja += fmt::format("build labs/{1}.o: cxx {0}/labs/{1}.cpp\n", source, file);
    ninja +=
        "build bin/one: link labs/one.o labs/03_obj/a.o\nbuild bin/two: link labs/two.o labs/03_obj/b.o\n"
        "build bin/both: link labs/two.o labs/03_obj/a.o labs/03_obj/b.o\n";
    test::put(tree_.source, {{"labs/03_obj/a.cpp", "int a() { return 1; }\n"},
                             {"labs/03_obj/b.cpp", "int b() { return 2; }\n"},
                             {"labs/one.cpp", "int a();\nint main() { return a(); }\n"},
                             {"labs/two.cpp", "int b();\nint main() { return b(); }\n"},
                             {"build/build.ninja", ninja}});
    EXPECT_EQ(run_program({"ninja", "-C", tree_.build.string()}).exit_code, 0);
    compiled = 0;
    workshop_ = std::make_unique<Workshop>(tree_, folder_ / "cache", counting);
  }
  static int exit_code(const Program& program) { return run_program({program.file.string()}).exit_code; }
  static std::string refused(const Program& program) {
    std::string files;
    for (const store::CompilerLog& log : program.refused) files += log.file + " ";
    return files;
  }

  test::TemporaryFolder folder_;
  BuiltTree tree_;
  std::unique_ptr<Workshop> workshop_;
};

TEST_F(WorkshopTest, puts_changed_files_in_place_of_the_trees) {
  const Program one = workshop_->make("one", {{"labs/03_obj/a.cpp", "int a() { return 5; }\n"}});
  EXPECT_EQ(refused(one), "");
  EXPECT_EQ(exit_code(one), 5);
  EXPECT_EQ(exit_code(workshop_->make("one", {})), 1);
}

TEST_F(WorkshopTest, lets_a_file_that_does_not_link_cost_only_what_links_it) {
  const std::map<std::string, std::string> files = {
      {"labs/03_obj/a.cpp", "int missing();\nint unlinked = missing();\nint a() { return 5; }\n"},
      {"labs/one.cpp", "int a();\nint main() { return 10 + a(); }\n"},
      {"labs/two.cpp", "int b();\nint main() { return 20 + b(); }\n"}};
  const Program one = workshop_->make("one", files), two = workshop_->make("two", files);
  EXPECT_EQ(refused(one), "labs/03_obj/a.cpp ");
  EXPECT_TRUE(has(one.refused[0].text, "missing"));
  EXPECT_EQ(exit_code(one), 11) << "the lab's own file is the student's, a.cpp is the tree's";
  EXPECT_EQ(refused(two), "");
  EXPECT_EQ(exit_code(two), 22);
}

TEST_F(WorkshopTest, compiles_a_file_once_for_all_labs_and_remembers_where_the_compiler_was_stopped) {
  for (const char* text : {"int a() { return 6; }\n", "int a() { return 7; }  // SLOW\n"}) {
    compiled = 0;
    std::vector<std::thread> labs;
    for (const char* lab : {"one", "both", "one", "both"})
      labs.emplace_back([&, lab] { workshop_->make(lab, {{"labs/03_obj/a.cpp", text}}); });
    for (std::thread& lab : labs) lab.join();
    EXPECT_EQ(compiled, 1) << text;
  }
  const Program slow = workshop_->make("one", {{"labs/03_obj/a.cpp", "int a() { return 7; }  // SLOW\n"}});
  ASSERT_EQ(refused(slow), "labs/03_obj/a.cpp ");
  EXPECT_TRUE(has(slow.refused[0].text, "used too much processor time"));
}

TEST_F(WorkshopTest, compiles_nothing_more_when_the_time_is_used_up) {
  TimeBudget budget(60);
  EXPECT_EQ(refused(workshop_->make("one", {{"labs/03_obj/a.cpp", "// SLOW\n"}}, &budget)),
            "labs/03_obj/a.cpp ");
  EXPECT_EQ(budget.load(), 0);
  const Program late = workshop_->make("one", {{"labs/03_obj/a.cpp", "int a() { return 8; }\n"}}, &budget);
  ASSERT_EQ(refused(late), "labs/03_obj/a.cpp ");
  EXPECT_TRUE(has(late.refused[0].text, "used up its time"));
  EXPECT_EQ(compiled, 1);
}

}  // namespace
}  // namespace texel::grade
