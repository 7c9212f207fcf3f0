// SPDX-License-Identifier: MIT
// The magnifier: the pixel that was clicked and its neighbours, with the values of all views.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "panel.hpp"

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
  using app::View;
  if (view == View::texcoord) return pixel_row(name, value, 2, "%.5f");
  if (view == View::color) return pixel_row(name, value, 3, "%.1f");
  if (view == View::normal || view == View::tangent || view == View::direction)
    return pixel_row(name, value, 3, "%+.4f");
  pixel_row(name, value, 1, "%.5g");
}

/// The pixels around, each as a square, and the middle one marked.
void magnifier(const WindowState::Inspected& inspected, float side) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_texture(inspected.around, at, {at.x + side, at.y + side});
  constexpr int kAround = WindowState::Inspected::kAround;
  const float pixel = side / kAround, middle = pixel * (kAround / 2);
  const ImVec2 from(at.x + middle, at.y + middle), to(from.x + pixel, from.y + pixel);
  list.AddRect({from.x - 1, from.y - 1}, {to.x + 1, to.y + 1}, IM_COL32_BLACK, 0, 0, 3);
  list.AddRect(from, to, IM_COL32_WHITE);
  ImGui::Dummy({side, side});
}

// ---- Below the magnifier: the textures that the lab reads there

constexpr const char* kFaceNames[] = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
constexpr ImU32 kMark = IM_COL32(255, 255, 255, 255), kShadow = IM_COL32(0, 0, 0, 255);

/// A part of a texture on the screen: where (s, t) = `least` and `most` lie in the rectangle. t grows upwards
/// on a 2D texture, and downwards on a face of a cube map.
struct Area {
  ImVec2 from, to;
  glm::dvec2 least{0}, most{1};
  bool is_upwards = true;

  [[nodiscard]] ImVec2 at(glm::dvec2 place) const {
    const glm::dvec2 part = (place - least) / (most - least);
    const double down = is_upwards ? 1 - part.y : part.y;
    return {from.x + static_cast<float>(part.x) * (to.x - from.x),
            from.y + static_cast<float>(down) * (to.y - from.y)};
  }
  void show(const gl::Texture& texture) const {
    const glm::vec2 a(least), b(most);
    draw_texture(texture, from, to, {a.x, is_upwards ? b.y : a.y}, {b.x, is_upwards ? a.y : b.y});
  }
  void frame(float width) const {
    const ImU32 color = ImGui::GetColorU32(theme().next);
    ImGui::GetWindowDrawList()->AddRect(from, to, color, 0, 0, width);
  }
};

/// A rectangle at the cursor, or so far from it.
Area area_here(glm::vec2 size, bool is_upwards, glm::vec2 moved = glm::vec2(0)) {
  const ImVec2 cursor = ImGui::GetCursorScreenPos(), at(cursor.x + moved.x, cursor.y + moved.y);
  return {.from = at, .to = {at.x + size.x, at.y + size.y}, .is_upwards = is_upwards};
}

/// The pixel's footprint with its middle, light on a dark border: it can be seen on any picture.
void mark(const Area& area, const Footprint& footprint, glm::dvec2 place, float scale) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const glm::dvec2 moved = place - footprint.place;
  ImVec2 corners[] = {area.at(moved + footprint.at(-0.5, -0.5)), area.at(moved + footprint.at(0.5, -0.5)),
                      area.at(moved + footprint.at(0.5, 0.5)), area.at(moved + footprint.at(-0.5, 0.5))};
  const ImVec2 middle = area.at(place);
  float reach = 0;
  for (const ImVec2& corner : corners)
    reach = std::max({reach, std::abs(corner.x - middle.x), std::abs(corner.y - middle.y)});
  if (reach > 3 * scale) {
    list.PushClipRect(area.from, area.to, true);
    list.AddPolyline(corners, 4, kShadow, ImDrawFlags_Closed, 4 * scale);
    list.AddPolyline(corners, 4, kMark, ImDrawFlags_Closed, 2 * scale);
    list.AddCircleFilled(middle, 2.5F * scale, kShadow);
    list.AddCircleFilled(middle, 1.5F * scale, kMark);
    list.PopClipRect();
  } else {  // too small to be seen: a ring around it
    list.AddCircle(middle, 5 * scale, kShadow, 0, 4 * scale);
    list.AddCircle(middle, 5 * scale, kMark, 0, 2 * scale);
  }
}

/// The place as the wrap mode has it.
glm::dvec2 wrapped_place(const TextureView& view) {
  return {wrapped(view.footprint.place.x, view.wrap_s), wrapped(view.footprint.place.y, view.wrap_t)};
}

/// The whole texture in a square of `side`.
void whole_texture(const TextureView& view, float side, float scale) {
  const glm::vec2 size(view.size_of(0));
  const Area area = area_here(size * (side / std::max(size.x, size.y)), true);
  area.show(view.whole.front());
  mark(area, view.footprint, wrapped_place(view), scale);
  ImGui::Dummy({side, side});
}

