// SPDX-License-Identifier: MIT
#include "grade/stage.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
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

/// The files, by path, that are not yet the solution when these steps are solved.
std::map<std::string, std::string> unfinished_files(const fs::path& course,
                                                    const std::set<std::string>& solved) {
  std::map<std::string, std::string> files;
  for (const std::string& file : step_files(course)) {
    bool is_finished = true;
    std::string text = course::with_steps(read_file(course / file), file, [&](const std::string& step) {
      is_finished = is_finished && solved.contains(step);
      return solved.contains(step);
    });
    if (!is_finished) files.emplace(file, std::move(text));
  }
  return files;
}

Stage make_stage(Workshop& workshop, const course::Lab& lab,
                 const std::map<std::string, std::string>& files, const fs::path& root) {
  const Program program = workshop.make(lab.program(), files);
  if (!program.refused.empty())
    throw Error::failed("a stage of the course does not build", {program.refused.front().file},
                        program.refused.front().text);
  constexpr std::string_view kShaders = "shaders/";
  std::map<std::string, std::string> shaders;
  for (const auto& [file, text] : files)
    if (file.starts_with(kShaders)) shaders.emplace(file.substr(kShaders.size()), text);
  const fs::path course = workshop.tree().source;
  overlay(course / kShaders, shaders, root / kShaders);
  fs::create_directory_symlink(course / "assets", root / "assets");
  return {program.file, root};
}

}  // namespace

std::vector<Stage> make_stages(const CourseTree& tree, const course::Lab& lab, const fs::path& folder) {
  Workshop workshop(solution_tree(tree.course, tree.build, {}), tree.cache / "solutions", true);
  std::set<std::string> solved;
  for (const course::Lab& earlier : tree.labs)
    for (const course::Step& step : earlier.steps)
      if (earlier.number < lab.number) solved.insert(step.id);
  std::vector<std::map<std::string, std::string>> files = {unfinished_files(tree.course, solved)};
  for (const course::Step& step : lab.steps) {
    solved.insert(step.id);
    files.push_back(unfinished_files(tree.course, solved));
  }
  std::vector<Stage> stages(files.size());
  in_parallel(processors(), files.size(), [&](std::size_t k) {
    stages[k] = make_stage(workshop, lab, files[k], folder / fmt::format("{}", k));
  });
  return stages;
}

}  // namespace texel::grade
