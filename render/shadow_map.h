// What the key light sees: the depth of the nearest surface.
#pragma once

#include <vector>

#include "render/gl.h"
#include "render/surface_buffer.h"

namespace render {

using SurfaceList = std::vector<const SurfaceBuffer*>;

class ShadowMap {
 public:
  static constexpr int texels = 512;  // along each side

  explicit ShadowMap(const GladGLContext& gl);

  // Draws the casters as seen along the key light of the frame block.
  void draw(const SurfaceList& casters) const;
  // Depth, 0 to 1 of the light's cube (render/light.h).
  const GlObject& depth() const { return depth_; }

 private:
  const GladGLContext& gl_;
  GlObject depth_, target_, program_;
};

}  // namespace render
