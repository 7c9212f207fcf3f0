// SPDX-License-Identifier: MIT
#include "window.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "config.hpp"
#include "core/error.hpp"
#include "core/stages.hpp"
#include "core/stopwatch.hpp"
#include "core/watcher.hpp"
#include "panel.hpp"
#include "reports.hpp"
#include "snapshot.hpp"

namespace texel::app {
namespace {

constexpr glm::ivec2 kWindowSize(960, 720);
constexpr double kTurnPerSecond = 15;       // degrees
constexpr double kWatchMilliseconds = 100;  // well below the half second in which a save is seen
constexpr float kDegreesPerUnit = 0.35F;    // of dragging
constexpr float kPanelGrey = 0.06F;         // of ImGui's dark style
constexpr float kClickTolerance = 3;        // window units that a click may move

/// ImGui with its two backends, from here to the end of the scope.
class Gui {
 public:
  Gui(GLFWwindow* window, float scale) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // the panel's place is not worth a file in the user's folder
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 6;
    style.Colors[ImGuiCol_WindowBg].w = 1;  // nothing of the last picture shines through
    style.FrameRounding = 3;
    style.ScaleAllSizes(scale);
    // ImGui's own font is drawn for 13 pixels; a common system font reads better where there is one.
    const std::filesystem::path font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
    if (std::filesystem::exists(font)) {
      io.Fonts->AddFontFromFileTTF(font.c_str(), std::round(14 * scale));
    } else {
      ImFontConfig config;
      config.SizePixels = std::round(13 * scale);
      io.Fonts->AddFontDefault(&config);
    }
    ImGui_ImplGlfw_InitForOpenGL(window, /*install_callbacks=*/true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
  }
  ~Gui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
  }
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;
};

class Window {
 public:
  Window(AnyLab& lab, const Assets& assets, const CommandLine& line)
      : lab_(lab),
        assets_(assets),
        samples_(line.samples),
        context_(line.size.value_or(kWindowSize).x, line.size.value_or(kWindowSize).y,
                 fmt::format("Texel Labs {}: {}", lab.info().number, lab.info().title)),
        canvas_(context_, assets, lab) {
    state_.view = find_view(lab, line.view);
    state_.paused = line.turn_given;
    see_ = line.see;
    state_.config_file = lab.info().program() + ".toml";
    const std::filesystem::path root = assets.shader_root().parent_path();
    if (std::filesystem::exists(root / "labs" / lab.info().folder() / "expected"))
      state_.steps.emplace(lab.info().number, root);
    std::error_code unknown;
    own_program_ = std::filesystem::read_symlink("/proc/self/exe", unknown);
    // Our callbacks first: ImGui's then call them.
    glfwSetWindowUserPointer(window(), this);
    glfwSetKeyCallback(window(),
                       [](GLFWwindow* w, int key, int, int action, int) { self(w).on_key(key, action); });
    glfwSetScrollCallback(window(), [](GLFWwindow* w, double, double dy) { self(w).on_scroll(dy); });
    glfwSetMouseButtonCallback(
        window(), [](GLFWwindow* w, int button, int action, int) { self(w).on_button(button, action); });
    glfwSetCursorPosCallback(window(), [](GLFWwindow* w, double x, double y) { self(w).on_move({x, y}); });
    glfwSetFramebufferSizeCallback(window(), [](GLFWwindow* w, int, int) { self(w).frame(); });
    float scale_y = 1;
    glfwGetWindowContentScale(window(), &scale_, &scale_y);
  }

  void run() {
    open();
    show();
    while (glfwWindowShouldClose(window()) == 0) {
      if (turning())
        glfwPollEvents();
      else
        glfwWaitEventsTimeout(kWatchMilliseconds / 1000);
      frame();
    }
  }

  /// Draws `count` frames as they are on a change of the look, and prints when the first picture stood, and
  /// the panel, how long the others took, and which part of that the panel, the statistics and the parameters
  /// had.
  void time_frames(int count) {
    open();
    wait_until_shown();
    const double first = milliseconds_since_start();
    show();
    wait_until_shown();
    const double panel = milliseconds_since_start();
    const double before = plumbing_milliseconds();
    std::vector<double> times;
    for (int i = 0; i < count; ++i) {
      const Stopwatch stopwatch;
      drawn_ = {};
      glfwPollEvents();
      frame();
      wait_until_shown();
      times.push_back(stopwatch.milliseconds());
    }
    const double plumbing = plumbing_milliseconds() - before;
    const double share = plumbing / std::accumulate(times.begin(), times.end(), 0.0);
    fmt::print(
        "the first after {:.0f} ms, the panel after {:.0f} ms\n{}"
        "panel, statistics and parameters: {:.3f} ms a frame, {:.2f} %\n",
        first, panel, frame_times_as_text(std::move(times), picture_pixels()), plumbing / count, 100 * share);
  }

