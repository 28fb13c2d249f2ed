// How much of the key light and of the sky each pixel sees: soft shadows and darkened creases.
#pragma once

#include "render/backdrop.h"
#include "render/canvas.h"
#include "render/gl.h"
#include "render/shadow_map.h"

namespace render {

// For the fragment stages that shade: visible(corner of the target in the picture) gives (key light, sky), 0 to 1. Of
// the four nearest texels of the visibility buffer those count that lie in the pixel's own plane; window depth is
// linear on planes. (A software rasteriser runs both sides of a branch, and loops of fixed length fastest: there is
// nothing to gain by skipping.)
inline constexpr std::string_view visibility_lookup = R"(
uniform sampler2D visibility;
vec2 visible(ivec2 origin) {
  vec2 scale = size.xy / size.zw;
  vec2 texel = (gl_FragCoord.xy + vec2(origin)) / scale - 0.5;
  vec2 base = floor(texel);
  vec2 f = texel - base;
  float depth = gl_FragCoord.z;
  vec2 slope = vec2(dFdx(depth), dFdy(depth)) * scale;
  float tolerance = 4e-3 * forward.w / eye_depth_slope(eye_depth(depth));
  vec3 sum = vec3(0.0);
  for (int k = 0; k < 4; ++k) {
    vec2 step = vec2(k & 1, k >> 1);
    vec3 v = textureLod(visibility, (base + step + 0.5) / size.zw, 0.0).xyz;
    vec2 w = mix(1.0 - f, f, step);
    float apart = abs(v.z - depth - dot(slope, step - f));
    sum += vec3(v.xy, 1.0) * ((w.x * w.y + 1e-3) / (apart + tolerance));
  }
  return sum.xy / sum.z;
}
)";

class Visibility {
 public:
  // A buffer for pictures of width x height, at a scale that leaves it about 360 rows: light that is soft needs no
  // more.
  Visibility(const GladGLContext& gl, int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }

  // Fills the part of the buffer under `rect` (pixels of the picture). Returns whether the inside of a closed surface
  // shows.
  bool draw(const Frame& frame, const View& view, const SurfaceList& solids, const Backdrop& backdrop,
            const ShadowMap& shadow, const Rect& rect) const;
  // Fills the buffer with full light.
  void clear() const;
  // Red: key light, green: sky, blue: window depth.
  const GlObject& texture() const { return smooth_; }

 private:
  void draw_solids(const SurfaceList& solids) const;

  const GladGLContext& gl_;
  int scale_, width_, height_;  // scale: picture pixels per texel along each side
  GlObject depth_, depth_target_, raw_, raw_target_, smooth_, smooth_target_;
  GlObject depth_program_, shadow_program_, sky_program_, both_program_, smooth_program_, empty_, inside_query_;
};

}  // namespace render
