// SPDX-License-Identifier: MIT
#include "window/gui.hpp"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace texel::window {
namespace {

const Theme kDark{.good = {0.45F, 0.85F, 0.50F, 1},
                  .next = {1.0F, 0.78F, 0.35F, 1},
                  .wrong = {1.0F, 0.45F, 0.40F, 1},
                  .dim = {0.62F, 0.66F, 0.72F, 1},
                  .text = {1, 1, 1, 1},
                  .background = {0.08F, 0.09F, 0.10F, 1},
                  .field = {0.16F, 0.18F, 0.20F, 1},
                  .accent = {0.94F, 0.60F, 0.42F, 1}};
// Each has a contrast of at least 4.5 to 1 with the background (WCAG 2.1, 1.4.3).
const Theme kLight{.good = {0.05F, 0.40F, 0.13F, 1},
                   .next = {0.55F, 0.33F, 0.00F, 1},
                   .wrong = {0.72F, 0.09F, 0.06F, 1},
                   .dim = {0.33F, 0.36F, 0.41F, 1},
                   .text = {0, 0, 0, 1},
                   .background = {0.98F, 0.98F, 0.96F, 1},
                   .field = {0.93F, 0.92F, 0.89F, 1},
                   .accent = {0.64F, 0.25F, 0.12F, 1}};
bool is_light = false;

/// DejaVu Sans with the letters and signs of formulas where the system has it, else ImGui's own font.
void load_font(float scale) {
  // Latin, Greek, punctuation, raised and lowered digits, arrows, mathematical signs, and what arrows with
  // a word in them are made of.
  static constexpr ImWchar kLetters[] = {0x20,   0xFF,   0x370,  0x3FF,  0x2010, 0x205E, 0x2070,
                                         0x209F, 0x2190, 0x21FF, 0x2200, 0x22FF, 0x2500, 0x2500,
                                         0x25B6, 0x25B6, 0x25C0, 0x25C0, 0};
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  const auto load = [&](const char* file, float size) {
    if (std::filesystem::exists(file))
      return fonts.AddFontFromFileTTF(file, std::round(size * scale), nullptr, kLetters);
    ImFontConfig config;
    config.SizePixels = std::round(13 * scale);  // for which ImGui's own font is drawn
    return fonts.AddFontDefault(&config);
  };
  load("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", 14);
  Gui::code_font = load("/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf", 13);
}

/// The text with its lines' ends instead of the blanks there. A word that is too long has a line of its own.
std::string broken(const std::string& text, float width) {
  std::string lines;
  std::size_t line = 0;  // where the present one begins in `lines`
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
    lines.append(text, begin, end - begin);
    const std::size_t blank = lines.find_last_of(' ');
    if (blank != std::string::npos && blank >= line && ImGui::CalcTextSize(lines.c_str() + line).x > width) {
      lines[blank] = '\n';
      line = blank + 1;
    }
    if (end < text.size()) lines += text[end];
    if (end < text.size() && text[end] == '\n') line = lines.size();
    begin = end + 1;
  }
  return lines;
}

}  // namespace

const Theme& theme() {
  return is_light ? kLight : kDark;
}

