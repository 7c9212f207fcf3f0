// SPDX-License-Identifier: MIT
// What stands over the picture.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/camera.hpp"
#include "app/settings.hpp"
#include "panel.hpp"

namespace texel::window {
namespace {

constexpr ImGuiWindowFlags kPlate = kPlaced | ImGuiWindowFlags_NoDecoration |
                                    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;

constexpr ImU32 kAxisColors[] = {IM_COL32(255, 80, 80, 255), IM_COL32(90, 230, 90, 255),
                                 IM_COL32(110, 150, 255, 255)};  // of T, B and N

ImU32 color_of(FrameLine::Axis axis) {
  return kAxisColors[static_cast<std::size_t>(axis)];
}

void wrapped_to(float width, const ImVec4& color, const std::string& text) {
  ImGui::PushTextWrapPos(width);
  ImGui::TextColored(color, "%s", text.c_str());
  ImGui::PopTextWrapPos();
}

/// Text on a plate: it can be read over any picture.
void plate(const char* id, ImVec2 at, ImVec2 pivot, const ImVec4& color, const std::string& text,
           float wrap_width) {
  if (text.empty()) return;
  ImGui::SetNextWindowPos(at, ImGuiCond_Always, pivot);
  ImGui::SetNextWindowBgAlpha(0.86F);
  ImGui::Begin(id, nullptr, kPlate | ImGuiWindowFlags_NoInputs);
  wrapped_to(wrap_width, color, text);
  ImGui::End();
}

/// The first message with its source line; the others on request.
void error_plate(WindowState& state, glm::vec2 size, float scale) {
  const ErrorMessage& error = state.shown_error();
  // From the left: its buttons stay where they are when it grows.
  ImGui::SetNextWindowPos({state.panel_width + 12 * scale, 12 * scale});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {size.x - 24 * scale, size.y - 24 * scale});
  ImGui::SetNextWindowBgAlpha(0.92F);
  ImGui::Begin("##error", nullptr, kPlate);
  const auto lines = [&](const ImVec4& color, const std::string& text) {
    wrapped_to(size.x - 60 * scale, color, text);
  };
  lines(theme().wrong, error.first);
  if (!error.source_line.empty())
    lines(theme().text, fmt::format("  {} |  {}", error.line, error.source_line));
  if (!error.file.empty() && ImGui::SmallButton("Open in editor")) state.wanted = Action::open_in_editor;
  if (error.others > 0) {
    if (!error.file.empty()) ImGui::SameLine();
    std::string label = state.all_messages
                            ? "Only the first"
                            : fmt::format("{} more line{}", error.others, error.others == 1 ? "" : "s");
    if (ImGui::SmallButton(label.append("###more").c_str())) state.all_messages = !state.all_messages;
    if (state.all_messages) lines(theme().dim, error.rest);
  }
  ImGui::End();
}

/// The camera that the parameters describe.
app::OrbitCamera camera_of(params::Set& parameters) {
  const auto value = [&](const char* name) { return static_cast<float>(parameters.at(name).value()); };
  app::OrbitCamera camera;
  camera.yaw = value("yaw"), camera.pitch = value("pitch");
  camera.distance = value("distance"), camera.field_of_view = value("field_of_view");
  return camera;
}

/// What the data views have at a pixel.
struct Views {
  image::ImageF depth, texcoord, normal, tangent;  ///< empty where the lab has no such view
  glm::ivec2 size;
  glm::mat4 world_from_view, clip_from_world;
  float tangent_of_half_angle, aspect;

  [[nodiscard]] bool is_object(glm::ivec2 p) const { return depth.at(p.x, p.y, 3) > 0; }
  static glm::vec3 vector(const image::ImageF& picture, glm::ivec2 p) {
    return {picture.at(p.x, p.y, 0), picture.at(p.x, p.y, 1), picture.at(p.x, p.y, 2)};
  }
  [[nodiscard]] glm::vec3 position(glm::ivec2 p) const {
    const glm::vec2 ndc = 2.0F * (glm::vec2(p) + 0.5F) / glm::vec2(size) - 1.0F;
    const float z = depth.at(p.x, p.y, 0), reach = z * tangent_of_half_angle;
    return glm::vec3(world_from_view * glm::vec4(ndc.x * reach * aspect, ndc.y * reach, -z, 1));
  }
  [[nodiscard]] glm::vec2 in_picture(const glm::vec3& world) const {
    const glm::vec4 clip = clip_from_world * glm::vec4(world, 1);
    return {0.5F + 0.5F * clip.x / clip.w, 0.5F - 0.5F * clip.y / clip.w};
  }
  /// Where t grows at a pixel, world space: from the differences to the pixels right of it and above.
  [[nodiscard]] glm::vec3 growth_of_t(glm::ivec2 p) const {
    const glm::ivec2 right = p + glm::ivec2(1, 0), up = p + glm::ivec2(0, 1);
    const glm::vec3 here = position(p), dx = position(right) - here, dy = position(up) - here;
    const glm::vec2 st(vector(texcoord, p)), sx = glm::vec2(vector(texcoord, right)) - st,
                                             sy = glm::vec2(vector(texcoord, up)) - st;
    const float determinant = sx.s * sy.t - sy.s * sx.t;
    return (sx.s * dy - sy.s * dx) * (determinant < 0 ? -1.0F : 1.0F);
  }
};

}  // namespace

