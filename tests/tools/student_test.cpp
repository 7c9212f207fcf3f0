// SPDX-License-Identifier: MIT
// The student's way through a tree: check, watch, hint, reset, progress, in a starter whose programs are the
// course's (so that its C++ steps are solved and its shaders are not), and in the course's own tree.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <thread>

#include "../support/picture_files.hpp"
#include "../support/places.hpp"
#include "../support/process.hpp"
#include "../support/said.hpp"
#include "check/check.hpp"
#include "core/files.hpp"
#include "core/json.hpp"
#include "course/lab_file.hpp"
#include "course/markers.hpp"
#include "image/load.hpp"
#include "material/mutant_file.hpp"
#include "student/report.hpp"

namespace texel {
namespace {

namespace fs = std::filesystem;
using test::has;
using test::Result;
using test::shell;
using test::shell_word;

const fs::path kRoot = test::kSource;
const std::string kTexel = fmt::format("{}/texel", test::kBin);

Result in_course(const std::string& arguments) {
  return shell(kTexel + " " + arguments + " 2>&1");
}

/// A tree as students get it, once for all tests; each works on labs of its own.
class StudentTree : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new test::TemporaryFolder("student");
    root_ = fs::absolute(*folder_ / "tree");
    const Result made = in_course("starter --out " + shell_word(root_.string()));
    ASSERT_EQ(made.exit_code, 0) << made.output;
  }
  static void TearDownTestSuite() { delete folder_; }

  static std::string line(const std::string& arguments) {
    return fmt::format("TEXEL_ROOT={} {} {}", shell_word(root_.string()), kTexel, arguments);
  }
  static Result texel(const std::string& arguments) { return shell(line(arguments) + " 2>&1"); }

  /// The steps of a lab by id, as --json has them.
  static std::map<std::string, Json> steps(int lab) {
    const Json result = parse_json(shell(line(fmt::format("check {} --json", lab))).output);
    std::map<std::string, Json> steps;
    for (const Json& step : result.at("steps")) steps[step.at("id")] = step;
    return steps;
  }

  /// Puts the course's solution of a step into the student's file.
  static void solve(const std::string& file, const std::string& step) {
    const std::string solution =
        course::with_steps(read_file(kRoot / file), file, [](const auto&) { return true; });
    write_file(root_ / file, course::with_step_from(read_file(root_ / file), file, step, solution));
  }

  static test::TemporaryFolder* folder_;
  static fs::path root_;
};

test::TemporaryFolder* StudentTree::folder_ = nullptr;
fs::path StudentTree::root_;

TEST(CourseTree, passes_its_own_checks) {
  const Result result = shell(kTexel + " check --json");
  EXPECT_EQ(result.exit_code, 0) << result.output;
  std::set<int> labs;
  for (const Json& lab : parse_json(result.output)) {
    labs.insert(std::stoi(lab.at("lab").get<std::string>()));
    for (const Json& step : lab.at("steps")) EXPECT_EQ(step.at("status"), "passed") << to_text(step, 1);
  }
  EXPECT_EQ(labs.size(), course::read_labs(kRoot / "labs").size());
}

TEST(CourseTree, has_its_catalogue_in_the_samples_of_mistakes) {
  // ./run expected renews them.
  std::map<std::string, material::Mutant> catalogue;
  for (const material::Mutant& mutant : material::read_mistakes(kRoot)) catalogue[mutant.name] = mutant;
  for (const course::Lab& lab : course::read_labs(kRoot / "labs")) {
    const Json mistakes = parse_json(read_file(kRoot / "labs" / lab.folder / "expected/mistakes.json"));
    EXPECT_GE(mistakes.size(), 6U) << lab.folder;
    for (const Json& mistake : mistakes) {
      SCOPED_TRACE(mistake.at("name"));
      ASSERT_TRUE(catalogue.contains(mistake.at("name")));
      const material::Mutant& mutant = catalogue[mistake.at("name")];
      EXPECT_EQ(mistake.at("step"), mutant.step);
      EXPECT_EQ(mistake.at("says"), mutant.says);
      for (const auto& one : mistake.at("cases").items())
        EXPECT_TRUE(std::any_of(lab.cases.begin(), lab.cases.end(), [&](const course::GradedCase& graded) {
          return graded.name == one.key() && graded.step == mutant.step;
        })) << one.key();
    }
  }
}

