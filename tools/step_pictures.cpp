// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "commands.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "core/scratch_folder.hpp"
#include "gallery.hpp"
#include "grade/stage.hpp"
#include "image/load.hpp"
#include "image/save.hpp"
#include "processes.hpp"

namespace texel::tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSize = "240x240";
constexpr int kGap = 8;  ///< pixels between before and after

/// What one looks at to see the step.
course::Look look_of(const course::Step& step, const char* when, const fs::path& root) {
  course::Look look;
  look.name = fmt::format("{}-{}", step.id, when);
  look.settings = step.settings;
  // A model's path is that in the course's root, wherever this runs.
  for (course::Setting& setting : look.settings)
    if (setting.value.starts_with("assets/")) setting.value = (root / setting.value).string();
  look.view = step.view;
  look.size = kSize;
  return look;
}

/// The program of the k-th stage with what is drawn by it: the step that it has solved last after it, and the
/// next one before it.
Command drawing(const course::Lab& lab, std::size_t k, const grade::Stage& stage, const fs::path& out) {
  course::Lab looks = lab;
  looks.looks.clear();
  if (k > 0) looks.looks.push_back(look_of(lab.steps[k - 1], "after", stage.root));
  if (k < lab.steps.size()) looks.looks.push_back(look_of(lab.steps[k], "before", stage.root));
  const fs::path list = stage.root / "batch.json";
  write_file(list, batch_list(looks));
  return {stage.program, "--assets", stage.root, "--batch", list, "--out", out};
}

/// Both side by side, with a white gap.
image::Image8 joined(const image::Image8& left, const image::Image8& right) {
  image::Image8 both(left.width + kGap + right.width, left.height, 3);
  std::fill(both.samples.begin(), both.samples.end(), std::uint8_t{255});
  const auto row = static_cast<std::ptrdiff_t>(left.width) * 3;
  for (int y = 0; y < both.height; ++y) {
    std::copy_n(&left.at(0, y), row, &both.at(0, y));
    std::copy_n(&right.at(0, y), row, &both.at(left.width + kGap, y));
  }
  return both;
}

void draw_steps(const grade::CourseTree& tree, const course::Lab& lab, const fs::path& folder) {
  const ScratchFolder work;
  const fs::path drawn = work.path() / "drawn";
  make_folder(drawn);
  const std::vector<grade::Stage> stages = grade::make_stages(tree, lab, work.path());
  std::vector<Command> commands;
  for (std::size_t k = 0; k < stages.size(); ++k) commands.push_back(drawing(lab, k, stages[k], drawn));
  bool failed = false;
  run_all(commands, static_cast<int>(processors()),
          [&](std::size_t, int status) { failed = failed || status != 0; });
  if (failed) throw Error::failed("could not draw the steps of " + lab.program(), {}, "see its message above");
  for (const course::Step& step : lab.steps)
    image::save_png(folder / (step.id + ".png"),
                    joined(image::load8(drawn / (step.id + "-before.png"), 3),
                           image::load8(drawn / (step.id + "-after.png"), 3)),
                    {}, 9);
}

}  // namespace

Exit step_pictures(const StarterOptions& options) {
  const fs::path root = course_root();
  const grade::CourseTree tree{root, course_build(),
                               options.cache.empty() ? root / "build/grade" : options.cache, course_labs()};
  make_folder(options.pictures);
  for (const course::Lab& lab : chosen_labs(options.labs)) {
    draw_steps(tree, lab, options.pictures);
    fmt::print("  lab {}: {} steps, before and after\n", lab.number, lab.steps.size());
    std::fflush(stdout);  // a log shows each as it ends
  }
  return Exit::holds;
}

}  // namespace texel::tools
