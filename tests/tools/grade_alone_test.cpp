// SPDX-License-Identifier: MIT
// Steps that are judged among the solution's others: one mistake costs one step, and the solution stays
// secret.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "../support/said.hpp"
#include "core/files.hpp"
#include "course/markers.hpp"
#include "graded_class.hpp"

namespace texel::test {
namespace {

class JudgedAlone : public GraderTest {
 protected:
  static void SetUpTestSuite() { make_work_folder(); }
  static void forget(const std::string& name) {
    for (const char* ending : {"", ".json", "_out"}) fs::remove_all(kWork / (name + ending));
  }
};

/// A course's file with these steps solved, as a student has it.
std::string students(const std::string& file, const std::set<std::string>& solved) {
  return course::with_steps(read_file(fs::path(kSource) / file), file,
                            [&](const std::string& step) { return solved.contains(step); });
}

void replace(std::string& text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  ASSERT_NE(at, text.npos) << what;
  text.replace(at, what.size(), by);
}

/// Puts a text before the part of a step, and another one behind it.
void surround(std::string& text, const std::string& step, const std::string& before,
              const std::string& behind) {
  const std::size_t begin = text.rfind('\n', text.find("//@step " + step + " begin")) + 1;
  text.insert(begin, before + "\n");
  const std::size_t end = text.find('\n', text.find("//@end", begin)) + 1;
  text.insert(end, behind + "\n");
}

const judge::StepResult& step_of(const store::StudentResult& student, std::string_view id) {
  for (const judge::LabResult& lab : student.labs)
    for (const judge::StepResult& step : lab.steps)
      if (step.id == id) return step;
  throw std::out_of_range(std::string(id));
}

/// About 40 wrong solutions, and as many right ones written in other ways. Labs that share files with steps
/// are graded together. Measured: 2 minutes on one processor.
TEST_F(JudgedAlone, costs_each_mistake_one_step_and_right_ones_none) {
  std::size_t wrong = 0, right = 0;
  for (const char* labs : {"1", "2", "3,4,5", "6,9", "7", "8"}) {
    const std::string name = fmt::format("mistakes_{}", labs[0]);
    forget(name);
    const Class made = make_class(name, labs, "--kinds mistake,equivalent --limit 7");
    const fs::path out = kWork / (name + "_out");
    const Result result = grade(made, out);
    ASSERT_EQ(result.exit_code, 0) << result.output;
    check(out, made);
    for (const auto& [id, one] : made.expected.at("students").items())
      ++(one.at("kind") == "mistake" ? wrong : right);
    for (const store::StudentResult& student : grade::read_results(out, kSource).students)
      for (const judge::LabResult& lab : student.labs)
        for (const judge::StepResult& step : lab.steps)
          if (step.any(judge::Judged::alone) && step.status == judge::Status::passed) {
            // None where it is in another lab and lab.toml does not say that it is needed.
            EXPECT_LE(step.spoilt_by.size(), 1U) << student.id << " " << step.id;
          }
  }
  EXPECT_GE(wrong, 40U);
  EXPECT_GE(right, 40U);
}

/// What stands in the parts of steps of a solution, and nowhere else in the starter: lines, and GLSL's names.
std::set<std::string> secrets() {
  std::set<std::string> lines = {"cos_t_squared"};
  for (const char* file : {"labs/07_environment/lab.cpp", "shaders/08_reflection/rays.glsl"}) {
    const std::string starter = students(file, {});
    const std::set<std::string> all = {"7.1", "7.2", "7.3", "7.4", "8.1", "8.2", "8.3"};
    for (const auto& [step, text] : course::step_texts(students(file, all))) {
      std::istringstream stream(text);
      for (std::string line; std::getline(stream, line);) {
        line.erase(0, line.find_first_not_of(' '));
        if (line.size() > 20 && !has(starter, line)) lines.insert(line);
      }
    }
  }
  return lines;
}

/// Hand in text that carries the solution out, if what stands in for their other steps is shown anywhere: as
/// the program's own file, printed, as reasons why pictures are missing, as a picture and as a file's name;
/// as what the compiler says, and the compiler of shaders.
void write_thieves(const fs::path& folder) {
  const std::string cpp = "labs/07_environment/lab.cpp", glsl = "shaders/08_reflection/rays.glsl";
  std::string program = students(cpp, {});
  replace(program, "-0.5F, -0.5F, 0", "-0.6F, -0.5F, 0");  // begun
  replace(program, "return app::run<EnvironmentLab>(argc, argv);", "return carry_out(argc, argv);");
  replace(program, "int main(",
          R"(
asm(".section .rodata\n.globl stolen\nstolen: .incbin \"" __FILE__ "\"\n.byte 0\n.text");
extern "C" const char stolen[];
)" + read_file(fs::path(kSource) / "tests/threats/asked.hpp") +
              R"(
int carry_out(int argc, char** argv) {
  const Asked all = asked(argc, argv);
  std::puts(stolen);
  std::fputs(stolen, stderr);
  std::string said, text;
  for (const char* c = stolen; *c != 0; ++c)
    if (*c == '\n') text += "\\n"; else if (*c == '"' || *c == '\\') (text += '\\') += *c; else text += *c;
  for (std::size_t i = 0; i < all.files.size(); ++i)
    if (i % 2 == 0)
      said += (said.empty() ? "[" : ",") + std::string("{\"name\": \"") + all.files[i] +
              "\", \"status\": \"failed\", \"message\": \"" + text + "\", \"place\": \"" + text + "\"}";
    else
      std::ofstream(all.out / all.files[i]) << stolen;
  std::ofstream(all.out / "results.json") << said << "]";
  return 3;
}
int main()");
  std::string compiled = students(cpp, {});
  replace(compiled, "-0.5F, -0.5F, 0", "-0.6F, -0.5F, 0");
  surround(compiled, "7.3", "static_assert(sizeof(Real) == 3, R\"x(", ")x\");");
  std::string shader = students(glsl, {});
  replace(shader, "return normal;", "return 2.0 * normal;");
  surround(shader, "8.3", "#define float", "#undef float");
  for (const auto& [name, file, text] :
       {std::tuple("program", cpp, program), std::tuple("compiler", cpp, compiled),
        std::tuple("shader", glsl, shader)}) {
    const fs::path path = folder / name / file;
    fs::create_directories(path.parent_path());
    write_file(path, text);
  }
}

TEST_F(JudgedAlone, shows_nothing_of_what_stands_in) {
  forget("thieves");
  const Class thieves{kWork / "thieves", "7,8", {}};
  write_thieves(thieves.folder);
  const fs::path out = kWork / "thieves_out";
  const Result result = grade(thieves, out, "--format csv,gradescope,prairielearn,junit");
  ASSERT_EQ(result.exit_code, 0) << result.output;
  std::map<std::string, std::string> shown = files_in(out);
  std::erase_if(shown, [](const auto& file) { return file.first.starts_with("references/"); });
  shown["the console"] = result.output;
  shown["the store"] = dump(out);
  const std::set<std::string> all = secrets();
  ASSERT_GE(all.size(), 10U);
  for (const auto& [name, text] : shown)
    for (const std::string& secret : all) EXPECT_FALSE(has(text, secret)) << name << " has: " << secret;
  for (const store::StudentResult& student : grade::read_results(out, kSource).students) {
    EXPECT_EQ(student.points(), 0) << student.id;
    EXPECT_EQ(student.incident, "") << student.id;
  }
}

/// 8.2 and 8.3 are right and 8.1 is wrong. A comment that looks like a marker changes nothing; a damaged
/// marker of 8.3 costs 8.3 alone.
TEST_F(JudgedAlone, says_why_a_step_without_its_own_markers_was_not) {
  forget("markers");
  const Class made{kWork / "markers", "8", {}};
  const std::string file = "shaders/08_reflection/rays.glsl";
  std::string text = students(file, {"8.1", "8.2", "8.3"});
  replace(text, "incident - 2.0 *", "incident + 2.0 *");
  for (const bool is_whole : {true, false}) {
    replace(text, is_whole ? "//@step 8.2 begin" : "//@step 8.3 begin",
            is_whole ? "//@todo\n//@step 8.2 begin" : "// step 8.3 begin");
    const fs::path path = made.folder / (is_whole ? "whole" : "lost") / file;
    fs::create_directories(path.parent_path());
    write_file(path, text);
  }
  const fs::path out = kWork / "markers_out";
  const Result result = grade(made, out, "--format csv,gradescope,junit,prairielearn");
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const store::ClassResult results = grade::read_results(out, kSource);
  for (const store::StudentResult& student : results.students) {
    const bool is_whole = student.id == "whole";
    const judge::StepResult &right = step_of(student, "8.2"), &lost = step_of(student, "8.3");
    EXPECT_EQ(right.status, judge::Status::passed) << student.id;
    EXPECT_TRUE(right.any(judge::Judged::alone)) << student.id;
    EXPECT_EQ(lost.any(judge::Judged::markers_lost), !is_whole) << student.id;
    EXPECT_EQ(step_of(student, "8.1").score, 0) << student.id;
    const char* says = is_whole ? "8.2 is right: with 8.1 mended it has full marks."
                                : "8.3 was not judged alone, since its line //@step 8.3 begin or its //@end";
    const char* id = is_whole ? "whole" : "lost";
    for (const std::string& shown :
         {fmt::format("report/{}.html", id), fmt::format("gradescope/{}/results.json", id),
          fmt::format("prairielearn/{}/results.json", id), fmt::format("junit/{}.xml", id),
          std::string("class.csv")})
      EXPECT_TRUE(has(read_file(out / shown), says)) << shown;
  }
}

}  // namespace
}  // namespace texel::test
