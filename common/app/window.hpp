// SPDX-License-Identifier: MIT
#pragma once
#include "canvas.hpp"
#include "command_line.hpp"

namespace texel::app {

/// Opens the lab's window and runs until it is closed.
void run_window(AnyLab& lab, const Assets& assets, const CommandLine& line);

}  // namespace texel::app
