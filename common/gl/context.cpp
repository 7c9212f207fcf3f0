// SPDX-License-Identifier: MIT
#include "gl/context.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <glad/gl.h>

#include <cstdlib>
#include <utility>

#include "core/error.hpp"
#include "core/stages.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

// The types and constants of EGL 1.5; its functions are looked up at run time.
#define EGL_EGL_PROTOTYPES 0
#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace texel::gl {
namespace {

void GLAD_API_PTR on_debug_message(GLenum source, GLenum type, GLuint, GLenum, GLsizei, const GLchar* message,
                                   const void* errors) {
  // What the compiler says of a shader is read from its log, with the file's own lines.
  if (type == GL_DEBUG_TYPE_ERROR && source != GL_DEBUG_SOURCE_SHADER_COMPILER)
    static_cast<std::vector<std::string>*>(const_cast<void*>(errors))->emplace_back(message);
}

/// A library opened at run time; stays open, since drivers do not survive being unloaded.
class Library {
 public:
  Library(const char* name, const char* package) {
    const Stage stage("loader");
    handle_ = ::dlopen(name, RTLD_NOW | RTLD_LOCAL);
    if (handle_ == nullptr)
      throw Error::failed(fmt::format("cannot open {}", name), {},
                          fmt::format("install {} or choose another --context", package));
  }
  template <class Function>
  Function function(const char* name) const {
    void* address = ::dlsym(handle_, name);
    if (address == nullptr) throw Error::failed(fmt::format("the library has no function {}", name));
    return reinterpret_cast<Function>(address);
  }

 private:
  void* handle_;
};

/// Mesa no longer comes with OSMesa's header since 25.1, but older libraries stay in use.
class OsmesaContext : public Context {
  static constexpr int kFormat = 0x22, kDepthBits = 0x30, kProfile = 0x33, kCoreProfile = 0x34,
                       kMajorVersion = 0x36, kMinorVersion = 0x37;

 public:
  explicit OsmesaContext(Shaders shaders) : Context(shaders) {
    const auto create =
        library_.function<void* (*)(const int* attributes, void* share)>("OSMesaCreateContextAttribs");
    const int attributes[][2] = {{kFormat, GL_RGBA}, {kDepthBits, 24},   {kProfile, kCoreProfile},
                                 {kMajorVersion, 3}, {kMinorVersion, 3}, {0, 0}};
    context_ = create(*attributes, nullptr);
    if (context_ == nullptr) throw Error::failed("OSMesa gives no OpenGL 3.3 core context");
    const auto make_current =
        library_.function<GLboolean (*)(void*, void* buffer, GLenum type, GLsizei, GLsizei)>(
            "OSMesaMakeCurrent");
    // We draw into framebuffer objects; the default framebuffer is one unused pixel.
    if (make_current(context_, pixel_, GL_UNSIGNED_BYTE, 1, 1) == GL_FALSE)
      throw Error::failed("cannot make the OSMesa context current");
    load(library_.function<void* (*)(const char*)>("OSMesaGetProcAddress"));
  }
  ~OsmesaContext() override { library_.function<void (*)(void*)>("OSMesaDestroyContext")(context_); }

