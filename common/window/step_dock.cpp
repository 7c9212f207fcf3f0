// SPDX-License-Identifier: MIT
// The step beside the picture: its lines, what the handout says of them, and yours beside the expected
// picture.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "panel.hpp"

namespace texel::window {
namespace {

/// The step's question, and the answer to the choice that was made.
void question_part(CasePictures& p) {
  wrapped_text(theme().text, p.text.question);
  for (std::size_t i = 1; i <= p.text.choices.size(); ++i) {
    if (ImGui::RadioButton(fmt::format("##choice{}", i).c_str(), p.chosen == i)) p.chosen = i;
    ImGui::SameLine();
    wrapped_text(theme().text, p.text.choices[i - 1]);
    if (p.chosen == i && i <= p.text.answers.size()) wrapped_text(theme().dim, p.text.answers[i - 1]);
  }
}

/// The step's lines, and what stands before them.
void code_part(const course::StepText& text) {
  ImGui::PushFont(Gui::code_font);
  for (const auto& [number, line, is_given] : text.lines) {
    ImGui::TextColored(theme().dim, "%4d", number);
    const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
    if (indent == line.size()) continue;
    // What does not fit goes on below, indented as the line is.
    ImGui::SameLine(0, ImGui::CalcTextSize(std::string(indent + 1, ' ').c_str()).x);
    wrapped_text(is_given ? theme().dim : theme().text, line.substr(indent));
  }
  ImGui::PopFont();
}

/// The file, a button that opens it, and what the handout says, beside the code. The chosen tab stays.
void text_part(WindowState& state) {
  const course::StepText& text = state.case_pictures->text;
  if (ImGui::SmallButton("Open in editor")) state.wanted = Action::open_in_editor;
  tooltip("By $VISUAL, else by code -g (E)");
  ImGui::SameLine();
  if (ImGui::SmallButton("See it")) state.wanted = Action::see_step;
  tooltip("Sets the look in which the handout shows this step");
  wrapped_text(theme().good, text.after);
  const auto tab = [&](const char* name, const auto& part) {
    if (!ImGui::BeginTabItem(name)) return;
    if (ImGui::BeginChild(name)) part();
    ImGui::EndChild();
    ImGui::EndTabItem();
  };
  if (!ImGui::BeginTabBar("step")) return;
  tab("Predict", [&] { question_part(*state.case_pictures); });
  tab("Task", [&] { wrapped_text(theme().text, text.task); });
  tab("Code", [&] {
    wrapped_text(theme().dim, fmt::format("{}:{}", text.shown_file, text.line));
    code_part(text);
  });
  ImGui::EndTabBar();
}

/// The figure that the step is judged by: a ring marks a pixel that has it.
std::string caption(const CasePictures& p) {
  const image::Difference& found = p.compared.figures;
  if (found.non_finite > 0)
    return fmt::format("{} pixels are not finite (green in the difference)", found.non_finite);
  const judge::CaseResult& one = p.result;
  if (found.max == 0) return fmt::format("equal to the expected picture; limit {:g}", one.limit);
  return one.passed() ? "right: " + off_by(one) : "wrong: " + off_by(one) + ", as in the ring";
}

void picture_part(CasePictures& p, float side, float scale) {
  const float height = side * p.aspect();
  const auto show = [&](const gl::Texture& texture, float from, float to) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    draw_texture(texture, {at.x + from * side, at.y}, {at.x + to * side, at.y + height}, {from, 1}, {to, 0});
  };
  if (p.result.is_mesh()) {
    show(p.expected, 0, 1);
    ImGui::Dummy({side, height});
    return wrapped_text(theme().dim, "Before | right. Yours is the large picture, in the same look.");
  }
  if (ImGui::RadioButton("yours | expected", !p.shows_difference)) p.shows_difference = false;
  ImGui::SameLine();
  if (ImGui::RadioButton("difference", p.shows_difference)) p.shows_difference = true;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (p.shows_difference) {
    show(p.difference, 0, 1);
  } else {
    show(p.own, 0, p.position);
    show(p.expected, p.position, 1);
    const float x = at.x + p.position * side;
    list.AddLine({x, at.y}, {x, at.y + height}, IM_COL32_WHITE, 1);
  }
  if (const image::Difference& found = p.compared.figures; !p.result.passed() && found.max > 0) {
    const float pixel = side / static_cast<float>(p.compared.own.width);  // the one that has the error
    const ImVec2 place(at.x + (static_cast<float>(found.telling_x) + 0.5F) * pixel,
                       at.y + height - (static_cast<float>(found.telling_y) + 0.5F) * pixel);
    list.AddCircle(place, 7 * scale, IM_COL32_BLACK, 0, 4 * scale);
    list.AddCircle(place, 7 * scale, IM_COL32(255, 64, 255, 255), 0, 2 * scale);
  }
  // The picture is a slider: the line follows the mouse.
  ImGui::InvisibleButton("##picture", {side, height});
  if (ImGui::IsItemActive() && !p.shows_difference)
    p.position = std::clamp((ImGui::GetIO().MousePos.x - at.x) / side, 0.0F, 1.0F);
  if (p.shows_difference) draw_legend(p.legend, p.legend_picture, scale);
  wrapped_text(theme().dim, caption(p));
}

}  // namespace

