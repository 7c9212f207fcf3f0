// SPDX-License-Identifier: MIT
// The steps: their check in the background, and their section of the panel.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <mutex>
#include <thread>
#include <utility>

#include "check/check.hpp"
#include "core/error.hpp"
#include "core/process.hpp"
#include "panel.hpp"

namespace texel::window {

namespace {

namespace fs = std::filesystem;
using judge::Status;

/// The folder where this program was built from the tree, or "".
fs::path build_folder_of(const fs::path& root) {
  std::error_code unknown;
  const fs::path build = fs::read_symlink("/proc/self/exe", unknown).parent_path().parent_path();
  std::ifstream cache(build / "CMakeCache.txt");
  constexpr std::string_view kHome = "CMAKE_HOME_DIRECTORY:INTERNAL=";
  for (std::string line; std::getline(cache, line);)
    if (line.starts_with(kHome) && fs::equivalent(line.substr(kHome.size()), root, unknown)) return build;
  return {};
}

/// A text that marks code with `, without these marks.
void wrapped_plain(const ImVec4& color, const std::string& text) {
  wrapped_text(color, course::without_markdown(text));
}

std::string figure(const judge::StepResult& step) {
  const judge::CaseResult* telling = judge::clearest_case(step);
  return telling == nullptr || std::isnan(telling->error) ? "nothing to compare" : off_by(*telling);
}

void step_details(app::AnyLab& lab, WindowState& state, const judge::StepResult& step) {
  wrapped_plain(theme().dim, fmt::format("{}:{}", step.file, step.line));
  const auto picked = std::ranges::find_if(step.cases, [&](const judge::CaseResult& one) {
    return state.case_pictures && state.case_pictures->result.name == one.name;
  });
  const std::string& message = picked != step.cases.end() ? picked->message : step.message;
  if (step.status != Status::passed && state.shown_error().first.empty())
    wrapped_plain(theme().text, message);
  if (!step.mistake_says.empty()) wrapped_plain(theme().next, "This looks like: " + step.mistake_says);
  std::size_t& shown = state.hints[step.id];
  for (std::size_t i = 0; i < std::min(shown, step.hints.size()); ++i)
    wrapped_plain(theme().dim, fmt::format("{}. {}", i + 1, step.hints[i]));
  if (shown < step.hints.size() && step.status != Status::passed &&
      ImGui::SmallButton(fmt::format("hint {} of {}", shown + 1, step.hints.size()).c_str()))
    ++shown;
  for (const judge::CaseResult& one : step.cases) {
    ImGui::PushStyleColor(ImGuiCol_Text, one.passed() ? theme().good : theme().next);
    if (ImGui::Selectable(fmt::format("{} {}", one.passed() ? "right" : "wrong", one.name).c_str(),
                          picked != step.cases.end() && &*picked == &one))
      pick_case(lab, state, step, one);
    ImGui::PopStyleColor();
    if (ImGui::IsItemHovered())
      ImGui::SetTooltip("Click to set this look and show the expected picture beside yours");
  }
}

}  // namespace

struct StepsCheck::Shared {
  course::Lab lab;
  check::OwnTree tree;
  std::mutex mutex;
  bool is_running = false, is_wanted = false, build_is_wanted = false, asked_for_course = false;
  std::string progress;
  Found last;
  bool is_new = false;  ///< `last` was not polled yet

  void say(std::string text) {
    const std::scoped_lock lock(mutex);
    progress = std::move(text);
  }

  /// The steps of some labs as `texel check` finds them; of all for none.
  [[nodiscard]] std::vector<judge::StepResult> check(const std::vector<std::string>& labs) const {
    const fs::path texel = fs::read_symlink("/proc/self/exe").parent_path() / "texel";
    std::vector<std::string> words{"env", "TEXEL_ROOT=" + tree.source.string(), texel.string(), "check",
                                   "--json"};
    words.insert(words.end(), labs.begin(), labs.end());
    const Ran ran = run_program(words, true);
    if (ran.exit_code > 1) throw Error::failed(ran.output);
    return judge::parse_steps(ran.output);
  }

  /// The compiler's messages, or "".
  std::string build() {
    say("building");
    return check::build_program(
        tree, lab, fmt::format("the window of lab {}", lab.number),
        [&](const std::string& other) { say("waiting for another build: " + other); });
  }