 private:
  /// The X server answers when the picture is on the screen.
  void wait_until_shown() const {
    glFinish();
    double x = 0, y = 0;
    glfwGetCursorPos(window(), &x, &y);
  }

  /// Of the main thread: on a software renderer its rasteriser wants the same processors.
  static double plumbing_milliseconds() {
    double sum = 0;
    for (const auto& [name, time] : stage_times())
      if (name == "panel" || name == "statistics" || name == "parameters") sum += time.processor;
    return sum;
  }

  static Window& self(GLFWwindow* window) { return *static_cast<Window*>(glfwGetWindowUserPointer(window)); }
  [[nodiscard]] GLFWwindow* window() const { return context_.window(); }
  [[nodiscard]] params::Parameter* turn() { return lab_.parameters().find("turn"); }
  [[nodiscard]] bool turning() { return turn() != nullptr && !state_.paused && state_.error.empty(); }

  /// Asks for the window's size, once a frame: each question waits for the window system's answer.
  void ask_size() {
    glfwGetFramebufferSize(window(), &pixels_.x, &pixels_.y);
    glfwGetWindowSize(window(), &units_.x, &units_.y);
  }
  [[nodiscard]] float pixels_per_unit() const {
    return static_cast<float>(pixels_.x) / static_cast<float>(std::max(units_.x, 1));
  }
  /// The picture lies right of the panel: its size in units and in pixels, and a window position within it.
  [[nodiscard]] glm::vec2 picture_units() const {
    return {std::max(static_cast<float>(units_.x) - state_.panel_width, 16.0F), static_cast<float>(units_.y)};
  }
  [[nodiscard]] glm::ivec2 picture_pixels() const {
    return {static_cast<int>(std::lround(picture_units().x * pixels_per_unit())), pixels_.y};
  }
  [[nodiscard]] glm::vec2 in_picture(glm::vec2 position) const {
    return {position.x - state_.panel_width, position.y};
  }

  [[nodiscard]] bool is_seen() const { return pixels_.x > 0 && pixels_.y > 0; }  // not iconified

  /// Shows the first picture, then makes what draws the panel: a software renderer compiles that for 70 ms.
  void open() {
    ask_size();
    state_.panel_width = default_panel_width(static_cast<float>(units_.x), scale_);
    if (is_seen()) {
      draw_picture();
      glBindFramebuffer(GL_FRAMEBUFFER, 0);
      glDisable(GL_FRAMEBUFFER_SRGB);
      glClearColor(kPanelGrey, kPanelGrey, kPanelGrey, 1);
      glClear(GL_COLOR_BUFFER_BIT);
      copy_picture();
      glfwSwapBuffers(window());
    }
    gui_.emplace(window(), scale_);
  }

  void frame() {
    ask_size();
    if (!is_seen() || !gui_) return;  // or not yet opened
    {
      const Stage stage("panel");
      watch();
      follow_steps();
      advance();
    }
    draw_picture();
    show();
  }

  void copy_picture() { canvas_.copy_to_window({pixels_.x - picture_pixels().x, 0}, picture_pixels()); }

  /// The last picture and the panel.
  void show() {
    if (!is_seen()) return;
    copy_picture();
    {
      const Stage stage("panel");
      ImGui_ImplOpenGL3_NewFrame();
      ImGui_ImplGlfw_NewFrame();
      ImGui::NewFrame();
      perform(draw_panel(lab_, state_, scale_));
      draw_overlay(lab_, state_, picture_units(), pixels_per_unit(), scale_);
      draw_case(state_, picture_units(), scale_);
      ImGui::Render();
    }
    glViewport(0, 0, pixels_.x, pixels_.y);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(window());
  }

  /// Edited shaders are compiled again, edited pictures and models loaded again.
  void watch() {
    if (watch_clock_.milliseconds() < kWatchMilliseconds) return;
    watch_clock_ = Stopwatch();
    if (!watcher_.changed(canvas_.programs().files()).empty()) reload(/*assets=*/false);
    if (!watcher_.changed(assets_.files()).empty()) reload(/*assets=*/true);
    // A program that was built again draws other pictures, but this process still has the old code.
    if (state_.steps && !watcher_.changed({own_program_}).empty()) {
      state_.steps->request();
      state_.message = "the lab was built again: close and open it to see the change";
    }
  }

