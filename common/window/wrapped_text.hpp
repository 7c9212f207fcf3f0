// SPDX-License-Identifier: MIT
#pragma once
#include <imgui.h>

#include <string>

namespace texel::window {

/// Shows a text, broken at its blanks where the window ends: ImGui also breaks at points, as in "0.5". An
/// empty one takes no room.
void wrapped_text(const ImVec4& color, const std::string& text);

}  // namespace texel::window
