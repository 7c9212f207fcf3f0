// SPDX-License-Identifier: MIT
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <cstdlib>

#include "core/error.hpp"
#include "gl/context.hpp"

namespace texel::gl {

WindowContext::WindowContext(int width, int height, const std::string& title)
    : Context(Shaders::quick_to_draw) {
  static std::string reason;
  glfwSetErrorCallback([](int, const char* text) { reason = text; });
#if defined(GLFW_PLATFORM_X11) && defined(__linux__)
  // GLFW 3.4 tries Wayland also where there is none, and Wayland's library complains on standard error.
  if (std::getenv("WAYLAND_DISPLAY") == nullptr) glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
  if (glfwInit() == GLFW_FALSE)
    throw Error::failed(fmt::format("cannot open a window: {}", reason), {},
                        "without a display add --snapshot FILE");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (window_ == nullptr) {
    glfwTerminate();
    throw Error::failed(fmt::format("cannot open a window with OpenGL 3.3: {}", reason), {},
                        "add --snapshot FILE to draw without a window");
  }
  WindowContext::make_current();
  glfwSwapInterval(1);
}

WindowContext::~WindowContext() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

void WindowContext::make_current() {
  glfwMakeContextCurrent(window_);
  load([](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); });
}

}  // namespace texel::gl
