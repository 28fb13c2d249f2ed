// Shapes that stand for things: obstacles, arrows, dots.
#pragma once

#include <vector>

#include "render/frame.h"
#include "render/gl.h"
#include "render/view.h"

namespace render {

// A sphere obstacle as a surface with normals.
Surface sphere_surface(const SphereObstacle& sphere);

// All arrows of one colour as one surface: shaft and head, as thick as the view can tell (a share of its extent).
// Arrows without length are left out.
std::vector<Surface> arrow_surfaces(const std::vector<Arrow>& arrows, float extent);

// Dots of fixed size on the screen with a light rim, drawn a little in front of the surface they mark.
class Markers {
 public:
  explicit Markers(const GladGLContext& gl);
  // diameter: pixels
  void draw(const std::vector<Marker>& markers, float diameter);

 private:
  const GladGLContext& gl_;
  GlObject program_, vertex_array_, vertices_;
  std::vector<float> packed_;  // scratch: position and colour of each
};

}  // namespace render
