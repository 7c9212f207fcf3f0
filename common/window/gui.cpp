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
                  .background = {0.06F, 0.06F, 0.06F, 1}};
// Each has a contrast of at least 4.5 to 1 with the background (WCAG 2.1, 1.4.3).
const Theme kLight{.good = {0.05F, 0.40F, 0.13F, 1},
                   .next = {0.55F, 0.33F, 0.00F, 1},
                   .wrong = {0.72F, 0.09F, 0.06F, 1},
                   .dim = {0.33F, 0.36F, 0.41F, 1},
                   .text = {0, 0, 0, 1},
                   .background = {0.95F, 0.95F, 0.95F, 1}};
bool is_light = false;

/// DejaVu Sans with the letters and signs of formulas where the system has it, else ImGui's own font.
void load_font(float scale) {
  // Latin, Greek, punctuation, raised and lowered digits, arrows, mathematical signs, and what arrows with
  // a word in them are made of.
  static constexpr ImWchar kLetters[] = {0x20,   0xFF,   0x370,  0x3FF,  0x2010, 0x205E, 0x2070,
                                         0x209F, 0x2190, 0x21FF, 0x2200, 0x22FF, 0x2500, 0x2500,
                                         0x25B6, 0x25B6, 0x25C0, 0x25C0, 0};
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  const std::filesystem::path font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
  if (std::filesystem::exists(font)) {
    fonts.AddFontFromFileTTF(font.c_str(), std::round(14 * scale), nullptr, kLetters);
    return;
  }
  ImFontConfig config;
  config.SizePixels = std::round(13 * scale);  // for which ImGui's own font is drawn
  fonts.AddFontDefault(&config);
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
  style.Colors[ImGuiCol_WindowBg] = theme().background;  // opaque: nothing of the last picture shows through
  style.Colors[ImGuiCol_PopupBg].w = 1;                  // nor of the panel below
  style.ScaleAllSizes(scale);
}

Gui::Gui(GLFWwindow* window, float scale) {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // the panel's place is not worth a file in the user's folder
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

void Gui::begin_frame() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void Gui::end_frame(glm::ivec2 pixels) {
  glViewport(0, 0, pixels.x, pixels.y);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
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
  const gl::Sampling sampling = {
      .minify = GL_LINEAR, .magnify = GL_NEAREST, .wrap_s = wrap_s, .wrap_t = wrap_t};
  return gl::make_texture_2d(picture, image::Encoding::linear, sampling);
}

void draw_texture(const gl::Texture& texture, ImVec2 from, ImVec2 to, ImVec2 upper_left, ImVec2 lower_right) {
  const auto id = ImTextureID(std::uintptr_t{texture.id()});  // a pointer, since ImGui 1.91 a number
  ImGui::GetWindowDrawList()->AddImage(id, from, to, upper_left, lower_right);
}

}  // namespace texel::window