 private:
  Library library_{"libOSMesa.so.8", "libosmesa6"};
  void* context_;
  unsigned char pixel_[4] = {};
};

class EglContext : public Context {
 public:
  explicit EglContext(Shaders shaders) : Context(shaders) {
    display_ = library_.function<PFNEGLGETPLATFORMDISPLAYPROC>("eglGetPlatformDisplay")(
        EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    const auto initialize = library_.function<PFNEGLINITIALIZEPROC>("eglInitialize");
    if (display_ == EGL_NO_DISPLAY || initialize(display_, nullptr, nullptr) == EGL_FALSE)
      throw Error::failed("EGL cannot draw without a surface on this machine", {}, "try --context osmesa");
    library_.function<PFNEGLBINDAPIPROC>("eglBindAPI")(EGL_OPENGL_API);
    const EGLint attributes[][2] = {{EGL_CONTEXT_MAJOR_VERSION, 3},
                                    {EGL_CONTEXT_MINOR_VERSION, 3},
                                    {EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT},
                                    {EGL_NONE, EGL_NONE}};
    const auto create = library_.function<PFNEGLCREATECONTEXTPROC>("eglCreateContext");
    context_ = create(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, *attributes);
    if (context_ == EGL_NO_CONTEXT) throw Error::failed("EGL gives no OpenGL 3.3 core context");
    if (bind(context_) == EGL_FALSE) throw Error::failed("cannot make the EGL context current");
    load(library_.function<void* (*)(const char*)>("eglGetProcAddress"));
  }
  ~EglContext() override {
    bind(EGL_NO_CONTEXT);
    library_.function<PFNEGLDESTROYCONTEXTPROC>("eglDestroyContext")(display_, context_);
    library_.function<PFNEGLTERMINATEPROC>("eglTerminate")(display_);
  }

 private:
  Library library_{"libEGL.so.1", "libegl1"};
  EGLBoolean bind(EGLContext context) {
    const auto make_current = library_.function<PFNEGLMAKECURRENTPROC>("eglMakeCurrent");
    return make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
  }
  EGLDisplay display_;
  EGLContext context_;
};

}  // namespace

// llvmpipe filters 8-bit textures by a short cut that is up to 10 steps off, and puts every shader through
// LLVM's optimising passes: the first never, the second where it pays. What the user has set stays.
Context::Context(Shaders shaders) {
  ::setenv("GALLIVM_PERF", shaders == Shaders::quick_to_compile ? "no_aos_sampling,nopt" : "no_aos_sampling",
           /*overwrite=*/0);
}

void Context::load(void* (*get_address)(const char*)) {
  const auto loader = [](void* get, const char* name) {
    return reinterpret_cast<GLADapiproc>(reinterpret_cast<void* (*)(const char*)>(get)(name));
  };
  if (gladLoadGLUserPtr(loader, reinterpret_cast<void*>(get_address)) == 0)
    throw Error::failed("cannot load OpenGL's functions");
  if (GLAD_GL_KHR_debug != 0 && glad_glDebugMessageCallback != nullptr) {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(on_debug_message, &errors_);
  }
}

std::string Context::renderer() const {
  return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}
std::string Context::version() const {
  return reinterpret_cast<const char*>(glGetString(GL_VERSION));
}

std::string Context::name() const {
  // llvmpipe says how many bits its vectors have, which depends on the processor, and the pictures do not.
  std::string name = renderer();
  if (name.ends_with(" bits)")) name.resize(name.rfind(", ")), name.push_back(')');
  const std::string driver = version();
  const std::size_t mesa = driver.find("Mesa ");
  return name + ", " + (mesa == std::string::npos ? driver : driver.substr(mesa));
}

std::vector<std::string> Context::take_errors() {
  while (const GLenum code = glGetError())
    if (GLAD_GL_KHR_debug == 0) errors_.push_back(fmt::format("OpenGL error 0x{:04x}", code));
  return std::exchange(errors_, {});
}

std::unique_ptr<Context> create_headless(Shaders shaders, std::string kind) {
  const char* named = std::getenv("TEXEL_CONTEXT");
  if (kind == "auto" && named != nullptr && *named != '\0') kind = named;
  if (kind == "osmesa") return std::make_unique<OsmesaContext>(shaders);
  if (kind == "egl") return std::make_unique<EglContext>(shaders);
  if (kind != "auto") throw Error::usage(fmt::format("TEXEL_CONTEXT is '{}'", kind), "egl or osmesa");
  try {
    return create_headless(shaders, "osmesa");
  } catch (const Error& no_osmesa) {
    try {
      return create_headless(shaders, "egl");
    } catch (const Error& no_egl) {
      throw Error::failed(fmt::format("neither OSMesa nor EGL works on this machine ({}; {})",
                                      no_osmesa.what(), no_egl.what()),
                          {}, "install libosmesa6, or libegl1 and libgl1-mesa-dri");
    }
  }
}

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
  glfwMakeContextCurrent(window_);
  load([](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); });
  glfwSwapInterval(1);
}

WindowContext::~WindowContext() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

}  // namespace texel::gl
