// SPDX-License-Identifier: MIT
#pragma once
#include <imgui.h>

namespace texel::window {

/// The colours of the panel's texts.
struct Theme {
  ImVec4 good, next, wrong, dim, text;
  ImVec4 background;  ///< of the panel
};

/// Of the present theme.
const Theme& theme();

/// Dark or light, for all of ImGui. `scale` is the display's: 2 at twice the density.
void set_theme(bool light, float scale);

/// ImGui's font for this display: DejaVu Sans with the letters and signs of formulas where the system has it.
void load_font(float scale);

}  // namespace texel::window
