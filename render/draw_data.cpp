#include "render/draw_data.h"

#include <imgui.h>

#include <algorithm>
#include <cstddef>

namespace render {
namespace {

// Pixels from the upper left to clip space.
constexpr std::string_view quad_vertex = R"(
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 texel;
layout(location = 2) in vec4 tint;
uniform vec2 display;
out vec2 at;
out vec4 ink;
void main() {
  at = texel;
  ink = tint;
  gl_Position = vec4(position.x / display.x * 2.0 - 1.0, 1.0 - position.y / display.y * 2.0, 0.0, 1.0);
}
)";

constexpr std::string_view quad_fragment = R"(
in vec2 at;
in vec4 ink;
uniform sampler2D atlas;
out vec4 colour;
void main() { colour = vec4(ink.rgb, ink.a * texture(atlas, at).r); }
)";

GlObject upload_atlas(const GladGLContext& gl, ImFontAtlas& fonts) {
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  fonts.GetTexDataAsAlpha8(&pixels, &width, &height);
  return make_texture(gl, {GL_R8, width, height, GL_RED, GL_UNSIGNED_BYTE, GL_LINEAR}, pixels);
}

}  // namespace

DrawDataPainter::DrawDataPainter(const GladGLContext& gl, ImFontAtlas& fonts)
    : gl_(gl),
      program_(make_program(gl, {quad_vertex}, {quad_fragment})),
      vertex_array_(make_vertex_array(gl)),
      vertices_(make_buffer(gl)),
      indices_(make_buffer(gl)),
      atlas_(upload_atlas(gl, fonts)) {
  gl.BindVertexArray(vertex_array_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
  const auto attribute = [&](GLuint index, GLint count, GLenum type, GLboolean normalised, std::size_t offset) {
    gl.VertexAttribPointer(index, count, type, normalised, sizeof(ImDrawVert), reinterpret_cast<const void*>(offset));
    gl.EnableVertexAttribArray(index);
  };
  attribute(0, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, pos));
  attribute(1, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, uv));
  attribute(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(ImDrawVert, col));
  gl.BindVertexArray(0);
}

void DrawDataPainter::draw(const ImDrawData& data) const {
  gl_.Disable(GL_DEPTH_TEST);
  begin_blending(gl_);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.UseProgram(program_.name());
  use_texture(gl_, program_, "atlas", 0, atlas_);
  gl_.Uniform2f(gl_.GetUniformLocation(program_.name(), "display"), data.DisplaySize.x, data.DisplaySize.y);
  gl_.BindVertexArray(vertex_array_.name());
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    fill_buffer(gl_, GL_ARRAY_BUFFER, vertices_, list.VtxBuffer.Data,
                static_cast<std::size_t>(list.VtxBuffer.size_in_bytes()));
    fill_buffer(gl_, GL_ELEMENT_ARRAY_BUFFER, indices_, list.IdxBuffer.Data,
                static_cast<std::size_t>(list.IdxBuffer.size_in_bytes()));
    for (const ImDrawCmd& command : list.CmdBuffer) {
      const float left = std::max(command.ClipRect.x, 0.0F), top = std::max(command.ClipRect.y, 0.0F);
      const float right = std::min(command.ClipRect.z, data.DisplaySize.x);
      const float bottom = std::min(command.ClipRect.w, data.DisplaySize.y);
      if (right <= left || bottom <= top) continue;
      gl_.Scissor(static_cast<GLint>(left), static_cast<GLint>(data.DisplaySize.y - bottom),
                  static_cast<GLsizei>(right - left), static_cast<GLsizei>(bottom - top));
      gl_.DrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
                                 sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                                 reinterpret_cast<const void*>(command.IdxOffset * sizeof(ImDrawIdx)),
                                 static_cast<GLint>(command.VtxOffset));
    }
  }
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.Disable(GL_BLEND);
}

}  // namespace render