TEST(CourseTree, does_not_let_its_solutions_be_reset) {
  const std::string before = read_file(kRoot / "shaders/05_normal_map/decode_normal.glsl");
  const Result result = in_course("reset 5.1");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(has(result.output, "texel starter --out DIR")) << result.output;
  EXPECT_EQ(read_file(kRoot / "shaders/05_normal_map/decode_normal.glsl"), before);
}

TEST_F(StudentTree, has_no_solution_no_truth_and_no_test) {
  for (const char* folder : {"tests", "teach", "docs/accuracy"})
    EXPECT_FALSE(fs::exists(root_ / folder)) << folder;
  for (const char* given :
       {"labs/05_normal_map/README.md", "docs/student.md", "docs/pictures/05_normal_map.png",
        "docs/pictures/steps/5.1.png", "labs/05_normal_map/expected/decode_bumps.pfm", "run"})
    EXPECT_TRUE(fs::exists(root_ / given)) << given;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kRoot / "labs")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string file = entry.path().lexically_relative(kRoot).string();
    for (const auto& [step, text] : course::step_texts(
             course::with_steps(read_file(entry.path()), file, [](const auto&) { return true; })))
      EXPECT_FALSE(has(read_file(root_ / file), text)) << file << " " << step;
  }
}

TEST_F(StudentTree, is_checked_step_by_step) {
  auto found = steps(9);
  ASSERT_TRUE(found.contains("9.1"));
  EXPECT_EQ(found["9.1"].at("status"), "skipped");  // 6.1 is not done
  EXPECT_TRUE(has(found["9.1"].at("message"), "6.1")) << found["9.1"];

  found = steps(6);
  EXPECT_EQ(found["6.1"].at("status"), "failed");
  EXPECT_TRUE(
      found["6.1"].at("message").get<std::string>().starts_with("This step is still as the starter has it. "))
      << found["6.1"];
  EXPECT_GT(found["6.1"].at("error").get<double>(), found["6.1"].at("limit").get<double>());
  EXPECT_FALSE(found["6.1"].at("unit").get<std::string>().empty());

  const std::string where = found["6.1"].at("file");
  solve(where, "6.1");
  found = steps(6);
  EXPECT_EQ(found["6.1"].at("status"), "passed") << found["6.1"];
  EXPECT_LE(found["6.1"].at("error").get<double>(), found["6.1"].at("limit").get<double>());
  EXPECT_EQ(steps(9)["9.1"].at("status"), "failed");
}

TEST_F(StudentTree, names_a_mistake_that_it_knows) {
  solve("shaders/05_normal_map/decode_normal.glsl", "5.1");
  const std::vector<material::Mutant> mutants = material::read_catalogue(kRoot / "tests/mutants");
  const auto mutant = std::find_if(mutants.begin(), mutants.end(), [](const material::Mutant& one) {
    return one.name == "normal-green-flipped";
  });
  ASSERT_NE(mutant, mutants.end());
  if (!has(read_file(root_ / mutant->file), mutant->what)) GTEST_SKIP() << "a tree of ./run mutants";
  write_file(root_ / mutant->file, material::mutated(*mutant, read_file(root_ / mutant->file)));
  const Json step = steps(5)["5.1"];
  EXPECT_EQ(step.at("status"), "failed");
  EXPECT_EQ(step.at("looks_like"), mutant->name) << step;
  EXPECT_EQ(step.at("looks_like_says"), mutant->says);
  const Result report = texel("check 5");
  EXPECT_EQ(report.exit_code, 1);
  // Git's other line endings make no other renderer of the one that is named.
  const fs::path renderer = root_ / "labs/05_normal_map/expected/renderer.txt";
  const std::string name = read_file(renderer);
  write_file(renderer, name.substr(0, name.find('\n')) + "\r\n");
  EXPECT_EQ(texel("check 5").output, report.output);
  EXPECT_TRUE(has(report.output, "This looks like: ")) << report.output;
  EXPECT_TRUE(has(report.output, "wrong  5.1")) << report.output;
  EXPECT_TRUE(has(report.output, "rawn by ")) << report.output;  // "Drawn by llvmpipe", or "… are drawn by …"
  EXPECT_TRUE(has(report.output, "shaders/05_normal_map/decode_normal.glsl:")) << report.output;
}

