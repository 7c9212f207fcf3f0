// SPDX-License-Identifier: MIT
// The frames of a lab's window.
#include "window/window.hpp"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gestures.hpp"
#include "app/settings.hpp"
#include "core/error.hpp"
#include "window_class.hpp"

namespace texel::window {
namespace {

constexpr glm::ivec2 kWindowSize(960, 720);
constexpr double kTurnPerSecond = 15;       // degrees
constexpr double kWatchMilliseconds = 100;  // well below the half second in which a save is seen
constexpr double kTruthMilliseconds = 80;   // a frame may work so long on the exact answer

/// After an event: the first frame finds what it does, the second draws it and measures what opens, and the
/// third has that in its place.
constexpr int kFramesToSettle = 2;

}  // namespace

Window::Window(app::AnyLab& lab, const app::Assets& assets, const WindowOptions& options)
    : lab_(lab),
      assets_(assets),
      options_(options),
      context_(options.size.value_or(kWindowSize).x, options.size.value_or(kWindowSize).y,
               fmt::format("Texel Labs {}: {}", lab.info().number, lab.info().title)),
      canvas_(context_, assets, lab) {
  state_.view = app::find_view(lab, options.view);
  state_.paused = options.turn_given;
  state_.config_file = lab.info().program() + ".toml";
  state_.looks.emplace(lab, assets);
  if (MoreSection::make != nullptr) state_.more = MoreSection::make(context_, assets, lab);
  state_.message = state_.looks->fault;
  if (!options.look_given && !state_.looks->entries.empty()) {
    const params::Parameter* turn = options.turn_given ? lab.parameters().find("turn") : nullptr;
    const double given = turn != nullptr ? turn->value() : 0;
    choose_look(lab, state_, 0);
    if (turn != nullptr) lab.parameters().at("turn").set_value(given);
  }
  const std::filesystem::path root = assets.shader_root().parent_path();
  if (state_.looks->fault.empty() &&
      std::filesystem::exists(root / "labs" / lab.info().folder() / "expected"))
    state_.steps.emplace(lab.info().folder(), root);
  std::error_code unknown;
  own_program_ = std::filesystem::read_symlink("/proc/self/exe", unknown);
  // Our callbacks first: ImGui's then call them.
  glfwSetWindowUserPointer(window(), this);
  glfwSetKeyCallback(window(), [](GLFWwindow* w, int key, int, int action, int mods) {
    self(w).on_key(key, action, (mods & GLFW_MOD_CONTROL) != 0);
  });
  glfwSetScrollCallback(window(), [](GLFWwindow* w, double, double dy) {
    if (self(w).over_picture()) app::zoom(self(w).lab_.parameters(), dy);
  });
  glfwSetMouseButtonCallback(
      window(), [](GLFWwindow* w, int button, int action, int) { self(w).on_button(button, action); });
  glfwSetCursorPosCallback(window(), [](GLFWwindow* w, double x, double y) { self(w).on_move({x, y}); });
  glfwSetDropCallback(window(), [](GLFWwindow* w, int count, const char** paths) {
    for (int i = 0; i < count; ++i) self(w).on_drop(paths[i]);
  });
  glfwSetFramebufferSizeCallback(window(), [](GLFWwindow* w, int, int) { self(w).frame(); });
  glfwGetWindowContentScale(window(), &scale_, nullptr);
}

void Window::run() {
  open();
  show();
  if (state_.steps) state_.steps->request();
  while (glfwWindowShouldClose(window()) == 0) {
    if (turning() || is_busy() || frames_due_ > 0) {
      glfwPollEvents();
      frames_due_ = std::max(frames_due_ - 1, 0);
    } else {
      const Stopwatch stopwatch;
      glfwWaitEventsTimeout(kWatchMilliseconds / 1000);
      if (stopwatch.milliseconds() < kWatchMilliseconds) frames_due_ = kFramesToSettle;
    }
    frame();
  }
}

bool Window::turning() {
  // The exact answer takes longer than a frame: under the view `error`, and while a section measures by it,
  // the model stands still.
  return lab_.parameters().find("turn") != nullptr && !state_.paused && state_.error.first.empty() &&
         state_.view != app::View::error && !state_.more_is_open && !state_.looks_open && !turntable_;
}

bool Window::is_busy() const {
  return truth_share_ < 1 || turntable_ || (state_.more_is_open && !state_.progress.empty()) ||
         (state_.looks_open && !state_.looks->are_drawn());
}

void Window::ask_size() {
  glfwGetFramebufferSize(window(), &pixels_.x, &pixels_.y);
  glfwGetWindowSize(window(), &units_.x, &units_.y);
}

void Window::open() {
  ask_size();
  state_.panel_width = default_panel_width(static_cast<float>(units_.x), scale_);
  if (is_seen()) {
    draw_picture();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glClearColor(theme().background.x, theme().background.y, theme().background.z, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    show_picture();
    glfwSwapBuffers(window());
  }
  gui_.emplace(window(), scale_);
}

void Window::frame() {
  ask_size();
  if (!is_seen() || !gui_) return;  // or not yet opened
  watch();
  follow_steps();
  const double seconds = std::min(frame_clock_.milliseconds() / 1000, 0.2);
  frame_clock_ = Stopwatch();
  if (turning()) app::turn(lab_.parameters(), kTurnPerSecond * seconds);
  state_.dock = dock_size(state_, room(), scale_);
  if (drag_ == Drag::none && !ImGui::IsAnyItemActive()) history_.note(save_look(lab_.parameters(), state_));
  try {
    if (state_.looks_open && !state_.looks->are_drawn()) {
      state_.looks->draw_next(context_, assets_, lab_);
    } else if (turntable_) {
      go_on_with_turntable();
    } else {
      draw_picture();
      work_on_more();
    }
  } catch (const Error& error) {
    state_.message = error.what();
  }
  show();
}

void Window::show_picture() {
  const glm::ivec2 size = picture_pixels();
  const auto left = static_cast<int>(std::lround(state_.panel_width * pixels_per_unit()));
  canvas_.copy_to_window({left, pixels_.y - size.y}, size);
}

void Window::show() {
  if (!is_seen()) return;
  show_picture();
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();  // before ImGui 1.87 it asks where the mouse is now
  if (held_frames_ > 0) --held_frames_, ImGui::GetIO().MousePos = {held_at_.x, held_at_.y};
  ImGui::NewFrame();
  if (drag_ == Drag::split_line || over_line()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  draw_panel(lab_, state_, scale_);
  draw_overlay(lab_, state_, picture_units(), pixels_per_unit(), scale_);
  draw_step(state_, units_, scale_);
  perform(std::exchange(state_.wanted, Action::none));  // what it opens is drawn in this frame
  draw_pixel(state_, picture_units(), pixels_per_unit(), scale_);
  draw_looks(lab_, state_, picture_units(), scale_);
  draw_keys(state_, picture_units());
  ImGui::Render();
  glViewport(0, 0, pixels_.x, pixels_.y);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  glfwSwapBuffers(window());
}

void Window::watch() {
  if (watch_clock_.milliseconds() < kWatchMilliseconds) return;
  watch_clock_ = Stopwatch();
  if (!watcher_.changed(canvas_.programs().files()).empty()) reload(/*assets=*/false);
  if (!watcher_.changed(assets_.files()).empty()) reload(/*assets=*/true);
  if (!state_.steps) return;
  if (!watcher_.changed(state_.steps->program_texts()).empty()) state_.steps->request(/*build=*/true);
  // A program that was built again draws other pictures, but this process still has the old code.
  if (!watcher_.changed({own_program_}).empty()) {
    state_.steps->request();
    state_.built_again = true;
  }
}

void Window::follow_steps() {
  if (!state_.steps || !state_.steps->poll()) return;
  const StepsCheck::Found& found = state_.steps->found();
  state_.compile_error = read_message(found.compile_error, assets_.shader_root().parent_path());
  for (const judge::StepResult& step : found.steps) {
    const auto one = std::ranges::find(step.cases, options_.see, &judge::CaseResult::name);
    if (step.id == options_.see)
      pick_step(lab_, state_, step);
    else if (one != step.cases.end())
      pick_case(lab_, state_, step, *one);
    else
      continue;
    state_.step_to_open = step.id;
    options_.see.clear();
  }
  if (!options_.see.empty() && !found.steps.empty())
    state_.message = fmt::format("this lab has no step or case {}", std::exchange(options_.see, {}));
  if (!state_.case_pictures) return;
  for (const judge::StepResult& step : found.steps)
    for (const judge::CaseResult& one : step.cases)
      if (one.name == state_.case_pictures->result.name) {
        CasePictures fresh = state_.steps->load_case(step, one);
        const CasePictures& before = *state_.case_pictures;
        fresh.shows_difference = before.shows_difference, fresh.position = before.position;
        fresh.chosen = before.chosen;
        state_.case_pictures = std::move(fresh);
      }
}

void Window::reload(bool assets) {
  if (state_.steps) state_.steps->request();
  canvas_.programs().clear();
  if (assets) lab_.forget();
  drawn_.clear();
  state_.looks->drawn = 0;
  if (state_.more) state_.more->forget();
  reloaded_ = assets ? "files reloaded" : "shaders compiled again";
}

void Window::fit_view() {
  const course::Look* look = chosen_look();
  const double made_for = look != nullptr ? static_cast<double>(look->size.width) / look->size.height : 1;
  const double own = static_cast<double>(picture_pixels().x) / std::max(picture_pixels().y, 1);
  app::fit_view(lab_.parameters(), own, made_for);
}

void Window::draw_picture() {
  const glm::ivec2 size = picture_pixels();
  const app::KeptValues before(lab_.parameters());
  fit_view();
  truth_share_ = 1;
  try {
    state_.progress.clear();
    state_.no_truth.clear();
    if (state_.view == app::View::error) try {
        truth_share_ = lab_.answer()->work(size, kTruthMilliseconds);
      } catch (const Error& error) {
        state_.no_truth = error.what();
      }
    if (truth_share_ < 1)
      state_.progress = fmt::format("working out the exact answer: {:.0f} %", 100 * truth_share_);
    // The colours stand in for the error until the exact answer is there. Where there is none, they are drawn
    // for the statistics only, and not shown: they would pass for an error.
    const bool is_unknown = !state_.no_truth.empty();
    const app::View view = truth_share_ < 1 || is_unknown ? app::View::color : state_.view;
    std::string look =
        fmt::format("{} {} {}x{} {} {} {}", lab_.parameters().key(), name_of(is_unknown ? state_.view : view),
                    size.x, size.y, state_.wireframe, state_.axes, state_.statistics_open);
    if (state_.split)
      look += fmt::format(" {}={} {}", state_.split->parameter, state_.split->value, state_.split->position);
    if (look == drawn_) return;
    drawn_ = look;
    const Stopwatch stopwatch;
    // While the model turns only the picture changes: what it is made of is not read again.
    const bool is_plain = !state_.split && !state_.wireframe;
    const bool reads = (is_plain || state_.statistics_open) && !(turning() && inspected_once_);
    if (reads) state_.record = canvas_.record(view, size, options_.samples);
    inspected_once_ = inspected_once_ || reads;
    canvas_.show_edges(state_.wireframe);
    if (!is_plain || !reads) canvas_.draw(view, size, options_.samples, state_.split);
    canvas_.show_edges(false);
    if (is_unknown) canvas_.draw_nothing(size);
    glFinish();
    state_.frame_milliseconds = stopwatch.milliseconds();
    state_.notes = canvas_.notes();
    state_.figures.reset();
    if (const app::ErrorFigures* figures = canvas_.error_figures()) state_.figures = *figures;
    state_.legend = is_unknown ? app::Legend() : canvas_.legend(view);
    if (!state_.legend.title.empty()) state_.legend_picture = picture_texture(state_.legend.picture);
    state_.error = {};
    if (!reloaded_.empty()) state_.message = std::exchange(reloaded_, {});
    inspect();
    state_.frame_lines = state_.axes ? frame_lines(canvas_, lab_, size) : std::vector<FrameLine>();
  } catch (const Error& error) {
    state_.error = read_message(error.what(), assets_.shader_root().parent_path());
    state_.frame_lines.clear();  // the last good picture may have another size
    if (!std::exchange(reloaded_, {}).empty()) state_.message = "the last good picture stays";
  }
}

void Window::work_on_more() {
  if (!state_.more_is_open || truth_share_ < 1) return;
  const app::KeptValues before(lab_.parameters());
  fit_view();
  const std::string progress = state_.more->work(picture_pixels());
  if (state_.progress.empty()) state_.progress = progress;
}

void Window::inspect() {
  if (!state_.inspected) return;
  const glm::ivec2 pixel = state_.inspected->pixel;
  state_.inspected->values.clear();
  state_.inspected->comparison.reset();
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= picture_pixels().x || pixel.y >= picture_pixels().y) return;
  for (const app::View view : lab_.views())
    if (view != app::View::color && view != app::View::mask && view != app::View::error)
      state_.inspected->values.emplace_back(view, canvas_.value_at(view, picture_pixels(), pixel));
  state_.inspected->textures = textures_at(canvas_, lab_, picture_pixels(), pixel);
  if (app::Answer* const answer = lab_.answer())
    state_.inspected->comparison = answer->compare_at(canvas_, picture_pixels(), pixel);
  state_.inspected->around = picture_texture(image::without_alpha(
      image::square_around(canvas_.read8(), pixel.x, pixel.y, WindowState::Inspected::kAround)));
}

void run_window(app::AnyLab& lab, const app::Assets& assets, const WindowOptions& options) {
  Window(lab, assets, options).run();
}

}  // namespace texel::window
