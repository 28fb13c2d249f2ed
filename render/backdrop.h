// What stands behind and below the bodies: background, ground, planes of obstacles.
#pragma once

#include "render/canvas.h"
#include "render/frame.h"
#include "render/gl.h"
#include "render/view.h"

namespace render {

class Backdrop {
 public:
  explicit Backdrop(const GladGLContext& gl);

  // Draws the background over the whole viewport, then ground and planes that face the eye, darkened by what the
  // visibility buffer has in the rectangle `shaded`. Needs a depth buffer, which it clears.
  void draw(const Frame& frame, const View& view, const GlObject& visibility, const Rect& shaded) const;
  // Draws the depth of ground and planes alone.
  void draw_depth(const Frame& frame, const View& view) const;

 private:
  const GladGLContext& gl_;
  GlObject gradient_, plane_, shade_, depth_, empty_;
};

}  // namespace render