/// Of labs 5 and 9; ./run expected counts those of all labs, C++ too.
TEST_F(StudentTree, names_nine_of_ten_mistakes_in_shaders) {
  const auto solved = [](const std::string& text, const std::string& file) {
    return course::with_steps(text, file, [](const auto&) { return true; });
  };
  for (const char* folder : {"05_normal_map", "09_bump", "lib"})
    for (const fs::directory_entry& entry : fs::directory_iterator(kRoot / "shaders" / folder)) {
      const std::string file = entry.path().lexically_relative(kRoot).string();
      write_file(root_ / file, solved(read_file(entry.path()), file));
    }
  int count = 0, named = 0;
  for (const material::Mutant& mutant : material::read_catalogue(kRoot / "tests/mutants")) {
    if (mutant.step.empty() || !mutant.file.starts_with("shaders/")) continue;
    const int lab = std::stoi(mutant.step);
    if (lab != 5 && lab != 9) continue;
    const std::string text = read_file(kRoot / mutant.file);
    if (!has(text, mutant.what))
      continue;  // as in a tree of ./run mutants; catalogue_test finds it elsewhere
    write_file(root_ / mutant.file, solved(material::mutated(mutant, text), mutant.file));
    const Json step = steps(lab)[mutant.step];
    write_file(root_ / mutant.file, solved(text, mutant.file));
    if (step.at("status") == "passed") continue;  // seen in hidden cases alone
    ++count;
    if (step.at("looks_like") == mutant.name)
      ++named;
    else
      fmt::print("{} was called '{}'\n", mutant.name, step.at("looks_like").get<std::string>());
  }
  EXPECT_GT(count, 15);
  EXPECT_GE(named, 0.9 * count);
}

/// The window shows a case's picture when it likes: by then another tree of the same build may be checked.
TEST_F(StudentTree, keeps_its_pictures_when_another_tree_is_checked) {
  const std::string picture = steps(9).at("9.4").at("cases").at(0).at("picture");
  const std::string before = read_file(picture);
  EXPECT_EQ(in_course("check 9").exit_code, 0);
  EXPECT_EQ(read_file(picture), before);
}

TEST_F(StudentTree, shows_a_step_beside_the_expected_picture) {
  const fs::path file = root_ / "out/see/6.2.png";
  const Result result = texel("see 6.2");
  ASSERT_EQ(result.exit_code, 0) << result.output;
  EXPECT_TRUE(has(result.output, file.string())) << result.output;
  const image::Image8 wrong = image::load8(file, 3);
  // Three squares with gaps between them. Expected and difference are no pictures of one colour.
  ASSERT_EQ(wrong.width, 3 * wrong.height + 2 * 6);
  const auto part = [](const image::Image8& whole, int number) {
    std::set<int> values;
    std::string bytes;
    for (int y = 0; y < whole.height; ++y)
      for (int x = 0; x < whole.height; ++x) {
        const int value = whole.at(number * (whole.height + 6) + x, y, 1);
        values.insert(value);
        bytes += static_cast<char>(value);
      }
    return std::pair(bytes, values);
  };
  EXPECT_NE(part(wrong, 0).first, part(wrong, 1).first);
  EXPECT_GT(part(wrong, 1).second.size(), 10U);
  EXPECT_GT(*part(wrong, 2).second.rbegin(), 200);

  // In the course's own tree nothing differs, or what renderers differ by: 1 step of 3, with a scale to 15.
  const fs::path solved = *folder_ / "solved.png";
  EXPECT_EQ(in_course("see 6.2 --out " + shell_word(solved.string())).exit_code, 0);
  const image::Image8 right = image::load8(solved, 3);
  EXPECT_EQ(part(right, 1).first, part(wrong, 1).first);
  EXPECT_LT(*part(right, 2).second.rbegin(), 30);

  EXPECT_EQ(texel("see 6.9").exit_code, 2);
  const Result vertices = texel("see 4.1");
  EXPECT_EQ(vertices.exit_code, 0);
  EXPECT_TRUE(has(vertices.output, "./run lab 4")) << vertices.output;
}

TEST_F(StudentTree, fits_eighty_columns) {
  for (const char* command : {"check 6", "see 6.2", "hint 6.2", "progress"}) {
    std::istringstream lines(texel(command).output);
    for (std::string line; std::getline(lines, line);)
      EXPECT_TRUE(line.size() <= 80 || has(line, root_.string())) << line;  // a path is not cut
  }
}

