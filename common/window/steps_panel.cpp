// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "panel.hpp"

namespace texel::window {
namespace {

using judge::Status;

/// A text that marks code with `, without these marks.
void wrapped_plain(const ImVec4& color, const std::string& text) {
  wrapped_text(color, course::without_markdown(text));
}

/// "off by 12.3 degrees (limit 0.05)".
std::string figure(const judge::StepResult& step) {
  const judge::CaseResult* telling = judge::clearest_case(step);
  if (telling == nullptr || std::isnan(telling->error)) return "nothing to compare";
  return fmt::format("off by {:.3g} {} (limit {:g})", telling->error, name_of(telling->unit()),
                     telling->limit);
}

/// Keeps the user's own look, and sets another.
void set_look(app::AnyLab& lab, WindowState& state, const course::Case& look) {
  if (!state.own_look) state.own_look = save_look(lab.parameters(), state);
  try {
    choose(look, lab, state.view);
    state.split.reset();
    state.look.reset();
    state.paused = true;
    state.message.clear();
  } catch (const Error& error) {
    state.message = error.what();
  }
}

void step_details(app::AnyLab& lab, WindowState& state, const judge::StepResult& step) {
  wrapped_plain(theme().dim, fmt::format("{}:{}", step.file, step.line));
  const auto picked = std::ranges::find_if(step.cases, [&](const judge::CaseResult& one) {
    return state.case_pictures && state.case_pictures->result.name == one.name;
  });
  const std::string& message = picked != step.cases.end() ? picked->message : step.message;
  if (step.status != Status::passed && state.shown_error().first.empty())
    wrapped_plain(theme().text, message);
  if (!step.mistake_says.empty()) wrapped_plain(theme().next, "This looks like: " + step.mistake_says);
  std::size_t& shown = state.hints[step.id];
  for (std::size_t i = 0; i < std::min(shown, step.hints.size()); ++i)
    wrapped_plain(theme().dim, fmt::format("{}. {}", i + 1, step.hints[i]));
  if (shown < step.hints.size() && step.status != Status::passed &&
      ImGui::SmallButton(fmt::format("hint {} of {}", shown + 1, step.hints.size()).c_str()))
    ++shown;
  for (const judge::CaseResult& one : step.cases) {
    ImGui::PushStyleColor(ImGuiCol_Text, one.passed() ? theme().good : theme().next);
    if (ImGui::Selectable(fmt::format("{} {}", one.passed() ? "right" : "wrong", one.name).c_str(),
                          picked != step.cases.end() && &*picked == &one))
      pick_case(lab, state, step, one);
    ImGui::PopStyleColor();
    if (ImGui::IsItemHovered())
      ImGui::SetTooltip("Click to set this look and show the expected picture beside yours");
  }
}

}  // namespace

void steps_section(app::AnyLab& lab, WindowState& state) {
  if (!state.steps || !ImGui::CollapsingHeader("Steps", ImGuiTreeNodeFlags_DefaultOpen)) return;
  const std::vector<judge::StepResult>& steps = state.steps->steps();
  const std::string& fault = state.steps->found().fault;
  if (!fault.empty())
    wrapped_plain(theme().next, "Not checked: " + fault);
  else if (steps.empty())
    ImGui::TextColored(theme().dim, "checking");
  bool has_next = false;
  for (const judge::StepResult& step : steps) {
    const bool is_done = step.status == Status::passed, is_open = step.status == Status::failed;
    const bool is_next = is_open && !has_next;
    has_next = has_next || is_next;
    const std::string title = course::without_markdown(step.title);
    const ImVec4& color = is_done ? theme().good : is_next ? theme().next : theme().dim;
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    if (state.step_to_open == step.id) {
      ImGui::SetNextItemOpen(true);
      state.step_to_open.clear();
    }
    const bool shows = ImGui::TreeNodeEx(step.id.c_str(), ImGuiTreeNodeFlags_SpanAvailWidth, "%s", "");
    ImGui::PopStyleColor();
    if (ImGui::IsItemToggledOpen() && shows) pick_step(lab, state, step);
    if (ImGui::IsItemHovered() && is_done) ImGui::SetTooltip("%s", figure(step).c_str());
    ImGui::SameLine();  // the title beside the triangle: a tree node's own text is not wrapped
    wrapped_plain(color, fmt::format("{} {} {}", judge::word_of(step, is_next), step.id, title));
    if (is_open && !shows && !step.is_untouched()) {
      ImGui::Indent();
      wrapped_plain(theme().dim, figure(step));
      ImGui::Unindent();
    }
    if (!shows) continue;
    step_details(lab, state, step);
    ImGui::TreePop();
  }
}

void pick_case(app::AnyLab& lab, WindowState& state, const judge::StepResult& step,
               const judge::CaseResult& one) {
  set_look(lab, state, one.is_mesh() ? state.steps->look_of(step.id) : one);
  state.case_pictures = load_case(state.steps->root(), lab.info().folder(), step, one);
  state.case_is_new = true;
}

void see_step(app::AnyLab& lab, WindowState& state, const std::string& step) {
  set_look(lab, state, state.steps->look_of(step));
}

void pick_step(app::AnyLab& lab, WindowState& state, const judge::StepResult& step) {
  if (const judge::CaseResult* telling = judge::clearest_case(step)) pick_case(lab, state, step, *telling);
}

}  // namespace texel::window
