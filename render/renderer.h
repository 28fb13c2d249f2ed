// Draws frames into pictures.
#pragma once

#include <memory>

#include "render/context.h"
#include "render/frame.h"
#include "render/image.h"

namespace render {

// Owns every GL object it draws with; several may live in one process, each with its own context. The context must
// outlive it, and all calls are made in one thread (the context is made current there).
class Renderer {
 public:
  // Pictures of width x height pixels, 1 to 8192 each; samples per pixel 1, 2, 4 or 8, lowered to what the context can
  // do. Throws std::invalid_argument for other numbers, std::runtime_error when the context lacks OpenGL 3.3.
  Renderer(Context& context, int width, int height, int samples = 4);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  // The picture of the frame, opaque: the same frame gives the same bytes. Throws std::invalid_argument, naming the
  // surface, for non-finite positions, indices out of range, lists of wrong length and values without a scale, and for
  // a camera without a direction.
  Image draw(const Frame& frame);

  // The same in two parts: paint, then read the pixels, or copy them to the default framebuffer of the context (a
  // window's), `x` pixels from its left edge. That framebuffer is bound then, for what stands beside the picture.
  void paint(const Frame& frame);
  Image read() const;
  void present(int x) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace render
