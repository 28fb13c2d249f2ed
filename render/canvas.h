// The picture being drawn, and the part of it that is drawn multisampled.
#pragma once

#include <glad/gl.h>

#include <string_view>

#include "render/gl.h"
#include "render/image.h"
#include "render/rect.h"

namespace render {

// What the opacity of a pixel of the region says: how much of its light does not come from the key light, scaled to
// 0 ... most_rest; 1 for what is not lit at all (background, lines, text).
inline constexpr std::string_view opacity_code = "const float most_rest = 0.9;\n";

// Background and text need no multisampling; bodies do. In software every sample costs, so only the rectangle that
// bodies cover is multisampled: it starts as a copy of the picture and is resolved back into it. What each pixel sees
// of the lights is applied then, once a pixel. Colours are stored as sRGB; shaders encode, because the encoding by a
// framebuffer is slower.
class Canvas {
 public:
  Canvas(const GladGLContext& gl, int width, int height, int samples);

  int width() const { return width_; }
  int height() const { return height_; }

  // Further drawing goes to the picture, one sample a pixel, depth test off.
  void draw_into_picture() const;
  // Copies a framebuffer of the same size into the picture.
  void copy_into_picture(const GlObject& framebuffer) const;
  // Further drawing goes to the region, with depth, until resolve. Its viewport is the picture's, shifted.
  void draw_into_region(const Rect& region);
  // Puts the region back: the mean of the samples in (nearly) linear light, darkened by the visibility buffer
  // (render/visibility.h) unless that is null.
  void resolve(const GlObject* visibility);
  // The picture, read back.
  Image read() const;
  // The picture, onto the default framebuffer of the context with its lower left corner at (x, 0); that one is bound
  // then.
  void copy_to_default(int x) const;

 private:
  void make_region(int width, int height);
  GLenum surface_kind() const { return samples_ > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D; }

  const GladGLContext& gl_;
  int width_, height_, samples_;
  Rect region_;
  int region_width_ = 0, region_height_ = 0;  // allocated
  GlObject picture_texture_, picture_depth_, picture_;
  GlObject region_colour_, region_depth_, region_target_;
  GlObject copy_, resolve_, resolve_shaded_, empty_;
};

}  // namespace render