  /// Steps are checked when the first picture stands, and after every save.
  void follow_steps() {
    if (!state_.steps) return;
    if (inspected_once_ && !std::exchange(steps_begun_, true)) state_.steps->request();
    if (!state_.steps->poll()) return;
    for (const grade::StepResult& step : state_.steps->steps())
      if (step.id == see_) {
        pick_step(lab_, state_, step);
        see_.clear();
      }
    if (!see_.empty() && !state_.steps->steps().empty()) {
      state_.message = fmt::format("this lab has no step {}", see_);
      see_.clear();
    }
    if (!state_.case_pictures) return;
    for (const grade::StepResult& step : state_.steps->steps())
      for (const grade::CaseResult& one : step.cases)
        if (one.name == state_.case_pictures->name) {
          CasePictures fresh = load_case(step.id, one);
          fresh.shown = state_.case_pictures->shown, fresh.position = state_.case_pictures->position;
          state_.case_pictures = std::move(fresh);
        }
  }

  void reload(bool assets) {
    if (state_.steps) state_.steps->request();
    canvas_.programs().clear();
    if (assets) lab_.forget();
    drawn_ = {};
    state_.message = assets ? "files reloaded" : "shaders compiled again";
  }

  void advance() {
    const double seconds = frame_clock_.milliseconds() / 1000;
    frame_clock_ = Stopwatch();
    if (!turning()) return;
    const double degrees = turn()->value() + kTurnPerSecond * std::min(seconds, 0.2);
    turn()->set_value(degrees > turn()->most ? degrees - 360 : degrees);
  }

  /// What the picture depends on; nothing is drawn again while it stays the same.
  struct Look {
    std::string key;
    View view = View::color;
    glm::ivec2 size{0};
    std::string split;
    bool operator==(const Look&) const = default;
  };

  void draw_picture() {
    const std::string split = state_.split ? fmt::format("{}={} {}", state_.split->parameter,
                                                         state_.split->value, state_.split->position)
                                           : "";
    Look look;
    {
      const Stage stage("parameters");
      look = {lab_.parameters().key(), state_.view, picture_pixels(), split};
    }
    if (look == drawn_) return;
    drawn_ = look;
    try {
      const Stopwatch stopwatch;
      // While the model turns only the picture changes: what it is made of is not read again.
      if (turning() && inspected_once_)
        canvas_.draw(state_.view, picture_pixels(), samples_, state_.split);
      else if (state_.split)
        canvas_.draw(state_.view, picture_pixels(), samples_, state_.split);
      else
        state_.record = canvas_.record(state_.view, picture_pixels(), samples_);
      glFinish();
      inspected_once_ = true;
      state_.frame_milliseconds = stopwatch.milliseconds();
      state_.notes = canvas_.notes();
      state_.figures = canvas_.error_figures();
      state_.error.clear();
      inspect();
    } catch (const Error& error) {
      state_.error = error.what();
    }
  }

  /// Reads the data views at the clicked pixel.
  void inspect() {
    if (!state_.inspected) return;
    const glm::ivec2 pixel = state_.inspected->pixel;
    state_.inspected->values.clear();
    state_.inspected->comparison.reset();
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= picture_pixels().x || pixel.y >= picture_pixels().y) return;
    for (const View view : lab_.views())
      if (view != View::color && view != View::mask && view != View::error)
        state_.inspected->values.emplace_back(view, canvas_.value_at(view, picture_pixels(), pixel));
    state_.inspected->comparison = canvas_.compare_at(picture_pixels(), pixel);
  }

  void perform(Action action) {
    try {
      switch (action) {
        case Action::none:
          return;
        case Action::copy_command_line:
          state_.message = command_line(lab_, state_.view);
          glfwSetClipboardString(window(), state_.message.c_str());
          return;
        case Action::save_config:
          save_config(state_.config_file, lab_.info(), lab_.parameters());
          state_.message = "saved " + state_.config_file;
          return;
        case Action::load_config:
          load_config(state_.config_file, lab_.info(), lab_.parameters());
          state_.message = "loaded " + state_.config_file;
          return;
        case Action::snapshot:
          snapshot();
          return;
        case Action::reset_parameters:
          lab_.parameters().reset();
          return;
        case Action::reload:
          reload(/*assets=*/true);
          return;
      }
    } catch (const Error& error) {
      state_.message = error.what();
    }
  }

  /// Writes the picture without the panel under the first free name.
  void snapshot() {
    for (int i = 1; i < 1000; ++i) {
      const std::filesystem::path file = fmt::format("{}-{:03}.png", lab_.info().program(), i);
      if (std::filesystem::exists(file)) continue;
      take_snapshot(canvas_, lab_, state_.view, picture_pixels(), file).write();
      state_.message = "wrote " + file.string();
      return;
    }
    throw Error::failed("there are already 999 snapshots here", {}, "remove some of them");
  }

