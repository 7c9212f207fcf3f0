// SPDX-License-Identifier: MIT
// What keys, mouse and buttons do in a lab's window.
#include <fmt/format.h>
#include <imgui_internal.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "app/batch.hpp"
#include "app/gestures.hpp"
#include "app/settings.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/plain_text.hpp"
#include "core/process.hpp"
#include "window_class.hpp"

namespace texel::window {
namespace {

constexpr float kClickTolerance = 3;    // window units that a click may move
constexpr int kTurntablePictures = 36;  // every 10 degrees

bool is_installed(const std::string& program) {
  return run_program({"sh", "-c", "command -v \"$1\"", "sh", program}, true).exit_code == 0;
}

/// Starts a shell's command with arguments "$1" and so on. Nobody waits for its end: an editor may stay open
/// as long as it likes.
void run_beside(const std::string& command, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"sh", "-c", command + " >/dev/null 2>&1 &", "sh"});
  run_program(arguments);
}

/// Opens a file at a line in the user's editor: $VISUAL where it is set, else Visual Studio Code (`code -g`).
/// Line and column from 1; 0: unknown. Does not wait for the editor. Throws Error (exit 3) when there
/// is none.
void open_in_editor(const std::filesystem::path& file, int line, int column = 0) {
  const char* visual = std::getenv("VISUAL");
  const std::string command = visual == nullptr || *visual == '\0' ? "code" : visual;
  const std::string program = command.substr(0, command.find(' '));
  if (!is_installed(program))
    throw Error::failed(fmt::format("there is no editor '{}' to open {}:{}", program, file.string(), line),
                        {}, "set VISUAL to a command that opens a window, as VISUAL='gvim' or VISUAL='code'");
  const std::string editor = std::filesystem::path(program).filename();
  const std::string place = fmt::format("{}:{}:{}", file.string(), std::max(line, 1), std::max(column, 1));
  if (editor == "code" || editor == "codium" || editor == "code-oss")
    run_beside(command + " -g \"$1\"", {place});
  else if (editor == "subl" || editor == "zed")
    run_beside(command + " \"$1\"", {place});
  else  // vi, emacs, kate's and nano's way
    run_beside(command + " \"$@\"", {fmt::format("+{}", std::max(line, 1)), file.string()});
}

/// Puts a PNG into the clipboard by wl-copy or xclip: GLFW has only text. Throws Error (exit 3) when neither
/// is installed.
void copy_png(const std::filesystem::path& png) {
  const bool is_wayland = std::getenv("WAYLAND_DISPLAY") != nullptr;
  const std::string tool = is_wayland ? "wl-copy" : "xclip";
  if (!is_installed(tool))
    throw Error::failed(
        fmt::format("a picture gets into the clipboard by the program {}, which is missing", tool), {},
        is_wayland ? "install wl-clipboard" : "install xclip");
  run_beside(
      is_wayland ? "wl-copy --type image/png < \"$1\"" : "xclip -selection clipboard -t image/png -i \"$1\"",
      {png.string()});
}

/// "lab05_normal_map-001.png": the first such name that is free.
std::filesystem::path free_name(const app::AnyLab& lab, const std::string& ending) {
  std::filesystem::path name;
  int i = 0;
  do name = fmt::format("{}-{:03}{}", lab.info().program(), ++i, ending);
  while (std::filesystem::exists(name));
  return name;
}

/// Sets the previous or next item of a list.
void step(params::Parameter* parameter, int by) {
  if (parameter == nullptr || parameter->items.empty()) return;
  const auto count = static_cast<int>(parameter->items.size());
  int index = -1;  // of a file that was dropped
  for (int i = 0; i < count; ++i)
    if (parameter->text() == parameter->items[static_cast<std::size_t>(i)].name) index = i;
  parameter->set(parameter->items[static_cast<std::size_t>((index + by + count) % count)].name);
}

