// SPDX-License-Identifier: MIT
#include "steps.hpp"

#include <fmt/format.h>

#include <mutex>
#include <thread>

#include "check/files.hpp"
#include "core/error.hpp"
#include "core/process.hpp"
#include "judge/results_json.hpp"
#include "picture_texture.hpp"

namespace texel::app {

namespace fs = std::filesystem;

struct StepsCheck::Shared {
  int lab;
  fs::path root;
  std::mutex mutex;
  bool is_running = false, is_wanted = false, is_new = false;
  std::vector<grade::StepResult> steps;
  std::string fault;

  void run() {
    for (;;) {
      std::vector<grade::StepResult> found;
      std::string why;
      try {
        const fs::path texel = fs::read_symlink("/proc/self/exe").parent_path() / "texel";
        const Ran ran = run_program(
            {"env", "TEXEL_ROOT=" + root.string(), texel.string(), "check", fmt::format("{}", lab), "--json"},
            true);
        if (ran.exit_code > 1) throw Error::failed(ran.output);
        found = grade::parse_steps(ran.output);
      } catch (const std::exception& error) {
        why = error.what();
      }
      const std::scoped_lock lock(mutex);
      steps = std::move(found), fault = std::move(why);
      is_new = true;
      is_running = is_wanted;
      if (!is_wanted) return;
      is_wanted = false;
    }
  }
};

StepsCheck::StepsCheck(int lab, fs::path root) : shared_(std::make_shared<Shared>()) {
  shared_->lab = lab, shared_->root = std::move(root);
}

void StepsCheck::request() {
  const std::scoped_lock lock(shared_->mutex);
  if (shared_->is_running) {
    shared_->is_wanted = true;
    return;
  }
  shared_->is_running = true;
  // It owns everything that it needs: closing the window need not wait for it.
  std::thread([shared = shared_] { shared->run(); }).detach();
}

bool StepsCheck::poll() {
  const std::scoped_lock lock(shared_->mutex);
  if (!shared_->is_new) return false;
  shared_->is_new = false;
  steps_ = shared_->steps, fault_ = shared_->fault;
  return true;
}

bool StepsCheck::is_running() const {
  const std::scoped_lock lock(shared_->mutex);
  return shared_->is_running;
}

const fs::path& StepsCheck::root() const {
  return shared_->root;
}

CasePictures load_case(const fs::path& root, const std::string& lab, const grade::StepResult& step,
                       const grade::CaseResult& one) {
  CasePictures pictures;
  pictures.step = step.id, pictures.name = one.name, pictures.title = step.title;
  pictures.message = one.message, pictures.unit = name_of(one.unit()), pictures.limit = one.limit;
  pictures.text = read_step_text(root, lab, step.id, step.file, step.line);
  try {
    const image::Compared all = grade::compared(one);
    pictures.width = all.own.width, pictures.height = all.own.height;
    pictures.own = picture_texture(all.own), pictures.expected = picture_texture(all.expected);
    pictures.difference = picture_texture(all.difference);
    pictures.heat_map = picture_texture(all.heat_map);
    pictures.figures = all.figures, pictures.full_scale = all.full_scale;
  } catch (const Error& error) {
    pictures.fault = error.what();
  }
  return pictures;
}

}  // namespace texel::app
