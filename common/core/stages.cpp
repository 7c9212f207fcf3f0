// SPDX-License-Identifier: MIT
#include "core/stages.hpp"

#include <algorithm>
#include <ctime>
#include <thread>

namespace texel {
namespace {

const std::thread::id main_thread = std::this_thread::get_id();
Stage* innermost = nullptr;

auto& all_stages() {
  static std::vector<std::pair<std::string, double>> all;
  return all;
}

// When this program's first instructions run nothing has waited yet: the processor's clock tells how long
// loading it took.
const double loading = 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
const Stopwatch since_loaded;

}  // namespace

Stage::Stage(const char* name) : name_(std::this_thread::get_id() == main_thread ? name : nullptr) {
  if (name_ == nullptr) return;
  outer_ = innermost;
  innermost = this;
}

Stage::~Stage() {
  if (name_ == nullptr) return;
  innermost = outer_;
  const double time = stopwatch_.milliseconds();
  if (outer_ != nullptr) outer_->inner_ += time;
  auto& all = all_stages();
  auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.first == name_; });
  if (found == all.end()) found = all.insert(found, {name_, 0});
  found->second += time - inner_;
}

std::vector<std::pair<std::string, double>> stage_times() {
  return all_stages();
}

double milliseconds_since_start() {
  return loading + since_loaded.milliseconds();
}

}  // namespace texel
