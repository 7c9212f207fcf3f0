// SPDX-License-Identifier: MIT
// What stands over the picture.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "panel.hpp"
#include "theme.hpp"

namespace texel::window {
namespace {

constexpr ImGuiWindowFlags kPlate = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                    ImGuiWindowFlags_NoMove;

ImU32 color_of(FrameLine::Axis axis) {
  switch (axis) {
    case FrameLine::Axis::tangent:
      return IM_COL32(255, 80, 80, 255);
    case FrameLine::Axis::bitangent:
      return IM_COL32(90, 230, 90, 255);
    case FrameLine::Axis::normal:
      break;
  }
  return IM_COL32(110, 150, 255, 255);
}

/// Text on a plate: it can be read over any picture.
void plate(const char* id, ImVec2 at, const ImVec4& color, const std::string& text, float wrap_width,
           ImVec2 pivot) {
  ImGui::SetNextWindowPos(at, ImGuiCond_Always, pivot);
  ImGui::SetNextWindowBgAlpha(0.86F);
  ImGui::Begin(id, nullptr, kPlate | ImGuiWindowFlags_NoInputs);
  ImGui::PushTextWrapPos(wrap_width);
  ImGui::TextColored(color, "%s", text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::End();
}

/// The first message with its source line; the others on request.
Action error_plate(WindowState& state, glm::vec2 size, float scale) {
  Action action = Action::none;
  const ErrorMessage& error = state.shown_error();
  // From the left: its buttons stay where they are when it grows.
  ImGui::SetNextWindowPos({state.panel_width + 12 * scale, 12 * scale});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {size.x - 24 * scale, size.y - 24 * scale});
  ImGui::SetNextWindowBgAlpha(0.92F);
  ImGui::Begin("##error", nullptr, kPlate);
  const auto lines = [&](const ImVec4& color, const std::string& text) {
    ImGui::PushTextWrapPos(size.x - 60 * scale);
    ImGui::TextColored(color, "%s", text.c_str());
    ImGui::PopTextWrapPos();
  };
  lines(theme().wrong, error.first);
  if (!error.source_line.empty())
    lines(theme().text, fmt::format("  {} |  {}", error.line, error.source_line));
  if (!error.file.empty() && ImGui::SmallButton("Open in editor")) action = Action::open_in_editor;
  if (error.others > 0) {
    if (!error.file.empty()) ImGui::SameLine();
    std::string label = state.all_messages
                            ? "Only the first"
                            : fmt::format("{} more line{}", error.others, error.others == 1 ? "" : "s");
    if (ImGui::SmallButton(label.append("###more").c_str())) state.all_messages = !state.all_messages;
    if (state.all_messages) lines(theme().dim, error.rest);
  }
  cover_picture(state);
  ImGui::End();
  return action;
}

}  // namespace

Action draw_overlay(app::AnyLab& lab, WindowState& state, glm::vec2 size, float pixels_per_unit,
                    float scale) {
  ImDrawList& canvas = *ImGui::GetBackgroundDrawList();
  const float origin = state.panel_width;
  if (state.split && state.view != app::View::error) {  // the error is drawn whole
    const float x = std::round(origin + state.split->position * size.x);
    canvas.AddLine({x, 0}, {x, size.y}, IM_COL32(255, 255, 255, 220), 2 * scale);
    const std::string left = lab.parameters().at(state.split->parameter).text(), right = state.split->value;
    const float y = size.y - 28 * scale, gap = 10 * scale;
    const float width = ImGui::CalcTextSize(left.c_str()).x;
    canvas.AddRectFilled({x - width - 2 * gap, y - gap / 2}, {x, size.y - gap / 2}, IM_COL32(0, 0, 0, 170));
    canvas.AddText({x - width - gap, y}, IM_COL32_WHITE, left.c_str());
    const float right_width = ImGui::CalcTextSize(right.c_str()).x;
    canvas.AddRectFilled({x, y - gap / 2}, {x + right_width + 2 * gap, size.y - gap / 2},
                         IM_COL32(0, 0, 0, 170));
    canvas.AddText({x + gap, y}, IM_COL32_WHITE, right.c_str());
  }
  for (const FrameLine& line : state.frame_lines) {
    const auto at = [&](glm::vec2 place) { return ImVec2(origin + place.x * size.x, place.y * size.y); };
    const ImU32 color = color_of(line.axis);
    canvas.AddLine(at(line.from), at(line.to), IM_COL32(0, 0, 0, 160), 3.5F * scale);
    canvas.AddLine(at(line.from), at(line.to), color, 2 * scale);
  }
  for (const auto& [axis, name] : {std::pair(FrameLine::Axis::tangent, "T"),
                                   {FrameLine::Axis::bitangent, "B"},
                                   {FrameLine::Axis::normal, "N"}})
    if (std::ranges::find(state.frame_lines, axis, &FrameLine::axis) != state.frame_lines.end())
      canvas.AddText({origin + (12 + 16 * static_cast<float>(axis)) * scale, 10 * scale}, color_of(axis),
                     name);
  if (state.inspected && state.error.first.empty()) {  // the last good picture may have another size
    const glm::vec2 pixel = glm::vec2(state.inspected->pixel) + 0.5F;
    const ImVec2 at(origin + pixel.x / pixels_per_unit, size.y - pixel.y / pixels_per_unit);
    canvas.AddCircle(at, 5 * scale, IM_COL32(0, 0, 0, 255), 16, 3 * scale);
    canvas.AddCircle(at, 5 * scale, IM_COL32(255, 255, 255, 255), 16, 1.5F * scale);
  }
  Action action = Action::none;
  if (!state.shown_error().first.empty()) {
    action = error_plate(state, size, scale);
  } else {
    std::string text;
    for (const std::string& warning : state.record.warnings)
      text.append(text.empty() ? "" : "\n").append(warning);
    if (!text.empty())
      plate("##warnings", {origin + size.x - 12 * scale, size.y - 12 * scale}, theme().next, text,
            size.x * 0.8F, {1, 1});
    if (!state.no_truth.empty())
      plate("##no truth", {origin + size.x / 2, size.y / 2}, theme().text, state.no_truth, size.x * 0.8F,
            {0.5F, 0.5F});
  }
  if (state.quit_asked)
    plate("##quit", {origin + size.x / 2, size.y / 4}, theme().text, "Press Esc again to quit", size.x * 0.8F,
          {0.5F, 0.5F});
  return action;
}

}  // namespace texel::window
