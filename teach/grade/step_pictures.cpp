// SPDX-License-Identifier: MIT
// What a lab looks like between starter and solution, as a student has it on the way.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <set>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "course/batch.hpp"
#include "course/markers.hpp"
#include "course/reader.hpp"
#include "grade/course_tree.hpp"
#include "grade/submission.hpp"
#include "image/compared.hpp"
#include "image/load.hpp"
#include "image/save.hpp"
#include "workshop.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

constexpr course::Size kSize = {300, 300};

/// The steps that are solved, as "5.1".
using Solved = std::set<std::string>;

/// What is drawn, by the steps that are solved in it.
using Stages = std::map<Solved, std::vector<course::Case>>;

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

/// Each step of the lab before and after, where those of `solved` are solved and then the earlier ones.
Stages stages_of(const course::Lab& lab, Solved solved, const fs::path& course) {
  const fs::path file = course / "labs" / lab.folder / "lab.toml";
  const toml::table table = course::read_toml(file);
  auto written = course::Reader(table, file.string()).tables("step");
  Stages stages;
  for (std::size_t i = 0; i < lab.steps.size(); ++i) {
    const course::Step& step = lab.steps[i];
    Solved stage = solved;
    for (const std::string& later : written[i].texts("seen_with")) stage.insert(later);
    stages[stage].push_back(look_of(step, "before", course));
    stage.insert(step.id);
    stages[stage].push_back(look_of(step, "after", course));
    solved.insert(step.id);
  }
  return stages;
}

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

/// Draws into the folder `drawn`; what is missing there afterwards was not drawn. `root` is a new folder.
void draw_stage(Workshop& workshop, const course::Lab& lab, const Stages::value_type& stage,
                const fs::path& root, const fs::path& drawn) {
  const fs::path course = workshop.tree().source;
  const std::map<std::string, std::string> files = unfinished_files(course, stage.first);
  const Program program = workshop.make(lab.program(), files);
  if (!program.refused.empty())
    throw Error::failed("does not build with only some of the steps solved", {program.refused.front().file},
                        program.refused.front().text);
  make_root(course, files, root);
  write_file(root / "batch.json", course::to_batch(stage.second));
  run_into({program.file, "--assets", root, "--batch", root / "batch.json", "--out", drawn}, STDOUT_FILENO,
           STDERR_FILENO);
}

image::Image8 step_picture(const fs::path& before, const fs::path& after) {
  const image::Image8 right = image::load8(after, 3);
  image::Image8 left(right.width, right.height, 3);
  std::ranges::fill(left.samples, std::uint8_t{128});
  // Without the step the lab may refuse to draw. The student sees a message, and an empty window.
  if (fs::exists(before)) left = image::load8(before, 3);
  return image::side_by_side({left, right});
}

}  // namespace

void draw_step_pictures(const CourseTree& tree, const fs::path& folder,
                        const std::function<void(const std::string&)>& say) {
  Workshop workshop(solution_tree(tree.course, tree.build, {}), tree.cache / "solutions", run_plainly);
  fs::create_directories(folder);
  Solved solved;
  for (const course::Lab& lab : course::read_labs(tree.course / "labs")) {
    if (std::ranges::count(tree.labs, lab.number, &course::Lab::number) > 0) {
      const ScratchFolder work;
      const fs::path drawn = work.path() / "drawn";
      fs::create_directory(drawn);
      const Stages by_solved = stages_of(lab, solved, tree.course);
      const std::vector<Stages::value_type> stages(by_solved.begin(), by_solved.end());
      in_parallel(processors(), stages.size(), [&](std::size_t i) {
        draw_stage(workshop, lab, stages[i], work.path() / fmt::format("{}", i), drawn);
      });
      for (const course::Step& step : lab.steps)
        image::save_png(folder / (step.id + ".png"),
                        step_picture(drawn / file_of(step, "before"), drawn / file_of(step, "after")), {}, 9);
      say(fmt::format("  lab {}: {} steps, before and after", lab.number, lab.steps.size()));
    }
    for (const course::Step& step : lab.steps) solved.insert(step.id);
  }
}

}  // namespace texel::grade
