// What the renderer needs of an OpenGL context: a window, an off-screen buffer or a surfaceless device gives it.
#pragma once

#include <memory>

namespace render {

// An OpenGL 3.3 core context. It may be current in one thread at a time; everything that uses it is called there.
class Context {
 public:
  using Procedure = void (*)();
  using Getter = Procedure (*)(const char* name);

  virtual ~Context() = default;
  // Makes the context current in the calling thread. Throws std::runtime_error when that fails.
  virtual void make_current() = 0;
  // Where the context's own GL functions are found by name.
  virtual Getter getter() const = 0;
  // Size of its default framebuffer in pixels.
  virtual int width() const = 0;
  virtual int height() const = 0;
};

// A context without display or graphics card (OSMesa, software). Pictures are drawn into framebuffers of the renderer,
// so its own buffer is one pixel. Throws std::runtime_error when the machine cannot give OpenGL 3.3 core.
std::unique_ptr<Context> make_offscreen_context();

}  // namespace render