void set_theme(bool light, float scale) {
  is_light = light;
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  if (light)
    ImGui::StyleColorsLight();
  else
    ImGui::StyleColorsDark();
  style.WindowRounding = 6;
  style.FrameRounding = 3;
  style.FrameBorderSize = 1;
  // The colours of our pages. Opaque: nothing of the last picture shows through, nor of the panel below.
  const auto shade = [](const ImVec4& color, float alpha) {
    return ImVec4(color.x, color.y, color.z, alpha);
  };
  const auto set = [&](const ImVec4& color, std::initializer_list<ImGuiCol> names) {
    for (const ImGuiCol name : names) style.Colors[name] = color;
  };
  set(theme().background, {ImGuiCol_WindowBg, ImGuiCol_PopupBg, ImGuiCol_TitleBg, ImGuiCol_MenuBarBg});
  set(theme().field,
      {ImGuiCol_FrameBg, ImGuiCol_Button, ImGuiCol_Header, ImGuiCol_TitleBgActive, ImGuiCol_Tab});
  set(shade(theme().accent, 0.3F), {ImGuiCol_FrameBgHovered, ImGuiCol_ButtonHovered, ImGuiCol_HeaderHovered,
                                    ImGuiCol_TabHovered, ImGuiCol_FrameBgActive});
  set(shade(theme().accent, 0.5F),
      {ImGuiCol_ButtonActive, ImGuiCol_HeaderActive, ImGuiCol_TabActive, ImGuiCol_TextSelectedBg,
       ImGuiCol_ResizeGrip, ImGuiCol_ResizeGripHovered});
  set(theme().accent, {ImGuiCol_CheckMark, ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive,
                       ImGuiCol_NavHighlight, ImGuiCol_ResizeGripActive});
  set(shade(theme().text, light ? 0.45F : 0.25F), {ImGuiCol_Border, ImGuiCol_Separator});
  style.ScaleAllSizes(scale);
}

Gui::Gui(GLFWwindow* window, float scale) {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // the panel's place is not worth a file in the user's folder
  ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  set_theme(/*light=*/false, scale);
  load_font(scale);
  ImGui_ImplGlfw_InitForOpenGL(window, /*install_callbacks=*/true);
  ImGui_ImplOpenGL3_Init("#version 330 core");
}

Gui::~Gui() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void wrapped_text(const ImVec4& color, const std::string& text) {
  if (text.empty()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::TextWrapped("%s", broken(text, ImGui::GetContentRegionAvail().x).c_str());
  ImGui::PopStyleColor();
}

void tooltip(std::string_view help, std::string_view more) {
  if (!ImGui::IsItemHovered()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
  ImGui::TextUnformatted(help.data(), help.data() + help.size());
  if (!more.empty()) ImGui::TextColored(theme().dim, "%.*s", static_cast<int>(more.size()), more.data());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

gl::Texture picture_texture(const image::Image8& picture, GLenum wrap_s, GLenum wrap_t) {
  return gl::make_texture_2d(picture, image::Encoding::linear, {GL_LINEAR, GL_NEAREST, wrap_s, wrap_t});
}

void draw_texture(const gl::Texture& texture, ImVec2 from, ImVec2 to, ImVec2 upper_left, ImVec2 lower_right) {
  const auto id = ImTextureID(std::uintptr_t{texture.id()});  // a pointer, since ImGui 1.91 a number
  ImGui::GetWindowDrawList()->AddImage(id, from, to, upper_left, lower_right);
}

void draw_legend(const app::Legend& legend, const gl::Texture& picture, float scale) {
  ImGui::TextUnformatted(legend.title.c_str());
  const bool is_bar = !legend.ticks.empty();  // with room for half a number at both ends
  const float margin = is_bar ? ImGui::CalcTextSize(legend.ticks.back().second.c_str()).x / 2 : 0;
  const ImVec2 room = is_bar ? ImVec2(190 * scale, 12 * scale) : ImVec2(64 * scale, 64 * scale),
               corner = ImGui::GetCursorScreenPos(), at(corner.x + margin, corner.y),
               to(at.x + room.x, at.y + room.y);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 ink = ImGui::GetColorU32(theme().text);
  list.AddImageRounded(ImTextureID(std::uintptr_t{picture.id()}), at, to, {0, 1}, {1, 0}, IM_COL32_WHITE,
                       legend.is_ball ? room.x / 2 : 0);
  for (const auto& [place, text] : legend.ticks) {
    const float x = at.x + static_cast<float>(place) * room.x, tick = 4 * scale;
    list.AddLine({x, to.y}, {x, to.y + tick}, ink);
    list.AddText({x - ImGui::CalcTextSize(text.c_str()).x / 2, to.y + tick}, ink, text.c_str());
  }
  ImGui::Dummy({room.x + 2 * margin, room.y + (is_bar ? 4 * scale + ImGui::GetTextLineHeight() : 0)});
}

}  // namespace texel::window
