// SPDX-License-Identifier: MIT
// Whole classes, graded by the program `texel` as a teacher runs it. make_class says what must come out.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <thread>

#include "../support/places.hpp"
#include "../support/process.hpp"
#include "../support/said.hpp"
#include "check/files.hpp"
#include "core/files.hpp"
#include "core/json.hpp"
#include "course/lab_file.hpp"
#include "grade/grader.hpp"
#include "graded_class.hpp"
#include "judge/plan.hpp"
#include "sandbox/sandbox.hpp"
#include "store/store.hpp"

namespace texel {
namespace {

namespace fs = std::filesystem;
using test::all_labs;
using test::check;
using test::Class;
using test::command;
using test::dump;
using test::files_in;
using test::grade;
using test::GraderTest;
using test::has;
using test::kCache;
using test::kSeed;
using test::kWork;
using test::make_class;
using test::Result;
using test::shell;
using test::shell_word;

const fs::path kBin = test::kBin, kSource = test::kSource;

/// The lines of a dump by their student, without the facts; those that speak of one lab, or all.
std::map<std::string, std::string> by_student(const std::string& dump, const std::string& lab = {}) {
  std::map<std::string, std::string> rows;
  std::istringstream lines(dump);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("facts\t") || !(lab.empty() || has(line, "\t" + lab + "\t"))) continue;
    const std::size_t begin = line.find('\t') + 1;
    rows[line.substr(begin, line.find('\t', begin) - begin)] += line + "\n";
  }
  return rows;
}

/// RFC 4180.
std::vector<std::vector<std::string>> read_csv(const std::string& text) {
  std::vector<std::vector<std::string>> rows(1, {""});
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"' && quoted && i + 1 < text.size() && text[i + 1] == '"')
      rows.back().back() += text[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      rows.back().emplace_back();
    else if (c == '\n' && !quoted)
      rows.push_back({""});
    else if (c != '\r' || quoted)
      rows.back().back() += c;
  }
  rows.pop_back();
  return rows;
}

/// That nothing of what the threats tried is to be seen.
void check_harmless(const fs::path& out, const Class& hostile,
                    const std::map<std::string, std::string>& before) {
  EXPECT_TRUE(files_in(hostile.folder) == before) << "submissions were changed";
  for (const fs::path& folder :
       {fs::path("/"), fs::path("/tmp"), kSource, hostile.folder, out, fs::current_path()})
    EXPECT_FALSE(fs::exists(folder / "texel_threat_was_here")) << folder;
  EXPECT_FALSE(has(dump(out), kSeed));
  for (const auto& [name, text] : files_in(out / "report")) {
    EXPECT_FALSE(has(text, "<script>texel_threat") || has(text, "<img src=x")) << name;
    EXPECT_FALSE(has(text, kSeed)) << name;
  }
  for (const auto& row : read_csv(read_file(out / "class.csv")))
    for (const std::string& cell : row)
      EXPECT_TRUE(cell.empty() || std::string("=+@").find(cell[0]) == std::string::npos) << cell;
}

/// Grades, is killed after each of the times (in seconds), and is taken up again until it ends.
void grade_with_kills(const Class& graded, const fs::path& out, const std::vector<double>& moments) {
  for (const double moment : moments) {
    const std::string line = "exec " + command(graded, out, "--resume") + " >/dev/null 2>&1";
    const pid_t grader = ::fork();
    if (grader == 0) {
      ::execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
      ::_exit(127);
    }
    std::this_thread::sleep_for(std::chrono::duration<double>(moment));
    ::kill(grader, SIGKILL);
    ::waitpid(grader, nullptr, 0);
  }
  const Result last = grade(graded, out, "--resume --format csv");
  EXPECT_EQ(last.exit_code, 0) << last.output;
}

/// That two folders hold the same grades, pictures and reports of the class.
void expect_same(const fs::path& a, const fs::path& b) {
  EXPECT_EQ(dump(a), dump(b));
  EXPECT_EQ(read_file(a / "class.csv"), read_file(b / "class.csv"));
  EXPECT_TRUE(files_in(a / "pictures") == files_in(b / "pictures"));
}

/// Builds what the others share, by grading somebody who handed in nothing.
class Starter : public GraderTest {};

