// SPDX-License-Identifier: MIT
// The gallery's looks with their small pictures, and what opens over the picture: these, and the list of
// keys.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/settings.hpp"
#include "core/error.hpp"
#include "panel.hpp"

namespace texel::window {
namespace {

constexpr ImGuiWindowFlags kFlags = kPlaced | ImGuiWindowFlags_NoResize;

/// A small picture with its name; true when it was clicked.
bool look_button(const Looks::Entry& entry, bool is_drawn, ImVec2 size) {
  const ImVec2 at = ImGui::GetCursorScreenPos(), to(at.x + size.x, at.y + size.y);
  ImGui::BeginGroup();
  const bool is_clicked = ImGui::InvisibleButton(entry.look.name.c_str(), size);
  const bool is_hovered = ImGui::IsItemHovered();
  tooltip(entry.look.caption, entry.fault);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (is_drawn && entry.fault.empty())
    draw_texture(entry.picture, at, to);
  else
    list.AddRectFilled(at, to, ImGui::GetColorU32(ImGuiCol_FrameBg));
  list.AddRect(at, to, ImGui::GetColorU32(is_hovered ? theme().next : theme().dim), 0, 0,
               is_hovered ? 2.0F : 1.0F);
  ImGui::TextColored(entry.fault.empty() ? theme().text : theme().next, "%s", entry.look.name.c_str());
  ImGui::EndGroup();
  return is_clicked;
}

/// The value right of the line of an opening; none of another look.
std::optional<app::Canvas::Split> split_of(const course::Look& look) {
  if (!look.right) return {};
  return app::Canvas::Split{look.right->parameter, look.right->value};
}

}  // namespace

Looks::Looks(app::AnyLab& lab, const app::Assets& assets) {
  const std::filesystem::path file =
      assets.shader_root().parent_path() / "labs" / lab.info().folder() / "lab.toml";
  if (!std::filesystem::exists(file)) return;
  try {
    course::Lab read = course::read_lab(file);
    for (std::vector<course::Look>* looks : {&read.openings, &read.looks})
      for (course::Look& look : *looks)
        if (std::ranges::count(lab.views(), look.view) > 0) entries.push_back({std::move(look), {}, {}});
  } catch (const Error& error) {
    fault = error.what();
  }
  std::ranges::stable_partition(entries, [](const Entry& one) { return one.look.right || one.look.hero; });
}

void Looks::draw_next(gl::Context& context, const app::Assets& assets, app::AnyLab& lab) {
  Entry& next = entries[drawn++];
  next.fault.clear();
  const app::KeptValues before(lab.parameters());
  try {
    app::View view{};
    choose(next.look, lab, view);
    app::Canvas canvas(context, assets, lab);  // the window's own keeps its picture
    canvas.draw(view, kSize, 4, split_of(next.look));
    next.picture = picture_texture(canvas.read8());
  } catch (const Error& error) {
    next.fault = error.what();
  }
}

void choose_look(app::AnyLab& lab, WindowState& state, std::size_t index) {
  const course::Look& look = state.looks->entries[index].look;
  choose(look, lab, state.view);
  // One that says how far the model is turned would turn away from what it shows.
  for (const auto& [parameter, value] : look.settings) state.paused |= parameter == "turn";
  state.look = index;
  state.split = split_of(look);
  state.message = look.caption;
}

void choose(const course::Case& look, app::AnyLab& lab, app::View& view) {
  app::check_settings(lab.parameters(), look.settings);
  lab.parameters().reset();
  for (const auto& [parameter, value] : look.settings) lab.parameters().at(parameter).set(value);
  view = look.view;
}

void draw_looks(app::AnyLab& lab, WindowState& state, glm::vec2 size, float scale) {
  if (!state.looks_open) return;
  const float margin = 12 * scale;
  const ImVec2 largest(size.x - 2 * margin, size.y - 2 * margin);
  ImGui::SetNextWindowPos({state.panel_width + margin, margin});
  ImGui::SetNextWindowSizeConstraints({largest.x, 0}, largest);
  ImGui::SetNextWindowSize({largest.x, 0});  // as high as the pictures
  const std::vector<Looks::Entry>& entries = state.looks->entries;
  const std::size_t drawn = state.looks->drawn;
  const std::string progress =
      state.looks->are_drawn() ? "" : fmt::format(": drawing {} of {}", drawn + 1, entries.size());
  ImGui::Begin(fmt::format("Looks{}###looks", progress).c_str(), &state.looks_open, kFlags);
  const float room = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemSpacing.x;
  const float columns = std::clamp(
      std::floor((room + gap) / (static_cast<float>(Looks::kSize.x) * scale * 0.8F + gap)), 1.0F, 5.0F);
  const float width = (room - (columns - 1) * gap) / columns;
  const ImVec2 picture(width, width * Looks::kSize.y / Looks::kSize.x);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (i % static_cast<std::size_t>(columns) != 0) ImGui::SameLine();
    if (!look_button(entries[i], i < drawn, picture)) continue;
    try {
      choose_look(lab, state, i);
    } catch (const Error& error) {
      state.message = error.what();
    }
    state.looks_open = false;
  }
  ImGui::End();
}

void draw_keys(WindowState& state, glm::vec2 size) {
  if (!state.keys_open) return;
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({std::min(state.panel_width + size.x / 2, window.x / 2), window.y / 2},
                          ImGuiCond_Always, {0.5F, 0.5F});
  ImGui::SetNextWindowFocus();
  ImGui::Begin("Keys and mouse", &state.keys_open, kFlags | ImGuiWindowFlags_AlwaysAutoResize);
  if (ImGui::BeginTable("keys", 4, ImGuiTableFlags_SizingFixedFit)) {
    const auto row = [](const char* shown, const char* what) {
      ImGui::TableNextColumn();
      ImGui::TextColored(theme().next, "%s", shown);
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(what);
    };
    for (const Key& key : kKeys) row(key.shown, key.what);
    row("Tab, arrows", "from one control to the next"), row("Enter", "press or open it");
    row("drag", "orbit"), row("right drag", "move the light");
    row("wheel", "zoom"), row("click", "inspect a pixel");
    row("drop a file", "an OBJ model or a picture");
    ImGui::EndTable();
  }
  ImGui::End();
}

}  // namespace texel::window
