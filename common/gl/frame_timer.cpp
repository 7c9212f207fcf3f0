// SPDX-License-Identifier: MIT
#include "gl/frame_timer.hpp"

#include <algorithm>
#include <array>

namespace texel::gl {
namespace {

bool is_software(const std::string& renderer) {
  constexpr std::array kSoftware = {"llvmpipe", "softpipe", "swrast", "Software Rasterizer", "SwiftShader"};
  return std::any_of(kSoftware.begin(), kSoftware.end(),
                     [&](const char* name) { return renderer.find(name) != std::string::npos; });
}

}  // namespace

FrameTimer::FrameTimer(const std::string& renderer) : software_(is_software(renderer)) {}

void FrameTimer::start() {
  glFinish();
  if (software_)
    stopwatch_ = Stopwatch();
  else
    glBeginQuery(GL_TIME_ELAPSED, query_.id());
}

double FrameTimer::stop() {
  if (software_) {
    glFinish();
    return stopwatch_.milliseconds() * 1e6;
  }
  glEndQuery(GL_TIME_ELAPSED);
  GLuint64 nanoseconds = 0;
  glGetQueryObjectui64v(query_.id(), GL_QUERY_RESULT, &nanoseconds);
  return static_cast<double>(nanoseconds);
}

}  // namespace texel::gl