TEST_F(Starter, is_built_and_an_empty_submission_scores_nothing) {
  fs::remove_all(kWork);
  make_work_folder();
  Class empty{kWork / "empty", all_labs(), {}};
  fs::create_directories(empty.folder / "nobody");
  const Result result = grade(empty, kWork / "empty_out");
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const store::ClassResult results = grade::read_results(kWork / "empty_out", kSource);
  ASSERT_EQ(results.students.size(), 1U);
  EXPECT_EQ(results.students[0].points(), 0);
  EXPECT_GT(results.students[0].max_points(), 0);
}

/// Two labs: one of C++, one of GLSL; and a few students on one lab for what does not depend on the labs.
class GradedClass : public GraderTest {
 protected:
  static void SetUpTestSuite() {
    if (!sandbox::sandbox_fault().empty()) return;
    make_work_folder();
    for (const char* name : {"two_labs", "few", "hostile", "shaders", "egl", "disk"})
      for (const char* ending : {"", ".json", "_out"}) fs::remove_all(kWork / (std::string(name) + ending));
    two_labs_ = make_class("two_labs", "7,9", "--kinds solution,starter,prefix,mutant,equivalent --limit 3");
    graded_ = grade(two_labs_, kWork / "two_labs_out");
    few_ = make_class("few", "9", "--kinds solution,starter,prefix,mutant --limit 1");
    const auto begin = std::chrono::steady_clock::now();
    graded_few_ = grade(few_, kWork / "few_out", "--format csv,gradescope,prairielearn,junit");
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }

  /// A folder for one test's results.
  static fs::path fresh(const std::string& name) {
    fs::remove_all(kWork / name);
    return kWork / name;
  }

  static Class two_labs_, few_;
  static Result graded_, graded_few_;
  static double seconds_;  ///< that grading the few takes
};

Class GradedClass::two_labs_, GradedClass::few_;
Result GradedClass::graded_, GradedClass::graded_few_;
double GradedClass::seconds_ = 0;

TEST_F(GradedClass, gives_everybody_what_they_earned) {
  ASSERT_EQ(graded_.exit_code, 0) << graded_.output;
  check(kWork / "two_labs_out", two_labs_);
}

/// On OSMesa, which `auto` prefers, the two labs are graded above.
TEST_F(GradedClass, is_graded_alike_on_egl) {
  const Class solutions = make_class("egl", "7,9", "--kinds solution,starter");
  const Result result = grade(solutions, fresh("egl_out"), "--context egl");
  ASSERT_EQ(result.exit_code, 0) << result.output;
  check(kWork / "egl_out", solutions);
}

/// Most threats are programs, of lab 7.
TEST_F(GradedClass, is_not_touched_by_threats) {
  const Class hostile =
      make_class("hostile", "7", "--kinds solution,starter,mutant,threat,files,broken --limit 3");
  const auto before = files_in(hostile.folder);
  const fs::path out = kWork / "hostile_out";
  const Result result = grade(hostile, out, "--format csv,junit");
  ASSERT_EQ(result.exit_code, 0) << result.output;
  check(out, hostile);
  check_harmless(out, hostile, before);
  const auto rows = by_student(dump(kWork / "two_labs_out"), "07_environment");
  std::size_t compared = 0;
  for (const auto& [student, lines] : by_student(dump(out), "07_environment"))
    if (const auto same = rows.find(student); same != rows.end()) {
      EXPECT_EQ(same->second, lines);
      ++compared;
    }
  EXPECT_GE(compared, 5U);  // solutions and starters
}

TEST_F(GradedClass, gives_nothing_to_shaders_that_cheat) {
  const Class shaders = make_class("shaders", "9", "--kinds threat");
  const Result result = grade(shaders, fresh("shaders_out"));
  ASSERT_EQ(result.exit_code, 0) << result.output;
  check(kWork / "shaders_out", shaders);
}

TEST_F(GradedClass, is_the_same_after_sudden_ends) {
  ASSERT_EQ(graded_few_.exit_code, 0) << graded_few_.output;
  const fs::path out = fresh("killed_out");
  grade_with_kills(few_, out, {0.3 * seconds_, 0.5 * seconds_, 0.6 * seconds_});
  expect_same(out, kWork / "few_out");
}

