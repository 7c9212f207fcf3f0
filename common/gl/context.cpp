// SPDX-License-Identifier: MIT
#include "gl/context.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <glad/gl.h>

#include <cstdlib>
#include <cstring>
#include <utility>

#include "core/error.hpp"
#include "core/stages.hpp"
#include "gl/texture.hpp"

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
  Function* function(const char* name) const {
    void* address = ::dlsym(handle_, name);
    if (address == nullptr) throw Error::failed(fmt::format("the library has no function {}", name));
    return reinterpret_cast<Function*>(address);
  }

 private:
  void* handle_;
};

/// What we use of OSMesa. Mesa no longer comes with its header since 25.1, but older libraries stay in use.
struct OsmesaApi {
  using Handle = struct osmesa_context*;
  using Create = Handle(const int* attributes, Handle share);
  using MakeCurrent = GLboolean(Handle, void* buffer, GLenum type, GLsizei width, GLsizei height);
  using Destroy = void(Handle);
  using GetAddress = void*(const char*);
  static constexpr int kFormat = 0x22, kDepthBits = 0x30, kProfile = 0x33, kCoreProfile = 0x34,
                       kMajorVersion = 0x36, kMinorVersion = 0x37;
};

class OsmesaContext : public Context {
 public:
  explicit OsmesaContext(Shaders shaders) : Context(shaders) {
    const auto create = library().function<OsmesaApi::Create>("OSMesaCreateContextAttribs");
    const int attributes[] = {OsmesaApi::kFormat,
                              GL_RGBA,
                              OsmesaApi::kDepthBits,
                              24,
                              OsmesaApi::kProfile,
                              OsmesaApi::kCoreProfile,
                              OsmesaApi::kMajorVersion,
                              3,
                              OsmesaApi::kMinorVersion,
                              3,
                              0};
    context_ = create(attributes, nullptr);
    if (context_ == nullptr) throw Error::failed("OSMesa gives no OpenGL 3.3 core context");
    OsmesaContext::make_current();
  }
  ~OsmesaContext() override { library().function<OsmesaApi::Destroy>("OSMesaDestroyContext")(context_); }
  void make_current() override {
    const auto make = library().function<OsmesaApi::MakeCurrent>("OSMesaMakeCurrent");
    // We draw into framebuffer objects; the default framebuffer is one unused pixel.
    if (make(context_, pixel_, GL_UNSIGNED_BYTE, 1, 1) == GL_FALSE)
      throw Error::failed("cannot make the OSMesa context current");
    load(library().function<OsmesaApi::GetAddress>("OSMesaGetProcAddress"));
  }
  [[nodiscard]] const char* kind_name() const override { return "osmesa"; }

 private:
  static const Library& library() {
    static const Library osmesa("libOSMesa.so.8", "libosmesa6");
    return osmesa;
  }
  OsmesaApi::Handle context_;
  unsigned char pixel_[4] = {};
};

class EglContext : public Context {
 public:
  explicit EglContext(Shaders shaders) : Context(shaders) {
    const auto get_platform_display =
        library().function<EGLDisplay(EGLenum, void*, const EGLAttrib*)>("eglGetPlatformDisplay");
    display_ = get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    const auto initialize = library().function<EGLBoolean(EGLDisplay, EGLint*, EGLint*)>("eglInitialize");
    if (display_ == EGL_NO_DISPLAY || initialize(display_, nullptr, nullptr) == EGL_FALSE)
      throw Error::failed("EGL cannot draw without a surface on this machine", {}, "try --context osmesa");
    library().function<EGLBoolean(EGLenum)>("eglBindAPI")(EGL_OPENGL_API);
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 3,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 3,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
    const auto create =
        library().function<EGLContext(EGLDisplay, EGLConfig, EGLContext, const EGLint*)>("eglCreateContext");
    context_ = create(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (context_ == EGL_NO_CONTEXT) throw Error::failed("EGL gives no OpenGL 3.3 core context");
    EglContext::make_current();
  }
  ~EglContext() override {
    bind(EGL_NO_CONTEXT);
    library().function<EGLBoolean(EGLDisplay, EGLContext)>("eglDestroyContext")(display_, context_);
    library().function<EGLBoolean(EGLDisplay)>("eglTerminate")(display_);
  }
  void make_current() override {
    if (bind(context_) == EGL_FALSE) throw Error::failed("cannot make the EGL context current");
    load(library().function<void*(const char*)>("eglGetProcAddress"));
  }
  [[nodiscard]] const char* kind_name() const override { return "egl"; }

 private:
  static const Library& library() {
    static const Library egl("libEGL.so.1", "libegl1");
    return egl;
  }
  EGLBoolean bind(EGLContext context) {
    return library().function<EGLBoolean(EGLDisplay, EGLSurface, EGLSurface, EGLContext)>("eglMakeCurrent")(
        display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
  }
  EGLDisplay display_;
  EGLContext context_;
};

PFNGLTEXIMAGE2DPROC upload = nullptr;

void GLAD_API_PTR count_and_upload(GLenum target, GLint level, GLint internal, GLsizei width, GLsizei height,
                                   GLint border, GLenum format, GLenum type, const void* data) {
  texture_bytes += std::size_t{4} * static_cast<unsigned>(width) * static_cast<unsigned>(height);
  upload(target, level, internal, width, height, border, format, type, data);
}

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
  upload = std::exchange(glad_glTexImage2D, count_and_upload);
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

std::unique_ptr<Context> create_headless(ContextKind kind, Shaders shaders) {
  if (kind == ContextKind::osmesa) return std::make_unique<OsmesaContext>(shaders);
  return std::make_unique<EglContext>(shaders);
}

std::unique_ptr<Context> create_headless(Shaders shaders) {
  if (const char* wanted = std::getenv("TEXEL_CONTEXT"); wanted != nullptr && *wanted != '\0') {
    if (wanted == std::string("osmesa")) return create_headless(ContextKind::osmesa, shaders);
    if (wanted == std::string("egl")) return create_headless(ContextKind::egl, shaders);
    throw Error::usage(fmt::format("TEXEL_CONTEXT is '{}'", wanted), "egl or osmesa");
  }
  try {
    return create_headless(ContextKind::osmesa, shaders);
  } catch (const Error& no_osmesa) {
    try {
      return create_headless(ContextKind::egl, shaders);
    } catch (const Error& no_egl) {
      throw Error::failed(fmt::format("neither OSMesa nor EGL works on this machine ({}; {})",
                                      no_osmesa.what(), no_egl.what()),
                          {}, "install libosmesa6, or libegl1 and libgl1-mesa-dri");
    }
  }
}

}  // namespace texel::gl
