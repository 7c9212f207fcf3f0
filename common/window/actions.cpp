// SPDX-License-Identifier: MIT
#include "actions.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace texel::window {
namespace {

constexpr Key kKeys[] = {
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
constexpr Gesture kGestures[] = {{"drag", "orbit"},
                                 {"right drag", "move the light"},
                                 {"wheel", "zoom"},
                                 {"click", "inspect a pixel"},
                                 {"drop a file", "an OBJ model or a picture"}};

}  // namespace

std::span<const Key> keys() {
  return kKeys;
}

Action action_of(int key, bool control) {
  for (const Key& one : kKeys)
    if (one.key == key && one.control == control) return one.action;
  return Action::none;
}

std::span<const Gesture> gestures() {
  return kGestures;
}

}  // namespace texel::window
