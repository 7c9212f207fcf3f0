// SPDX-License-Identifier: MIT
#include "theme.hpp"

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

}  // namespace texel::window