TEST_F(StudentTree, says_where_a_shader_does_not_compile) {
  const fs::path file = root_ / "shaders/05_normal_map/decode_normal.glsl";
  const std::string before = read_file(file);
  write_file(file, before + "vec3 broken( {\n");
  const Result report = texel("check 5"), see = texel("see 5.1");
  write_file(file, before);
  EXPECT_EQ(report.exit_code, 1);
  EXPECT_TRUE(has(report.output, "shaders/05_normal_map/decode_normal.glsl:")) << report.output;
  const std::size_t first = report.output.find("error: ");
  EXPECT_NE(first, report.output.npos) << report.output;
  EXPECT_EQ(report.output.find("error: ", first + 1), report.output.npos) << report.output;  // said once
  EXPECT_FALSE(has(report.output, "see it:")) << report.output;  // there is no picture
  EXPECT_FALSE(has(report.output, "decode_bumps")) << "it concerns all cases: " << report.output;
  EXPECT_EQ(see.exit_code, 3) << see.output;
  EXPECT_TRUE(has(see.output, "error: ")) << see.output;
}

TEST(Report, says_once_why_several_steps_wait) {
  judge::LabResult lab;
  for (const char* id : {"7.1", "7.2", "7.3", "7.4"}) {
    judge::StepResult step;
    step.id = step.title = id;
    step.cases.emplace_back();
    if (!lab.steps.empty()) step.status = judge::Status::skipped, step.message = "because";
    lab.steps.push_back(step);
  }
  lab.steps.back().message = "for another reason";
  const std::string text = tools::report(lab, false);
  EXPECT_TRUE(has(text, "7.2: because")) << text;
  EXPECT_EQ(text.find("because"), text.rfind("because")) << text;
  EXPECT_TRUE(has(text, "7.4: for another reason")) << text;
}

TEST_F(StudentTree, names_the_form_of_a_command_before_it_builds) {
  for (const auto& [typed, said] : {std::pair("watch", "./run watch 1"),
                                    {"reset 1", "./run reset 5.1"},
                                    {"check 1.3", "./run see 1.3"}}) {
    const Result result = shell(shell_word((root_ / "run").string()) + " " + typed + " 2>&1");
    EXPECT_EQ(result.exit_code, 2) << result.output;
    EXPECT_TRUE(has(result.output, said)) << result.output;
  }
}

/// ./run in a tree whose build does what a test says.
class StudentBuild : public StudentTree {
 protected:
  StudentBuild() {
    fs::create_directories(build_ / "bin");
    for (const char* program : {"texel", "lab05_normal_map"})
      fs::create_symlink(fmt::format("{}/{}", test::kBin, program), build_ / "bin" / program);
    is_configured_for(root_);
  }
  ~StudentBuild() override { fs::remove_all(root_ / "build"); }
  void is_configured_for(const fs::path& tree) const {
    write_file(build_ / "CMakeCache.txt", "CMAKE_HOME_DIRECTORY:INTERNAL=" + tree.string() + "\n");
  }
  /// What it prints; `before` is a line of shell in the same folder.
  [[nodiscard]] Result run(const std::string& ninja, const std::string& arguments,
                           const std::string& before = ":") const {
    write_file(build_ / "build.ninja", "rule r\n command = $does\n" + ninja);
    return shell(fmt::format("cd {0} && {1} && TEXEL_NO_APT=1 TEXEL_ROOT={0} ./run {2} 2>&1",
                             shell_word(root_.string()), before, arguments));
  }

  const fs::path build_ = root_ / "build/release";
  const std::string kAllBuilt =
      "build texel: phony\nbuild lab05_normal_map: phony\nbuild labs/all: phony\nbuild tools/all: phony\n";
};

