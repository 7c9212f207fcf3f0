// SPDX-License-Identifier: MIT
// What keys, mouse and buttons do in a lab's window.
#include <fmt/format.h>
#include <imgui_internal.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/config.hpp"
#include "app/gestures.hpp"
#include "app/settings.hpp"
#include "app/snapshot.hpp"
#include "core/error.hpp"
#include "core/plain_text.hpp"
#include "desktop.hpp"
#include "window_class.hpp"

namespace texel::window {
namespace {

constexpr float kClickTolerance = 3;  // window units that a click may move

}  // namespace

void Window::perform(Action action) {
  if (action != Action::none && action != Action::quit) state_.quit_asked = false;
  try {
    switch (action) {
      case Action::none:
        return;
      case Action::copy_command_line:
        state_.message = command_line(lab_, state_.view);
        glfwSetClipboardString(window(), state_.message.c_str());
        return;
      case Action::copy_picture:
        copy_picture();
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
        const std::filesystem::path file = free_name(".png");
        write_picture(file);
        state_.message = "wrote " + file.string();
        return;
      }
      case Action::turntable:
        turntable_.emplace(free_name("-turntable"));
        return;
      case Action::default_look:
        lab_.parameters().reset();
        state_.look.reset();
        if (opens_with_hero_) state_.look = 0;  // the hero
        if (const course::Look* hero = chosen_look()) Looks::choose(*hero, lab_, state_.view);
        return;
      case Action::show_looks:
        state_.looks_open = !state_.looks_open && !state_.looks->entries().empty();
        return;
      case Action::own_look:
        if (state_.own_look) go_to(*state_.own_look);
        state_.own_look.reset();
        state_.case_pictures.reset();
        return;
      case Action::see_step:
        if (state_.case_pictures) see_step(lab_, state_, state_.case_pictures->step);
        return;
      case Action::undo:
        if (const SavedLook* look = history_.undo())
          go_to(*look);
        else
          state_.message = "nothing to undo";
        return;
      case Action::redo:
        if (const SavedLook* look = history_.redo())
          go_to(*look);
        else
          state_.message = "nothing to redo";
        return;
      case Action::reload:
        if (state_.built_again) open_anew();
        reload(/*assets=*/true);
        return;
      case Action::open_in_editor:
        open_place();
        return;
      case Action::toggle_normal_map:
        if (params::Parameter* p = lab_.parameters().find("normal_mapping"))
          p->set_value(p->value() != 0 ? 0 : 1);
        return;
      case Action::toggle_pause:
        state_.paused = !state_.paused;
        return;
      case Action::toggle_panel:
        state_.panel_visible = !state_.panel_visible;
        return;
      case Action::toggle_theme:
        state_.light_theme = !state_.light_theme;
        set_theme(state_.light_theme, scale_);
        return;
      case Action::toggle_wireframe:
        state_.wireframe = !state_.wireframe;
        return;
      case Action::toggle_axes:
        state_.axes = !state_.axes;
        if (std::ranges::count(lab_.views(), app::View::normal) == 0)
          state_.message = "this lab has no normals to show";
        return;
      case Action::previous_texture:
        step(texture_parameter(), -1);
        return;
      case Action::next_texture:
        step(texture_parameter(), +1);
        return;
      case Action::reset_view:
        for (const char* name : {"yaw", "pitch", "distance", "field_of_view", "turn"})
          if (params::Parameter* p = lab_.parameters().find(name)) {
            p->reset();
            for (const auto& [parameter, value] :
                 chosen_look() != nullptr ? chosen_look()->settings : app::Settings())
              if (parameter == name) p->set(value);
          }
        return;
      case Action::show_keys:
        state_.keys_open = !state_.keys_open;
        return;
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
  if (state_.case_pictures) words.insert(words.end(), {"--see", state_.case_pictures->name});
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execv(pointers.front(), pointers.data());
  throw Error::failed("cannot start it", {own_program_.string()}, "close this window and open the lab again");
}

void Window::go_to(const SavedLook& look) {
  restore(look, lab_.parameters());
  state_.view = look.view, state_.look = look.look;
}

std::filesystem::path Window::free_name(const std::string& ending) const {
  for (int i = 1; i < 1000; ++i) {
    const std::filesystem::path name = fmt::format("{}-{:03}{}", lab_.info().program(), i, ending);
    if (!std::filesystem::exists(name)) return name;
  }
  throw Error::failed("there are already 999 snapshots here", {}, "remove some of them");
}

void Window::write_picture(const std::filesystem::path& file) {
  if (truth_share_ < 1)
    throw Error::failed("the exact answer is not there yet", {},
                        "wait until the status line no longer says so");
  const FittedView fitted = fitted_view();
  app::take_snapshot(canvas_, lab_, state_.view, picture_pixels(), file).write();
}

void Window::copy_picture() {
  if (!scratch_) scratch_.emplace();
  const std::filesystem::path file = scratch_->path() / "picture.png";
  write_picture(file);
  copy_png(file);
  state_.message = "the picture is in the clipboard";
}

void Window::go_on_with_turntable() {
  const FittedView fitted = fitted_view();
  try {
    turntable_->write_next(canvas_, lab_, state_.view, picture_pixels(), samples_);
  } catch (const Error&) {
    turntable_.reset();
    throw;
  }
  state_.message = fmt::format("{} of {} pictures in {}/", turntable_->written(), Turntable::kPictures,
                               turntable_->folder().string());
  if (turntable_->written() == Turntable::kPictures) turntable_.reset();
  drawn_ = {};
}

void Window::open_place() {
  if (const ErrorMessage& error = state_.shown_error(); !error.file.empty())
    open_in_editor(error.file, error.line, error.column);
  else if (state_.case_pictures)
    open_in_editor(state_.case_pictures->text.file, state_.case_pictures->text.line);
  else
    state_.message = "pick a case of a step first";
}

void Window::step(params::Parameter* parameter, int by) {
  if (parameter == nullptr || parameter->items.empty()) return;
  const auto count = static_cast<int>(parameter->items.size());
  int index = -1;
  for (int i = 0; i < count; ++i)
    if (parameter->text() == parameter->items[static_cast<std::size_t>(i)].name) index = i;
  parameter->set(parameter->items[static_cast<std::size_t>((index + by + count) % count)].name);
}

params::Parameter* Window::texture_parameter() {
  params::Parameter* texture = lab_.parameters().find("texture");
  return texture != nullptr ? texture : lab_.parameters().find("cube_map");
}

void Window::on_key(int key, int action, bool control) {
  if (action == GLFW_RELEASE || ImGui::GetIO().WantTextInput) return;
  // Held down, Esc would close one thing after the other, and quit.
  if (action == GLFW_REPEAT && key == GLFW_KEY_ESCAPE) return;
  perform(action_of(key, control));
}

void Window::on_drop(const std::filesystem::path& file) {
  const bool is_model = lower_case(file.extension().string()) == ".obj";
  params::Parameter* parameter = is_model ? app::model_parameter(lab_.parameters()) : texture_parameter();
  if (parameter == nullptr || parameter->type != params::Parameter::Type::file) {
    state_.message = fmt::format("this lab takes no {}", is_model ? "model" : "picture");
    return;
  }
  try {
    parameter->set(file.string());
    state_.message = fmt::format("{} is {}", parameter->name, file.string());
  } catch (const Error& error) {
    state_.message = error.what();
  }
}

bool Window::over_picture() const {
  const glm::vec2 at = in_picture(mouse_), size = picture_units();
  const bool inside = at.x >= 0 && at.x < size.x && at.y < size.y;
  const auto covers_mouse = [&](const std::pair<glm::vec2, glm::vec2>& cover) {
    return glm::all(glm::greaterThanEqual(mouse_, cover.first)) &&
           glm::all(glm::lessThan(mouse_, cover.second));
  };
  const bool is_covered = state_.looks_open || ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup) ||
                          std::any_of(state_.covers.begin(), state_.covers.end(), covers_mouse);
  return inside && !is_covered;
}

void Window::on_scroll(double dy) {
  if (over_picture()) app::zoom(lab_.parameters(), dy);
}

void Window::on_button(int button, int action) {
  state_.quit_asked = false;
  if (button == GLFW_MOUSE_BUTTON_RIGHT) {
    drag_ = action == GLFW_PRESS && over_picture() ? Drag::light : Drag::none;
    return;
  }
  if (button != GLFW_MOUSE_BUTTON_LEFT) return;
  if (action == GLFW_PRESS && over_picture()) {
    drag_ = Drag::picture;
    if (state_.split &&
        std::abs(in_picture(mouse_).x - state_.split->position * picture_units().x) < 8 * scale_)
      drag_ = Drag::split_line;
    pressed_at_ = mouse_;
  } else if (action == GLFW_RELEASE) {
    if (drag_ == Drag::picture && glm::distance(pressed_at_, mouse_) <= kClickTolerance) click();
    drag_ = Drag::none;
  }
}

void Window::click() {
  const glm::vec2 pixel = in_picture(mouse_) * pixels_per_unit();
  state_.inspected.emplace();
  state_.inspected->pixel = {static_cast<int>(pixel.x), picture_pixels().y - 1 - static_cast<int>(pixel.y)};
  drawn_ = {};
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
