// What stands behind and below the bodies: background, ground, planes of obstacles.
#pragma once

#include <Eigen/Core>
#include <optional>
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
  // For pictures of width x height pixels.
  Backdrop(const GladGLContext& gl, int width, int height);

  // Draws the background over the whole picture, and ground and planes that face the eye, darkened by what the
  // visibility buffer has.
  void draw(const Frame& frame, const View& view, const GlObject& visibility, const Shades& shades,
            const Canvas& canvas);
  // Draws the depth of ground and planes alone.
  void draw_depth(const Frame& frame, const View& view) const;

 private:
  // All that background and unshaded ground depend on: as long as it stays, they are copied, not drawn.
  struct Sky {
    Eigen::Vector3f above, below;
    Eigen::Matrix3f to_disc;
    Eigen::Vector4f tint;
    bool operator==(const Sky&) const = default;
  };

  void draw_background(const Frame& frame, const View& view, const Disc* ground, const Canvas& canvas);
  void draw_shade(const Disc& disc, const GlObject& visibility, const Rect& rect) const;

  const GladGLContext& gl_;
  GlObject background_, plane_, shade_, depth_, made_texture_, made_target_, empty_;
  std::optional<Sky> made_;
};

}  // namespace render