TEST_F(StudentBuild, says_why_it_fails) {
  for (const auto& [ninja, said] : std::vector<std::pair<std::string, std::string>>{
           {"build texel: r\n does = exit 1\n", "does not say why: exit 1"},
           {"build texel: r\n does = echo cc1plus is killed; exit 1\n", "cc1plus is killed"},
           {"build texel: r " + (root_ / "gone.cpp").string() + "\n",
            "'gone.cpp', needed by 'texel', missing"},
           {"build texel: r gone.cpp\n", "type: ./run build"},
           {"build other: phony\n", "unknown target"},
           // Of two errors one is shown.
           {"build texel: phony x y\nbuild x: r\n does = echo error: e; exit 1\nbuild y: r\n does = echo "
            "error: e; exit 1\n",
            "error: e"}}) {
    const Result result = run(ninja + "build lab05_normal_map: phony\n", "check 5");
    EXPECT_EQ(result.exit_code, 3) << result.output;
    EXPECT_TRUE(has(result.output, said)) << result.output;
    EXPECT_EQ(has(result.output, "does not say why"), has(said, "does not say why")) << result.output;
  }
  fs::remove_all(root_ / "build");
  write_file(root_ / "build", "");  // no folder can be made there
  const Result result = shell(shell_word((root_ / "run").string()) + " check 5 2>&1");
  EXPECT_EQ(result.exit_code, 3) << result.output;
  EXPECT_TRUE(has(result.output, "cannot write build/release/build.lock")) << result.output;
}

TEST_F(StudentBuild, is_made_anew_in_a_tree_that_was_copied) {
  is_configured_for(root_.parent_path());
  write_file(root_ / "build/cmake", "#!/bin/sh\necho \"asked $*\"\nexit 1\n");
  fs::permissions(root_ / "build/cmake", fs::perms::owner_all);
  const Result result = run(kAllBuilt, "check 5", "export PATH=$PWD/build:$PATH");
  EXPECT_EQ(result.exit_code, 3) << result.output;
  EXPECT_TRUE(has(result.output, "asked --fresh --preset release")) << result.output;
}

TEST_F(StudentBuild, waits_for_another_and_says_for_whom) {
  // The other one builds until ./run says that it waits.
  const std::string other =
      "(flock build/release/build.lock sh -c 'printf \"the window of lab 5\" >build/release/build.lock; "
      "touch build/held; "
      "for i in $(seq 600); do grep -qs waiting build/said && break; sleep 0.05; done; touch build/done' &) "
      "&& "
      "while [ ! -e build/held ]; do sleep 0.05; done && exec >build/said";
  const Result result =
      run("build texel: r\n does = ls ../../build/done\nbuild lab05_normal_map: phony\n", "check 5", other);
  EXPECT_LE(result.exit_code, 1);
  const std::string said = read_file(root_ / "build/said");
  EXPECT_TRUE(has(said, "waiting for another build: the window of lab 5")) << said;
  EXPECT_TRUE(has(said, "Lab 5: ")) << said;
}

TEST_F(StudentBuild, takes_no_copy_for_a_lab) {
  fs::create_directories(root_ / "labs/10_mine");
  fs::copy(root_ / "labs/05_normal_map", root_ / "labs/05_a_copy");
  const Result fifth = run("build texel: phony\nbuild lab05_normal_map: phony\n", "check 5"),
               tenth = run(kAllBuilt, "check 10"), progress = run(kAllBuilt, "progress");
  fs::remove_all(root_ / "labs/10_mine");
  fs::remove_all(root_ / "labs/05_a_copy");
  EXPECT_TRUE(has(fifth.output, "labs/05_a_copy is a copy of this lab")) << fifth.output;
  EXPECT_EQ(tenth.exit_code, 2) << tenth.output;
  EXPECT_TRUE(has(tenth.output, "there is no lab 10")) << tenth.output;
  EXPECT_EQ(progress.exit_code, 0) << progress.output;
  EXPECT_TRUE(has(progress.output, "labs/05_a_copy is a copy of lab 5")) << progress.output;
}

TEST_F(StudentBuild, gives_a_picture_where_the_display_is_gone) {
  for (const char* gone : {"export DISPLAY=:997", "unset DISPLAY && export WAYLAND_DISPLAY=wayland-997"}) {
    fs::remove(root_ / "out/see/5.1.png");
    const Result result = run(kAllBuilt, "see 5.1", gone);
    EXPECT_EQ(result.exit_code, 0) << result.output;
    EXPECT_TRUE(has(result.output, "cannot open a window")) << result.output;
    EXPECT_FALSE(has(result.output, "--snapshot")) << result.output;
    EXPECT_TRUE(fs::exists(root_ / "out/see/5.1.png"));
  }
  const Result named = run(kAllBuilt, "see 5.1 --out here.png");
  EXPECT_EQ(named.exit_code, 0) << named.output;
  EXPECT_TRUE(fs::remove(root_ / "here.png"));
}