TEST_F(GradedClass, is_the_same_from_two_shards) {
  const fs::path first = fresh("shard_1_out"), second = fresh("shard_2_out"), merged = fresh("merged_out");
  for (const auto& [out, shard] : {std::pair(first, "1/2"), std::pair(second, "2/2")}) {
    const Result result = grade(few_, out, std::string("--shard ") + shard);
    ASSERT_EQ(result.exit_code, 0) << result.output;
  }
  const Result result = shell(fmt::format("{}/texel grade merge {} {} --out {} --format csv 2>&1",
                                          kBin.string(), first.string(), second.string(), merged.string()));
  ASSERT_EQ(result.exit_code, 0) << result.output;
  expect_same(merged, kWork / "few_out");
}

/// A small disk of its own for the results, in which half the class is graded. Then it is full, and then it
/// cannot be written: each time a run must fail and say why. At last all is well, and a run must end.
TEST_F(GradedClass, survives_a_disk_that_is_full_or_cannot_be_written) {
  if (::geteuid() != 0 || shell("unshare -m true").exit_code != 0)
    GTEST_SKIP() << "needs to mount a disk, as root";
  const fs::path disk = kWork / "disk", kept = kWork / "disk_kept", half = kWork / "disk_half";
  for (const fs::path& folder : {disk, kept, half}) {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  const auto line = [&](const char* rest) { return command(few_, disk, rest); };
  const std::string script = fmt::format(
      "d={0}; mount -t tmpfs -o size=64m,mode=755 tmpfs $d && {1} >/dev/null 2>&1; echo first $?\n"
      "head -c $(($(df -B1 --output=avail $d | tail -1) - 700000)) /dev/zero >$d/filler; {2}; echo full $?\n"
      "rm $d/filler; mount -o remount,ro $d; {2}; echo closed $?\n"
      "mount -o remount,rw $d; cp -p $d/results.sqlite* {3}\n"
      "{4} >/dev/null 2>&1; echo last $?; cp -r $d/. {5}",
      disk.string(), line("--shard 1/2"), line("--resume"), half.string(), line("--resume --format csv"),
      kept.string());
  const Result result = shell(fmt::format("unshare -m sh -c {} 2>&1", shell_word(script)));
  for (const char* text : {"first 0\n", "full 3\n", "closed 3\n", "last 0\n", "texel: ", "the disk is full",
                           "ead-only file system"})
    EXPECT_TRUE(has(result.output, text)) << text << " is not in " << result.output;
  // What was there stayed, and in the end nothing is missing.
  const auto whole = by_student(dump(kWork / "few_out")), rows = by_student(dump(half));
  EXPECT_GE(rows.size(), whole.size() / 2);
  int intact = 0;
  for (const auto& [student, lines] : rows) intact += whole.at(student) == lines ? 1 : 0;
  EXPECT_GE(intact, static_cast<int>(whole.size() / 2));
  expect_same(kept, kWork / "few_out");
}

/// The results as a run leaves them that was cut off: one student done, one in the middle, the others not
/// begun.
TEST_F(GradedClass, says_that_a_run_is_not_finished) {
  ASSERT_EQ(graded_few_.exit_code, 0) << graded_few_.output;
  const fs::path cut = fresh("cut_out"), joined = fresh("cut_joined");
  fs::create_directories(cut);
  const store::ClassResult whole = grade::read_results(kWork / "few_out", kSource);
  ASSERT_GE(whole.students.size(), 3U);
  {
    store::Store store(grade::store_file(cut));
    store.put_facts(store::Store(grade::store_file(kWork / "few_out")).facts());
    for (const store::StudentResult& student : whole.students) store.expect_student(student);
    for (std::size_t i = 0; i < 2; ++i) {
      store.put_student(whole.students[i], "digest");
      for (const judge::LabResult& lab : whole.students[i].labs)
        for (const judge::StepResult& step : lab.steps)
          for (const judge::CaseResult& one : step.cases)
            if (i == 0 || &one != &step.cases.back()) store.put(whole.students[i].id, one);
    }
  }
  const std::string texel = (kBin / "texel").string(), to = shell_word(cut.string());
  for (const std::string& line :
       {texel + " grade report " + to + " --format csv,gradescope",
        texel + " grade merge " + to + " --out " + shell_word(joined.string()) + " --format csv"}) {
    const Result result = shell(line + " 2>&1");
    EXPECT_EQ(result.exit_code, 3) << result.output;
    EXPECT_TRUE(has(result.output, fmt::format("not finished: {} students", whole.students.size() - 1)))
        << result.output;
    EXPECT_EQ(shell(line + " --unfinished 2>&1").exit_code, 0);
  }
  for (const fs::path& folder : {cut, joined}) {
    const auto rows = read_csv(read_file(folder / "class.csv"));
    ASSERT_EQ(rows.size(), whole.students.size() + 1);
    EXPECT_NE(rows[1][3], "");
    for (std::size_t i = 2; i < rows.size(); ++i) EXPECT_EQ(rows[i][3], "") << rows[i][1];
  }
  EXPECT_TRUE(fs::exists(cut / "gradescope" / whole.students[0].id / "results.json"));
  EXPECT_FALSE(fs::exists(cut / "gradescope" / whole.students[1].id / "results.json"));
}

TEST_F(GradedClass, has_reports_in_every_format) {
  ASSERT_EQ(graded_few_.exit_code, 0) << graded_few_.output;
  const fs::path out = kWork / "few_out";
  const auto rows = read_csv(read_file(out / "class.csv"));
  EXPECT_EQ(rows.size(), few_.expected.at("students").size() + 1);
  for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
  for (const auto& [id, expected] : few_.expected.at("students").items()) {
    EXPECT_TRUE(parse_json(read_file(out / "gradescope" / id / "results.json")).contains("tests")) << id;
    EXPECT_TRUE(parse_json(read_file(out / "prairielearn" / id / "results.json")).contains("score")) << id;
    EXPECT_TRUE(read_file(out / "junit" / (id + ".xml")).starts_with("<?xml")) << id;
    EXPECT_TRUE(has(read_file(out / "report" / (id + ".html")), "</html>")) << id;
  }
  EXPECT_TRUE(has(read_file(out / "report/index.html"), "</html>"));
}

/// The guide tells students to hand in the whole folder. What they did not change is not worth a line.
TEST_F(GradedClass, tells_a_student_who_packs_the_whole_folder_only_what_is_theirs) {
  Class whole{kWork / "whole", "9", {}};
  fs::remove_all(whole.folder);
  fs::create_directories(whole.folder);
  const fs::path tree = fresh("whole_tree") / "my-labs";
  const std::string texel = (kBin / "texel").string(), pack = "cmake -E tar cf ../../whole/";
  ASSERT_EQ(shell(fmt::format("{} starter --out {}", texel, tree.string())).exit_code, 0);
  for (const char* path :
       {"build/release/build.ninja", "out/gallery/index.html", ".git/HEAD", "labs/.DS_Store",
        "__MACOSX/._labs", ".before-update-2/run", "labs/05_normal_map/lab.cpp.before-reset-2"}) {
    fs::create_directories((tree / path).parent_path());
    write_file(tree / path, "made there");
  }
  const auto packed = [&](const std::string& line) {
    const Result result = shell(fmt::format("cd {} && {} 2>&1", tree.string(), line));
    EXPECT_EQ(result.exit_code, 0) << result.output;
  };
  packed(pack + "inside.zip --format=zip -- . ");
  packed("cd .. && cmake -E tar cfz ../whole/around.tar.gz my-labs");
  write_file(tree / "common/core/include/core/error.hpp", "#pragma once\n");
  write_file(tree / "notes.txt", "mine");
  packed("cp -r . ../../whole/changed");
  const Result result = grade(whole, fresh("whole_out"));
  ASSERT_EQ(result.exit_code, 0) << result.output;
  for (const store::StudentResult& student : grade::read_results(kWork / "whole_out", kSource).students) {
    std::set<std::string> told;
    for (const store::Ignored& one : student.ignored) told.insert(one.path);
    EXPECT_EQ(student.fault, "");
    EXPECT_EQ(told, student.id == "changed"
                        ? std::set<std::string>({"common/core/include/core/error.hpp", "notes.txt"})
                        : std::set<std::string>())
        << student.id;
  }
}

TEST_F(GradedClass, is_found_again_by_a_second_run_that_judges_nothing) {
  const Result again = grade(few_, kWork / "few_out", "--resume --format csv");
  EXPECT_EQ(again.exit_code, 0) << again.output;
  EXPECT_TRUE(has(again.output, ": 0 cases in ")) << again.output;
}

/// The same over all labs, with every mutant, equivalent and threat there is.
class WholeCourse : public GraderTest {
 protected:
  void SetUp() override {
    GraderTest::SetUp();
    if (std::getenv("TEXEL_TEST_ALL") == nullptr) GTEST_SKIP() << "takes hours: TEXEL_TEST_ALL=1 runs it";
    make_work_folder();
  }
  static Class made(const std::string& name, const std::string& rest) {
    for (const char* ending : {"", ".json", "_out"}) fs::remove_all(kWork / (name + ending));
    return make_class(name, all_labs(), rest);
  }
};

TEST_F(WholeCourse, has_a_starter_that_keeps_its_promises) {
  const Result result = shell(
      fmt::format("{}/texel starter --verify --cache {} 2>&1", kBin.string(), shell_word(kCache.string())));
  EXPECT_EQ(result.exit_code, 0) << result.output;
}

TEST_F(WholeCourse, is_graded_rightly_for_every_wrong_and_every_right_solution) {
  const Class all = made("all", "--kinds solution,starter,prefix,mutant,equivalent");
  const Result result = grade(all, kWork / "all_out");
  ASSERT_EQ(result.exit_code, 0) << result.output;
  check(kWork / "all_out", all);
}

TEST_F(WholeCourse, is_not_touched_by_threats) {
  const Class hostile = made(
      "all_hostile", "--kinds solution,starter,prefix,mutant,equivalent,threat,slow,files,broken --limit 8");
  const auto before = files_in(hostile.folder);
  const fs::path out = kWork / "all_hostile_out";
  const Result result = grade(hostile, out, "--format csv,gradescope,prairielearn,junit");
  ASSERT_EQ(result.exit_code, 0) << result.output;
  check(out, hostile);
  check_harmless(out, hostile, before);
  ASSERT_TRUE(fs::exists(kWork / "all_out")) << "the test before this one grades the class without threats";
  const auto rows = by_student(dump(kWork / "all_out"));
  int compared = 0;
  for (const auto& [student, lines] : by_student(dump(out)))
    if (const auto same = rows.find(student); same != rows.end()) {
      EXPECT_EQ(same->second, lines);
      ++compared;
    }
  EXPECT_GE(compared, 3 + 2 + 3 * 8);
}

TEST_F(WholeCourse, is_the_same_after_twenty_sudden_ends_and_from_four_shards) {
  const Class some = made("some", "--kinds solution,starter,prefix,mutant,equivalent --limit 5");
  const fs::path whole = kWork / "some_out", killed = kWork / "some_killed", merged = kWork / "some_merged";
  for (const fs::path& folder : {whole, killed, merged}) fs::remove_all(folder);
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(grade(some, whole, "--format csv").exit_code, 0);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::mt19937 random(std::random_device{}());
  std::vector<double> moments;
  for (int i = 0; i < 20; ++i) moments.push_back(std::uniform_real_distribution(0.5, 0.15 * seconds)(random));
  grade_with_kills(some, killed, moments);
  expect_same(killed, whole);

  if (shell("parallel --version").exit_code != 0) GTEST_SKIP() << "GNU parallel is missing";
  const std::string shards = (kWork / "some_shard").string();
  shell("rm -rf " + shards + "_*");
  const Result parallel =
      shell(fmt::format("parallel -j 2 {} ::: 1 2 3 4 2>&1",
                        shell_word(command(some, shards + "_{}", "--jobs 1 --shard {}/4"))));
  ASSERT_EQ(parallel.exit_code, 0) << parallel.output;
  const Result result =
      shell(fmt::format("{0}/texel grade merge {1}_1 {1}_2 {1}_3 {1}_4 --out {2} --format csv 2>&1",
                        kBin.string(), shards, merged.string()));
  ASSERT_EQ(result.exit_code, 0) << result.output;
  expect_same(merged, whole);
}

}  // namespace
}  // namespace texel