  /// The previous or next item of a list.
  static void step(params::Parameter* parameter, int by) {
    if (parameter == nullptr || parameter->items.empty()) return;
    const auto count = static_cast<int>(parameter->items.size());
    int index = -1;
    for (int i = 0; i < count; ++i)
      if (parameter->text() == parameter->items[static_cast<std::size_t>(i)].name) index = i;
    parameter->set(parameter->items[static_cast<std::size_t>((index + by + count) % count)].name);
  }

  /// The picture that K and L change: `texture`, else `cube_map`.
  params::Parameter* texture_parameter() {
    params::Parameter* texture = lab_.parameters().find("texture");
    return texture != nullptr ? texture : lab_.parameters().find("cube_map");
  }

  void on_key(int key, int action) {
    if (action == GLFW_RELEASE || ImGui::GetIO().WantTextInput) return;
    switch (key) {
      case GLFW_KEY_ESCAPE:
        glfwSetWindowShouldClose(window(), GLFW_TRUE);
        break;
      case GLFW_KEY_J:
        perform(Action::reset_parameters);
        break;
      case GLFW_KEY_M:
        if (params::Parameter* p = lab_.parameters().find("normal_mapping"))
          p->set_value(p->value() != 0 ? 0 : 1);
        break;
      case GLFW_KEY_K:
        step(texture_parameter(), -1);
        break;
      case GLFW_KEY_L:
        step(texture_parameter(), +1);
        break;
      case GLFW_KEY_SPACE:
        state_.paused = !state_.paused;
        break;
      case GLFW_KEY_R:
        for (const char* name : {"yaw", "pitch", "distance", "field_of_view", "turn"})
          if (params::Parameter* p = lab_.parameters().find(name)) p->reset();
        break;
      case GLFW_KEY_F5:
        perform(Action::reload);
        break;
      case GLFW_KEY_F12:
        perform(Action::snapshot);
        break;
      case GLFW_KEY_H:
        state_.panel_visible = !state_.panel_visible;
        break;
      default:
        break;
    }
  }

  void change(const char* name, double factor, double offset) {
    if (params::Parameter* p = lab_.parameters().find(name))
      p->set_value(std::clamp(p->value() * factor + offset, p->least, p->most));
  }

  /// By the mouse's place now: ImGui's WantCaptureMouse is that of the last frame.
  [[nodiscard]] bool over_picture() const {
    return in_picture(mouse_).x >= 0 && !ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
  }

  void on_scroll(double dy) {
    if (over_picture()) change("distance", std::pow(0.9, dy), 0);
  }

  void on_button(int button, int action) {
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

  void click() {
    const glm::vec2 pixel = in_picture(mouse_) * pixels_per_unit();
    state_.inspected = {{static_cast<int>(pixel.x), pixels_.y - 1 - static_cast<int>(pixel.y)}, {}, {}};
    drawn_ = {};
  }

  void on_move(glm::vec2 mouse) {
    const glm::vec2 moved = mouse - mouse_;
    mouse_ = mouse;
    if (drag_ == Drag::split_line && state_.split)
      state_.split->position = std::clamp(in_picture(mouse).x / picture_units().x, 0.0F, 1.0F);
    if (drag_ != Drag::picture || glm::distance(pressed_at_, mouse) <= kClickTolerance) return;
    if (params::Parameter* yaw = lab_.parameters().find("yaw"))
      yaw->set_value(std::remainder(yaw->value() - static_cast<double>(kDegreesPerUnit * moved.x), 360));
    change("pitch", 1, static_cast<double>(kDegreesPerUnit * moved.y));
  }

  enum class Drag { none, picture, split_line };

  AnyLab& lab_;
  const Assets& assets_;
  int samples_;
  gl::WindowContext context_;
  Canvas canvas_;
  std::optional<Gui> gui_;
  WindowState state_;
  Watcher watcher_;
  Stopwatch watch_clock_, frame_clock_;
  glm::ivec2 pixels_{0};  ///< of the framebuffer
  glm::ivec2 units_{0};   ///< of the window, in the units in which the mouse's place is told
  Look drawn_;
  bool inspected_once_ = false;
  bool steps_begun_ = false;
  std::string see_;  ///< the step that is shown as soon as it is checked, or ""
  std::filesystem::path own_program_;
  float scale_ = 1;
  Drag drag_ = Drag::none;
  glm::vec2 mouse_{0}, pressed_at_{0};
};

}  // namespace

void run_window(AnyLab& lab, const Assets& assets, const CommandLine& line) {
  Window window(lab, assets, line);
  if (line.frames > 0)
    window.time_frames(line.frames);
  else
    window.run();
}

}  // namespace texel::app