/// The picture that K and L change: `texture`, else `cube_map`.
params::Parameter* texture_parameter(params::Set& parameters) {
  params::Parameter* texture = parameters.find("texture");
  return texture != nullptr ? texture : parameters.find("cube_map");
}

/// Whether a window of the last frame takes the mouse there.
bool is_covered(glm::vec2 mouse) {
  constexpr float kEdge = 4;  // so far from its edge a window still takes the mouse, to be resized
  return std::ranges::any_of(ImGui::GetCurrentContext()->Windows, [&](const ImGuiWindow* window) {
    ImRect area = window->Rect();
    area.Expand(kEdge);
    return window->Active && (window->Flags & ImGuiWindowFlags_NoMouseInputs) == 0 &&
           area.Contains({mouse.x, mouse.y});
  });
}

void toggle(bool& value) {
  value = !value;
}

}  // namespace

void Window::perform(Action action) {
  if (action != Action::none && action != Action::quit) state_.quit_asked = false;
  try {
    switch (action) {
      case Action::none:
        return;
      case Action::copy_command_line:
        state_.message = lab_.info().program();
        if (!lab_.parameters().key().empty()) state_.message += " " + lab_.parameters().flags();
        if (state_.view != app::View::color)
          state_.message += fmt::format(" --view {}", name_of(state_.view));
        glfwSetClipboardString(window(), state_.message.c_str());
        return;
      case Action::copy_picture:
        if (!scratch_) scratch_.emplace();
        write_picture(scratch_->path() / "picture.png");
        copy_png(scratch_->path() / "picture.png");
        state_.message = "the picture is in the clipboard";
        return;
      case Action::save_config:
        app::save_config(state_.config_file, lab_.info(), lab_.parameters());
        state_.message = "saved " + state_.config_file;
        return;
      case Action::load_config:
        app::load_config(state_.config_file, lab_.info(), lab_.parameters());
        state_.message = "loaded " + state_.config_file;
        return;
      case Action::snapshot: {
        const std::filesystem::path file = free_name(lab_, ".png");
        write_picture(file);
        state_.message = "wrote " + file.string();
        return;
      }
      case Action::turntable: {
        const std::filesystem::path folder = free_name(lab_, "-turntable");
        make_folder(folder, "start the program in a folder where you may write");
        turntable_ = {.folder = folder};
        return;
      }
      case Action::default_look:
        if (state_.looks->entries.empty())
          lab_.parameters().reset();
        else
          choose_look(lab_, state_, 0);
        return;
      case Action::show_looks:
        state_.looks_open = !state_.looks_open && !state_.looks->entries.empty();
        return;
      case Action::see_step:
        if (state_.case_pictures) set_look(lab_, state_, state_.steps->look_of(state_.case_pictures->step));
        return;
      case Action::undo:
        return go_back_to(history_.undo(), "nothing to undo");
      case Action::redo:
        return go_back_to(history_.redo(), "nothing to redo");
      case Action::reload:
        if (state_.built_again) open_anew();
        return reload(/*assets=*/true);
      case Action::open_in_editor:
        if (const ErrorMessage& error = state_.shown_error(); !error.file.empty())
          open_in_editor(error.file, error.line, error.column);
        else if (const auto& picked = state_.case_pictures)
          open_in_editor(picked->text.file, picked->text.line + 1);  // below the marker
        else
          state_.message = "pick a case of a step first";
        return;
      case Action::toggle_normal_map:
        if (params::Parameter* p = lab_.parameters().find("normal_mapping"))
          p->set_value(p->value() != 0 ? 0 : 1);
        return;
      case Action::toggle_pause:
        return toggle(state_.paused);
      case Action::toggle_panel:
        return toggle(state_.panel_visible);
      case Action::toggle_theme:
        toggle(state_.light_theme);
        return set_theme(state_.light_theme, scale_);
      case Action::toggle_wireframe:
        toggle(state_.wireframe);
        if (state_.wireframe && state_.view != app::View::color)
          state_.message = "edges are drawn over the view color";
        return;
      case Action::toggle_axes:
        toggle(state_.axes);
        if (std::ranges::count(lab_.views(), app::View::normal) == 0)
          state_.message = "this lab has no normals to show";
        return;
      case Action::previous_texture:
        return step(texture_parameter(lab_.parameters()), -1);
      case Action::next_texture:
        return step(texture_parameter(lab_.parameters()), +1);
      case Action::reset_view:
        for (const char* name : {"yaw", "pitch", "distance", "field_of_view", "turn"})
          if (params::Parameter* p = lab_.parameters().find(name)) {
            p->reset();
            if (chosen_look() == nullptr) continue;
            for (const auto& [parameter, value] : chosen_look()->settings)
              if (parameter == name) p->set(value);
          }
        return;
      case Action::show_keys:
        return toggle(state_.keys_open);
      case Action::quit:
        if (close_topmost())
          state_.quit_asked = false;
        else if (std::exchange(state_.quit_asked, true))
          glfwSetWindowShouldClose(window(), GLFW_TRUE);
        return;
    }
  } catch (const Error& error) {
    state_.message = error.what();
  }
}