TEST_F(StudentTree, gives_one_hint_after_the_other) {
  const fs::path shown = fs::path(test::kBuild) / "check/hints.json";
  fs::remove(shown);
  const Result first = texel("hint 2.2"), second = texel("hint 2.2");
  EXPECT_EQ(first.exit_code, 0) << first.output;
  EXPECT_TRUE(has(first.output, "hint 1 of ") && !has(first.output, "hint 2 of ")) << first.output;
  EXPECT_TRUE(has(second.output, "hint 1 of ") && has(second.output, "hint 2 of ")) << second.output;
  write_file(shown, "{ broken");
  EXPECT_TRUE(has(texel("hint 2.2").output, "hint 1 of "));
  const Result unknown = texel("hint 5.99");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_TRUE(has(unknown.output, "5.99")) << unknown.output;
  EXPECT_EQ(texel("hint five").exit_code, 2);
}

TEST_F(StudentTree, takes_a_step_back_and_keeps_what_was_written) {
  const auto found = steps(9);
  const fs::path file = root_ / found.at("9.2").at("file").get<std::string>();
  const std::string relative = file.lexically_relative(root_).string();
  const std::string first = read_file(file);
  EXPECT_TRUE(has(texel("reset 9.2").output, "already has its starting code"));
  solve(relative, "9.2");
  const std::string own = read_file(file);
  ASSERT_NE(own, first);
  const Result reset = texel("reset 9.2");
  EXPECT_EQ(reset.exit_code, 0) << reset.output;
  EXPECT_EQ(read_file(file), first);
  EXPECT_EQ(read_file(file.string() + ".before-reset"), own);
  // A second time, nothing is written over.
  write_file(file, own);
  EXPECT_EQ(texel("reset 9.2").exit_code, 0);
  EXPECT_EQ(read_file(file.string() + ".before-reset-2"), own);
  // What is kept beside the file is no other step: what is written now is a mistake, and not "Not begun".
  std::string wrong = own;
  wrong.insert(wrong.find('\n', wrong.find("//@step 9.2 begin")) + 1, "  // a new attempt\n");
  write_file(file, wrong);
  const auto untouched = check::untouched_steps({root_, root_ / "build"});
  EXPECT_FALSE(untouched.contains("9.2"));
  write_file(file, first);
  EXPECT_TRUE(check::untouched_steps({root_, root_ / "build"}).contains("9.2"));
}

/// An editor that saves with other line ends or tabs, and comments alone, begin no step, in any file of the
/// course.
TEST_F(StudentTree, is_not_begun_by_line_ends_tabs_blank_lines_and_comments) {
  for (const std::string& file : course::step_files(root_)) {
    const std::string first = read_file(root_ / course::kFirstTexts / file);
    const std::regex end("\n");
    for (const std::string& text :
         {std::regex_replace(first, end, "\r\n"), std::regex_replace(first, std::regex("\n +"), "\n\t"),
          std::regex_replace(first, std::regex("\n( *//@end)"), "\n\n  // it's my plan\n$1")}) {
      ASSERT_NE(text, first);
      EXPECT_EQ(course::untouched_steps(text, first).size(), course::step_texts(first).size()) << file;
    }
  }
}

TEST_F(StudentTree, says_what_is_wrong_with_spoilt_markers_and_missing_pictures) {
  const fs::path file = root_ / steps(9).at("9.2").at("file").get<std::string>();
  const std::string before = read_file(file);
  std::string spoilt = before;
  spoilt.erase(spoilt.rfind("//@end"), 6);
  write_file(file, spoilt);
  const Result check = texel("check 9"), reset = texel("reset 9.2");
  // Without its first marker nobody knows where the step is.
  std::string lost = "//@todo\n" + before;
  lost.erase(lost.find("//@step 9.2 begin"), 17);
  write_file(file, lost);
  const Result gone = texel("check 9"), progress = texel("progress"), other = texel("reset 9.1");
  fs::rename(file, file.string() + ".old");
  const Result renamed = texel("check 1");
  fs::remove(file.string() + ".old");
  write_file(file, before);
  EXPECT_EQ(renamed.exit_code, 3) << renamed.output;
  EXPECT_TRUE(has(renamed.output, "is missing; it has steps")) << renamed.output;
  // The step is judged all the same, as the others are.
  for (const Result& result : {check, gone}) {
    EXPECT_LE(result.exit_code, 1) << result.output;
    EXPECT_TRUE(has(result.output, "  9.3")) << result.output;
  }
  EXPECT_TRUE(has(gone.output, "'//@step 9.2 begin' is missing")) << gone.output;
  EXPECT_EQ(progress.exit_code, 0) << progress.output;
  EXPECT_EQ(other.exit_code, 0) << other.output;
  EXPECT_EQ(reset.exit_code, 3) << reset.output;
  for (const Result& result : {check, reset}) {
    EXPECT_TRUE(has(result.output, "step 9.2 has no '//@end'")) << result.output;
    EXPECT_TRUE(has(result.output, ".glsl:")) << result.output;
  }
  const fs::path expected = root_ / "labs/07_environment/expected";
  fs::rename(expected, expected.string() + "-away");
  const Result missing = texel("check 7");
  fs::rename(expected.string() + "-away", expected);
  EXPECT_EQ(missing.exit_code, 3);
  EXPECT_TRUE(has(missing.output, "expected pictures")) << missing.output;
  EXPECT_EQ(texel("check 12").exit_code, 2);
}

