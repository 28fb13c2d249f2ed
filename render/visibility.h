// How much of the key light and of the sky each pixel sees: soft shadows and darkened creases.
#pragma once

#include "render/backdrop.h"
#include "render/gl.h"
#include "render/rect.h"
#include "render/shadow_map.h"

namespace render {

// For the fragment stages that shade: visible gives (key light, sky), 0 to 1, at a pixel of the picture with a window
// depth and its change from pixel to pixel. Of the nearest texels of the visibility buffer those count that lie in the
// pixel's own plane; window depth is linear on planes. (A software rasteriser runs both sides of a branch, and loops of
// fixed length fastest: there is nothing to gain by skipping.) Behind visibility_reach.
inline constexpr std::string_view visibility_lookup = R"(
uniform sampler2D visibility;
vec2 visible(vec2 pixel, float depth, vec2 change) {
  vec2 place = pixel * texel.xy * size.zw - 0.5;
  vec2 base = floor(place) - float(REACH - 2);
  float sharpness = eye_depth_slope(eye_depth(depth)) / (4e-3 * forward.w);
  vec2 slope = change * (size.xy * texel.zw);
  slope *= step(abs(slope) * sharpness, vec2(12.0));  // more is an edge
  vec3 sum = vec3(0.0);
  for (int k = 0; k < REACH * REACH; ++k) {
    vec2 at = base + vec2(k % REACH, k / REACH);
    vec3 v = textureLod(visibility, (at + 0.5) * texel.zw, 0.0).xyz;
    vec2 w = max(1.0 - abs(at - place), 0.0);
    float apart = abs(v.z - depth - dot(slope, at - place)) * sharpness;
    sum += vec3(v.xy, 1.0) * ((w.x * w.y + 1e-2) / (1.0 + apart * apart));
  }
  return sum.xy / sum.z;
}
)";

// How many texels along each side are looked at in a picture of that height: where texels are pixels, what lies behind
// the edge of a body finds its own plane only in the texels all around.
std::string_view visibility_reach(int height);

class Visibility {
 public:
  // A buffer for pictures of width x height, at a scale that leaves it about 270 rows: light that is soft needs no
  // more.
  Visibility(const GladGLContext& gl, int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }

  // Fills the part of the buffer under `rect` (pixels of the picture). Returns whether the inside of a closed surface
  // shows.
  bool draw(const Frame& frame, const View& view, const SurfaceList& solids, const Backdrop& backdrop,
            const ShadowMap& shadow, const Rect& rect) const;
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
