// SPDX-License-Identifier: MIT
#include "steps.hpp"

#include <fmt/format.h>

#include <cmath>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/error.hpp"
#include "core/process.hpp"
#include "gl/upload.hpp"
#include "image/data_view.hpp"
#include "image/difference.hpp"
#include "image/load.hpp"

namespace texel::app {
namespace {

namespace fs = std::filesystem;
using image::Image8;
using image::ImageF;
using nlohmann::json;

/// A number; NaN has none in JSON.
double number(const json& value) {
  return value.is_null() ? std::nan("") : value.get<double>();
}

StepCase parse_case(const json& from) {
  StepCase one;
  one.name = from.at("name"), one.view = from.at("view"), one.message = from.at("message");
  one.unit = from.at("unit"), one.passed = from.at("status") == "passed";
  one.error = number(from.at("error")), one.limit = number(from.at("limit"));
  one.picture = from.at("picture").get<std::string>(), one.expected = from.at("expected").get<std::string>();
  for (const auto& [parameter, value] : from.at("set").items())
    one.settings.emplace_back(parameter, value.get<std::string>());
  return one;
}

/// A picture as it is shown: colours as they are, data views in colours.
Image8 shown(const Image8& picture, const std::string&) {
  return picture;
}
using image::shown;

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
void fill(CasePictures& pictures, const Picture& own, const Picture& expected, const StepCase& one) {
  if (own.width != expected.width || own.height != expected.height)
    throw Error::failed("does not have the size of the expected picture", {one.picture.string()});
  pictures.width = own.width, pictures.height = own.height;
  const Image8 own_shown = shown(own, one.view), expected_shown = shown(expected, one.view);
  pictures.own = upload(own_shown), pictures.expected = upload(expected_shown);
  pictures.difference = upload(absolute_difference(own_shown, expected_shown));
  image::Comparing comparing;
  if (one.unit == "degrees") comparing.unit = image::Unit::degrees;
  pictures.heat_map = upload(image::heatmap(expected, own, 0, comparing));
}

}  // namespace

struct StepsCheck::Shared {
  int lab;
  fs::path root;
  std::mutex mutex;
  bool is_running = false, is_wanted = false, is_new = false;
  std::vector<LabStep> steps;
  std::string fault;

  void run() {
    for (;;) {
      std::vector<LabStep> found;
      std::string why;
      try {
        const fs::path texel = fs::read_symlink("/proc/self/exe").parent_path() / "texel";
        const Ran ran = run_program(
            {"env", "TEXEL_ROOT=" + root.string(), texel.string(), "check", fmt::format("{}", lab), "--json"},
            true);
        if (ran.exit_code > 1) throw Error::failed(ran.output);
        found = parse_steps(ran.output);
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

std::vector<LabStep> parse_steps(const std::string& text) {
  std::vector<LabStep> steps;
  try {
    const json all = json::parse(text);
    for (const json& from : all.at("steps")) {
      LabStep step;
      step.id = from.at("id"), step.title = from.at("title"), step.status = from.at("status");
      step.message = from.at("message"), step.looks_like = from.at("looks_like_says");
      step.place = fmt::format("{}:{}", from.at("file").get<std::string>(), from.at("line").get<int>());
      step.hints = from.at("hints"), step.unit = from.at("unit");
      step.error = number(from.at("error")), step.limit = number(from.at("limit"));
      for (const json& one : from.at("cases")) step.cases.push_back(parse_case(one));
      steps.push_back(std::move(step));
    }
  } catch (const json::exception& error) {
    throw Error::failed(fmt::format("the check did not print its JSON: {}", error.what()));
  }
  return steps;
}

CasePictures load_case(const std::string& step, const StepCase& one) {
  CasePictures pictures;
  pictures.step = step, pictures.name = one.name;
  try {
    if (one.view == "mesh") throw Error::failed("this case compares vertices, not pictures");
    if (one.picture.empty()) throw Error::failed("your picture is missing: " + one.message);
    if (one.view == "color")
      fill(pictures, image::load8(one.picture, 3), image::load8(one.expected, 3), one);
    else
      fill(pictures, image::load_pfm(one.picture), image::load_pfm(one.expected), one);
  } catch (const Error& error) {
    pictures.fault = error.what();
  }
  return pictures;
}

}  // namespace texel::app