glm::vec2 dock_size(const WindowState& state, glm::vec2 size, float scale) {
  if (!state.case_pictures) return {0, 0};
  if (size.x > 1.3F * size.y) return {std::min(420 * scale, 0.45F * size.x), 0};
  return {0, std::min(340 * scale, 0.5F * size.y)};
}

void draw_step(WindowState& state, glm::vec2 window, float scale) {
  if (!state.case_pictures || state.dock == glm::vec2(0)) return;
  const bool is_below = state.dock.y > 0;
  const glm::vec2 at(is_below ? state.panel_width : window.x - state.dock.x,
                     is_below ? window.y - state.dock.y : 0);
  ImGui::SetNextWindowPos({at.x, at.y});
  ImGui::SetNextWindowSize({window.x - at.x, window.y - at.y});
  CasePictures& p = *state.case_pictures;
  bool is_open = true;
  const bool is_new = std::exchange(state.case_is_new, false);
  ImGui::Begin(
      fmt::format("{} {}: {}###case", p.step, course::without_markdown(p.title), p.result.name).c_str(),
      &is_open, kPlaced | ImGuiWindowFlags_NoResize);
  // The text begins at its first line, wherever the last one was scrolled to.
  if (is_new) ImGui::SetScrollY(0);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  // Below the picture: its buttons, the difference's scale and two lines of text.
  const float texts = ImGui::GetFrameHeightWithSpacing() + 4 * ImGui::GetTextLineHeightWithSpacing();
  if (!p.fault.empty()) {
    // A shader's error stands over the picture already, and in one place only.
    wrapped_text(theme().next,
                 state.error.first.empty() ? p.fault : "No picture: the shader does not compile.");
    text_part(state);
  } else if (is_below) {
    const float side = std::clamp((room.y - texts) / p.aspect(), 64.0F, 0.5F * room.x);
    const float column = std::max(side, std::min(ImGui::GetFontSize() * 23, 0.54F * room.x));
    ImGui::BeginChild("text", {room.x - column - ImGui::GetStyle().ItemSpacing.x, 0});
    if (is_new) ImGui::SetScrollY(0);
    text_part(state);
    ImGui::EndChild();
    ImGui::SameLine();
    ImGui::BeginChild("pictures");
    picture_part(p, side, scale);
    ImGui::EndChild();
  } else {
    const float highest = (0.6F * room.y - texts) / p.aspect();
    picture_part(p, std::min(room.x - ImGui::GetStyle().ScrollbarSize, highest), scale);
    ImGui::Separator();
    text_part(state);
  }
  ImGui::End();
  if (!is_open) state.case_pictures.reset();
}

}  // namespace texel::window
