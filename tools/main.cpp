// SPDX-License-Identifier: MIT
// texel: the course's command line.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <regex>

#include "command_line.hpp"
#include "commands.hpp"
#include "core/terminal.hpp"

namespace texel::tools {
namespace {

void add_gallery(CLI::App& app, GalleryOptions& options) {
  CLI::App* command = app.add_subcommand("gallery", "Draw every lab's looks, and a page that shows them");
  command->add_option("--out", options.out, "Folder for the page and the pictures [out/gallery]");
  command->add_option("--lab", options.labs, "Draw only this lab; repeat the option for several labs")
      ->check(CLI::Range(1, 99));
}

/// What the student's commands take: one of them runs.
struct StudentOptions {
  CheckOptions check;
  int lab = 0;
  std::size_t choice = 0;
  std::string step, context = "auto";
  std::filesystem::path out;
};

void add_student(CLI::App& app, StudentOptions& options) {
  const auto add = [&](const char* name, const char* what) {
    CLI::App* command = app.add_subcommand(name, what);
    add_context(command, options.context);
    return command;
  };
  CLI::App* check = add("check", "Show which steps are right, and how far the next one is off");
  check->footer("Exit codes: 0 all steps passed, 1 not all, 2 wrong usage, 3 could not draw or compare.");
  static const std::regex place("[1-9][0-9]?(\\.[0-9]+)?");
  check->add_option("LAB", options.check.places, "Labs as 9, and steps as 9.4 [all labs]")
      ->check([](const std::string& text) {
        return std::regex_match(text, place) ? "" : fmt::format("'{}' is neither a lab nor a step", text);
      });
  check->add_flag("--json", options.check.json, "Print JSON: an object for one lab, a list for several");
  check->add_flag("--unless-begun", options.check.unless_begun,
                  "Exit code 0 also if no step of these labs is begun");
  CLI::App* see = add("see", "Write one picture of a step: yours, the expected one, and where they differ");
  see->add_option("STEP", options.step, "A step as 5.1")->required();
  see->add_option("--out", options.out, "The .png to write [out/see/STEP.png]");
  CLI::App* watch = add("watch", "Check a lab after every save; h shows a hint, q quits");
  watch->add_option("LAB", options.lab, "The lab's number")->required()->check(CLI::Range(1, 99));
  CLI::App* hint = add("hint", "Show one more hint for a step");
  hint->add_option("STEP", options.step, "A step as 5.1, or a lab's number [the next step of the course]");
  CLI::App* predict = app.add_subcommand("predict", "Ask a step's question, or answer your choice");
  predict->add_option("STEP", options.step, "A step as 5.1")->required();
  predict->add_option("CHOICE", options.choice, "Your answer: 1, 2 or 3")->check(CLI::Range(1, 3));
  CLI::App* reset =
      app.add_subcommand("reset", "Restore a step's starting code; your code is saved in another file");
  reset->add_option("STEP", options.step, "A step as 5.1")->required();
  add("progress", "Show all labs with their steps and points");
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
  GalleryOptions gallery_options;
  StudentOptions student;
  app.add_subcommand("list", "List the labs");
  add_gallery(app, gallery_options);
  add_student(app, student);
  const std::unique_ptr<MoreCommands> more =
      MoreCommands::make != nullptr ? MoreCommands::make(app) : nullptr;
  reject_unknown_command(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& done) {  // --help, --version
    app.exit(done);
    return Exit::holds;
  } catch (const CLI::ParseError& error) {
    throw Error::usage(error.what(), "see --help");
  }
  if (app.got_subcommand("list")) return list();
  if (app.got_subcommand("check")) return check(student.check, student.context);
  if (app.got_subcommand("see")) return see(student.step, student.out, student.context);
  if (app.got_subcommand("watch")) return watch(student.lab, student.context);
  if (app.got_subcommand("hint")) return hint(student.step, student.context);
  if (app.got_subcommand("predict")) return predict(student.step, student.choice);
  if (app.got_subcommand("reset")) return reset(student.step);
  if (app.got_subcommand("progress")) return progress(student.context);
  if (more)
    if (const std::optional<Exit> done = more->run()) return *done;
  return gallery(gallery_options);
}

}  // namespace
}  // namespace texel::tools

int main(int argc, char** argv) {
  return texel::run_main("texel", [&] { return texel::tools::run(argc, argv); });
}
