// SPDX-License-Identifier: MIT
// Classes that make_class makes, graded by the program `texel` as a teacher runs it, for the tests of the
// grader.
#pragma once
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "../support/places.hpp"
#include "../support/process.hpp"
#include "core/files.hpp"
#include "core/json.hpp"
#include "course/lab_file.hpp"
#include "grade/grader.hpp"
#include "sandbox/sandbox.hpp"
#include "store/store.hpp"

namespace texel::test {

namespace fs = std::filesystem;

inline const fs::path kWork = fs::path(kBuild) / "grade_test";
inline const fs::path kCache = fs::path(kBuild) / "grade";
inline constexpr const char* kSeed = "a seed that no report may show";

/// The numbers of all labs, as --labs takes them.
inline std::string all_labs() {
  std::string numbers;
  for (const course::Lab& lab : course::read_labs(fs::path(kSource) / "labs"))
    numbers += fmt::format("{}{}", numbers.empty() ? "" : ",", lab.number);
  return numbers;
}

/// A class folder and what must come out of it.
struct Class {
  fs::path folder;
  std::string labs;
  Json expected;
};

inline Class make_class(const std::string& name, const std::string& labs, const std::string& rest) {
  Class made{kWork / name, labs, {}};
  const Result result =
      shell(fmt::format("{} --root {} --out {} --labs {} {} 2>&1", (fs::path(kBin) / "make_class").string(),
                        shell_word(kSource), shell_word(made.folder.string()), labs, rest));
  EXPECT_EQ(result.exit_code, 0) << result.output;
  made.expected = parse_json(read_file(kWork / (name + ".json")));
  return made;
}

/// The command that grades a class, as words for a shell.
inline std::string command(const Class& graded, const fs::path& out, const std::string& rest = {}) {
  return fmt::format("{}/texel grade {} --out {} --labs {} --cache {} --seed-file {} {}", kBin,
                     shell_word(graded.folder.string()), shell_word(out.string()), graded.labs,
                     shell_word(kCache.string()), shell_word((kWork / "seed.txt").string()), rest);
}

inline Result grade(const Class& graded, const fs::path& out, const std::string& rest = {}) {
  return shell(command(graded, out, rest) + " 2>&1");
}

inline std::string dump(const fs::path& out) {
  return store::Store(grade::store_file(out)).dump();
}

/// Every file below a folder with its bytes.
inline std::map<std::string, std::string> files_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && !entry.is_symlink())
      files[entry.path().lexically_relative(folder).string()] = read_file(entry.path());
  return files;
}

/// Holds one student's grades against what must come out; whether a mistake that has a name got it.
inline bool check_student(const store::StudentResult& student, const Json& expected) {
  SCOPED_TRACE(fmt::format("{} ({} {})", student.id, expected.at("kind").get<std::string>(),
                           expected.at("name").get<std::string>()));
  EXPECT_EQ(student.incident, "");
  EXPECT_EQ(student.fault.empty(), !expected.value("fault", false)) << student.fault;
  std::set<std::string> passed;
  bool is_named = true;
  const auto zero = expected.value("zero", std::set<std::string>());
  for (const judge::LabResult& lab : student.labs)
    for (const judge::StepResult& step : lab.steps) {
      const std::string told = fmt::format("{}: {} {}", step.id, step.score, step.message);
      if (step.status == judge::Status::passed) passed.insert(step.id);
      EXPECT_EQ(step.status == judge::Status::passed, step.score == 1) << told;
      if (zero.count(step.id) > 0) {
        EXPECT_EQ(step.score, 0) << told;
      }
      if (step.id == expected.value("untouched", "")) {
        EXPECT_TRUE(std::any_of(step.cases.begin(), step.cases.end(), [](const judge::CaseResult& one) {
          return one.status == judge::CaseStatus::untouched;
        })) << told;
      }
      if (expected.value("fails", "") != step.id) continue;
      EXPECT_LT(step.score, 1) << told;
      EXPECT_NE(step.status, judge::Status::passed) << told;
      if (!expected.contains("mistake")) continue;
      is_named = expected.at("mistake").get<std::string>() == step.mistake;
      if (!is_named)
        fmt::print("{} was called '{}'\n", expected.at("mistake").get<std::string>(), step.mistake);
    }
  if (expected.contains("passes")) {
    EXPECT_EQ(passed, expected.at("passes").get<std::set<std::string>>());
  }
  return is_named;
}

/// Holds all students of a class against what must come out.
inline void check(const fs::path& out, const Class& graded) {
  const store::ClassResult results = grade::read_results(out, kSource);
  const Json& expected = graded.expected.at("students");
  EXPECT_EQ(results.students.size(), expected.size());
  int mutants = 0, named = 0;
  for (const store::StudentResult& student : results.students) {
    ASSERT_TRUE(expected.contains(student.id)) << student.id;
    const bool is_named = check_student(student, expected.at(student.id));
    if (!expected.at(student.id).contains("mistake")) continue;
    ++mutants;
    named += is_named ? 1 : 0;
  }
  fmt::print("{} of {} mutants were named rightly\n", named, mutants);
  EXPECT_GE(named, 0.9 * mutants);
}

class GraderTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!sandbox::sandbox_fault().empty())
      GTEST_SKIP() << "bubblewrap cannot work here: " << sandbox::sandbox_fault();
  }
  static void make_work_folder() {
    fs::create_directories(kWork);
    write_file(kWork / "seed.txt", kSeed);
  }
};

}  // namespace texel::test
