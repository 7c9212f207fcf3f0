// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace texel::gl {

/// Where OpenGL comes from.
enum class ContextKind {
  window,  ///< GLFW
  osmesa,  ///< Mesa's software renderer into main memory
  egl      ///< EGL without a surface (EGL_MESA_platform_surfaceless)
};

/// The goal of a software renderer's shader compiler. The pictures are the same, bit by bit.
enum class Shaders {
  quick_to_compile,  ///< on llvmpipe in half the time, and they draw 1.1 to 1.6 times as long
  quick_to_draw
};

/// An OpenGL 3.3 core context. All drawing goes into framebuffer objects: the three kinds give the
/// same pictures.
class Context {
 public:
  virtual ~Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// Makes it the thread's context and loads OpenGL's functions from it.
  virtual void make_current() = 0;

  [[nodiscard]] virtual const char* kind_name() const = 0;
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
  void load(void* (*get_address)(const char*));

 private:
  std::vector<std::string> errors_;
};

/// Without a window. Throws Error (exit 3) that names the missing library. A process has one kind of shaders,
/// that of its first context.
std::unique_ptr<Context> create_headless(ContextKind kind, Shaders shaders = Shaders::quick_to_compile);
/// What the variable TEXEL_CONTEXT names (osmesa or egl); without it OSMesa, else EGL.
std::unique_ptr<Context> create_headless(Shaders shaders = Shaders::quick_to_compile);

/// A GLFW window. Only gl and app know GLFW.
class WindowContext : public Context {
 public:
  /// Throws Error (exit 3) when there is no display or no OpenGL 3.3.
  WindowContext(int width, int height, const std::string& title);
  ~WindowContext() override;
  void make_current() override;
  [[nodiscard]] const char* kind_name() const override { return "window"; }
  [[nodiscard]] GLFWwindow* window() const { return window_; }

 private:
  GLFWwindow* window_ = nullptr;
};

}  // namespace texel::gl
