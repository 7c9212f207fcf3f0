// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "app/lab.hpp"
#include "batch.hpp"
#include "bench.hpp"
#include "canvas.hpp"
#include "command_line.hpp"
#include "config.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/stopwatch.hpp"
#include "reports.hpp"
#include "snapshot.hpp"
#include "window.hpp"

namespace texel::app {
namespace {

constexpr glm::ivec2 kSnapshotSize(512, 512);

void print(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
}

/// To standard output for "-".
void write_report(const std::filesystem::path& file, const std::string& json) {
  if (file == "-")
    print(json);
  else
    write_file(file, json);
}

std::unique_ptr<gl::Context> headless_context(const CommandLine& line) {
  if (line.context == "osmesa") return gl::create_headless(gl::ContextKind::osmesa);
  if (line.context == "egl") return gl::create_headless(gl::ContextKind::egl);
  if (line.context == "window") return std::make_unique<gl::WindowContext>(64, 64, "texel");
  return gl::create_headless();
}

/// Draws frame after frame and prints how long they took: the driver has finished each when it is counted.
void time_frames(Canvas& canvas, View view, glm::ivec2 size, int samples, int count) {
  std::vector<double> times;
  canvas.draw(view, size, samples);  // compiles and loads
  glFinish();
  for (int i = 0; i < count; ++i) {
    const Stopwatch stopwatch;
    canvas.draw(view, size, samples);
    glFinish();
    times.push_back(stopwatch.milliseconds());
  }
  std::sort(times.begin(), times.end());
  const auto quantile = [&](double q) {
    return times[static_cast<std::size_t>(q * static_cast<double>(count - 1))];
  };
  print(fmt::format("{} frames of {}x{}: median {:.2f} ms, 5 % {:.2f} ms, 95 % {:.2f} ms, most {:.2f} ms\n",
                    count, size.x, size.y, quantile(0.5), quantile(0.05), quantile(0.95), times.back()));
}

/// Everything that needs a context but no window.
void run_headless(AnyLab& lab, const Assets& assets, const CommandLine& line) {
  const Stopwatch start;
  const View view = find_view(lab.info(), line.view);
  const glm::ivec2 size = line.size.value_or(kSnapshotSize);
  if (!line.snapshot.empty()) check_ending(line.snapshot, view);
  const std::unique_ptr<gl::Context> context = headless_context(line);
  const double context_time = start.milliseconds();
  Canvas canvas(*context, assets, lab);
  canvas.set_error_scale(line.error_scale);
  if (!line.mesh.empty()) write_mesh(lab, assets, line.mesh);
  if (!line.batch.empty()) draw_batch(canvas, lab, assets, line.batch, line.out, line.samples);
  if (!line.measure.empty()) {
    canvas.draw(View::error, size, 1);
    write_report(line.measure, to_json(lab, *canvas.error_figures()));
  }
  if (!line.bench.empty()) write_report(line.report, run_bench(canvas, lab, line.bench));
  if (line.frames > 0) time_frames(canvas, view, size, line.samples, line.frames);
  if (line.snapshot.empty() && line.stats.empty()) return;

  Statistics statistics{lab.info().folder(), context->renderer(), context->version(), {}, {}, {}};
  const Stopwatch drawing;
  if (line.stats.empty())
    canvas.draw(view, size, line.samples);
  else
    statistics.record = canvas.record(view, size, line.samples);
  glFinish();
  const double draw_time = drawing.milliseconds();
  const Stopwatch writing;
  if (!line.snapshot.empty()) write_picture(canvas, lab, view, size, line.snapshot, statistics.renderer);
  if (line.stats.empty()) return;
  statistics.notes = lab.notes();
  const double decode_time = assets.milliseconds(), compile_time = canvas.programs().milliseconds();
  statistics.milliseconds = {
      {"context", context_time},         {"decode", decode_time},
      {"compile", compile_time},         {"draw", std::max(0.0, draw_time - decode_time - compile_time)},
      {"write", writing.milliseconds()}, {"total", start.milliseconds()}};
  write_report(line.stats, to_json(statistics));
}

void run_as_asked(AnyLab& lab, const CommandLine& line) {
  if (line.list_parameters) {
    print(line.json ? parameters_as_json(lab.parameters()) : parameters_as_text(lab.parameters()));
    return;
  }
  if (line.list_views) {
    for (const View view : lab.info().views)
      print(fmt::format("{}\n", kViewNames[static_cast<std::size_t>(view)]));
    return;
  }
  if (!line.save_config.empty()) save_config(line.save_config, lab.info(), lab.parameters());
  const Assets assets(line.assets);
  const bool headless = !line.snapshot.empty() || !line.batch.empty() || !line.stats.empty() ||
                        !line.mesh.empty() || !line.measure.empty() || !line.bench.empty() || line.frames > 0;
  if (headless)
    run_headless(lab, assets, line);
  else if (line.context == "osmesa" || line.context == "egl")
    throw Error::usage(fmt::format("--context {} has no window", line.context), "add --snapshot FILE");
  else if (line.save_config.empty())
    run_window(lab, assets, line);
}

}  // namespace

int run(AnyLab& lab, int argc, char** argv) {
  try {
    if (const std::optional<CommandLine> line = read_command_line(lab, argc, argv)) run_as_asked(lab, *line);
    return static_cast<int>(Exit::holds);
  } catch (const Error& error) {
    std::fprintf(stderr, "%s: %s\n", lab.info().program().c_str(), error.what());
    return static_cast<int>(error.exit_code());
  } catch (const std::exception& error) {  // out of memory, a fault of ours
    std::fprintf(stderr, "%s: %s\n", lab.info().program().c_str(), error.what());
    return static_cast<int>(Exit::failed);
  }
}

}  // namespace texel::app
