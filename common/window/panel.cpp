// SPDX-License-Identifier: MIT
#include "panel.hpp"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

namespace texel::window {
namespace {

using Type = params::Parameter::Type;

/// "bump_strength" → "bump strength"
std::string label_of(std::string_view name) {
  std::string label(name);
  for (char& c : label) c = c == '_' ? ' ' : c;
  return label;
}

/// The name of what the next widget changes, which fills the rest of the line but for `right`.
void label(const ImVec4& color, const std::string& text, std::string_view help, std::string_view more = {},
           float right = 1) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextColored(color, "%s", text.c_str());
  tooltip(help, more);
  ImGui::SameLine(ImGui::GetFontSize() * 8.6F);
  ImGui::SetNextItemWidth(-right);
}

/// A list to choose from, and what is chosen.
std::string combo(const char* id, std::span<const params::Item> items, std::string current) {
  if (!ImGui::BeginCombo(id, current.c_str(), ImGuiComboFlags_HeightLarge)) return current;
  std::string chosen = current;
  for (const params::Item& item : items) {
    if (ImGui::Selectable(item.name, current == item.name)) chosen = item.name;
    tooltip(item.help);
  }
  ImGui::EndCombo();
  return chosen;
}

void number_widget(params::Parameter& p) {
  const auto least = static_cast<float>(p.least), most = static_cast<float>(p.most);
  std::string format = p.unit == "degrees" ? "%.1f\xC2\xB0" : "%.4g";
  if (p.unit != "degrees" && !p.unit.empty()) format.append(" ").append(p.unit);
  ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoRoundToFormat;
  if (p.scale == params::Scale::logarithmic) flags |= ImGuiSliderFlags_Logarithmic;
  if (p.type == Type::integer) {
    int value = static_cast<int>(p.value());
    if (ImGui::SliderInt("##value", &value, static_cast<int>(least), static_cast<int>(most), "%d", flags))
      p.set_value(value);
    return;
  }
  auto value = static_cast<float>(p.value());
  if (ImGui::SliderFloat("##value", &value, least, most, format.c_str(), flags))
    p.set_value(static_cast<double>(value));
}

/// One parameter: its name, its widget, and a button that takes it back when it is not the default.
void parameter_widget(params::Parameter& p) {
  ImGui::PushID(p.name.data());
  const bool is_default = p.is_default();
  const std::string range = p.is_ranged() ? fmt::format(", {} to {} {}", p.least, p.most, p.unit) : "";
  label(is_default ? theme().text : theme().next, label_of(p.name), p.help,
        fmt::format("--{}, default {}{}\nCtrl+click a slider to type a value", p.flag(), p.initial(), range),
        is_default ? 1 : ImGui::GetFontSize() * 3.4F);
  if (p.type == Type::toggle) {
    bool on = p.value() != 0;
    if (ImGui::Checkbox("##value", &on)) p.set_value(on ? 1 : 0);
  } else if (p.is_ranged()) {
    number_widget(p);
  } else {
    if (const std::string chosen = combo("##value", p.items, p.text()); chosen != p.text()) p.set(chosen);
    tooltip(p.help);
  }
  if (!is_default) {
    ImGui::SameLine();
    if (ImGui::SmallButton("reset")) p.reset();
    tooltip(fmt::format("back to {}", p.initial()));
  }
  ImGui::PopID();
}

void parameters_section(params::Set& parameters) {
  std::string_view section = "\n";
  bool open = true;
  for (params::Parameter& p : parameters) {
    if (p.section != section) {
      section = p.section;
      // The mouse moves the camera: its numbers are seldom wanted.
      const bool starts_open = section != "Camera";
      open = section.empty() ||
             ImGui::CollapsingHeader(section.data(), starts_open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
    }
    if (open) parameter_widget(p);
  }
}

void view_section(app::AnyLab& lab, WindowState& state) {
  if (!ImGui::CollapsingHeader("View", ImGuiTreeNodeFlags_DefaultOpen)) return;
  for (const app::View view : lab.views()) {
    if (view != lab.views().front()) ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x < ImGui::GetFontSize() * 6) ImGui::NewLine();
    if (ImGui::RadioButton(name_of(view), state.view == view)) state.view = view;
  }

  if (state.figures) {
    const app::ErrorFigures& f = *state.figures;
    const app::Measure measure = *lab.measure();
    wrapped_text(
        theme().text,
        f.reason != nullptr
            ? f.reason
            : fmt::format("mean {:.3g}, P99 {:.3g}, most {:.3g} {} over {:.1f} % of {} pixels", f.mean, f.p99,
                          f.max, name_of(measure.unit), 100 * f.coverage(), f.truth_pixels));
    wrapped_text(f.non_finite == 0 ? theme().dim : theme().wrong,
                 fmt::format("{} not finite; compared with {}", f.non_finite, measure.truth));
  }

  // Compare: another value of one choice or toggle right of a line.
  const std::string current = state.split ? label_of(state.split->parameter) : "nothing";
  label(theme().text, "compare",
        "Draws the right part of the picture with another value of a parameter. Drag the line.");
  if (ImGui::BeginCombo("##compare", current.c_str())) {
    if (ImGui::Selectable("nothing", !state.split)) state.split.reset();
    for (const params::Parameter& p : lab.parameters()) {
      if (p.is_ranged()) continue;
      if (!ImGui::Selectable(label_of(p.name).c_str())) continue;
      const std::string other = p.type == Type::toggle
                                    ? (p.value() != 0 ? "off" : "on")
                                    : p.items[p.text() == p.items[0].name ? p.items.size() - 1 : 0].name;
      state.split = app::Canvas::Split{std::string(p.name), other, 0.5F};
    }
    ImGui::EndCombo();
  }
  if (!state.split) return;
  const params::Parameter& p = lab.parameters().at(state.split->parameter);
  if (p.type == Type::toggle) return;
  label(theme().text, "right side", "The value right of the line");
  state.split->value = combo("##right", p.items, state.split->value);
}

std::string bytes_text(long long bytes) {
  if (bytes < 10'000) return fmt::format("{} B", bytes);
  return bytes < 10'000'000 ? fmt::format("{:.0f} kB", static_cast<double>(bytes) / 1e3)
                            : fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

void statistics_section(const WindowState& state) {
  if (!ImGui::CollapsingHeader("Statistics", ImGuiTreeNodeFlags_DefaultOpen)) return;
  const gl::Record& record = state.record;
  long long attribute_bytes = 0, texture_bytes = 0;
  for (const auto& use : record.attributes) attribute_bytes += use.bytes;
  for (const auto& use : record.textures) texture_bytes += use.bytes;
  ImGui::Text("%.1f ms a frame, %d draw call%s", state.frame_milliseconds, record.draw_calls,
              record.draw_calls == 1 ? "" : "s");
  ImGui::Text("%lld triangles, %lld vertices", record.triangles, record.vertices);
  ImGui::Text("%s of attributes, %s of textures", bytes_text(attribute_bytes).c_str(),
              bytes_text(texture_bytes).c_str());
  for (const auto& use : record.attributes)
    ImGui::TextColored(theme().dim, "  %s  %s", use.name.c_str(), bytes_text(use.bytes).c_str());
  for (const auto& use : record.textures)
    ImGui::TextColored(theme().dim, "  %s  %dx%d %s", use.name.c_str(), use.width, use.height,
                       use.format.c_str());
  for (const std::string& warning : state.notes.warnings) wrapped_text(theme().next, warning);
  for (const std::string& fact : state.notes.facts) wrapped_text(theme().dim, fact);
}

void buttons(WindowState& state) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const auto width_of = [&](const char* label) {
    return ImGui::CalcTextSize(label).x + 2 * style.FramePadding.x;
  };
  const auto button = [&](const char* label, Action value, const char* help, bool is_first = false) {
    // On the same line while there is room.
    if (!is_first) ImGui::SameLine();
    if (!is_first && ImGui::GetContentRegionAvail().x < width_of(label)) ImGui::NewLine();
    if (ImGui::Button(label)) state.wanted = value;
    tooltip(help);
  };
  const bool has_looks = !state.looks->entries.empty();
  if (has_looks)
    button("Looks", Action::show_looks, "Small pictures of the gallery's looks: click one to have it (G)",
           true);
  button("Default", Action::default_look, "Sets the look with which the lab opens (J)", !has_looks);
  button("Undo", Action::undo, "Takes back the last change of a parameter (Ctrl+Z)");
  button("Redo", Action::redo, "Makes it again (Ctrl+Y)");
  button("Keys", Action::show_keys, "All keys (F1)");
  button(state.light_theme ? "Dark" : "Light", Action::toggle_theme, "Changes the panel's colours");
  button("Snapshot", Action::snapshot,
         "Writes the picture into the folder where you started the program (F12)", true);
  button("Copy", Action::copy_picture, "Copies the picture into the clipboard (Ctrl+C)");
  button("Command", Action::copy_command_line, "Copies the command that draws this look");
  button("Turntable", Action::turntable,
         "Writes 36 pictures of one turn into the folder where you started the program");
  ImGui::SetNextItemWidth(-width_of("Save") - width_of("Load") - 2 * style.ItemSpacing.x);
  ImGui::InputText("##config", &state.config_file);
  tooltip("The file for Save and Load: all parameters, in the format of --config");
  button("Save", Action::save_config, "Writes all parameters to the file");
  button("Load", Action::load_config, "Reads parameters from the file");
}

/// Two lines of text below a line.
float status_bar_height() {
  return 2 * ImGui::GetTextLineHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
}

/// What happens, and what the last action did: at the lower end, where it moves nothing.
void status_bar(const WindowState& state) {
  ImGui::Separator();
  std::string text;
  for (const std::string& line : {state.message, state.progress, state.steps ? state.steps->progress() : ""})
    if (!line.empty()) text.append(text.empty() ? "" : "\n").append(line);
  ImGui::BeginChild("status", {0, 0}, 0, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  if (state.built_again) wrapped_text(theme().next, "The lab was built again: F5 opens it anew");
  wrapped_text(theme().dim, text);
  if (!text.empty() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text.c_str());
  ImGui::EndChild();
}

}  // namespace

SavedLook save_look(const params::Set& parameters, const WindowState& state) {
  SavedLook saved{{}, state.view, state.look};
  for (const params::Parameter& p : parameters) saved.values.push_back(p.name == "turn" ? "" : p.text());
  return saved;
}

void go_to(const SavedLook& look, params::Set& parameters, WindowState& state) {
  auto value = look.values.begin();
  for (params::Parameter& p : parameters) {
    if (p.name != "turn") p.set(*value);
    ++value;
  }
  state.view = look.view, state.look = look.look;
}

float default_panel_width(float window, float scale) {
  return std::min(340 * scale, window / 2);
}

void draw_panel(app::AnyLab& lab, WindowState& state, float scale) {
  state.panel_width = 0;
  if (!state.panel_visible) return;
  const glm::vec2 window(ImGui::GetIO().DisplaySize.x, ImGui::GetIO().DisplaySize.y);
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({default_panel_width(window.x, scale), window.y}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSizeConstraints({std::min(200 * scale, window.x / 2), window.y},
                                      {window.x * 0.7F, window.y});
  const app::Info& info = lab.info();
  ImGui::Begin(fmt::format("Lab {}: {}###panel", info.number, info.title).c_str(), nullptr,
               kPlaced | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  state.panel_width = ImGui::GetWindowWidth();
  ImGui::BeginChild("sections", {0, -status_bar_height()});
  wrapped_text(theme().dim, info.lesson);
  buttons(state);
  steps_section(lab, state);
  view_section(lab, state);
  state.more_is_open = state.more && state.more->draw(scale);
  parameters_section(lab.parameters());
  statistics_section(state);
  ImGui::EndChild();
  status_bar(state);
  ImGui::End();
}

}  // namespace texel::window
