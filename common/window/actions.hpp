// SPDX-License-Identifier: MIT
#pragma once
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace texel::window {

/// What a key or a button asks the window for.
enum class Action {
  none,
  copy_command_line,
  copy_picture,
  save_config,
  load_config,
  snapshot,
  turntable,
  default_look,
  show_looks,
  own_look,
  see_step,
  undo,
  redo,
  reload,
  open_in_editor,
  toggle_normal_map,
  toggle_pause,
  toggle_panel,
  toggle_theme,
  toggle_wireframe,
  toggle_axes,
  previous_texture,
  next_texture,
  reset_view,
  show_keys,
  quit
};

/// A key of the window.
struct Key {
  int key;  ///< GLFW's
  bool control;
  Action action;
  const char* shown;  ///< "Ctrl+Z"
  const char* what;   ///< a few words
};

/// All keys, in the order in which F1 shows them.
inline constexpr Key kKeys[] = {
    {GLFW_KEY_F1, false, Action::show_keys, "F1", "all keys"},
    {GLFW_KEY_G, false, Action::show_looks, "G", "looks of the gallery"},
    {GLFW_KEY_J, false, Action::default_look, "J", "default look"},
    {GLFW_KEY_M, false, Action::toggle_normal_map, "M", "normal map on and off"},
    {GLFW_KEY_K, false, Action::previous_texture, "K", "previous texture"},
    {GLFW_KEY_L, false, Action::next_texture, "L", "next texture"},
    {GLFW_KEY_R, false, Action::reset_view, "R", "reset the view"},
    {GLFW_KEY_SPACE, false, Action::toggle_pause, "space", "pause"},
    {GLFW_KEY_Z, true, Action::undo, "Ctrl+Z", "undo"},
    {GLFW_KEY_Y, true, Action::redo, "Ctrl+Y", "redo"},
    {GLFW_KEY_C, true, Action::copy_picture, "Ctrl+C", "copy the picture"},
    {GLFW_KEY_W, false, Action::toggle_wireframe, "W", "wireframe"},
    {GLFW_KEY_T, false, Action::toggle_axes, "T", "lines of T, B and N"},
    {GLFW_KEY_E, false, Action::open_in_editor, "E", "open the step or the error in your editor"},
    {GLFW_KEY_F5, false, Action::reload, "F5", "read all files again"},
    {GLFW_KEY_F12, false, Action::snapshot, "F12", "write the picture"},
    {GLFW_KEY_H, false, Action::toggle_panel, "H", "hide the panel"},
    {GLFW_KEY_ESCAPE, false, Action::quit, "Esc", "close what is open, else quit"},
};

}  // namespace texel::window
