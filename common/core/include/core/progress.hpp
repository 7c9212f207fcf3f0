// SPDX-License-Identifier: MIT
#pragma once
#include <cstdio>
#include <mutex>
#include <string>

#include "core/stopwatch.hpp"

namespace texel {

/// Shows on standard error what is being done with a file, in one line that is overwritten, once the work has
/// taken half a second. Any thread may call it.
class Progress {
 public:
  explicit Progress(std::string file) : file_(std::move(file)) {}
  ~Progress() {
    if (!said_.empty()) std::fputc('\n', stderr);
  }
  Progress& operator=(Progress&&) = delete;
  void say(const std::string& what) {
    const std::lock_guard lock(speaking_);
    if (what == said_ || stopwatch_.milliseconds() < 500) return;
    said_ = what;
    std::fprintf(stderr, "\r%s: %-20s", file_.c_str(), what.c_str());  // padded: it covers what stood there
    std::fflush(stderr);
  }

 private:
  std::string file_;
  Stopwatch stopwatch_;
  std::mutex speaking_;
  std::string said_;
};

}  // namespace texel
