// SPDX-License-Identifier: MIT
// Below the magnifier: the textures that the lab reads at the clicked pixel.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "panel.hpp"
#include "theme.hpp"

namespace texel::window {
namespace {

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
    ImGui::GetWindowDrawList()->AddImage(ImTextureID(std::uintptr_t{texture.id()}), from, to,
                                         {a.x, is_upwards ? b.y : a.y}, {b.x, is_upwards ? a.y : b.y});
  }
};

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

void frame(ImVec2 from, ImVec2 to, const ImVec4& color, float width) {
  ImGui::GetWindowDrawList()->AddRect(from, to, ImGui::GetColorU32(color), 0, 0, width);
}

/// The place as the wrap mode has it.
glm::dvec2 wrapped_place(const TextureView& view) {
  return {wrapped(view.footprint.place.x, view.wrap_s), wrapped(view.footprint.place.y, view.wrap_t)};
}

/// The whole texture in a square of `side`.
void whole_texture(const TextureView& view, float side, float scale) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const glm::vec2 size =
      glm::vec2(view.size) * (side / static_cast<float>(std::max(view.size.x, view.size.y)));
  const Area area{at, {at.x + size.x, at.y + size.y}};
  area.show(view.whole.front());
  mark(area, view.footprint, wrapped_place(view), scale);
  ImGui::Dummy({side, side});
}

/// The six faces of a cube, unfolded: four columns and three rows.
void faces(const TextureView& view, float side, float scale) {
  constexpr glm::ivec2 kPlaces[] = {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}};
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto area_of = [&](int face) {
    const glm::vec2 corner = side * glm::vec2(kPlaces[face]);
    return Area{{at.x + corner.x, at.y + corner.y},
                {at.x + corner.x + side, at.y + corner.y + side},
                glm::dvec2(0),
                glm::dvec2(1),
                false};
  };
  for (int face = 0; face < 6; ++face) {
    const Area area = area_of(face);
    area.show(view.whole[static_cast<std::size_t>(face)]);
    const ImVec2 text(area.from.x + 3 * scale, area.from.y + scale);
    list.AddText({text.x + scale, text.y + scale}, kShadow, kFaceNames[face]);
    list.AddText(text, kMark, kFaceNames[face]);
  }
  const Area met = area_of(view.footprint.face);
  frame(met.from, met.to, theme().next, 2 * scale);
  mark(met, view.footprint, view.footprint.place, scale);
  ImGui::Dummy({4 * side, 3 * side});
}

/// The texels around the footprint, of the level that is read.
void texels(const TextureView& view, float side, float scale) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const glm::dvec2 size(view.size_of(view.first_read));
  constexpr double kFewest = 4, kLargest = 2.5;  // texels across; sides of the footprint across
  const double across = std::max(kFewest, kLargest * view.footprint.sides(size).x);
  const glm::dvec2 place = view.is_cube ? view.footprint.place : wrapped_place(view),
                   half = 0.5 * across / size;
  const Area area{at, {at.x + side, at.y + side}, place - half, place + half, !view.is_cube};
  area.show(view.read);
  mark(area, view.footprint, place, scale);
  ImGui::Dummy({side, side});
}

void facts(const TextureView& view) {
  const glm::dvec2 sides = view.footprint.sides(view.size);
  ImGui::BeginGroup();
  ImGui::TextColored(theme().dim, "%dx%d %s", view.size.x, view.size.y, view.format.c_str());
  ImGui::TextColored(theme().dim, "footprint in texels");
  ImGui::Text("%.3g x %.3g", sides.x, sides.y);
  ImGui::TextColored(theme().dim, view.is_cube ? "level, face" : "level");
  if (view.is_cube)
    ImGui::Text("%.2f, %s", view.level, kFaceNames[view.footprint.face]);
  else
    ImGui::Text("%.2f", view.level);
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
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Area area{at, {at.x + side, at.y + side}, glm::dvec2(0), glm::dvec2(1), !view.is_cube};
    area.show(view.chain[static_cast<std::size_t>(level)]);
    const bool is_read = level == view.first_read || level == view.last_read;
    if (is_read) frame(area.from, area.to, theme().next, 2 * scale);
    ImGui::Dummy({side, side});
    ImGui::TextColored(is_read ? theme().next : theme().dim, "%d", level);
    ImGui::EndGroup();
    if (!ImGui::IsItemHovered()) continue;
    const glm::ivec2 size = view.size_of(level);
    ImGui::SetTooltip("level %d: %dx%d texels", level, size.x, size.y);
  }
}

}  // namespace

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

}  // namespace texel::window
