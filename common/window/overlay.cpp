// SPDX-License-Identifier: MIT
// What stands over the picture.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "panel.hpp"

namespace texel::window {
namespace {

constexpr ImGuiWindowFlags kPlate = kPlaced | ImGuiWindowFlags_NoDecoration |
                                    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;

// By FrameLine::Axis.
constexpr const char* kAxisNames[] = {"T", "B", "N"};
constexpr ImU32 kAxisColors[] = {IM_COL32(255, 80, 80, 255), IM_COL32(90, 230, 90, 255),
                                 IM_COL32(110, 150, 255, 255)};

void wrapped_to(float width, const ImVec4& color, const std::string& text) {
  ImGui::PushTextWrapPos(width);
  ImGui::TextColored(color, "%s", text.c_str());
  ImGui::PopTextWrapPos();
}

/// What can be read over any picture.
void plate(const char* id, ImVec2 at, ImVec2 pivot, const std::function<void()>& draw) {
  ImGui::SetNextWindowPos(at, ImGuiCond_Always, pivot);
  ImGui::SetNextWindowBgAlpha(0.86F);
  ImGui::Begin(id, nullptr, kPlate | ImGuiWindowFlags_NoInputs);
  draw();
  ImGui::End();
}

/// The first message with its source line; the others on request.
void error_plate(WindowState& state, glm::vec2 size, float scale) {
  const ErrorMessage& error = state.shown_error();
  // From the left: its buttons stay where they are when it grows.
  ImGui::SetNextWindowPos({state.panel_width + 12 * scale, 12 * scale});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {size.x - 24 * scale, size.y - 24 * scale});
  ImGui::SetNextWindowBgAlpha(0.92F);
  ImGui::Begin("##error", nullptr, kPlate);
  const float width = size.x - 60 * scale;
  wrapped_to(width, theme().wrong, error.first);
  if (!error.source_line.empty())
    wrapped_to(width, theme().text, fmt::format("  {} |  {}", error.line, error.source_line));
  if (!error.file.empty() && ImGui::SmallButton("Open in editor")) state.wanted = Action::open_in_editor;
  if (error.others > 0) {
    if (!error.file.empty()) ImGui::SameLine();
    std::string label = state.all_messages
                            ? "Only the first"
                            : fmt::format("{} more line{}", error.others, error.others == 1 ? "" : "s");
    if (ImGui::SmallButton(label.append("###more").c_str())) state.all_messages = !state.all_messages;
    if (state.all_messages) wrapped_to(width, theme().dim, error.rest);
  }
  ImGui::End();
}

/// What stands at the line: what the opening calls its two sides as long as these are shown, else the values.
std::pair<std::string, std::string> sides(const params::Parameter& p, const WindowState& state) {
  if (state.look) {
    const course::Look& look = state.looks->entries[*state.look].look;
    const course::Setting left{std::string(p.name), p.text()}, right{left.parameter, state.split->value};
    if (look.right == right && std::ranges::count(look.settings, left) > 0)
      return {look.sides.front(), look.sides.back()};
  }
  const std::string of = p.type == params::Parameter::Type::toggle ? label_of(p.name) + " " : "";
  return {of + p.text(), of + state.split->value};
}

}  // namespace

void draw_overlay(app::AnyLab& lab, WindowState& state, glm::vec2 size, float pixels_per_unit, float scale) {
  ImDrawList& canvas = *ImGui::GetBackgroundDrawList();
  const float origin = state.panel_width;
  if (state.split && state.view != app::View::error) {  // the error is drawn whole
    const float x = std::round(origin + state.split->position * size.x), gap = 10 * scale;
    canvas.AddLine({x, 0}, {x, size.y}, IM_COL32(255, 255, 255, 220), 2 * scale);
    // A handle says that the line can be dragged.
    const float middle = size.y / 2;
    canvas.AddCircleFilled({x, middle}, 1.3F * gap, IM_COL32(20, 21, 24, 220));
    canvas.AddCircle({x, middle}, 1.3F * gap, IM_COL32_WHITE, 0, 1.5F * scale);
    for (const float way : {-1.0F, 1.0F})
      canvas.AddTriangleFilled({x + way * 0.95F * gap, middle}, {x + way * 0.3F * gap, middle - gap / 2},
                               {x + way * 0.3F * gap, middle + gap / 2}, IM_COL32_WHITE);
    const float y = size.y - 28 * scale;
    // What a side shows, at the line.
    const auto name = [&](const std::string& side, float pivot) {
      const float width = ImGui::CalcTextSize(side.c_str()).x, left = x - pivot * (width + 2 * gap);
      canvas.AddRectFilled({left, y - gap / 2}, {left + width + 2 * gap, size.y - gap / 2},
                           IM_COL32(0, 0, 0, 225));
      canvas.AddText({left + gap, y}, IM_COL32_WHITE, side.c_str());
    };
    const auto [left, right] = sides(lab.parameters().at(state.split->parameter), state);
    name(left, 1);
    name(right, 0);
  }
  for (const FrameLine& line : state.frame_lines) {
    const auto at = [&](glm::vec2 place) { return ImVec2(origin + place.x * size.x, place.y * size.y); };
    canvas.AddLine(at(line.from), at(line.to), IM_COL32(0, 0, 0, 160), 3.5F * scale);
    canvas.AddLine(at(line.from), at(line.to), kAxisColors[static_cast<int>(line.axis)], 2 * scale);
  }
  for (int i = 0; i < 3; ++i)
    if (std::ranges::count(state.frame_lines, FrameLine::Axis(i), &FrameLine::axis) > 0)
      canvas.AddText({origin + size.x - (60 - 16 * static_cast<float>(i)) * scale, 10 * scale},
                     kAxisColors[i], kAxisNames[i]);
  if (state.inspected && state.error.first.empty()) {  // the last good picture may have another size
    const glm::vec2 pixel = glm::vec2(state.inspected->pixel) + 0.5F;
    const ImVec2 at(origin + pixel.x / pixels_per_unit, size.y - pixel.y / pixels_per_unit);
    canvas.AddCircle(at, 5 * scale, IM_COL32(0, 0, 0, 255), 16, 3 * scale);
    canvas.AddCircle(at, 5 * scale, IM_COL32(255, 255, 255, 255), 16, 1.5F * scale);
  }
  const float middle = origin + size.x / 2;
  const auto text_plate = [&](const char* id, ImVec2 at, ImVec2 pivot, const ImVec4& color,
                              const std::string& text) {
    if (!text.empty()) plate(id, at, pivot, [&] { wrapped_to(0.8F * size.x, color, text); });
  };
  if (!state.shown_error().first.empty()) {
    error_plate(state, size, scale);
  } else {
    const float margin = 12 * scale, bottom = size.y - (state.split ? 3 : 1) * margin;  // above the sides
    text_plate("##warnings", {origin + size.x - margin, bottom}, {1, 1}, theme().next,
               fmt::format("{}", fmt::join(state.record.warnings, "\n")));
    if (!state.legend.title.empty() && size.x > 260 * scale)
      plate("##legend", {origin + margin, margin}, {0, 0},
            [&] { draw_legend(state.legend, state.legend_picture, scale); });
    text_plate("##no truth", {middle, size.y / 2}, {0.5F, 0.5F}, theme().text, state.no_truth);
  }
  if (state.quit_asked)
    text_plate("##quit", {middle, size.y / 4}, {0.5F, 0.5F}, theme().text, "Press Esc again to quit");
}

}  // namespace texel::window
