// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "app/lab.hpp"

namespace texel::app {

/// What the command line asks for; the parameters' values are already in the lab.
struct CommandLine {
  std::optional<glm::ivec2> size;
  std::string view = "color";
  std::filesystem::path snapshot, batch, out, stats, measure, bench, report = "-", mesh, save_config, assets;
  std::string context = "auto";
  std::string see;  ///< a step that the window shows first: "5.1"
  double error_scale = 0;
  int samples = 4;
  int frames = 0;
  bool list_parameters = false, list_views = false, print_shader = false, json = false;
  bool look_given = false;  ///< a parameter other than turn, a view or a step: the window opens with it
  bool turn_given = false;  ///< the user chose how far the model is turned: it does not turn by itself
};

/// Reads the arguments and sets the lab's parameters (--config first, then the flags). Throws Error (usage)
/// for what is unknown, with the nearest name. Nothing is returned when the help was asked for and printed.
std::optional<CommandLine> read_command_line(AnyLab& lab, int argc, char** argv);

inline glm::ivec2 pixels(course::Size size) {
  return {size.width, size.height};
}
/// "640x480" in pixels. Throws Error (usage).
glm::ivec2 parse_size(const std::string& text);

/// The view of that name. Throws Error (usage) when the lab does not have it.
View find_view(const AnyLab& lab, const std::string& name);

/// The lab's parameter that names its model file, or null.
params::Parameter* model_parameter(params::Set& parameters);

}  // namespace texel::app
