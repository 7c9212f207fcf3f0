// SPDX-License-Identifier: MIT
#include "steps.hpp"

#include <fmt/format.h>

#include <mutex>
#include <thread>

#include "core/error.hpp"
#include "core/process.hpp"
#include "gl/upload.hpp"
#include "image/data_view.hpp"
#include "image/difference.hpp"
#include "image/load.hpp"
#include "judge/results_json.hpp"

namespace texel::app {
namespace {

namespace fs = std::filesystem;
using image::Image8;
using image::ImageF;

/// A picture as it is shown: colours as they are, data views in colours.
Image8 shown(const Image8& picture, View) {
  return picture;
}
Image8 shown(const ImageF& picture, View view) {
  return image::shown(picture, name_of(view));
}

Image8 absolute_difference(const Image8& a, const Image8& b) {
  Image8 result(a.width, a.height, 3);
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x)
      for (int c = 0; c < 3; ++c)
        result.at(x, y, c) = static_cast<std::uint8_t>(std::abs(a.at(x, y, c) - b.at(x, y, c)));
  return result;
}

gl::Texture upload(const Image8& picture) {
  gl::Sampling sampling;
  sampling.minify = GL_LINEAR, sampling.magnify = GL_NEAREST;
  sampling.wrap_s = sampling.wrap_t = GL_CLAMP_TO_EDGE;
  return gl::make_texture_2d(picture, image::Encoding::linear, sampling);
}

template <class Picture>
void fill(CasePictures& pictures, const Picture& own, const Picture& expected, const grade::CaseResult& one) {
  if (own.width != expected.width || own.height != expected.height)
    throw Error::failed("does not have the size of the expected picture", {one.picture});
  pictures.width = own.width, pictures.height = own.height;
  const Image8 own_shown = shown(own, one.view), expected_shown = shown(expected, one.view);
  pictures.own = upload(own_shown), pictures.expected = upload(expected_shown);
  pictures.difference = upload(absolute_difference(own_shown, expected_shown));
  image::Comparing comparing;
  if (one.unit() == Unit::degrees) comparing.unit = image::Unit::degrees;
  pictures.heat_map = upload(image::heatmap(expected, own, 0, comparing));
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
    if (one.is_mesh()) throw Error::failed("this case compares vertices, not pictures");
    if (one.picture.empty()) throw Error::failed("your picture is missing: " + one.message);
    if (one.view == View::color)
      fill(pictures, image::load8(one.picture, 3), image::load8(one.reference, 3), one);
    else
      fill(pictures, image::load_pfm(one.picture), image::load_pfm(one.reference), one);
  } catch (const Error& error) {
    pictures.fault = error.what();
  }
  return pictures;
}

}  // namespace texel::app