bool Window::close_topmost() {
  if (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup)) {
    ImGui::ClosePopupToLevel(0, true);
    return true;
  }
  const auto close = [](auto& optional) {
    const bool was_open = optional.has_value();
    optional.reset();
    return was_open;
  };
  return std::exchange(state_.keys_open, false) || std::exchange(state_.looks_open, false) ||
         close(state_.inspected) || close(state_.case_pictures) || close(state_.split);
}

void Window::open_anew() {
  std::vector<std::string> words = {own_program_.string(), "--size", fmt::format("{}x{}", units_.x, units_.y),
                                    "--view", name_of(state_.view)};
  for (const params::Parameter& p : lab_.parameters())
    // A model that is given its turn stands still, as this one does.
    if (!p.is_default() || (p.name == "turn" && state_.paused))
      words.insert(words.end(), {fmt::format("--{}", p.flag()), p.text()});
  if (state_.case_pictures) words.insert(words.end(), {"--see", state_.case_pictures->result.name});
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execv(pointers.front(), pointers.data());
  throw Error::failed("cannot start it", {own_program_.string()}, "close this window and open the lab again");
}

void Window::go_back_to(const SavedLook* look, const char* nothing) {
  if (look == nullptr) {
    state_.message = nothing;
    return;
  }
  for (const auto& [parameter, value] : look->settings) lab_.parameters().at(parameter).set(value);
  state_.view = look->view, state_.split = look->split, state_.look = look->look;
}

void Window::write_picture(const std::filesystem::path& file) {
  if (truth_share_ < 1)
    throw Error::failed("the exact answer is not there yet", {},
                        "wait until the status line no longer says so");
  const app::KeptValues before(lab_.parameters());
  fit_view();
  app::take_snapshot(canvas_, lab_, state_.view, picture_pixels(), file)();
}

void Window::go_on_with_turntable() {
  auto [folder, written] = *std::exchange(turntable_, {});  // an error ends it
  const app::KeptValues before(lab_.parameters());
  fit_view();
  params::Parameter* turn = lab_.parameters().find("turn");
  params::Parameter& angle = turn != nullptr ? *turn : lab_.parameters().at("yaw");
  angle.set_value(std::remainder(angle.value() + 360.0 * written / kTurntablePictures, 360));
  canvas_.draw(state_.view, picture_pixels(), options_.samples);
  const std::filesystem::path file = folder / fmt::format("{:03}.png", written);
  app::take_snapshot(canvas_, lab_, state_.view, picture_pixels(), file)();
  state_.message = fmt::format("{} of {} pictures in {}/", ++written, kTurntablePictures, folder.string());
  if (written < kTurntablePictures) turntable_ = {folder, written};
  drawn_.clear();
}

