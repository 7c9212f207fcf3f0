// SPDX-License-Identifier: MIT
// What opens over the picture: the gallery's looks, and the list of keys.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "core/error.hpp"
#include "panel.hpp"
#include "theme.hpp"

namespace texel::window {
namespace {

constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove;

/// A small picture with its name; true when it was clicked.
bool look_button(const Looks::Entry& entry, ImVec2 size) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::BeginGroup();
  const bool is_clicked = ImGui::InvisibleButton(entry.look.name.c_str(), size);
  const bool is_hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (entry.is_drawn && entry.fault.empty()) {
    const auto id = ImTextureID(std::uintptr_t{entry.picture.id()});
    list.AddImage(id, at, {at.x + size.x, at.y + size.y}, {0, 1}, {1, 0});
  } else {
    list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg));
  }
  const ImVec4 frame = is_hovered ? theme().next : theme().dim;
  list.AddRect(at, {at.x + size.x, at.y + size.y}, ImGui::GetColorU32(frame), 0, 0, is_hovered ? 2.0F : 1.0F);
  ImGui::TextColored(entry.fault.empty() ? theme().text : theme().next, "%s", entry.look.name.c_str());
  ImGui::EndGroup();
  if (is_hovered) {
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
    ImGui::TextUnformatted(entry.look.caption.c_str());
    if (!entry.fault.empty()) ImGui::TextColored(theme().next, "%s", entry.fault.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
  }
  return is_clicked;
}

}  // namespace

void draw_looks(app::AnyLab& lab, WindowState& state, glm::vec2 size, float scale) {
  if (!state.looks_open || !state.looks) return;
  const float margin = 12 * scale;
  const ImVec2 largest(size.x - 2 * margin, size.y - 2 * margin);
  ImGui::SetNextWindowPos({state.panel_width + margin, margin});
  ImGui::SetNextWindowSizeConstraints({largest.x, 0}, largest);
  ImGui::SetNextWindowSize({largest.x, 0});  // as high as the pictures
  const auto& entries = state.looks->entries();
  const std::string progress =
      state.looks->drawn() < entries.size()
          ? fmt::format(": drawing {} of {}", state.looks->drawn() + 1, entries.size())
          : "";
  ImGui::Begin(fmt::format("Looks{}###looks", progress).c_str(), &state.looks_open, kFlags);
  const float room = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemSpacing.x;
  const float columns = std::clamp(
      std::floor((room + gap) / (static_cast<float>(Looks::kSize.x) * scale * 0.8F + gap)), 1.0F, 5.0F);
  const float width = (room - (columns - 1) * gap) / columns;
  const ImVec2 picture(width,
                       width * static_cast<float>(Looks::kSize.y) / static_cast<float>(Looks::kSize.x));
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (i % static_cast<std::size_t>(columns) != 0) ImGui::SameLine();
    if (!look_button(entries[i], picture)) continue;
    try {
      Looks::choose(entries[i].look, lab, state.view);
      state.look = i;
      state.split.reset();
      state.message = entries[i].look.caption;
    } catch (const Error& error) {
      state.message = error.what();
    }
    state.looks_open = false;
  }
  ImGui::End();
}

void draw_keys(WindowState& state, glm::vec2 size) {
  if (!state.keys_open) return;
  ImGui::SetNextWindowPos({state.panel_width + size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::Begin("Keys and mouse", &state.keys_open, kFlags | ImGuiWindowFlags_AlwaysAutoResize);
  const auto row = [](const char* shown, const char* what) {
    ImGui::TextColored(theme().next, "%s", shown);
    ImGui::SameLine(ImGui::GetFontSize() * 6.5F);
    ImGui::TextUnformatted(what);
  };
  for (const Key& key : keys()) row(key.shown, key.what);
  ImGui::Separator();
  for (const Gesture& gesture : gestures()) row(gesture.shown, gesture.what);
  cover_picture(state);
  ImGui::End();
}

}  // namespace texel::window
