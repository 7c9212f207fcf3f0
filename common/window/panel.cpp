// SPDX-License-Identifier: MIT
#include "panel.hpp"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace texel::window {
namespace {

using Type = params::Parameter::Type;

constexpr float kLabel = 8.6F;  // letters before a widget

/// The name of what the next widget changes, which fills the rest of the line but for `right`.
void label(const ImVec4& color, const std::string& text, std::string_view help, std::string_view more = {},
           float right = 1) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextColored(color, "%s", text.c_str());
  tooltip(help, more);
  ImGui::SameLine(ImGui::GetFontSize() * kLabel);
  ImGui::SetNextItemWidth(-right);
}

/// A list to choose from, each value by its sentence, with its name behind it; and what is chosen.
std::string combo(const char* id, std::span<const params::Item> items, std::string current) {
  ImGui::PushStyleColor(ImGuiCol_Text, theme().dim);
  const bool is_open = ImGui::BeginCombo(id, current.c_str(), ImGuiComboFlags_HeightLarge);
  ImGui::PopStyleColor();
  if (!is_open) return current;
  const float room = 24 * ImGui::GetFontSize();
  std::string chosen = current;
  for (const params::Item& item : items) {
    const float height = ImGui::CalcTextSize(item.help, nullptr, false, room).y, top = ImGui::GetCursorPosY();
    ImGui::PushID(item.name);
    if (ImGui::Selectable("##item", current == item.name, 0, {1.45F * room, height})) chosen = item.name;
    ImGui::PopID();
    const float bottom = ImGui::GetCursorPosY();
    ImGui::SetCursorPosY(top);
    ImGui::PushTextWrapPos(room);
    ImGui::TextUnformatted(item.help);
    ImGui::PopTextWrapPos();
    ImGui::SameLine(room + ImGui::GetFontSize());
    ImGui::TextColored(theme().dim, "%s", item.name);
    ImGui::SetCursorPosY(bottom);
  }
  ImGui::EndCombo();
  return chosen;
}

/// A slider, and its number beside it.
void number_widget(params::Parameter& p) {
  const auto least = static_cast<float>(p.least), most = static_cast<float>(p.most);
  ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoRoundToFormat;
  if (p.scale == params::Scale::logarithmic) flags |= ImGuiSliderFlags_Logarithmic;
  if (auto value = static_cast<int>(p.value()); p.type == Type::integer) {
    if (ImGui::SliderInt("##value", &value, static_cast<int>(least), static_cast<int>(most), "", flags))
      p.set_value(value);
  } else if (auto real = static_cast<float>(p.value());
             ImGui::SliderFloat("##value", &real, least, most, "", flags)) {
    p.set_value(static_cast<double>(real));
  }
  ImGui::SameLine();
  ImGui::Text(p.unit == "degrees" ? "%.1f\xC2\xB0" : "%.4g", p.value());
}

/// One parameter: its name, its widget, and a button that takes it back when it is not the default.
void parameter_widget(params::Parameter& p) {
  ImGui::PushID(p.name.data());
  const bool is_default = p.is_default();
  const float letter = ImGui::GetFontSize(), reset = 1.9F * letter;
  const std::string range = p.is_ranged() ? fmt::format(", {} to {} {}", p.least, p.most, p.unit) : "";
  label(is_default ? theme().text : theme().next, label_of(p.name), p.help,
        fmt::format("--{}, default {}{}\nCtrl+click a slider to type a value", p.flag(), p.initial(), range),
        p.is_ranged() ? reset + 3.9F * letter : reset);
  if (p.type == Type::toggle) {
    bool on = p.value() != 0;
    if (ImGui::Checkbox("##value", &on)) p.set_value(on ? 1 : 0);
  } else if (p.is_ranged()) {
    number_widget(p);
  } else if (const std::string chosen = combo("##value", p.items, p.text()); chosen != p.text()) {
    p.set(chosen);
  }
  if (!is_default) {
    ImGui::SameLine(ImGui::GetContentRegionMax().x - 1.5F * letter);
#if IMGUI_VERSION_NUM >= 19200
    const bool has_arrow = ImGui::GetFont()->IsGlyphInFont(0x21BA);
#else
    const bool has_arrow = ImGui::GetFont()->FindGlyphNoFallback(0x21BA) != nullptr;
#endif
    if (ImGui::SmallButton(has_arrow ? "\u21BA" : "x")) p.reset();
    tooltip(fmt::format("back to {}", p.initial()));
  }
  if (p.type == Type::choice && (p.name == "method" || !is_default)) {
    ImGui::Indent(kLabel * letter);
    wrapped_text(theme().text, p.items[static_cast<std::size_t>(p.value())].help);
    ImGui::Unindent(kLabel * letter);
  }
  ImGui::PopID();
}

