// OpenGL names as owning objects. The function table comes from the context and is a value, not a global.
#pragma once

#include <glad/gl.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "render/context.h"
#include "render/image.h"

namespace render {

// The GL functions of the context, which is made current. Throws std::runtime_error when it lacks OpenGL 3.3.
GladGLContext load_gl(Context& context);
// What draws in the context, in the words of its driver: "llvmpipe (LLVM 15.0.6, 256 bits)".
std::string driver_of(Context& context);

// Owns one GL name; movable. Deleted through the table, which must outlive it, with the context current.
class GlObject {
 public:
  using Deleter = void (*)(const GladGLContext& gl, GLuint name);

  GlObject() = default;
  GlObject(const GladGLContext& gl, GLuint name, Deleter deleter) : gl_(&gl), name_(name), deleter_(deleter) {}
  GlObject(GlObject&& other) noexcept { swap(other); }
  GlObject& operator=(GlObject&& other) noexcept {
    swap(other);
    return *this;
  }
  ~GlObject() {
    if (name_ != 0) deleter_(*gl_, name_);
  }
  GLuint name() const { return name_; }

 private:
  void swap(GlObject& other) {
    std::swap(gl_, other.gl_);
    std::swap(name_, other.name_);
    std::swap(deleter_, other.deleter_);
  }

  const GladGLContext* gl_ = nullptr;
  GLuint name_ = 0;
  Deleter deleter_ = nullptr;
};

GlObject make_buffer(const GladGLContext& gl);
GlObject make_vertex_array(const GladGLContext& gl);
GlObject make_framebuffer(const GladGLContext& gl);
GlObject make_query(const GladGLContext& gl);

// A 2D texture, one level, clamped to its edge. `format` and `type` describe `pixels`, which may be null.
struct TextureShape {
  GLenum internal_format;
  int width, height;
  GLenum format, type;
  GLenum filter;
};
GlObject make_texture(const GladGLContext& gl, const TextureShape& shape, const void* pixels = nullptr);

// A buffer of pixels to draw into.
GlObject make_renderbuffer(const GladGLContext& gl, GLenum internal_format, int width, int height);

// A linked program; each stage is the concatenation of its pieces behind "#version 330 core". Throws std::runtime_error
// with the compiler's message (our bug, or a driver's).
using Sources = std::vector<std::string_view>;
GlObject make_program(const GladGLContext& gl, const Sources& vertex, const Sources& fragment);

// A vertex stage that covers the viewport with one triangle at the far plane: DrawArrays(GL_TRIANGLES, 0, 3).
inline constexpr std::string_view cover_vertex = R"(
out vec2 place;  // 0 to 1 from the lower left
void main() {
  place = vec2(float(gl_VertexID & 1) * 2.0, float(gl_VertexID & 2));
  gl_Position = vec4(place * 2.0 - 1.0, 1.0, 1.0);
}
)";

// Puts the texture on a unit and gives the unit to the sampler of the program in use.
void use_texture(const GladGLContext& gl, const GlObject& program, const char* sampler, int unit,
                 const GlObject& texture);

// Blends by the fragment's opacity; the picture stays opaque. Ends with Disable(GL_BLEND).
void begin_blending(const GladGLContext& gl);

// Throws std::runtime_error, naming `what`, when the bound framebuffer cannot be drawn into.
void check_framebuffer(const GladGLContext& gl, const char* what);

// Puts `bytes` bytes into the buffer bound to `target`; its old storage is given up, so a frame in flight is not
// waited for.
void fill_buffer(const GladGLContext& gl, GLenum target, const GlObject& buffer, const void* data, std::size_t bytes);

// The pixels of the bound framebuffer.
Image read_pixels(const GladGLContext& gl, int width, int height);

}  // namespace render
