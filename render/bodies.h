// Draws surfaces: lit, flat, as ghosts, and their edges.
#pragma once

#include <Eigen/Core>
#include <string>

#include "render/gl.h"
#include "render/surface_buffer.h"

namespace render {

class Bodies {
 public:
  explicit Bodies(const GladGLContext& gl);

  // The colours that values take; may be null when no surface has values.
  void use_scale(const ColourScale* scale);

  // All draw into the canvas's region.
  // inside_shows: draw the inside of closed surfaces too (it is seen where a body is inverted).
  void draw_solid(const Surface& surface, const SurfaceBuffer& buffer, bool inside_shows) const;
  // What of a surface is behind others: seen through them, weakly.
  void draw_hidden(const Surface& surface, const SurfaceBuffer& buffer) const;
  void draw_flat(const Surface& surface, const SurfaceBuffer& buffer) const;
  void draw_ghost(const Surface& surface, const SurfaceBuffer& buffer) const;
  // Lines of a width in pixels, as far as the context can, just in front of the surface they lie on.
  void draw_edges(const SurfaceBuffer& buffer, const Eigen::Vector4f& colour, float width) const;

 private:
  struct Programs {
    GlObject solid, fine, inside, flat, ghost;
  };
  const Programs& programs_for(const Surface& surface) const;
  void use_finish(const GlObject& program, const Surface& surface) const;
  void use_surface(const GlObject& program, const Surface& surface, float opacity) const;
  void use_lines(const Eigen::Vector4f& colour, float width) const;

  const GladGLContext& gl_;
  Programs plain_, by_value_;
  GlObject lines_, colours_;
  std::string map_;  // what colours_ holds
  float widest_line_ = 1;
};

}  // namespace render
