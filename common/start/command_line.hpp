// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "start/more_options.hpp"
#include "window/window.hpp"

namespace texel::start {

/// What the command line asks for, of a window or without one; the parameters' values are already in the lab.
struct CommandLine : window::WindowOptions {
  std::filesystem::path snapshot, batch, out, stats, mesh, save_config, assets;
  std::string context = "auto";
  std::unique_ptr<MoreOptions> more;  ///< or null
  bool list_parameters = false, list_views = false, print_shader = false, json = false;
};

/// Reads the arguments and sets the lab's parameters (--config first, then the flags). Throws Error (usage)
/// for what is unknown, with the nearest name. Nothing is returned when the help was asked for and printed.
std::optional<CommandLine> read_command_line(app::AnyLab& lab, int argc, char** argv);

}  // namespace texel::start