/// By sections. Those of the method and of what the lab opens with stand open.
void parameters_section(params::Set& parameters, const WindowState& state) {
  const auto is_of_lesson = [&](const params::Parameter& p) {
    return p.name == "method" || (state.split && state.split->parameter == p.name);
  };
  for (auto first = parameters.begin(), end = first; first != parameters.end(); first = end) {
    end = std::find_if(first, parameters.end(), [&](const auto& p) { return p.section != first->section; });
    const auto changed = std::count_if(first, end, [](const auto& p) { return !p.is_default(); });
    const std::string count = changed > 0 ? fmt::format("  ({} changed)", changed) : "";
    const bool starts_open = std::any_of(first, end, is_of_lesson);
    if (!first->section.empty() &&
        !ImGui::CollapsingHeader(fmt::format("{}{}###{}", first->section, count, first->section).c_str(),
                                 starts_open ? ImGuiTreeNodeFlags_DefaultOpen : 0))
      continue;
    for (auto p = first; p != end; ++p) parameter_widget(*p);
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
    const app::Measure measure = lab.answer()->measure();
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

void statistics_section(WindowState& state) {
  state.statistics_open = ImGui::CollapsingHeader("Statistics");
  if (!state.statistics_open) return;
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

/// What a key or a menu does, by name.
const char* shortcut_of(Action action) {
  const auto* key = std::ranges::find(kKeys, action, &Key::action);
  return key != std::end(kKeys) ? key->shown : nullptr;
}

/// Three buttons, and a menu for what is wanted now and then.
void buttons(WindowState& state) {
  const auto item = [&](const char* name, Action value) {
    if (ImGui::MenuItem(name, shortcut_of(value))) state.wanted = value;
  };
  const auto button = [&](const char* name, Action value, const char* help) {
    if (ImGui::Button(name)) state.wanted = value;
    tooltip(fmt::format("{} ({})", help, shortcut_of(value)));
    ImGui::SameLine();
  };
  if (!state.looks->entries.empty())
    button("Looks", Action::show_looks, "Small pictures: click one to have its look");
  button("Undo", Action::undo, "Takes back the last change");
  button("Redo", Action::redo, "Makes it again");
  if (ImGui::Button("Menu")) ImGui::OpenPopup("menu");
  if (!ImGui::BeginPopup("menu")) return;
  item("First look", Action::default_look);
  item("Keys and mouse", Action::show_keys);
  item(state.light_theme ? "Dark colours" : "Light colours", Action::toggle_theme);
  ImGui::Separator();
  item("Snapshot into this folder", Action::snapshot);
  item("Copy the picture", Action::copy_picture);
  item("Copy the command", Action::copy_command_line);
  item("Turntable of 36 pictures", Action::turntable);
  ImGui::Separator();
  ImGui::InputText("##config", &state.config_file);
  item("Save parameters", Action::save_config);
  item("Load parameters", Action::load_config);
  ImGui::EndPopup();
}

/// What happens, and what the last action did, at the lower end; or nothing.
std::string status_of(const WindowState& state) {
  std::string text = state.built_again ? "The lab was built again: F5 opens it anew" : "";
  for (const std::string& line : {state.message, state.progress, state.steps ? state.steps->progress() : ""})
    if (!line.empty()) text.append(text.empty() ? "" : "\n").append(line);
  return text;
}

/// Three lines of the text at most, below a line; no room for none.
float status_height(const std::string& text) {
  if (text.empty()) return 0;
  const float lines = ImGui::CalcTextSize(text.c_str(), nullptr, false, ImGui::GetContentRegionAvail().x).y;
  return std::min(lines, 3 * ImGui::GetTextLineHeight()) + 2 * ImGui::GetStyle().ItemSpacing.y + 1;
}

void status_bar(const WindowState& state, const std::string& text) {
  if (text.empty()) return;
  ImGui::Separator();
  ImGui::BeginChild("status", {0, 0}, 0, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  wrapped_text(state.built_again ? theme().next : theme().dim, text);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text.c_str());
  ImGui::EndChild();
}

}  // namespace

std::string label_of(std::string_view name) {
  std::string label(name);
  std::ranges::replace(label, '_', ' ');
  return label;
}

SavedLook save_look(const params::Set& parameters, const WindowState& state) {
  SavedLook saved{{}, state.view, state.split, state.look};
  for (const params::Parameter& p : parameters)
    if (p.name != "turn") saved.settings.push_back({std::string(p.name), p.text()});
  return saved;
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
  const std::string status = status_of(state);
  const std::vector<judge::StepResult> nothing, &course = state.steps ? state.steps->found().course : nothing;
  const float line = course.empty() ? 0 : 2 * ImGui::GetTextLineHeightWithSpacing();
  ImGui::BeginChild("sections", {0, -status_height(status) - line}, false, ImGuiWindowFlags_NavFlattened);
  wrapped_text(theme().dim, info.lesson);
  buttons(state);
  steps_section(lab, state);
  view_section(lab, state);
  parameters_section(lab.parameters(), state);
  state.more_is_open = state.more && state.more->draw(scale);
  statistics_section(state);
  ImGui::EndChild();
  course_line(course, info.number);
  status_bar(state, status);
  ImGui::End();
}

}  // namespace texel::window
