// SPDX-License-Identifier: MIT
// What all panels are drawn with.
#pragma once
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <string>
#include <string_view>

#include "app/legend.hpp"
#include "gl/upload.hpp"

namespace texel::window {

/// The colours of the panel's texts.
struct Theme {
  ImVec4 good, next, wrong, dim, text;
  ImVec4 background;  ///< of the panel
  ImVec4 field;       ///< of headings, buttons and what a value stands on
  ImVec4 accent;      ///< of what is chosen
};

/// Of the present theme.
const Theme& theme();

/// Dark or light, for all of ImGui. `scale` is the display's: 2 at twice the density.
void set_theme(bool light, float scale);

/// Of the windows that we place.
inline constexpr ImGuiWindowFlags kPlaced =
    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove;

/// ImGui with its two backends, from here to the end of the scope.
class Gui {
 public:
  Gui(GLFWwindow* window, float scale);
  ~Gui();
  Gui& operator=(Gui&&) = delete;

  static inline ImFont* code_font = nullptr;  ///< all letters are as wide
};

/// Shows a text, broken at its blanks where the window ends: ImGui also breaks at points, as in "0.5". An
/// empty one takes no room.
void wrapped_text(const ImVec4& color, const std::string& text);

/// Help for the item above, while the mouse is over it.
void tooltip(std::string_view help, std::string_view more = {});

/// A picture for ImGui: its bytes as they are, enlarged to squares.
gl::Texture picture_texture(const image::Image8& picture, GLenum wrap_s = GL_CLAMP_TO_EDGE,
                            GLenum wrap_t = GL_CLAMP_TO_EDGE);

/// Draws a picture whose bottom row is the first, or a part of it.
void draw_texture(const gl::Texture& texture, ImVec2 from, ImVec2 to, ImVec2 upper_left = {0, 1},
                  ImVec2 lower_right = {1, 0});

/// How colours are read, with its picture; where the next widget would stand.
void draw_legend(const app::Legend& legend, const gl::Texture& picture, float scale);

}  // namespace texel::window