void Window::on_key(int key, int action, bool control) {
  ImGuiIO& io = ImGui::GetIO();
  // Of Dear ImGui the space bar presses a control, and Tab finds fields of text alone.
  const int known = key == GLFW_KEY_ENTER ? GLFW_KEY_SPACE : key == GLFW_KEY_TAB ? GLFW_KEY_DOWN : 0;
  if (known != 0) io.KeysDown[known] = action != GLFW_RELEASE && !io.WantTextInput;
  if (action == GLFW_RELEASE || io.WantTextInput) return;
  if (io.NavVisible && key == GLFW_KEY_SPACE) return;  // it presses the control that has the focus
  // Held down, Esc would close one thing after the other, and quit.
  if (action == GLFW_REPEAT && key == GLFW_KEY_ESCAPE) return;
  for (const Key& one : kKeys)
    if (one.key == key && one.control == control) return perform(one.action);
}

void Window::on_drop(const std::filesystem::path& file) {
  const bool is_model = lower_case(file.extension().string()) == ".obj";
  params::Parameter* parameter =
      is_model ? app::model_parameter(lab_.parameters()) : texture_parameter(lab_.parameters());
  if (parameter == nullptr || parameter->type != params::Parameter::Type::file) {
    state_.message = fmt::format("this lab takes no {}", is_model ? "model" : "picture");
    return;
  }
  parameter->set(file.string());
  state_.message = fmt::format("{} is {}", parameter->name, file.string());
}

bool Window::over_picture() const {
  const glm::vec2 at = in_picture(mouse_), size = picture_units();
  const bool inside = at.x >= 0 && at.x < size.x && at.y < size.y;
  return inside && !state_.looks_open && !ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup) &&
         !is_covered(mouse_);
}

bool Window::over_line() const {
  if (!state_.split || !over_picture()) return false;
  const glm::vec2 at = in_picture(mouse_) - picture_units() * glm::vec2(state_.split->position, 0.5F);
  return std::abs(at.x) < 8 * scale_ || glm::length(at) < 14 * scale_;
}

void Window::on_button(int button, int action) {
  state_.quit_asked = false;
  if (button == GLFW_MOUSE_BUTTON_RIGHT) {
    drag_ = action == GLFW_PRESS && over_picture() ? Drag::light : Drag::none;
    return;
  }
  if (button != GLFW_MOUSE_BUTTON_LEFT) return;
  // For the panel a press lasts a frame, its release another one, both here: the mouse may be gone by then.
  if (held_frames_ < 2) held_at_ = mouse_, held_frames_ = action == GLFW_PRESS ? 2 : 1;
  if (action == GLFW_PRESS && over_picture()) {
    drag_ = over_line() ? Drag::split_line : Drag::picture;
    pressed_at_ = mouse_;
  } else if (action == GLFW_RELEASE) {
    if (drag_ == Drag::picture && glm::distance(pressed_at_, mouse_) <= kClickTolerance) {
      const glm::ivec2 pixel(in_picture(mouse_) * pixels_per_unit());
      state_.inspected.emplace().pixel = {pixel.x, picture_pixels().y - 1 - pixel.y};
      drawn_.clear();
    }
    drag_ = Drag::none;
  }
}

void Window::on_move(glm::vec2 mouse) {
  const glm::vec2 moved = mouse - mouse_;
  mouse_ = mouse;
  if (drag_ == Drag::split_line && state_.split)
    state_.split->position = std::clamp(in_picture(mouse).x / picture_units().x, 0.0F, 1.0F);
  if (drag_ == Drag::light) app::move_light(lab_.parameters(), moved);
  if (drag_ == Drag::picture && glm::distance(pressed_at_, mouse) > kClickTolerance)
    app::orbit(lab_.parameters(), moved);
}

}  // namespace texel::window
