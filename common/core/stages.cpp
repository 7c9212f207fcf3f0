// SPDX-License-Identifier: MIT
#include "core/stages.hpp"

#include <algorithm>
#include <ctime>
#include <thread>

namespace texel {
namespace {

const std::thread::id main_thread = std::this_thread::get_id();
Stage* innermost = nullptr;

std::vector<NamedStage>& all_stages() {
  static std::vector<NamedStage> all;
  return all;
}

double milliseconds(clockid_t clock) {
  timespec now{};
  ::clock_gettime(clock, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

// When this program's first instructions run nothing has waited yet: the processor's clock tells how long
// loading it took.
const double loading = milliseconds(CLOCK_PROCESS_CPUTIME_ID), loaded_at = milliseconds(CLOCK_MONOTONIC);

}  // namespace

Stage::Stage(const char* name) : name_(std::this_thread::get_id() == main_thread ? name : nullptr) {
  if (name_ == nullptr) return;
  outer_ = innermost;
  innermost = this;
  begin_ = milliseconds(CLOCK_MONOTONIC);
}

Stage::~Stage() {
  if (name_ == nullptr) return;
  innermost = outer_;
  const double time = milliseconds(CLOCK_MONOTONIC) - begin_;
  if (outer_ != nullptr) outer_->inner_ += time;
  std::vector<NamedStage>& all = all_stages();
  auto found = std::find_if(all.begin(), all.end(), [&](const NamedStage& one) { return one.name == name_; });
  if (found == all.end()) found = all.insert(found, {name_, 0});
  found->milliseconds += time - inner_;
}

std::vector<NamedStage> stage_times() {
  return all_stages();
}

double milliseconds_since_start() {
  return loading + milliseconds(CLOCK_MONOTONIC) - loaded_at;
}

}  // namespace texel
