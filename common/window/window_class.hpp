// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>

#include "core/files.hpp"
#include "core/stopwatch.hpp"
#include "panel.hpp"
#include "window/window.hpp"

namespace texel::window {

/// A lab's window. window.cpp has its frames, window_input.cpp what keys, mouse and buttons do.
class Window {
 public:
  Window(app::AnyLab& lab, const app::Assets& assets, const WindowOptions& options);

  void run();

 private:
  static Window& self(GLFWwindow* window) { return *static_cast<Window*>(glfwGetWindowUserPointer(window)); }
  [[nodiscard]] GLFWwindow* window() const { return context_.window(); }
  [[nodiscard]] bool turning();
  [[nodiscard]] bool is_busy() const;  // with what takes longer than a frame

  /// Asks for the window's size, once a frame: each question waits for the window system's answer.
  void ask_size();
  [[nodiscard]] float pixels_per_unit() const {
    return static_cast<float>(pixels_.x) / static_cast<float>(std::max(units_.x, 1));
  }
  /// The picture lies right of the panel, and left of or above the step: its size in units and in pixels, and
  /// a window position within it.
  [[nodiscard]] glm::vec2 picture_units() const { return glm::max(room() - state_.dock, glm::vec2(16)); }
  [[nodiscard]] glm::ivec2 picture_pixels() const {
    return glm::ivec2(glm::round(picture_units() * pixels_per_unit()));
  }
  [[nodiscard]] glm::vec2 in_picture(glm::vec2 position) const {
    return {position.x - state_.panel_width, position.y};
  }
  /// Beside the panel.
  [[nodiscard]] glm::vec2 room() const {
    return {std::max(static_cast<float>(units_.x) - state_.panel_width, 16.0F), static_cast<float>(units_.y)};
  }

  /// The look that was chosen last, or null.
  [[nodiscard]] const course::Look* chosen_look() const {
    return state_.look ? &state_.looks->entries[*state_.look].look : nullptr;
  }
  /// For the chosen look, as app::fit_view.
  void fit_view();

  [[nodiscard]] bool is_seen() const { return pixels_.x > 0 && pixels_.y > 0; }  // not iconified

  /// Shows the first picture, then makes what draws the panel: a software renderer compiles that for 70 ms.
  void open();

  void frame();
  void show_picture();
  /// The last picture and the panel.
  void show();
  /// Edited shaders are compiled again, edited pictures and models loaded again.
  void watch();
  void follow_steps();
  void reload(bool assets);
  /// Starts the program that was built again in this one's place, with the same look and step.
  void open_anew();

  void draw_picture();
  /// What the section that only some trees have works on, a little each frame.
  void work_on_more();
  /// Reads the data views at the clicked pixel.
  void inspect();
  void perform(Action action);
  /// The look to which undo and redo lead, or null; then a message says that there is `nothing`.
  void go_back_to(const SavedLook* look, const char* nothing);
  void write_picture(const std::filesystem::path& file);
  void go_on_with_turntable();
  /// Closes what lies over all else, up to the split line; false where nothing is open.
  bool close_topmost();
  void on_key(int key, int action, bool control);
  void on_drop(const std::filesystem::path& file);
  /// By the mouse's place now: what ImGui says is hovered is of the last frame, and a slow frame would lose
  /// clicks.
  [[nodiscard]] bool over_picture() const;
  [[nodiscard]] bool over_line() const;
  void on_button(int button, int action);
  void on_move(glm::vec2 mouse);

  enum class Drag { none, picture, split_line, light };

  /// One turn of the model, or of the camera where the lab turns none, as pictures 000.png, 001.png, …
  struct Turntable {
    std::filesystem::path folder;
    int written = 0;
  };

  app::AnyLab& lab_;
  const app::Assets& assets_;
  WindowOptions options_;  ///< `see` until it is seen
  gl::WindowContext context_;
  app::Canvas canvas_;
  std::optional<Gui> gui_;
  WindowState state_;
  Watcher watcher_;
  Stopwatch watch_clock_, frame_clock_;
  glm::ivec2 pixels_{0};  ///< of the framebuffer
  glm::ivec2 units_{0};   ///< of the window, in the units in which the mouse's place is told
  std::string drawn_;     ///< what the picture depends on; nothing is drawn again while it stays the same
  History history_;
  std::optional<Turntable> turntable_;    ///< while it is written
  std::optional<ScratchFolder> scratch_;  ///< for the clipboard
  double truth_share_ = 1;                ///< of the exact answer that the view `error` needs
  std::string reloaded_;                  ///< what is said once the files that were read again are drawn
  int frames_due_ = 0;                    ///< to draw without a wait
  bool inspected_once_ = false;
  std::filesystem::path own_program_;
  float scale_ = 1;
  Drag drag_ = Drag::none;
  glm::vec2 mouse_{0}, pressed_at_{0}, held_at_{0};
  int held_frames_ = 0;  ///< for which the panel has the mouse at held_at_
};

}  // namespace texel::window
