#include "render/shadow_map.h"

#include "render/light.h"

namespace render {
namespace {

constexpr std::string_view shadow_vertex = R"(
void main() { gl_Position = vec4((world_to_light * vec4(position, 1.0)).xyz * 2.0 - 1.0, 1.0); }
)";

constexpr std::string_view shadow_fragment = "void main() {}\n";

}  // namespace

ShadowMap::ShadowMap(const GladGLContext& gl)
    : gl_(gl),
      depth_(make_texture(gl, {GL_DEPTH_COMPONENT32F, texels, texels, GL_DEPTH_COMPONENT, GL_FLOAT, GL_NEAREST})),
      target_(make_framebuffer(gl)),
      program_(make_program(gl, {frame_block, vertex_attributes, shadow_vertex}, {shadow_fragment})) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, target_.name());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.name(), 0);
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
  check_framebuffer(gl, "shadow map");
}

void ShadowMap::draw(const SurfaceList& casters) const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, target_.name());
  gl_.Viewport(0, 0, texels, texels);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthMask(GL_TRUE);
  gl_.DepthFunc(GL_LESS);
  gl_.ClearDepth(1);
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  // Away from the light by the slope, so that a surface does not shade itself.
  gl_.Enable(GL_POLYGON_OFFSET_FILL);
  gl_.PolygonOffset(1.5F, 2);
  gl_.UseProgram(program_.name());
  // What is nearest to the light on a closed surface faces it.
  gl_.CullFace(GL_BACK);
  for (const SurfaceBuffer* caster : casters) {
    if (caster->closed()) gl_.Enable(GL_CULL_FACE);
    caster->draw_triangles();
    gl_.Disable(GL_CULL_FACE);
  }
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
}

}  // namespace render
