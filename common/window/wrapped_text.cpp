// SPDX-License-Identifier: MIT
#include "wrapped_text.hpp"

#include <algorithm>

namespace texel::window {
namespace {

/// The text with its lines' ends instead of the blanks there. A word that is too long has a line of its own.
std::string broken(const std::string& text, float width) {
  std::string lines;
  std::size_t line = 0;  // where the present one begins in `lines`
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
    lines.append(text, begin, end - begin);
    const std::size_t blank = lines.find_last_of(' ');
    if (blank != std::string::npos && blank >= line && ImGui::CalcTextSize(lines.c_str() + line).x > width) {
      lines[blank] = '\n';
      line = blank + 1;
    }
    if (end < text.size()) lines += text[end];
    if (end < text.size() && text[end] == '\n') line = lines.size();
    begin = end + 1;
  }
  return lines;
}

}  // namespace

void wrapped_text(const ImVec4& color, const std::string& text) {
  if (text.empty()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::TextWrapped("%s", broken(text, ImGui::GetContentRegionAvail().x).c_str());
  ImGui::PopStyleColor();
}

}  // namespace texel::window
