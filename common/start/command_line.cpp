// SPDX-License-Identifier: MIT
#include "command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "app/settings.hpp"
#include "core/error.hpp"

namespace texel::start {
namespace {

/// "number from 0 to 4 units, default 1" — what stands behind a flag in --help.
std::string describe(const params::Parameter& p) {
  std::string text(p.help);
  if (p.type == params::Parameter::Type::choice || p.type == params::Parameter::Type::file) {
    text += p.type == params::Parameter::Type::file ? "; a path, or one of:" : "; one of:";
    for (const params::Item& item : p.items) text += fmt::format("\n  {}: {}", item.name, item.help);
  } else if (p.type != params::Parameter::Type::toggle) {
    text += fmt::format("; {} to {}{}{}", p.least, p.most, p.unit.empty() ? "" : " ", p.unit);
  }
  return text + fmt::format(" [{}]", p.initial());
}

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

}  // namespace

std::optional<CommandLine> read_command_line(app::AnyLab& lab, int argc, char** argv) {
  CommandLine line;
  std::string size, config, model;
  std::map<std::string, std::string> values;
  const app::Info& info = lab.info();

  CLI::App app(fmt::format("Lab {}: {}. {}", info.number, info.title, info.lesson), info.program());
  app.allow_extras();
  app.get_formatter()->column_width(34);
  app.set_version_flag("--version", TEXEL_VERSION, "Print the version and exit");
  if (app::model_parameter(lab.parameters()) != nullptr)
    app.add_option("MODEL.obj", model, "An OBJ file instead of the built-in models");
  app.add_option("--size", size,
                 "Size of the window or picture, WxH in pixels [960x720, a snapshot 512x512]");
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
  app.add_option("--frames", line.frames,
                 "Draw this many frames and print quantiles of their times; with --context window in the "
                 "window, with its panel")
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
    app.add_option("--" + p.flag(), values[std::string(p.name)], describe(p))->group("Parameters");
  app.footer(
      "In the window: drag orbit, wheel zoom, G looks, J default look, space pause; F1 lists all keys, Esc "
      "closes what is open, else quits");

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& done) {  // --help, --version
    app.exit(done);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw Error::usage(error.what(), "see --help");
  }
  reject_unknown(app);
  if (!config.empty()) app::load_config(config, info, lab.parameters());
  for (params::Parameter& p : lab.parameters())
    if (app.count("--" + p.flag()) > 0) p.set(values[std::string(p.name)]);
  if (!model.empty()) {
    // A model on the command line is a path, also without a folder and ending.
    const bool bare = model.find_first_of("./") == std::string::npos;
    app::model_parameter(lab.parameters())->set(bare ? "./" + model : model);
  }
  line.turn_given = lab.parameters().find("turn") != nullptr && app.count("--turn") > 0;
  line.look_given = !config.empty() || !model.empty() || app.count("--view") > 0 || !line.see.empty();
  for (const params::Parameter& p : lab.parameters())
    line.look_given = line.look_given || (p.name != "turn" && app.count("--" + p.flag()) > 0);
  if (app.count("--size") > 0) {
    const std::optional<course::Size> asked = course::find_size(size);
    if (!asked)
      throw Error::usage(fmt::format("--size takes WIDTHxHEIGHT in pixels, each from 1 to {}, not '{}'",
                                     course::Size::kMostPixels, size));
    line.size = app::pixels(*asked);
  }
  app::find_view(lab, line.view);
  if (!line.batch.empty() && line.out.empty()) throw Error::usage("--batch needs --out DIR");
  return line;
}

}  // namespace texel::start
