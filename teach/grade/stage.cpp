// SPDX-License-Identifier: MIT
#include "grade/stage.hpp"

#include <fmt/format.h>

#include <string_view>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "course/markers.hpp"
#include "grade/submission.hpp"
#include "workshop.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

/// The files, by path, in which a step is not solved.
std::map<std::string, std::string> unfinished_files(const fs::path& source, const Solved& solved) {
  std::map<std::string, std::string> files;
  for (const std::string& file : course::step_files(source)) {
    bool is_finished = true;
    std::string text = course::with_steps(read_file(source / file), file, [&](const std::string& step) {
      is_finished = is_finished && solved.contains(step);
      return solved.contains(step);
    });
    if (!is_finished) files.emplace(file, std::move(text));
  }
  return files;
}

Stage make_stage(Workshop& workshop, const course::Lab& lab, const Solved& solved, const fs::path& root) {
  const fs::path course = workshop.tree().source;
  const std::map<std::string, std::string> files = unfinished_files(course, solved);
  const Program program = workshop.make(lab.program(), files);
  if (!program.refused.empty())
    throw Error::failed("does not build with only some of the steps solved", {program.refused.front().file},
                        program.refused.front().text);
  constexpr std::string_view kShaders = "shaders/";
  std::map<std::string, std::string> shaders;
  for (const auto& [file, text] : files)
    if (file.starts_with(kShaders)) shaders.emplace(file.substr(kShaders.size()), text);
  overlay(course / "shaders", shaders, root / "shaders");
  fs::create_directory_symlink(course / "assets", root / "assets");
  return {program.file, root};
}

}  // namespace

std::map<Solved, Stage> make_stages(const CourseTree& tree, const course::Lab& lab,
                                    const std::vector<Solved>& stages, const fs::path& folder) {
  Workshop workshop(solution_tree(tree.course, tree.build, {}), tree.cache / "solutions", run_plainly);
  std::vector<Stage> made(stages.size());
  in_parallel(processors(), stages.size(), [&](std::size_t i) {
    made[i] = make_stage(workshop, lab, stages[i], folder / fmt::format("{}", i));
  });
  std::map<Solved, Stage> by_solved;
  for (std::size_t i = 0; i < stages.size(); ++i) by_solved[stages[i]] = made[i];
  return by_solved;
}

}  // namespace texel::grade