  /// Builds and checks until nothing more is wanted.
  void run() {
    for (std::unique_lock lock(mutex); is_wanted;) {
      is_wanted = false;
      const bool builds = std::exchange(build_is_wanted, false);
      Found found = {.steps = last.steps, .course = {}, .fault = {}, .compile_error = {}};
      lock.unlock();
      try {
        if (builds) found.compile_error = build();
        // Else the program is older than what was saved: the steps stay.
        say("checking your steps");
        if (found.compile_error.empty()) found.steps = check({std::to_string(lab.number)});
      } catch (const std::exception& error) {
        found = {.steps = {}, .course = {}, .fault = error.what(), .compile_error = {}};
      }
      lock.lock();
      found.course = std::move(last.course);
      last = std::move(found);
      is_new = true;
      is_running = is_wanted;
    }
  }

  /// Checks all labs, once. Nobody waits for it: another lab's program may never end.
  void check_course() {
    std::unique_lock lock(mutex);
    if (std::exchange(asked_for_course, true)) return;
    lock.unlock();
    try {
      std::vector<judge::StepResult> course = check({});
      lock.lock();
      last.course = std::move(course);
      is_new = true;
    } catch (const std::exception&) {  // a lab's program is not built: there is no line of the course
    }
  }
};

StepsCheck::StepsCheck(const std::string& lab_folder, fs::path root) : shared_(std::make_shared<Shared>()) {
  shared_->lab = course::read_lab(root / "labs" / lab_folder / "lab.toml");
  const fs::path build = build_folder_of(root);
  if (!build.empty())
    for (const fs::path& file : check::edited_files(root, shared_->lab))
      if (file.extension() == ".cpp" || file.extension() == ".hpp") program_texts_.push_back(file);
  shared_->tree = {std::move(root), build};
}

void StepsCheck::request(bool build) {
  const std::scoped_lock lock(shared_->mutex);
  shared_->is_wanted = true;
  shared_->build_is_wanted = shared_->build_is_wanted || build;
  if (std::exchange(shared_->is_running, true)) return;
  // It owns everything that it needs: closing the window need not wait for it.
  std::thread([shared = shared_] { shared->run(), shared->check_course(); }).detach();
}

bool StepsCheck::poll() {
  const std::scoped_lock lock(shared_->mutex);
  if (!std::exchange(shared_->is_new, false)) return false;
  found_ = shared_->last;
  for (const judge::StepResult& own : found_.steps)
    if (const auto one = std::ranges::find(found_.course, own.id, &judge::StepResult::id);
        one != found_.course.end())
      *one = own;
  return true;
}

std::string StepsCheck::progress() const {
  const std::scoped_lock lock(shared_->mutex);
  return shared_->is_running ? shared_->progress : "";
}

const course::Case& StepsCheck::look_of(const std::string& step) const {
  const std::vector<course::Step>& all = shared_->lab.steps;
  const auto found = std::ranges::find(all, step, &course::Step::id);
  if (found == all.end()) throw Error::usage(fmt::format("this lab has no step '{}'", step));
  return found->see;
}

std::string off_by(const judge::CaseResult& one) {
  return fmt::format("off by {:.3g} {} (limit {:g})", one.error, name_of(one.unit()), one.limit);
}

CasePictures StepsCheck::load_case(const judge::StepResult& step, const judge::CaseResult& one) const {
  CasePictures pictures;
  pictures.step = step.id, pictures.title = step.title, pictures.result = one;
  pictures.text =
      course::read_step_text(shared_->tree.source, shared_->lab.folder, step.id, step.file, step.line);
  if (step.status != judge::Status::passed) pictures.text.after.clear();
  try {
    const image::Compared& all = pictures.compared = check::compared(one);
    pictures.own = picture_texture(all.own), pictures.expected = picture_texture(all.expected);
    pictures.difference = picture_texture(all.difference);
    pictures.heat_map = picture_texture(all.heat_map);
    pictures.legend = app::error_legend(all.full_scale, one.unit());
    pictures.legend_picture = picture_texture(pictures.legend.picture);
  } catch (const Error& error) {
    pictures.fault = error.what();
  }
  return pictures;
}

void steps_section(app::AnyLab& lab, WindowState& state) {
  if (!state.steps) return;
  const std::vector<judge::StepResult>& steps = state.steps->found().steps;
  const auto done = std::ranges::count(steps, Status::passed, &judge::StepResult::status);
  const bool are_all = done > 0 && done == std::ssize(steps);
  // They fold when the last one is done, and open when one no longer is.
  if (std::exchange(state.all_steps_done, are_all) != are_all) ImGui::SetNextItemOpen(!are_all);
  const std::string count = steps.empty() ? "" : fmt::format(": {} of {} done", done, steps.size());
  ImGui::PushStyleColor(ImGuiCol_Text, are_all ? theme().good : theme().text);
  const bool is_open =
      ImGui::CollapsingHeader(fmt::format("Steps{}###steps", count).c_str(), ImGuiTreeNodeFlags_DefaultOpen);
  ImGui::PopStyleColor();
  if (!is_open) return;
  const std::string& fault = state.steps->found().fault;
  if (!fault.empty())
    wrapped_plain(theme().next, "Not checked: " + fault);
  else if (steps.empty())
    ImGui::TextColored(theme().dim, "checking");
  const auto next = std::ranges::find(steps, Status::failed, &judge::StepResult::status);
  for (const judge::StepResult& step : steps) {
    const bool is_done = step.status == Status::passed, is_wrong = step.status == Status::failed;
    const bool is_next = is_wrong && &step == &*next;
    const ImVec4& color = is_done ? theme().good : is_next ? theme().next : theme().dim;
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    if (state.step_to_open == step.id) {
      ImGui::SetNextItemOpen(true);
      state.step_to_open.clear();
    }
    const bool shows = ImGui::TreeNodeEx(step.id.c_str(), ImGuiTreeNodeFlags_SpanAvailWidth, "%s", "");
    ImGui::PopStyleColor();
    if (ImGui::IsItemToggledOpen() && shows) pick_step(lab, state, step);
    if (ImGui::IsItemHovered() && is_done) ImGui::SetTooltip("%s", figure(step).c_str());
    ImGui::SameLine();  // the title beside the triangle: a tree node's own text is not wrapped
    const std::string waits = step.status == Status::skipped && !step.spoilt_by.empty()
                                  ? " (for " + judge::listed(step.spoilt_by) + ")"
                                  : "";
    wrapped_plain(color,
                  fmt::format("{} {} {}{}", judge::word_of(step, is_next), step.id, step.title, waits));
    if (is_wrong && !shows && !step.is_untouched()) {
      ImGui::Indent();
      wrapped_plain(theme().dim, figure(step));
      ImGui::Unindent();
    }
    if (!shows) continue;
    step_details(lab, state, step);
    ImGui::TreePop();
  }
}

void course_line(const std::vector<judge::StepResult>& course, int lab) {
  if (course.empty()) return;
  const float unit = ImGui::GetFontSize() / 2,
              width = ImGui::GetContentRegionAvail().x / static_cast<float>(course.size());
  ImVec2 from = ImGui::GetCursorScreenPos();
  const judge::StepResult* next = nullptr;
  const ImVec4& border = ImGui::GetStyleColorVec4(ImGuiCol_Border);  // seen in both themes
  for (const judge::StepResult& step : course) {
    const bool is_done = step.status == Status::passed, is_next = !is_done && next == nullptr;
    if (is_next) next = &step;
    const float height = std::stoi(step.id) == lab ? 1.5F * unit : unit;
    const ImVec4& color = is_done ? theme().good : is_next ? theme().next : border;
    ImGui::GetWindowDrawList()->AddRectFilled({from.x, from.y + 1.5F * unit - height},
                                              {from.x + width - 1, from.y + 1.5F * unit},
                                              ImGui::GetColorU32(color));
    if (ImGui::IsMouseHoveringRect(from, {from.x + width, from.y + 2 * unit}))
      ImGui::SetTooltip("%s %s: %s", step.id.c_str(), step.title.c_str(), judge::word_of(step, is_next));
    from.x += width;
  }
  ImGui::Dummy({0, 2 * unit});
  const auto done = std::ranges::count(course, Status::passed, &judge::StepResult::status);
  wrapped_text(theme().dim, fmt::format("Course: {} of {} steps right{}", done, course.size(),
                                        next != nullptr ? ", next is " + next->id : ""));
}

void set_look(app::AnyLab& lab, WindowState& state, const course::Case& look) {
  try {
    choose(look, lab, state.view);
    state.split.reset();
    state.look.reset();
    state.paused = true;
    state.message.clear();
  } catch (const Error& error) {
    state.message = error.what();
  }
}

void pick_case(app::AnyLab& lab, WindowState& state, const judge::StepResult& step,
               const judge::CaseResult& one) {
  set_look(lab, state, one.is_mesh() ? state.steps->look_of(step.id) : one);
  state.case_pictures = state.steps->load_case(step, one);
  state.case_is_new = true;
}

void pick_step(app::AnyLab& lab, WindowState& state, const judge::StepResult& step) {
  if (const judge::CaseResult* telling = judge::clearest_case(step)) pick_case(lab, state, step, *telling);
}

}  // namespace texel::window
