// SPDX-License-Identifier: MIT
#pragma once
#include <span>

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
std::span<const Key> keys();

/// The action of a key, or none.
Action action_of(int key, bool control);

/// What the mouse does, for the same list: "drag", "orbit".
struct Gesture {
  const char *shown, *what;
};
std::span<const Gesture> gestures();

}  // namespace texel::window
