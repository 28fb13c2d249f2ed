// What the renderer needs of an OpenGL context: a window, an off-screen buffer or a surfaceless device gives it.
#pragma once

#include <memory>
#include <span>
#include <string_view>

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

// A way to draw without a window. Pictures are drawn into framebuffers of the renderer, so that the context's own
// buffer is one pixel or none.
struct OffscreenKind {
  std::string_view name;
  std::unique_ptr<Context> (*make)();  // throws std::runtime_error when the machine cannot give OpenGL 3.3 core
};

// Those that this program was built with; the first is the default.
std::span<const OffscreenKind> offscreen_kinds();

// A context of the kind of this name, or of the default one when it is empty. Throws std::invalid_argument for a name
// that is none of theirs, std::runtime_error when the machine cannot give OpenGL 3.3 core.
std::unique_ptr<Context> make_offscreen_context(std::string_view kind = {});

}  // namespace render
