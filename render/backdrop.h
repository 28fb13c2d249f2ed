// What stands behind and below the bodies: background, ground, planes of obstacles.
#pragma once

#include <vector>

#include "render/canvas.h"
#include "render/frame.h"
#include "render/gl.h"
#include "render/view.h"

namespace render {

struct Disc;

// Where ground and planes can be darkened (pixels of the picture; empty: nowhere). One for each plane of the frame.
struct Shades {
  Rect ground;
  std::vector<Rect> planes;
};

class Backdrop {
 public:
  explicit Backdrop(const GladGLContext& gl);

  // Draws the background over the whole viewport, and ground and planes that face the eye, darkened by what the
  // visibility buffer has. With planes it needs a depth buffer, which it clears.
  void draw(const Frame& frame, const View& view, const GlObject& visibility, const Shades& shades) const;
  // Draws the depth of ground and planes alone.
  void draw_depth(const Frame& frame, const View& view) const;

 private:
  void draw_background(const Frame& frame, const View& view, const Disc* ground) const;
  void draw_shade(const Disc& disc, const GlObject& visibility, const Rect& rect) const;

  const GladGLContext& gl_;
  GlObject background_, plane_, shade_, depth_, empty_;
};

}  // namespace render