TEST_F(StudentTree, shows_the_progress_in_all_labs) {
  const Result result = texel("progress");
  EXPECT_EQ(result.exit_code, 0) << result.output;
  for (const course::Lab& lab : course::read_labs(kRoot / "labs"))
    EXPECT_TRUE(has(result.output, fmt::format("{}  {}", lab.number, lab.title))) << result.output;
  EXPECT_TRUE(has(result.output, "next: ")) << result.output;
}

/// `texel watch`, which runs until it is told to end.
class Watching {
 public:
  explicit Watching(const std::string& line, const fs::path& output) : output_(output) {
    const std::string command = "exec env " + line + " >" + shell_word(output.string()) + " 2>&1 </dev/null";
    process_ = ::fork();
    if (process_ == 0) {
      ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      ::_exit(127);
    }
  }
  /// Waits until the output has the text so many times, wherever its lines end; false after a minute.
  [[nodiscard]] bool shows(const std::string& text, std::size_t times = 1) const {
    for (int i = 0; i < 600; ++i) {
      std::string all = fs::exists(output_) ? read_file(output_) : "";
      if (text.find("  ") == text.npos) all = std::regex_replace(all, std::regex("\\s+"), " ");
      std::size_t count = 0;
      for (std::size_t at = 0; (at = all.find(text, at)) != all.npos; ++at) ++count;
      if (count >= times) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return false;
  }
  /// Ends it as Ctrl+C does; its exit code.
  int end() const {
    ::kill(process_, SIGINT);
    int status = 0;
    ::waitpid(process_, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  fs::path output_;
  pid_t process_ = 0;
};

TEST_F(StudentTree, is_checked_again_after_each_save) {
  const fs::path output = root_ / "watch.txt";
  const fs::path file = root_ / steps(8).at("8.1").at("file").get<std::string>();
  const Watching watching(line("watch 8"), output);
  ASSERT_TRUE(watching.shows("next   8.1")) << read_file(output);
  solve(file.lexically_relative(root_).string(), "8.1");
  EXPECT_TRUE(watching.shows("done   8.1")) << read_file(output);
  solve(file.lexically_relative(root_).string(), "8.2");
  EXPECT_TRUE(watching.shows("done   8.2")) << read_file(output);
  const std::string before = read_file(file);
  // What passed is remembered: the step that changed is wrong, and not the one that it spoils.
  std::string wrong = before;
  const std::size_t sign = wrong.find("incident - 2.0 *");
  ASSERT_NE(sign, wrong.npos);
  write_file(file, wrong.replace(sign, 10, "incident +"));
  EXPECT_TRUE(watching.shows("Your last save changed 8.1; this step passed before it.")) << read_file(output);
  EXPECT_TRUE(watching.shows("wrong  8.1")) << read_file(output);
  write_file(file, before);
  EXPECT_TRUE(watching.shows("done   8.2", 2)) << read_file(output);
  // A marker that is gone is said, and the watch goes on.
  std::string spoilt = before;
  spoilt.erase(spoilt.rfind("//@end"), 6);
  write_file(file, spoilt);
  EXPECT_TRUE(watching.shows("has no '//@end' of its own")) << read_file(output);
  write_file(file, before);
  EXPECT_TRUE(watching.shows("done   8.2", 3)) << read_file(output);
  EXPECT_EQ(watching.end(), 0);
}

}  // namespace
}  // namespace texel
