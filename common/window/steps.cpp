// SPDX-License-Identifier: MIT
// The section "Steps" of the panel, and the line of the whole course.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "panel.hpp"

namespace texel::window {
namespace {

using judge::Status;

/// A text that marks code with `, without these marks.
void wrapped_plain(const ImVec4& color, const std::string& text) {
  wrapped_text(color, course::without_markdown(text));
}

std::string figure(const judge::StepResult& step) {
  const judge::CaseResult* telling = judge::clearest_case(step);
  return telling == nullptr || std::isnan(telling->error) ? "nothing to compare" : off_by(*telling);
}

void step_details(app::AnyLab& lab, WindowState& state, const judge::StepResult& step) {
  wrapped_plain(theme().dim, fmt::format("{}:{}", step.file, step.line));
  const std::string open = state.case_pictures ? state.case_pictures->result.name : "";
  const auto picked = std::ranges::find(step.cases, open, &judge::CaseResult::name);
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

std::string off_by(const judge::CaseResult& one) {
  return fmt::format("off by {:.3g} {} (limit {:g})", one.error, name_of(one.unit()), one.limit);
}

void steps_section(app::AnyLab& lab, WindowState& state) {
  if (!state.steps) return;
  const std::vector<judge::StepResult>& steps = state.steps->found().steps;
  const auto done = std::ranges::count(steps, Status::passed, &judge::StepResult::status);
  const bool are_all = done > 0 && done == std::ssize(steps);
  // They fold when the last one is done, and open when one no longer is.
  if (std::exchange(state.all_steps_done, are_all) != are_all) ImGui::SetNextItemOpen(!are_all);
  const std::string count = steps.empty() ? "" : fmt::format(": {} of {} done", done, steps.size());
  ImGui::PushStyleColor(ImGuiCol_Text, are_all ? theme().good : theme().text);
  const bool is_open =
      ImGui::CollapsingHeader(fmt::format("Steps{}###steps", count).c_str(), ImGuiTreeNodeFlags_DefaultOpen);
  ImGui::PopStyleColor();
  if (!is_open) return;
  const std::string& fault = state.steps->found().fault;
  if (!fault.empty())
    wrapped_plain(theme().next, "Not checked: " + fault);
  else if (steps.empty())
    ImGui::TextColored(theme().dim, "checking");
  const judge::StepResult* next = judge::next_step(steps);
  for (const judge::StepResult& step : steps) {
    const bool is_done = step.status == Status::passed, is_wrong = step.status == Status::failed;
    const bool is_next = &step == next;
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
    const std::string waits = step.spoilt_by.empty() ? "" : " (for " + judge::listed(step.spoilt_by) + ")";
    wrapped_plain(color,
                  fmt::format("{} {} {}{}", judge::word_of(step, is_next), step.id, step.title, waits));
    if (is_wrong && !shows && !step.is_untouched()) {
      ImGui::Indent();
      wrapped_plain(theme().dim, figure(step));
      ImGui::Unindent();
    }
    if (!shows) continue;
    step_details(lab, state, step);
    ImGui::TreePop();
  }
}

void course_line(const std::vector<judge::StepResult>& course, int lab) {
  if (course.empty()) return;
  const float unit = ImGui::GetFontSize() / 2,
              width = ImGui::GetContentRegionAvail().x / static_cast<float>(course.size());
  ImVec2 from = ImGui::GetCursorScreenPos();
  const judge::StepResult* next = judge::next_step(course);
  const ImVec4& border = ImGui::GetStyleColorVec4(ImGuiCol_Border);  // seen in both themes
  for (const judge::StepResult& step : course) {
    const bool is_done = step.passed(), is_next = &step == next;
    const float height = std::stoi(step.id) == lab ? 1.5F * unit : unit;
    const ImVec4& color = is_done ? theme().good : is_next ? theme().next : border;
    ImGui::GetWindowDrawList()->AddRectFilled({from.x, from.y + 1.5F * unit - height},
                                              {from.x + width - 1, from.y + 1.5F * unit},
                                              ImGui::GetColorU32(color));
    if (ImGui::IsMouseHoveringRect(from, {from.x + width, from.y + 2 * unit}))
      ImGui::SetTooltip("%s %s: %s", step.id.c_str(), step.title.c_str(), judge::word_of(step, is_next));
    from.x += width;
  }
  ImGui::Dummy({0, 2 * unit});
  const auto done = std::ranges::count_if(course, &judge::StepResult::passed);
  const std::string left = next == nullptr ? ""
                                           : fmt::format(", next {}, {:.0f} h left", next->id,
                                                         std::ceil(judge::hours_left(course)));
  wrapped_text(theme().dim, fmt::format("{} of {} steps right{}", done, course.size(), left));
}

void set_look(app::AnyLab& lab, WindowState& state, const course::Case& look) {
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

void pick_case(app::AnyLab& lab, WindowState& state, const judge::StepResult& step,
               const judge::CaseResult& one) {
  set_look(lab, state, one.is_mesh() ? state.steps->look_of(step.id) : one);
  state.case_pictures = state.steps->load_case(step, one);
  state.case_is_new = true;
}

void pick_step(app::AnyLab& lab, WindowState& state, const judge::StepResult& step) {
  if (const judge::CaseResult* telling = judge::clearest_case(step)) pick_case(lab, state, step, *telling);
}

}  // namespace texel::window
