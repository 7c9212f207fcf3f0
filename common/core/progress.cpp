// SPDX-License-Identifier: MIT
#include "core/progress.hpp"

#include <cstdio>

namespace texel {

Progress::~Progress() {
  if (!said_.empty()) std::fputc('\n', stderr);
}

void Progress::say(const std::string& what) {
  const std::lock_guard lock(speaking_);
  if (what == said_ || stopwatch_.milliseconds() < 500) return;
  said_ = what;
  std::fprintf(stderr, "\r%s: %-20s", file_.c_str(), what.c_str());  // padded: it covers what stood there
  std::fflush(stderr);
}

}  // namespace texel
