#define EGL_NO_X11  // its types are not needed here
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "render/offscreen.h"

namespace render {
namespace {

// A display that belongs to no screen: a device, or Mesa's choice.
struct Source {
  EGLenum platform;
  void* native;
};

// Extensions are listed with spaces between them.
bool lists(const char* extensions, std::string_view wanted) {
  if (extensions == nullptr) return false;
  return (" " + std::string(extensions) + " ").find(" " + std::string(wanted) + " ") != std::string::npos;
}

// Graphics cards in the order in which EGL counts them; software last, as it is always there.
std::vector<Source> sources() {
  std::vector<Source> found;
  const auto query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  const auto query_string =
      reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(eglGetProcAddress("eglQueryDeviceStringEXT"));
  std::array<EGLDeviceEXT, 16> devices{};
  EGLint count = 0;
  if (query_devices != nullptr && query_string != nullptr &&
      query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count) == EGL_TRUE) {
    for (EGLint i = 0; i < count; ++i) {
      const bool software = lists(query_string(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software");
      if (!software) found.push_back({EGL_PLATFORM_DEVICE_EXT, devices[i]});
    }
  }
  found.push_back({EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY});
  return found;
}

class EglContext final : public Context {
 public:
  // The first source that gives OpenGL 3.3 core.
  EglContext() {
    for (const Source& source : sources()) {
      if (open(source)) return;
    }
    throw std::runtime_error("EGL gives no OpenGL 3.3 core context; the software one comes with libgl1-mesa-dri");
  }
  // The display stays: all contexts of the process share it.
  ~EglContext() override {
    if (eglGetCurrentContext() == context_) {
      eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglDestroyContext(display_, context_);
  }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void make_current() override {
    if (eglGetCurrentContext() == context_) return;
    if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE) {
      throw std::runtime_error("EGL cannot make its context current");
    }
  }
  Getter getter() const override { return eglGetProcAddress; }
  int width() const override { return 1; }
  int height() const override { return 1; }

 private:
  bool open(const Source& source) {
    display_ = eglGetPlatformDisplay(source.platform, source.native, nullptr);
    if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) != EGL_TRUE) return false;
    const char* const extensions = eglQueryString(display_, EGL_EXTENSIONS);
    if (!lists(extensions, "EGL_KHR_no_config_context") || !lists(extensions, "EGL_KHR_surfaceless_context") ||
        eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) {
      return false;
    }
    constexpr std::array<EGLint, 7> wanted = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted.data());
    return context_ != EGL_NO_CONTEXT;
  }

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<Context> make_egl_context() {
  return std::make_unique<EglContext>();
}

}  // namespace render
