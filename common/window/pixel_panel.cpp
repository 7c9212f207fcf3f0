// SPDX-License-Identifier: MIT
// The magnifier: the pixel that was clicked and its neighbours, with the values of all views.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "panel.hpp"
#include "theme.hpp"

namespace texel::window {
namespace {

/// A name, and its value in a column.
void pixel_row(const char* name, const std::string& value) {
  ImGui::TextUnformatted(name);
  ImGui::SameLine(ImGui::GetFontSize() * 5);
  ImGui::TextUnformatted(value.c_str());
}

/// Three components, or as many as the view has, each in a column of its own.
void pixel_row(const char* name, const glm::dvec3& value, int components, const char* format) {
  ImGui::TextUnformatted(name);
  for (int c = 0; c < components; ++c) {
    ImGui::SameLine(ImGui::GetFontSize() * (5 + 4.5F * static_cast<float>(c)));
    ImGui::Text(format, value[c]);
  }
}

/// How a value of the view is written; 8-bit steps for colours.
void pixel_row(const char* name, app::View view, const glm::dvec3& value) {
  switch (view) {
    case app::View::mesh:  // no picture
    case app::View::lod:
    case app::View::depth:
    case app::View::mask:
    case app::View::error:
      return pixel_row(name, value, 1, "%.5g");
    case app::View::texcoord:
      return pixel_row(name, value, 2, "%.5f");
    case app::View::color:
      return pixel_row(name, value, 3, "%.1f");
    case app::View::normal:
    case app::View::tangent:
    case app::View::direction:
      return pixel_row(name, value, 3, "%+.4f");
  }
}

/// The pixels around, each as a square, and the middle one marked.
void magnifier(const WindowState::Inspected& inspected, float side) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto id = ImTextureID(std::uintptr_t{inspected.around.id()});
  list.AddImage(id, at, {at.x + side, at.y + side}, {0, 1}, {1, 0});
  const float pixel = side / WindowState::Inspected::kAround,
              middle = pixel * (WindowState::Inspected::kAround / 2);
  const ImVec2 from(at.x + middle, at.y + middle), to(from.x + pixel, from.y + pixel);
  list.AddRect({from.x - 1, from.y - 1}, {to.x + 1, to.y + 1}, IM_COL32_BLACK, 0, 0, 3);
  list.AddRect(from, to, IM_COL32_WHITE);
  ImGui::Dummy({side, side});
}

}  // namespace

void draw_pixel(WindowState& state, glm::vec2 size, float pixels_per_unit, float scale) {
  if (!state.inspected || state.inspected->values.empty()) return;
  const WindowState::Inspected& inspected = *state.inspected;
  const glm::vec2 pixel = (glm::vec2(inspected.pixel) + 0.5F) / pixels_per_unit;
  // On the side of the pixel that has more room, within the picture.
  const glm::vec2 at(pixel.x, size.y - pixel.y), gap(24 * scale), own = state.pixel_panel;
  const glm::vec2 place(at.x > size.x / 2 ? at.x - gap.x - own.x : at.x + gap.x,
                        at.y > size.y / 2 ? at.y - gap.y - own.y : at.y + gap.y);
  const glm::vec2 inside = glm::max(glm::min(place, size - own), glm::vec2(0));
  ImGui::SetNextWindowPos({state.panel_width + inside.x, inside.y});
  ImGui::SetNextWindowBgAlpha(0.92F);
  bool is_open = true;
  ImGui::Begin(
      fmt::format("Pixel {}, {} from the lower left###pixel", inspected.pixel.x, inspected.pixel.y).c_str(),
      &is_open,
      ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse |
          ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoFocusOnAppearing);
  state.pixel_panel = {ImGui::GetWindowWidth(), ImGui::GetWindowHeight()};
  magnifier(inspected, 120 * scale);
  ImGui::SameLine();
  ImGui::BeginGroup();
  for (const auto& [view, value] : inspected.values) {
    const char* name = name_of(view);
    if (value.w <= 0)
      pixel_row(name, "background");
    else
      pixel_row(name, view, glm::dvec3(value));
  }
  if (inspected.comparison) {
    const app::Canvas::Comparison& c = *inspected.comparison;
    ImGui::TextColored(theme().dim, "%s against the truth", name_of(c.measure.view));
    pixel_row("method", c.measure.view, c.value);
    pixel_row("truth", c.measure.view, c.truth);
    pixel_row("error", fmt::format("{:.4g} {}", c.error, name_of(c.measure.unit)));
  }
  ImGui::EndGroup();
  texture_section(inspected.textures, scale);
  cover_picture(state);
  ImGui::End();
  if (!is_open) state.inspected.reset();
}

}  // namespace texel::window
