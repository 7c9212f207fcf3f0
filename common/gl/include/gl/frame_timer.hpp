// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "core/stopwatch.hpp"
#include "gl/objects.hpp"

namespace texel::gl {

/// How long drawing takes. On hardware a timer query measures it. On a software renderer queries only time
/// the call: there the clock measures from an idle driver to glFinish.
class FrameTimer {
 public:
  /// `renderer` is the context's GL_RENDERER.
  explicit FrameTimer(const std::string& renderer);
  void start();
  /// Since start, in nanoseconds; waits until all is drawn.
  [[nodiscard]] double stop();

 private:
  bool software_;
  Query query_;
  Stopwatch stopwatch_;
};

}  // namespace texel::gl
