// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "panel.hpp"

namespace texel::app {
namespace {

using grade::Status;

const ImVec4 kGreen(0.45F, 0.85F, 0.50F, 1), kYellow(1.0F, 0.78F, 0.35F, 1), kDim(0.62F, 0.66F, 0.72F, 1);

void wrapped(const ImVec4& colour, const std::string& text) {
  if (text.empty()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::TextWrapped("%s", text.c_str());
  ImGui::PopStyleColor();
}

/// "12.3 degrees (limit 0.05)".
std::string figure(const grade::StepResult& step) {
  const grade::CaseResult* telling = grade::telling_case(step);
  if (telling == nullptr || std::isnan(telling->error)) return "nothing to compare";
  return fmt::format("{:.3g} {} (limit {:g})", telling->error, name_of(telling->unit()), telling->limit);
}

/// Sets the case's look and shows its pictures.
void pick(AnyLab& lab, WindowState& state, const grade::StepResult& step, const grade::CaseResult& one) {
  try {
    lab.parameters().reset();
    for (const auto& [parameter, value] : one.settings) lab.parameters().at(parameter).set(value);
    if (!one.is_mesh()) state.view = one.view;
    state.split.reset();
    state.paused = true;
    state.message.clear();
  } catch (const Error& error) {
    state.message = error.what();
  }
  state.case_pictures = load_case(step.id, one);
}

void step_details(AnyLab& lab, WindowState& state, const grade::StepResult& step) {
  wrapped(kDim, fmt::format("{}:{}", step.file, step.line));
  if (step.status != Status::passed) wrapped(ImVec4(1, 1, 1, 1), step.message);
  if (!step.mistake_says.empty()) wrapped(kYellow, "This looks like: " + step.mistake_says);
  std::size_t& shown = state.hints[step.id];
  for (std::size_t i = 0; i < std::min(shown, step.hints.size()); ++i)
    wrapped(kDim, fmt::format("{}. {}", i + 1, step.hints[i]));
  if (shown < step.hints.size() && step.status != Status::passed &&
      ImGui::SmallButton(fmt::format("hint {} of {}", shown + 1, step.hints.size()).c_str()))
    ++shown;
  for (const grade::CaseResult& one : step.cases) {
    const bool is_picked = state.case_pictures && state.case_pictures->name == one.name;
    ImGui::PushStyleColor(ImGuiCol_Text, one.passed() ? kGreen : kYellow);
    if (ImGui::Selectable(fmt::format("{} {}", one.passed() ? "right" : "wrong", one.name).c_str(),
                          is_picked))
      pick(lab, state, step, one);
    ImGui::PopStyleColor();
    if (ImGui::IsItemHovered())
      ImGui::SetTooltip("Click to set this look and show the expected picture beside yours");
  }
}

}  // namespace

void steps_section(AnyLab& lab, WindowState& state) {
  if (!state.steps || !ImGui::CollapsingHeader("Steps", ImGuiTreeNodeFlags_DefaultOpen)) return;
  const std::vector<grade::StepResult>& steps = state.steps->steps();
  if (!state.steps->fault().empty()) wrapped(kYellow, "Not checked: " + state.steps->fault());
  if (steps.empty() && state.steps->fault().empty()) ImGui::TextColored(kDim, "checking");
  bool has_next = false;
  for (const grade::StepResult& step : steps) {
    const bool is_done = step.status == Status::passed, is_open = step.status == Status::failed;
    const bool is_next = is_open && !has_next;
    has_next = has_next || is_next;
    ImGui::PushStyleColor(ImGuiCol_Text, is_done ? kGreen : is_next ? kYellow : kDim);
    const bool shows = ImGui::TreeNodeEx(step.id.c_str(), ImGuiTreeNodeFlags_SpanAvailWidth, "%s %s %s",
                                         is_done                          ? "done"
                                         : step.status == Status::skipped ? "waits"
                                         : is_next                        ? "next"
                                                                          : "to do",
                                         step.id.c_str(), step.title.c_str());
    ImGui::PopStyleColor();
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s\n%s", step.title.c_str(), figure(step).c_str());
    if (is_open && !shows) wrapped(kDim, "      off by " + figure(step));
    if (!shows) continue;
    step_details(lab, state, step);
    ImGui::TreePop();
  }
}

void pick_step(AnyLab& lab, WindowState& state, const grade::StepResult& step) {
  if (const grade::CaseResult* telling = grade::telling_case(step)) pick(lab, state, step, *telling);
}

void draw_case(WindowState& state, glm::vec2 size, float scale) {
  if (!state.case_pictures) return;
  CasePictures& pictures = *state.case_pictures;
  const float side = std::min({320 * scale, 0.8F * size.x, 0.6F * size.y});
  ImGui::SetNextWindowPos({state.panel_width + size.x - 12 * scale, size.y - 12 * scale}, ImGuiCond_Appearing,
                          {1, 1});
  bool is_open = true;
  ImGui::Begin(
      fmt::format("{} {}###case", pictures.step, pictures.name).c_str(), &is_open,
      ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse);
  if (!pictures.fault.empty()) {
    ImGui::PushTextWrapPos(side);
    ImGui::TextUnformatted(pictures.fault.c_str());
    ImGui::PopTextWrapPos();
  } else {
    using Shown = CasePictures::Shown;
    const auto choose = [&](const char* name, Shown value) {
      if (value != Shown::split) ImGui::SameLine();
      if (ImGui::RadioButton(name, pictures.shown == value)) pictures.shown = value;
    };
    choose("yours | expected", Shown::split), choose("difference", Shown::difference);
    choose("heat map", Shown::heat_map);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = side * static_cast<float>(pictures.height) / static_cast<float>(pictures.width);
    const auto show = [&](const gl::Texture& texture, float from, float to) {
      const auto id = ImTextureID(std::uintptr_t{texture.id()});  // a pointer, since ImGui 1.91 a number
      // Bottom row first: v runs upwards.
      ImGui::GetWindowDrawList()->AddImage(id, {at.x + from * side, at.y}, {at.x + to * side, at.y + height},
                                           {from, 1}, {to, 0});
    };
    if (pictures.shown == Shown::split) {
      show(pictures.own, 0, pictures.position);
      show(pictures.expected, pictures.position, 1);
      const float x = at.x + pictures.position * side;
      ImGui::GetWindowDrawList()->AddLine({x, at.y}, {x, at.y + height}, IM_COL32_WHITE, scale);
    } else {
      show(pictures.shown == Shown::difference ? pictures.difference : pictures.heat_map, 0, 1);
    }
    ImGui::Dummy({side, height});
    ImGui::SetNextItemWidth(side);
    if (pictures.shown == Shown::split)
      ImGui::SliderFloat("##position", &pictures.position, 0, 1, "", ImGuiSliderFlags_AlwaysClamp);
  }
  ImGui::End();
  if (!is_open) state.case_pictures.reset();
}

}  // namespace texel::app
