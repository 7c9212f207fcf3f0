// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "core/stopwatch.hpp"
#include "gl/objects.hpp"

namespace texel::gl {

/// How long drawing takes: on hardware by a timer query; on a software renderer, whose queries only time the
/// call, by the clock from an idle driver to glFinish.
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
