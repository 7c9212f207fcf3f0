// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace texel::gl {

/// The goal of a software renderer's shader compiler. The pictures are the same, bit by bit.
enum class Shaders {
  quick_to_compile,  ///< on llvmpipe in half the time, and they draw 1.1 to 1.6 times as long
  quick_to_draw
};

/// An OpenGL 3.3 core context, the thread's own from its constructor on. All drawing goes into framebuffer
/// objects: a window, OSMesa and EGL give the same pictures.
class Context {
 public:
  virtual ~Context() = default;
  Context& operator=(Context&&) = delete;

  /// GL_RENDERER and GL_VERSION.
  [[nodiscard]] std::string renderer() const;
  [[nodiscard]] std::string version() const;
  /// Both, without parts that change no pixel: "llvmpipe (LLVM 15.0.6), Mesa 22.3.6".
  [[nodiscard]] std::string name() const;
  /// What the driver reported as an error since the last call (KHR_debug, else glGetError). Empty in a
  /// correct program.
  [[nodiscard]] std::vector<std::string> take_errors();

 protected:
  /// Called before the driver is loaded: it then reads the goal of its shader compiler.
  explicit Context(Shaders shaders);
  /// Loads OpenGL's functions from the current context.
  void load(void* (*get_address)(const char*));

 private:
  std::vector<std::string> errors_;
};

/// Without a window: "osmesa" (Mesa's software renderer into main memory) or "egl" (EGL without a surface).
/// "auto" is what the variable TEXEL_CONTEXT names; without it OSMesa, else EGL. Throws Error (exit 3) that
/// names the missing library. A process has one kind of shaders, that of its first context.
std::unique_ptr<Context> create_headless(Shaders shaders = Shaders::quick_to_compile,
                                         std::string kind = "auto");

/// A GLFW window. Only gl and app know GLFW.
class WindowContext : public Context {
 public:
  /// Throws Error (exit 3) when there is no display or no OpenGL 3.3.
  WindowContext(int width, int height, const std::string& title);
  ~WindowContext() override;
  [[nodiscard]] GLFWwindow* window() const { return window_; }

 private:
  GLFWwindow* window_ = nullptr;
};

}  // namespace texel::gl
