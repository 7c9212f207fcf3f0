// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "commands.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "core/process.hpp"
#include "core/terminal.hpp"
#include "course/batch.hpp"
#include "course_commands.hpp"
#include "grade/course_tree.hpp"
#include "image/compared.hpp"
#include "image/load.hpp"
#include "image/save.hpp"

namespace texel::commands {
namespace {

namespace fs = std::filesystem;

constexpr course::Size kSize = {200, 200};

/// The file of the look by which one sees the step.
std::string file_of(const course::Step& step, const char* when) {
  return fmt::format("{}-{}.png", step.id, when);
}

course::Case look_of(const course::Step& step, const char* when, const fs::path& root) {
  course::Case look = step.see;
  look.file = file_of(step, when), look.size = kSize;
  // A model's path begins in the course's root, wherever this runs.
  for (course::Setting& setting : look.settings)
    if (setting.value.starts_with("assets/")) setting.value = (root / setting.value).string();
  return look;
}

using Looks = std::vector<course::Case>;

/// What is drawn at each stage of the lab.
std::map<grade::Solved, Looks> looks_by_stage(const grade::CourseTree& tree, const course::Lab& lab) {
  grade::Solved solved;
  for (const course::Lab& earlier : tree.labs)
    for (const course::Step& step : earlier.steps)
      if (earlier.number < lab.number) solved.insert(step.id);
  std::map<grade::Solved, Looks> stages;
  const auto draw = [&](const grade::Solved& stage, const course::Step& step, const char* when) {
    stages[stage].push_back(look_of(step, when, tree.course));
  };
  for (const course::Step& step : lab.steps) {
    grade::Solved stage = solved;
    stage.insert(step.seen_with.begin(), step.seen_with.end());
    draw(stage, step, "before");
    stage.insert(step.id);
    draw(stage, step, "after");
    solved.insert(step.id);
  }
  return stages;
}

image::Image8 step_picture(const fs::path& before, const fs::path& after) {
  const image::Image8 right = image::load8(after, 3);
  if (fs::exists(before)) return image::side_by_side({image::load8(before, 3), right});
  // Without the step the lab may refuse to draw. The student sees a message, and an empty window.
  image::Image8 empty(right.width, right.height, 3);
  std::fill(empty.samples.begin(), empty.samples.end(), std::uint8_t{128});
  return image::side_by_side({empty, right});
}

void draw_steps(const grade::CourseTree& tree, const course::Lab& lab, const fs::path& folder) {
  const ScratchFolder work;
  const fs::path drawn = work.path() / "drawn";
  make_folder(drawn);
  const std::map<grade::Solved, Looks> looks = looks_by_stage(tree, lab);
  std::vector<grade::Solved> stages;
  for (const auto& [solved, at_stage] : looks) stages.push_back(solved);
  std::vector<std::vector<std::string>> commands;
  for (const auto& [solved, stage] : grade::make_stages(tree, lab, stages, work.path())) {
    const fs::path list = stage.root / "batch.json";
    write_file(list, course::to_batch(looks.at(solved)));
    commands.push_back({stage.program, "--assets", stage.root, "--batch", list, "--out", drawn});
  }
  // What is missing afterwards was not drawn.
  in_parallel(processors(), commands.size(),
              [&](std::size_t i) { run_into(commands[i], STDOUT_FILENO, STDERR_FILENO); });
  for (const course::Step& step : lab.steps) {
    const fs::path before = drawn / file_of(step, "before"), after = drawn / file_of(step, "after");
    image::save_png(folder / (step.id + ".png"), step_picture(before, after), {}, 9);
  }
}

}  // namespace

Exit step_pictures(const StarterOptions& options) {
  const grade::CourseTree tree = course_tree({}, options.cache);
  make_folder(options.pictures);
  for (const course::Lab& lab : tools::chosen_labs(options.labs)) {
    draw_steps(tree, lab, options.pictures);
    fmt::print("  lab {}: {} steps, before and after\n", lab.number, lab.steps.size());
    flush_output();  // a log shows each as it ends
  }
  return Exit::holds;
}

}  // namespace texel::commands