/// The six faces of a cube, unfolded: four columns and three rows.
void faces(const TextureView& view, float side, float scale) {
  constexpr glm::ivec2 kPlaces[] = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}};
  const auto area_of = [&](int face) {
    return area_here({side, side}, false, side * glm::vec2(kPlaces[face]));
  };
  for (int face = 0; face < 6; ++face) {
    const Area area = area_of(face);
    area.show(view.whole[static_cast<std::size_t>(face)]);
    const ImVec2 text(area.from.x + 3 * scale, area.from.y + scale);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddText({text.x + scale, text.y + scale}, kShadow, kFaceNames[face]);
    list.AddText(text, kMark, kFaceNames[face]);
  }
  const Area met = area_of(view.footprint.face);
  met.frame(2 * scale);
  mark(met, view.footprint, view.footprint.place, scale);
  ImGui::Dummy({4 * side, 3 * side});
}

/// The texels around the footprint, of the level that is read.
void texels(const TextureView& view, float side, float scale) {
  const glm::dvec2 size(view.size_of(view.first_read));
  constexpr double kFewest = 4, kLargest = 2.5;  // texels across; sides of the footprint across
  const double across = std::max(kFewest, kLargest * view.footprint.sides(size).x);
  const glm::dvec2 place = view.is_cube ? view.footprint.place : wrapped_place(view),
                   half = 0.5 * across / size;
  Area area = area_here({side, side}, !view.is_cube);
  area.least = place - half, area.most = place + half;
  area.show(view.read);
  mark(area, view.footprint, place, scale);
  ImGui::Dummy({side, side});
}

void facts(const TextureView& view) {
  const glm::dvec2 sides = view.footprint.sides(view.size_of(0));
  ImGui::BeginGroup();
  ImGui::TextColored(theme().dim, "%dx%d %s", view.width, view.height, view.format.c_str());
  ImGui::TextColored(theme().dim, "footprint in texels");
  ImGui::Text("%.3g x %.3g", sides.x, sides.y);
  ImGui::TextColored(theme().dim, view.is_cube ? "level, face" : "level");
  ImGui::Text("%.2f%s%s", view.level_of_detail, view.is_cube ? ", " : "",
              view.is_cube ? kFaceNames[view.footprint.face] : "");
  if (!view.is_mipmapped) ImGui::TextColored(theme().next, "no mipmaps");
  ImGui::EndGroup();
}

/// Each level as a small picture, a frame around those that the filter reads.
void chain(const TextureView& view, float width, float scale) {
  const float gap = 4 * scale;
  const auto count = static_cast<float>(view.levels);
  const float side = std::min(32 * scale, (width - (count - 1) * gap) / count);
  for (int level = 0; level < view.levels; ++level) {
    if (level > 0) ImGui::SameLine(0, gap);
    ImGui::BeginGroup();
    const Area area = area_here({side, side}, !view.is_cube);
    area.show(view.chain[static_cast<std::size_t>(level)]);
    const bool is_read = level == view.first_read || level == view.last_read;
    if (is_read) area.frame(2 * scale);
    ImGui::Dummy({side, side});
    ImGui::TextColored(is_read ? theme().next : theme().dim, "%d", level);
    ImGui::EndGroup();
    if (!ImGui::IsItemHovered()) continue;
    const glm::ivec2 size = view.size_of(level);
    ImGui::SetTooltip("level %d: %dx%d texels", level, size.x, size.y);
  }
}

/// The textures that the lab reads at the pixel, each with its levels or faces and the pixel's footprint.
void texture_section(const std::vector<TextureView>& textures, float scale) {
  if (textures.empty() || !ImGui::BeginTabBar("textures")) return;
  const float side = 120 * scale;
  for (const TextureView& view : textures) {
    if (!ImGui::BeginTabItem(view.name.c_str())) continue;
    if (view.is_cube)
      faces(view, side / 3, scale);
    else
      whole_texture(view, side, scale);
    ImGui::SameLine();
    texels(view, side, scale);
    ImGui::SameLine();
    facts(view);
    chain(view, std::max(ImGui::GetContentRegionAvail().x, 380 * scale), scale);
    ImGui::EndTabItem();
  }
  ImGui::EndTabBar();
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
      &is_open, kPlaced | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
  state.pixel_panel = {ImGui::GetWindowWidth(), ImGui::GetWindowHeight()};
  magnifier(inspected, 120 * scale);
  ImGui::SameLine();
  ImGui::BeginGroup();
  for (const auto& [view, value] : inspected.values) {
    if (value.w <= 0)
      pixel_row(name_of(view), "background");
    else
      pixel_row(name_of(view), view, glm::dvec3(value));
  }
  if (inspected.comparison) {
    const app::Comparison& c = *inspected.comparison;
    ImGui::TextColored(theme().dim, "%s against the truth", name_of(c.measure.view));
    pixel_row("method", c.measure.view, c.value);
    pixel_row("truth", c.measure.view, c.truth);
    pixel_row("error", fmt::format("{:.4g} {}", c.error, name_of(c.measure.unit)));
  }
  ImGui::EndGroup();
  texture_section(inspected.textures, scale);
  ImGui::End();
  if (!is_open) state.inspected.reset();
}

}  // namespace texel::window
