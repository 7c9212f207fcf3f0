// SPDX-License-Identifier: MIT
#include "steps_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <mutex>
#include <thread>
#include <utility>

#include "check/check.hpp"
#include "core/error.hpp"
#include "core/process.hpp"
#include "image/load.hpp"

namespace texel::window {

namespace fs = std::filesystem;

namespace {

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
        say("checking your steps");
        // Else the program is older than what was saved: the steps stay.
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

  /// Checks all labs, until that went well once. Nobody waits for it: another lab's program may never end.
  void check_course() {
    std::unique_lock lock(mutex);
    if (std::exchange(asked_for_course, true)) return;
    lock.unlock();
    try {
      std::vector<judge::StepResult> course = check({});
      lock.lock();
      last.course = std::move(course);
      is_new = true;
    } catch (const std::exception&) {  // a lab's program is not built: asked again after the next save
      lock.lock();
      asked_for_course = false;
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

CasePictures StepsCheck::load_case(const judge::StepResult& step, const judge::CaseResult& one) const {
  CasePictures pictures;
  pictures.step = step.id, pictures.title = step.title, pictures.result = one;
  pictures.text =
      course::read_step_text(shared_->tree.source, shared_->lab.folder, step.id, step.file, step.line);
  if (step.status != judge::Status::passed) pictures.text.after.clear();
  try {
    if (one.is_mesh()) {  // what the handout shows: before, and right
      pictures.compared.own =
          image::load8(shared_->tree.source / "docs/pictures/steps" / (step.id + ".png"), 3);
      pictures.expected = picture_texture(pictures.compared.own);
      return pictures;
    }
    const image::Compared& all = pictures.compared = check::compared(one);
    pictures.own = picture_texture(all.own), pictures.expected = picture_texture(all.expected);
    pictures.difference = picture_texture(all.heat_map);
    pictures.legend = app::error_legend(all.full_scale, one.unit());
    pictures.legend_picture = picture_texture(pictures.legend.picture);
  } catch (const Error& error) {
    pictures.fault = error.what();
  }
  return pictures;
}

}  // namespace texel::window
