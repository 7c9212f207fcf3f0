// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <vector>

#include "app/batch.hpp"
#include "app/canvas.hpp"
#include "app/lab.hpp"
#include "app/reports.hpp"
#include "app/settings.hpp"
#include "app/snapshot.hpp"
#include "command_line.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/stages.hpp"
#include "core/stopwatch.hpp"
#include "core/terminal.hpp"
#include "window/window.hpp"

namespace texel::start {
namespace {

constexpr glm::ivec2 kSnapshotSize(512, 512);
/// What optimising a shader takes longer, it has saved after 7 pictures of 512x512 in labs 5 and 9, and after
/// 20 in labs 1 and 7.
constexpr double kPixelsWorthOptimising = 7 * 512 * 512;

std::unique_ptr<gl::Context> headless_context(const CommandLine& line, gl::Shaders shaders) {
  const Stage stage("context");
  if (line.context == "window") return std::make_unique<gl::WindowContext>(64, 64, "texel");
  return gl::create_headless(shaders, line.context);
}

/// Draws, and returns when the driver has.
void draw_and_finish(app::Canvas& canvas, app::View view, glm::ivec2 size, int samples) {
  canvas.draw(view, size, samples);
  glFinish();
}

/// Draws frame after frame and prints how long they took: the driver has finished each when it is counted.
void time_frames(app::Canvas& canvas, app::View view, glm::ivec2 size, int samples, int count) {
  std::vector<double> times;
  draw_and_finish(canvas, view, size, samples);  // compiles and loads
  for (int i = 0; i < count; ++i) {
    const Stopwatch stopwatch;
    draw_and_finish(canvas, view, size, samples);
    times.push_back(stopwatch.milliseconds());
  }
  fmt::print("{}", app::frame_times_as_text(std::move(times), size));
}

/// Milliseconds by stage of everything so far; `start` is what went by before the first.
app::StageTimes stages_so_far(double start) {
  const double total = milliseconds_since_start();
  app::StageTimes list = {{"start", start}};
  for (const NamedStage& stage : stage_times()) list.emplace_back(stage.name, stage.time.wall);
  double other = total;
  for (const auto& [name, milliseconds] : list) other -= milliseconds;
  list.insert(list.end(), {{"other", other}, {"total", total}});
  return list;
}

/// Everything that needs a context but no window.
void run_headless(app::AnyLab& lab, const app::Assets& assets, const CommandLine& line) {
  const double start = milliseconds_since_start();
  const app::View view = app::find_view(lab, line.view);
  const glm::ivec2 size = line.size.value_or(kSnapshotSize);
  if (!line.snapshot.empty()) app::check_ending(line.snapshot, view);
  const app::Batch batch = line.batch.empty() ? app::Batch() : app::read_batch(lab, line.batch);
  const bool timed = (line.more && line.more->prepare(lab)) || line.frames > 0;
  const double pixels =
      batch.empty() ? static_cast<double>(size.x) * size.y : app::pixels_per_program(batch, lab.parameters());
  const std::unique_ptr<gl::Context> context =
      headless_context(line, timed || pixels > kPixelsWorthOptimising ? gl::Shaders::quick_to_draw
                                                                      : gl::Shaders::quick_to_compile);
  app::Canvas canvas(*context, assets, lab);
  if (line.more) line.more->run(canvas, lab, size);
  if (!line.mesh.empty()) app::write_mesh(lab, assets, line.mesh);
  if (!line.batch.empty()) app::draw_batch(canvas, lab, assets, batch, line.out, line.samples);
  if (line.print_shader) {
    canvas.draw(view, size, line.samples);
    fmt::print("{}", app::shaders_as_text(canvas.programs(), lab.parameters(), view));
  }
  if (line.frames > 0) time_frames(canvas, view, size, line.samples, line.frames);
  if (line.snapshot.empty() && line.stats.empty()) return;

  {
    const Stage stage("first_draw");
    draw_and_finish(canvas, view, size, line.samples);
  }
  if (!line.snapshot.empty()) app::take_snapshot(canvas, lab, view, size, line.snapshot).write();
  if (line.stats.empty()) return;
  app::StageTimes stages = stages_so_far(start);
  const long long peak_bytes = app::peak_resident_bytes();
  const Stopwatch again;
  draw_and_finish(canvas, view, size, line.samples);
  stages.emplace_back("draw", again.milliseconds());  // all is loaded and compiled now
  const gl::Record record = canvas.record(view, size, line.samples);
  write_report(line.stats, app::statistics_as_json(lab, canvas, record, stages, peak_bytes));
}

void run_as_asked(app::AnyLab& lab, const CommandLine& line) {
  if (line.list_parameters) {
    fmt::print("{}", line.json ? app::parameters_as_json(lab.parameters())
                               : app::parameters_as_text(lab.parameters()));
    return;
  }
  if (line.list_views) {
    for (const app::View view : lab.views()) fmt::print("{}\n", name_of(view));
    return;
  }
  if (!line.save_config.empty()) app::save_config(line.save_config, lab.info(), lab.parameters());
  const app::Assets assets(line.assets);
  const bool headless = !line.snapshot.empty() || !line.batch.empty() || !line.stats.empty() ||
                        !line.mesh.empty() || (line.more && line.more->is_headless()) || line.print_shader ||
                        (line.frames > 0 && line.context != "window");
  if (headless)
    run_headless(lab, assets, line);
  else if (line.context == "osmesa" || line.context == "egl")
    throw Error::usage(fmt::format("--context {} cannot open a window", line.context), "add --snapshot FILE");
  else if (line.save_config.empty())
    window::run_window(lab, assets, line);
}

}  // namespace

void write_report(const std::filesystem::path& file, const std::string& json) {
  if (file == "-")
    fmt::print("{}", json);
  else
    write_file(file, json);
}

}  // namespace texel::start

int texel::app::run(AnyLab& lab, int argc, char** argv) {
  return run_main(lab.info().program(), [&] {
    if (const std::optional<start::CommandLine> line = start::read_command_line(lab, argc, argv))
      start::run_as_asked(lab, *line);
    return Exit::holds;
  });
}
