// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/batch.hpp"
#include "app/canvas.hpp"
#include "app/lab.hpp"
#include "app/reports.hpp"
#include "app/settings.hpp"
#include "core/crash.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/json.hpp"
#include "core/stages.hpp"
#include "core/stopwatch.hpp"
#include "core/terminal.hpp"
#include "start/more_options.hpp"
#include "window/window.hpp"

namespace texel::start {
namespace {

/// What the command line asks for, of a window or without one; the parameters' values are already in the lab.
struct CommandLine : window::WindowOptions {
  std::filesystem::path snapshot, batch, out, stats, mesh, save_config, assets;
  std::string context = "auto";
  std::unique_ptr<MoreOptions> more;  ///< or null
  int frames = 0;
  bool list_parameters = false, list_views = false, print_shader = false, json = false;
};

/// CLI11 collects what it does not know; this names the nearest flag that it does.
void reject_unknown(const CLI::App& app) {
  const std::vector<std::string> unknown = app.remaining();
  if (unknown.empty()) return;
  const std::string& first = unknown.front();
  if (!first.starts_with('-'))
    throw Error::usage(fmt::format("unexpected argument '{}'", first), "see --help");
  std::vector<std::string> flags;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
  throw Error::usage(fmt::format("there is no option '{}'", first),
                     did_you_mean(first.substr(0, first.find('=')), flags, "see --help"));
}

/// Reads the arguments and sets the lab's parameters (--config first, then the flags). Throws Error (usage)
/// for what is unknown, with the nearest name. Nothing is returned when the help was asked for and printed.
std::optional<CommandLine> read_command_line(app::AnyLab& lab, int argc, char** argv) {
  CommandLine line;
  std::string size, config, model;
  std::map<std::string, std::string> values;
  const app::Info& info = lab.info();

  CLI::App app(fmt::format("Lab {}: {}. {}", info.number, info.title, info.lesson), info.program());
  app.allow_extras();
  app.get_formatter()->column_width(34);
  app.get_formatter()->label("TEXT", "VALUE");  // most are no texts
  app.set_version_flag("--version", TEXEL_VERSION, "Print the version and exit");
  if (app::model_parameter(lab.parameters()) != nullptr)
    app.add_option("MODEL.obj", model, "An OBJ file instead of the built-in models");
  app.add_option("--size", size, "Size of the window or picture, WxH in pixels [960x720, a snapshot 512x512]")
      ->check([](const std::string& text) {
        return course::find_size(text) ? ""
                                       : fmt::format("'{}' is not WIDTHxHEIGHT, each from 1 to 16384", text);
      });
  app.add_option("--see", line.see,
                 "A step, as 5.1, or a case: the window shows your picture of it and the expected one");
  app.add_option("--snapshot", line.snapshot,
                 "Draw once without a window and write a .png, or a .pfm for a data view");
  app.add_option("--view", line.view, "Which picture to draw; --list-views lists them [color]");
  app.add_option("--samples", line.samples, "Samples per pixel of the colour picture, 1 or 4 [4]")
      ->check(CLI::IsMember({1, 4}));
  app.add_option("--batch", line.batch, "Draw many snapshots: a JSON list of {name, view, size, set}");
  app.add_option("--out", line.out, "Folder for the pictures of --batch");
  app.add_option("--stats", line.stats,
                 "Write as JSON what the scene contains and how long each stage took (- prints it)");
  if (MoreOptions::make != nullptr) line.more = MoreOptions::make(app);
  app.add_option("--mesh", line.mesh, "Write the vertices as drawn into a binary .ply");
  app.add_option("--frames", line.frames, "Draw this many frames and print quantiles of their times")
      ->check(CLI::Range(1, 1000000));
  app.add_option("--config", config, "Read all parameters from a TOML file");
  app.add_option("--save-config", line.save_config, "Write all parameters to a TOML file");
  app.add_option("--context", line.context,
                 "Where OpenGL comes from: window, osmesa, egl, or auto: TEXEL_CONTEXT if it is set, else\n"
                 "osmesa if it is installed, else egl [auto]")
      ->check(CLI::IsMember({"auto", "window", "osmesa", "egl"}));
  app.add_option("--assets", line.assets,
                 "Folder with assets/ and shaders/ [TEXEL_ROOT, else beside the program]");
  app.add_flag("--list-parameters", line.list_parameters, "Print every parameter with its range and help");
  app.add_flag("--list-views", line.list_views, "Print the names of the pictures that this lab draws");
  app.add_flag(
      "--print-shader", line.print_shader,
      "Print the shaders as they are compiled; comments say where each constant and uniform comes from");
  app.add_flag("--json", line.json, "Print --list-parameters as JSON");
  for (const params::Parameter& p : lab.parameters())
    app.add_option("--" + p.flag(), values[std::string(p.name)], app::describe(p))->group("Parameters");
  app.footer(
      "In the window: drag orbit, wheel zoom, G looks, J first look, space pause; F1 lists all keys, Esc "
      "closes what is open, else quits");

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& done) {  // --help, --version
    fmt::print("{}", done.get_name() == "CallForVersion" ? TEXEL_VERSION "\n" : fitted(app.help()));
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw Error::usage(error.what(), "see --help");
  }
  reject_unknown(app);
  if (!config.empty()) app::load_config(config, info, lab.parameters());
  line.look_given = !config.empty() || !model.empty() || app.count("--view") > 0 || !line.see.empty();
  for (params::Parameter& p : lab.parameters()) {
    if (app.count("--" + p.flag()) == 0) continue;
    p.set(values[std::string(p.name)]);
    (p.name == "turn" ? line.turn_given : line.look_given) = true;
  }
  if (!model.empty()) {
    // A model on the command line is a path, also without a folder and ending.
    const bool bare = model.find_first_of("./") == std::string::npos;
    app::model_parameter(lab.parameters())->set(bare ? "./" + model : model);
  }
  if (app.count("--size") > 0) line.size = app::pixels(course::parse_size(size));
  app::find_view(lab, line.view);
  if (!line.batch.empty() && line.out.empty()) throw Error::usage("--batch needs --out DIR");
  return line;
}

constexpr glm::ivec2 kSnapshotSize(512, 512);
/// What optimising a shader takes longer, it has saved after 7 pictures of 512x512 in labs 5 and 9, and after
/// 20 in labs 1 and 7.
constexpr double kPixelsWorthOptimising = 7 * 512 * 512;

std::unique_ptr<gl::Context> headless_context(const std::string& kind, bool draws_much) {
  const Stage stage("context");
  if (kind == "window") return std::make_unique<gl::WindowContext>(64, 64, "texel");
  return gl::create_headless(draws_much ? gl::Shaders::quick_to_draw : gl::Shaders::quick_to_compile, kind);
}

/// What --stats prints, a contract with scripts: what was drawn (canvas.record), and how long it took.
/// `drawn_by` is renderer and version, without what changes no pixel.
std::string statistics_as_json(const app::AnyLab& lab, const app::Canvas& canvas, const gl::Record& record,
                               const Json& milliseconds, long long peak_bytes) {
  Json attributes = Json::array(), textures = Json::array();
  for (const auto& use : record.attributes) attributes.push_back({{"name", use.name}, {"bytes", use.bytes}});
  for (const auto& use : record.textures)
    textures.push_back({{"name", use.name},
                        {"width", use.width},
                        {"height", use.height},
                        {"format", use.format},
                        {"bytes", use.bytes}});
  std::vector<std::string> warnings = canvas.notes().warnings;
  warnings.insert(warnings.end(), record.warnings.begin(), record.warnings.end());
  const Json json = {{"lab", lab.info().folder()},
                     {"vertices", record.vertices},
                     {"triangles", record.triangles},
                     {"draw_calls", record.draw_calls},
                     {"attributes", attributes},
                     {"index_bytes", record.index_bytes},
                     {"textures", textures},
                     {"milliseconds", milliseconds},
                     {"peak_bytes", peak_bytes},
                     {"notes", canvas.notes().facts},
                     {"warnings", warnings},
                     {"renderer", canvas.context().renderer()},
                     {"version", canvas.context().version()},
                     {"drawn_by", canvas.context().name()}};
  return to_text(json, 2) + "\n";
}

/// Milliseconds by stage of everything so far; `start` is what went by before the first.
Json stages_so_far(double start) {
  const double total = milliseconds_since_start();
  Json stages = {{"start", start}};
  double other = total - start;
  for (const auto& [name, time] : stage_times()) stages[name] = time, other -= time;
  stages["other"] = other, stages["total"] = total;
  return stages;
}

/// Of frames that took so many milliseconds each, at least one.
std::string frame_times_as_text(std::vector<double> milliseconds, glm::ivec2 size) {
  std::sort(milliseconds.begin(), milliseconds.end());
  const auto quantile = [&](double q) {
    return milliseconds[static_cast<std::size_t>(q * static_cast<double>(milliseconds.size() - 1))];
  };
  return fmt::format("{} frames of {}x{}: median {:.2f} ms, 5 % {:.2f} ms, 95 % {:.2f} ms, most {:.2f} ms\n",
                     milliseconds.size(), size.x, size.y, quantile(0.5), quantile(0.05), quantile(0.95),
                     milliseconds.back());
}

/// Everything that needs a context but no window.
void run_headless(app::AnyLab& lab, const app::Assets& assets, const CommandLine& line) {
  const double start = milliseconds_since_start();
  report_crashes();
  const app::View view = app::find_view(lab, line.view);
  const glm::ivec2 size = line.size.value_or(kSnapshotSize);
  if (!line.snapshot.empty()) app::check_ending(line.snapshot, view);
  const app::Batch batch = line.batch.empty() ? app::Batch() : app::read_batch(lab, line.batch);
  const bool timed = (line.more && line.more->prepare(lab)) || line.frames > 0;
  const double pixels =
      batch.empty() ? static_cast<double>(size.x) * size.y : app::pixels_per_program(batch, lab.parameters());
  const std::unique_ptr<gl::Context> context =
      headless_context(line.context, timed || pixels > kPixelsWorthOptimising);
  app::Canvas canvas(*context, assets, lab);
  // How many milliseconds it took until the driver had drawn.
  const auto draw = [&] {
    const Stopwatch stopwatch;
    canvas.draw(view, size, line.samples);
    glFinish();
    return stopwatch.milliseconds();
  };
  if (line.more) line.more->run(canvas, lab, size);
  if (!line.mesh.empty()) app::write_mesh(lab, assets, line.mesh);
  if (!line.batch.empty()) app::draw_batch(canvas, lab, assets, batch, line.out, line.samples);
  if (line.print_shader) {
    draw();
    fmt::print("{}", app::shaders_as_text(canvas.programs(), lab.parameters(), view));
  }
  if (line.frames > 0) {
    draw();  // compiles and loads
    std::vector<double> times(static_cast<std::size_t>(line.frames));
    std::ranges::generate(times, draw);
    fmt::print("{}", frame_times_as_text(std::move(times), size));
  }
  if (line.snapshot.empty() && line.stats.empty()) return;

  {
    const Stage stage("first_draw");
    draw();
  }
  if (!line.snapshot.empty()) app::take_snapshot(canvas, lab, view, size, line.snapshot)();
  if (line.stats.empty()) return;
  Json stages = stages_so_far(start);
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const long long peak_bytes = static_cast<long long>(usage.ru_maxrss) * 1024;
  stages["draw"] = draw();  // all is loaded and compiled now
  const gl::Record record = canvas.record(view, size, line.samples);
  write_report(line.stats, statistics_as_json(lab, canvas, record, stages, peak_bytes));
}

void run_as_asked(app::AnyLab& lab, const CommandLine& line) {
  if (line.list_parameters) {
    fmt::print("{}", line.json ? app::parameters_as_json(lab.parameters())
                               : fitted(app::parameters_as_text(lab.parameters())));
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
                        line.frames > 0;
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
