// SPDX-License-Identifier: MIT
#include "steps.hpp"

#include <fmt/format.h>

#include <mutex>
#include <thread>

#include "check/files.hpp"
#include "core/error.hpp"
#include "core/process.hpp"
#include "gl/upload.hpp"
#include "judge/results_json.hpp"

namespace texel::app {
namespace {

namespace fs = std::filesystem;
gl::Texture upload(const image::Image8& picture) {
  gl::Sampling sampling;
  sampling.minify = GL_LINEAR, sampling.magnify = GL_NEAREST;
  sampling.wrap_s = sampling.wrap_t = GL_CLAMP_TO_EDGE;
  return gl::make_texture_2d(picture, image::Encoding::linear, sampling);
}

}  // namespace

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

CasePictures load_case(const std::string& step, const grade::CaseResult& one) {
  CasePictures pictures;
  pictures.step = step, pictures.name = one.name;
  try {
    const image::Compared all = grade::compared(one);
    pictures.width = all.own.width, pictures.height = all.own.height;
    pictures.own = upload(all.own), pictures.expected = upload(all.expected);
    pictures.difference = upload(all.difference), pictures.heat_map = upload(all.heat_map);
  } catch (const Error& error) {
    pictures.fault = error.what();
  }
  return pictures;
}

}  // namespace texel::app
