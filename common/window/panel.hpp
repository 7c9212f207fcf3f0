// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/canvas.hpp"
#include "app/legend.hpp"
#include "course/lab_file.hpp"
#include "history.hpp"
#include "judge/results.hpp"
#include "shader_message.hpp"
#include "steps_check.hpp"
#include "texture_view.hpp"
#include "window/gui.hpp"
#include "window/more_section.hpp"

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
    {GLFW_KEY_J, false, Action::default_look, "J", "first look"},
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

/// The gallery's looks of a lab (labs/NN_name/lab.toml), hero first, with small pictures of them.
struct Looks {
  static constexpr glm::ivec2 kSize{240, 160};  ///< of a small picture, in pixels

  struct Entry {
    course::Look look;
    gl::Texture picture;  ///< bottom row first
    std::string fault;    ///< why it could not be drawn, or ""
  };
  std::vector<Entry> entries;
  std::size_t drawn = 0;  ///< so many small pictures are there; 0 has all drawn again
  std::string fault;      ///< why the lab's file cannot be read, or ""

  /// None where the lab's file is missing; those with a view that this tree does not have are left out.
  Looks(app::AnyLab& lab, const app::Assets& assets);

  [[nodiscard]] bool are_drawn() const { return drawn == entries.size(); }
  /// Draws the next small picture that is missing; the lab keeps its parameters.
  void draw_next(gl::Context& context, const app::Assets& assets, app::AnyLab& lab);
};

/// One axis of a surface's tangent frame, as a line over the picture: places from (0, 0), the picture's upper
/// left corner, to (1, 1).
struct FrameLine {
  enum class Axis { tangent, bitangent, normal } axis;
  glm::vec2 from, to;
};

/// What the window shows beside the lab's parameters; the panel's widgets change it.
struct WindowState {
  app::View view = app::View::color;
  std::optional<app::Canvas::Split> split;
  /// Which of the looks was chosen last, or none: the view goes back to its camera.
  std::optional<std::size_t> look;
  Action wanted = Action::none;  ///< by a button of this frame
  bool paused = false;
  bool panel_visible = true;
  float panel_width = 0;  ///< window units, 0 while hidden
  glm::vec2 dock{0};      ///< window units that the step has beside the picture: at the right, or below

  /// What stands over the picture: the shader's message, else the compiler's.
  [[nodiscard]] const ErrorMessage& shown_error() const {
    return error.first.empty() ? compile_error : error;
  }

  gl::Record record;   ///< of the last frame that was inspected
  app::Notes notes;    ///< of the lab
  app::Legend legend;  ///< of the data view
  gl::Texture legend_picture;
  double frame_milliseconds = 0;
  std::optional<app::ErrorFigures> figures;  ///< while the view `error` is shown
  ErrorMessage compile_error;                ///< of what was saved in C++, until it is mended
  ErrorMessage error;                        ///< over the last good picture, until it is mended
  bool all_messages = false;                 ///< not only the error's first
  std::string no_truth;                      ///< why the view `error` shows nothing, or ""
  std::string message;                       ///< what the last action did
  bool built_again = false;                  ///< the program, since this process began
  bool quit_asked = false;                   ///< Esc was typed with nothing open: the next one quits

  /// The pixel that was clicked, from the bottom left, and the value of each data view there.
  struct Inspected {
    glm::ivec2 pixel;
    std::vector<std::pair<app::View, glm::vec4>> values;
    std::optional<app::Comparison> comparison;  ///< of the method with the truth
    std::vector<TextureView> textures;
    gl::Texture around;  ///< the pixels around it, kAround in a row; bottom row first
    static constexpr int kAround = 15;
  };
  std::optional<Inspected> inspected;
  glm::vec2 pixel_panel{0};  ///< window units that the panel beside the pixel had in the last frame

  std::optional<StepsCheck> steps;           ///< none where there is nothing to check
  std::map<std::string, std::size_t> hints;  ///< how many are shown, by step
  std::optional<CasePictures> case_pictures;
  bool case_is_new = false;  ///< since the last frame
  bool all_steps_done = false;
  std::string step_to_open;           ///< in the section "Steps", or ""
  std::optional<Looks> looks;         ///< always there while the window is open
  std::unique_ptr<MoreSection> more;  ///< or null
  bool more_is_open = false, statistics_open = false;
  bool looks_open = false, keys_open = false, light_theme = false, wireframe = false, axes = false;
  std::vector<FrameLine> frame_lines;  ///< while `axes` is on
  std::string progress;                ///< what goes on for longer than a frame, or ""
  std::string config_file;
};

/// "bump_strength" → "bump strength"
std::string label_of(std::string_view name);
/// "off by 12.3 degrees (limit 0.05)".
std::string off_by(const judge::CaseResult& one);

/// The present look: parameters (not how far the model is turned), view, comparison and gallery's look.
SavedLook save_look(const params::Set& parameters, const WindowState& state);

/// Sets parameters and view. Throws Error (usage) when the lab does not have them.
void choose(const course::Case& look, app::AnyLab& lab, app::View& view);
/// Sets a look of the gallery, with its line. Throws as choose.
void choose_look(app::AnyLab& lab, WindowState& state, std::size_t index);

/// The section "Steps": each with its figure; its cases, which set the look when they are picked; its hints.
void steps_section(app::AnyLab& lab, WindowState& state);
/// The whole course as one line: what is right, what comes next, and, taller, the steps of this lab. Nothing
/// for no steps.
void course_line(const std::vector<judge::StepResult>& course, int lab);

/// Sets the look of a step or a case; a message says why where the lab does not have it.
void set_look(app::AnyLab& lab, WindowState& state, const course::Case& look);
/// Sets the case's look and shows its pictures. Nothing is seen of a vertex stream: there the step's look.
void pick_case(app::AnyLab& lab, WindowState& state, const judge::StepResult& step,
               const judge::CaseResult& one);
/// Sets the look of the step's case that says most, and shows that case's pictures.
void pick_step(app::AnyLab& lab, WindowState& state, const judge::StepResult& step);

/// T, B and N on a grid over the visible surface, of those that the lab draws as views. They are the
/// surface's own: without the normal map. B stands at right angles to N and T, on the side to which t grows.
/// Throws Error as Canvas::draw.
std::vector<FrameLine> frame_lines(app::Canvas& canvas, app::AnyLab& lab, glm::ivec2 size);

/// How wide the panel is until it is resized, in units of a window so wide.
float default_panel_width(float window, float scale);

/// The room that the step needs beside a picture that would have `size` window units without it.
glm::vec2 dock_size(const WindowState& state, glm::vec2 size, float scale);

// Each draws a part of the window for one frame with ImGui, and changes parameters and state in place. The
// picture lies right of the panel and is `size` window units large.

void draw_panel(app::AnyLab& lab, WindowState& state, float scale);
/// Over the picture: the split line and its labels, the mark of the inspected pixel, an error or warning.
void draw_overlay(app::AnyLab& lab, WindowState& state, glm::vec2 size, float pixels_per_unit, float scale);
/// In the room `state.dock`: the step and the pictures of the case that was picked.
void draw_step(WindowState& state, glm::vec2 window, float scale);
/// Beside the pixel that was clicked: it and its neighbours magnified, and the value of each view there.
void draw_pixel(WindowState& state, glm::vec2 size, float pixels_per_unit, float scale);
/// Over the picture: the gallery's looks with small pictures; choosing one sets parameters and view.
void draw_looks(app::AnyLab& lab, WindowState& state, glm::vec2 size, float scale);
void draw_keys(WindowState& state, glm::vec2 size);

}  // namespace texel::window
