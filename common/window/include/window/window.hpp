// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "app/lab.hpp"

namespace texel::window {

/// What a lab's window is asked for; the parameters' values are already in the lab.
struct WindowOptions {
  std::optional<glm::ivec2> size;
  std::string view = "color";
  std::string see;  ///< a step that the window shows first: "5.1"
  int samples = 4;
  bool look_given = false;  ///< a parameter other than turn, a view or a step: the window opens with it
  bool turn_given = false;  ///< the user chose how far the model is turned: it does not turn by itself
};

/// Opens the lab's window and runs until it is closed.
void run_window(app::AnyLab& lab, const app::Assets& assets, const WindowOptions& options);

}  // namespace texel::window
