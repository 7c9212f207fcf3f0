// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "core/stopwatch.hpp"

namespace texel {

/// While it lives, time counts for the stage of that name. A stage inside another does not count for
/// the outer one. Only the main thread is measured: work of other threads counts for no stage.
class Stage {
 public:
  /// `name` must live as long as this: a literal.
  explicit Stage(const char* name);
  ~Stage();
  Stage& operator=(Stage&&) = delete;

 private:
  const char* name_;  ///< none on other threads
  Stage* outer_ = nullptr;
  Stopwatch stopwatch_;
  double inner_ = 0;
};

/// All stages since the process began with their milliseconds, in the order in which they first ended.
std::vector<std::pair<std::string, double>> stage_times();

/// Milliseconds since the process began, its own loading included.
double milliseconds_since_start();

}  // namespace texel
