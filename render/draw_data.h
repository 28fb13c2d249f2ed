// Dear ImGui's draw lists on our GL table. (Its packaged backend opens libGL by itself, which a software context is
// not in.)
#pragma once

#include "render/gl.h"

struct ImDrawData;
struct ImFontAtlas;

namespace render {

class DrawDataPainter {
 public:
  // Uploads the atlas (alpha only) of the fonts that the lists will use.
  DrawDataPainter(const GladGLContext& gl, ImFontAtlas& fonts);

  // Draws into the bound framebuffer, whose viewport is the display size of the data.
  void draw(const ImDrawData& data) const;

 private:
  const GladGLContext& gl_;
  GlObject program_, vertex_array_, vertices_, indices_, atlas_;
};

}  // namespace render
