// SPDX-License-Identifier: MIT
// texel: the course's command line.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <stdexcept>

#include "commands.hpp"
#include "core/pattern.hpp"
#include "core/terminal.hpp"

namespace texel::tools {

void add_context(CLI::App* command, std::string& context) {
  command->add_option("--context", context, "Where OpenGL comes from")
      ->check(CLI::IsMember({"auto", "osmesa", "egl"}));
}

namespace {

/// What the commands take: one of them runs.
struct Options {
  std::filesystem::path gallery = "out/gallery";
  std::vector<int> labs;  ///< none for all
  CheckOptions check;
  int lab = 0;
  std::size_t choice = 0;
  std::string step, context = "auto";
  std::filesystem::path out;
};

/// With what each does.
std::vector<std::pair<const CLI::App*, std::function<Exit()>>> add_commands(CLI::App& app, Options& o) {
  std::vector<std::pair<const CLI::App*, std::function<Exit()>>> commands;
  const auto add = [&](const char* name, const char* what, bool draws, std::function<Exit()> run) {
    CLI::App* command = app.add_subcommand(name, what);
    if (draws) add_context(command, o.context);
    commands.emplace_back(command, std::move(run));
    return command;
  };
  static const Pattern lab_or_step("[1-9][0-9]?(\\.[0-9]+)?");
  const auto is_place = [](const std::string& text) {
    return lab_or_step.match(text).empty() ? fmt::format("'{}' is neither a lab nor a step", text) : "";
  };
  add("list", "List the labs", false, list);
  CLI::App* command = add("gallery", "Draw every lab's looks, and a page that shows them", false,
                          [&] { return gallery(o.labs, o.gallery); });
  command->add_option("--out", o.gallery, "Folder for the page and the pictures [out/gallery]");
  command->add_option("--lab", o.labs, "Draw only this lab; repeat the option for several labs")
      ->check(CLI::Range(1, 99));
  command = add("check", "Show which steps are right, and how far the next one is off", true,
                [&] { return check(o.check, o.context); });
  command->footer("Exit codes: 0 all steps passed, 1 not all, 2 wrong usage, 3 could not draw or compare.");
  command->add_option("LAB", o.check.places, "Labs as 9, and steps as 9.4 [all labs]")->check(is_place);
  command->add_flag("--json", o.check.json, "Print JSON: an object for one lab, a list for several");
  command->add_flag("--unless-begun", o.check.unless_begun,
                    "Exit code 0 also if no step of these labs is begun");
  command = add("see", "Write one picture of a step: yours, the expected one, and where they differ", true,
                [&] { return see(o.step, o.out, o.context); });
  command->add_option("STEP", o.step, "A step as 5.1")->required();
  command->add_option("--out", o.out, "The .png to write [out/see/STEP.png]");
  command = add("watch", "Check a lab after every save; h shows a hint, q quits", true,
                [&] { return watch(o.lab, o.context); });
  command->add_option("LAB", o.lab, "The lab's number")->required()->check(CLI::Range(1, 99));
  command = add("hint", "Show one more hint for a step", true, [&] { return hint(o.step, o.context); });
  command->add_option("STEP", o.step, "A step as 5.1, or a lab's number [the next step of the course]")
      ->check(is_place);
  command = add("predict", "Ask a step's question, or answer your choice", false,
                [&] { return predict(o.step, o.choice); });
  command->add_option("STEP", o.step, "A step as 5.1")->required();
  command->add_option("CHOICE", o.choice, "Your answer: 1, 2 or 3")->check(CLI::Range(1, 3));
  command = add("reset", "Restore a step's starting code; your code is saved in another file", false,
                [&] { return reset(o.step); });
  command->add_option("STEP", o.step, "A step as 5.1")->required();
  add("progress", "Show all labs with their steps and points", true, [&] { return progress(o.context); });
  return commands;
}

/// CLI11 says only that a command is needed; this names the nearest.
void reject_unknown_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (std::ranges::count(names, argv[1]) > 0) return;
  throw Error::usage(
      fmt::format("there is no command '{}'", argv[1]),
      did_you_mean(argv[1], names, fmt::format("the commands are {}", fmt::join(names, ", "))));
}

Exit run(int argc, char** argv) {
  CLI::App app("The course's command line", "texel");
  app.set_version_flag("--version", TEXEL_VERSION, "Print the version and exit");
  app.require_subcommand(1);
  Options options;
  const auto commands = add_commands(app, options);
  const std::unique_ptr<MoreCommands> more =
      MoreCommands::make != nullptr ? MoreCommands::make(app) : nullptr;
  reject_unknown_command(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& done) {  // --help, --version
    fmt::print("{}", done.get_name() == "CallForVersion" ? TEXEL_VERSION "\n" : fitted(app.help()));
    return Exit::holds;
  } catch (const CLI::ParseError& error) {
    throw Error::usage(error.what(), "see --help");
  }
  if (more)
    if (const std::optional<Exit> done = more->run()) return *done;
  for (const auto& [command, run] : commands)
    if (command->parsed()) return run();
  throw std::logic_error("a command that nobody runs");
}

}  // namespace
}  // namespace texel::tools

int main(int argc, char** argv) {
  return texel::run_main("texel", [&] { return texel::tools::run(argc, argv); });
}
