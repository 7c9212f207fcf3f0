// SPDX-License-Identifier: MIT
#pragma once
#include <mutex>
#include <string>

#include "core/stopwatch.hpp"

namespace texel {

/// Shows on standard error what is being done with a file, in one line that is overwritten, once the work has
/// taken half a second. Any thread may call it.
class Progress {
 public:
  explicit Progress(std::string file) : file_(std::move(file)) {}
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void say(const std::string& what);

 private:
  std::string file_;
  Stopwatch stopwatch_;
  std::mutex speaking_;
  std::string said_;
};

}  // namespace texel