std::vector<FrameLine> frame_lines(app::Canvas& canvas, app::AnyLab& lab, glm::ivec2 size, int spacing) {
  const auto has = [&](app::View view) { return std::ranges::count(lab.views(), view) > 0; };
  if (!has(app::View::depth) || !has(app::View::normal)) return {};
  const app::OrbitCamera camera = camera_of(lab.parameters());
  const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
  Views views;
  views.size = size, views.aspect = aspect;
  views.world_from_view = glm::inverse(camera.view_from_world());
  views.clip_from_world = camera.clip_from_world(aspect);
  views.tangent_of_half_angle = std::tan(glm::radians(camera.field_of_view) / 2);
  views.depth = canvas.values_of(app::View::depth, size);
  if (has(app::View::texcoord)) views.texcoord = canvas.values_of(app::View::texcoord, size);
  if (has(app::View::tangent)) views.tangent = canvas.values_of(app::View::tangent, size);
  {
    const app::KeptValues before(lab.parameters());
    if (params::Parameter* mapping = lab.parameters().find("normal_mapping")) mapping->set_value(0);
    views.normal = canvas.values_of(app::View::normal, size);
  }

  std::vector<FrameLine> lines;
  const float length = 0.06F * camera.distance;  // world units
  for (int y = spacing / 2; y + 1 < size.y; y += spacing)
    for (int x = spacing / 2; x + 1 < size.x; x += spacing) {
      const glm::ivec2 p(x, y);
      if (!views.is_object(p) || !views.is_object(p + glm::ivec2(1, 0)) ||
          !views.is_object(p + glm::ivec2(0, 1)))
        continue;
      const glm::vec3 position = views.position(p), normal = Views::vector(views.normal, p);
      const auto add = [&](FrameLine::Axis axis, const glm::vec3& direction) {
        const glm::vec2 from = views.in_picture(position),
                        to = views.in_picture(position + length * direction);
        if (std::isfinite(to.x + to.y)) lines.push_back({axis, from, to});
      };
      add(FrameLine::Axis::normal, normal);
      if (views.tangent.samples.empty()) continue;
      const glm::vec3 tangent = Views::vector(views.tangent, p), side = glm::cross(normal, tangent);
      add(FrameLine::Axis::tangent, tangent);
      if (views.texcoord.samples.empty()) continue;
      add(FrameLine::Axis::bitangent, glm::dot(side, views.growth_of_t(p)) < 0 ? -side : side);
    }
  return lines;
}

void draw_overlay(app::AnyLab& lab, WindowState& state, glm::vec2 size, float pixels_per_unit, float scale) {
  ImDrawList& canvas = *ImGui::GetBackgroundDrawList();
  const float origin = state.panel_width;
  if (state.split && state.view != app::View::error) {  // the error is drawn whole
    const float x = std::round(origin + state.split->position * size.x);
    canvas.AddLine({x, 0}, {x, size.y}, IM_COL32(255, 255, 255, 220), 2 * scale);
    const float y = size.y - 28 * scale, gap = 10 * scale;
    // The value's name on its side of the line.
    const auto name = [&](const std::string& value, float pivot) {
      const float width = ImGui::CalcTextSize(value.c_str()).x, left = x - pivot * (width + 2 * gap);
      canvas.AddRectFilled({left, y - gap / 2}, {left + width + 2 * gap, size.y - gap / 2},
                           IM_COL32(0, 0, 0, 170));
      canvas.AddText({left + gap, y}, IM_COL32_WHITE, value.c_str());
    };
    name(lab.parameters().at(state.split->parameter).text(), 1);
    name(state.split->value, 0);
  }
  for (const FrameLine& line : state.frame_lines) {
    const auto at = [&](glm::vec2 place) { return ImVec2(origin + place.x * size.x, place.y * size.y); };
    canvas.AddLine(at(line.from), at(line.to), IM_COL32(0, 0, 0, 160), 3.5F * scale);
    canvas.AddLine(at(line.from), at(line.to), color_of(line.axis), 2 * scale);
  }
  for (const auto& [axis, name] : {std::pair(FrameLine::Axis::tangent, "T"),
                                   {FrameLine::Axis::bitangent, "B"},
                                   {FrameLine::Axis::normal, "N"}})
    if (std::ranges::find(state.frame_lines, axis, &FrameLine::axis) != state.frame_lines.end())
      canvas.AddText({origin + (12 + 16 * static_cast<float>(axis)) * scale, 10 * scale}, color_of(axis),
                     name);
  if (state.inspected && state.error.first.empty()) {  // the last good picture may have another size
    const glm::vec2 pixel = glm::vec2(state.inspected->pixel) + 0.5F;
    const ImVec2 at(origin + pixel.x / pixels_per_unit, size.y - pixel.y / pixels_per_unit);
    canvas.AddCircle(at, 5 * scale, IM_COL32(0, 0, 0, 255), 16, 3 * scale);
    canvas.AddCircle(at, 5 * scale, IM_COL32(255, 255, 255, 255), 16, 1.5F * scale);
  }
  if (!state.shown_error().first.empty()) {
    error_plate(state, size, scale);
  } else {
    const ImVec2 lower_right(origin + size.x - 12 * scale, size.y - 12 * scale);
    const ImVec2 middle(origin + size.x / 2, size.y / 2);
    plate("##warnings", lower_right, {1, 1}, theme().next,
          fmt::format("{}", fmt::join(state.record.warnings, "\n")), 0.8F * size.x);
    plate("##no truth", middle, {0.5F, 0.5F}, theme().text, state.no_truth, 0.8F * size.x);
  }
  if (state.quit_asked)
    plate("##quit", {origin + size.x / 2, size.y / 4}, {0.5F, 0.5F}, theme().text, "Press Esc again to quit",
          0.8F * size.x);
}

}  // namespace texel::window
