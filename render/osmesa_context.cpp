#include <GL/osmesa.h>

#include <array>
#include <stdexcept>

#include "render/offscreen.h"

namespace render {
namespace {

// Mesa's software rasteriser, drawing into memory.
class OsmesaContext final : public Context {
 public:
  OsmesaContext() {
    constexpr std::array<int, 13> wanted = {OSMESA_FORMAT,
                                            OSMESA_RGBA,
                                            OSMESA_DEPTH_BITS,
                                            0,
                                            OSMESA_STENCIL_BITS,
                                            0,
                                            OSMESA_PROFILE,
                                            OSMESA_CORE_PROFILE,
                                            OSMESA_CONTEXT_MAJOR_VERSION,
                                            3,
                                            OSMESA_CONTEXT_MINOR_VERSION,
                                            3,
                                            0};
    context_ = OSMesaCreateContextAttribs(wanted.data(), nullptr);
    if (context_ == nullptr) throw std::runtime_error("OSMesa gives no OpenGL 3.3 core context");
  }
  ~OsmesaContext() override { OSMesaDestroyContext(context_); }
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  void make_current() override {
    if (OSMesaGetCurrentContext() == context_) return;
    if (OSMesaMakeCurrent(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1) != GL_TRUE) {
      throw std::runtime_error("OSMesa cannot make its context current");
    }
  }
  Getter getter() const override { return OSMesaGetProcAddress; }
  int width() const override { return 1; }
  int height() const override { return 1; }

 private:
  OSMesaContext context_ = nullptr;
  std::array<unsigned char, 4> pixel_{};  // its own buffer: OSMesa asks for one
};

}  // namespace

std::unique_ptr<Context> make_osmesa_context() {
  return std::make_unique<OsmesaContext>();
}

}  // namespace render
