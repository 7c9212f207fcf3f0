// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "canvas.hpp"
#include "steps.hpp"

namespace texel::app {

/// What the window shows beside the lab's parameters; the panel's widgets change it.
struct WindowState {
  View view = View::color;
  std::optional<Canvas::Split> split;
  bool paused = false;
  bool panel_visible = true;
  float panel_width = 0;  ///< window units, 0 while hidden; the picture has the rest

  gl::Record record;  ///< of the last frame that was inspected
  Notes notes;        ///< of the lab
  double frame_milliseconds = 0;
  std::optional<ErrorFigures> figures;  ///< while the view `error` is shown
  std::string error;                    ///< over the last good picture, until it is mended
  std::string message;                  ///< what the last action did

  /// The pixel that was clicked, from the bottom left, and the value of each data view there.
  struct Inspected {
    glm::ivec2 pixel;
    std::vector<std::pair<View, glm::vec4>> values;
    std::optional<Canvas::Comparison> comparison;  ///< of the method with the truth
  };
  std::optional<Inspected> inspected;

  std::optional<StepsCheck> steps;           ///< none where there is nothing to check
  std::map<std::string, std::size_t> hints;  ///< how many are shown, by step
  std::optional<CasePictures> case_pictures;
  std::string config_file;
};

/// What a button asked for.
enum class Action { none, copy_command_line, save_config, load_config, snapshot, reset_parameters, reload };

/// The section "Steps": each with its figure; its cases, which set the look when they are picked; its hints.
void steps_section(AnyLab& lab, WindowState& state);

/// Sets the look of the step's case that says most, and shows that case's pictures.
void pick_step(AnyLab& lab, WindowState& state, const grade::StepResult& step);

/// Over the picture: the pictures of the case that was picked. As draw_overlay.
void draw_case(WindowState& state, glm::vec2 size, float scale);

/// How wide the panel is until it is resized, in units of a window so wide.
float default_panel_width(float window, float scale);

/// Draws the panel for one frame with ImGui, at the left edge; changes parameters and state in place.
Action draw_panel(AnyLab& lab, WindowState& state, float scale);

/// The error or warning over the picture, the split line and its labels, the mark of the inspected pixel. The
/// picture lies right of the panel and is `size` window units large.
void draw_overlay(AnyLab& lab, const WindowState& state, glm::vec2 size, float pixels_per_unit, float scale);

/// "lab05_normal_map --method averaged --view normal": what draws the present look again.
std::string command_line(AnyLab& lab, View view);

}  // namespace texel::app
