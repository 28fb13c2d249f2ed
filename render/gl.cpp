#include "render/gl.h"

#include <algorithm>
#include <stdexcept>

namespace render {

GladGLContext load_gl(Context& context) {
  context.make_current();
  GladGLContext gl{};
  const int version = gladLoadGLContext(&gl, context.getter());
  if (version < GLAD_MAKE_VERSION(3, 3)) {
    throw std::runtime_error("OpenGL 3.3 core is needed, the context gives " +
                             std::to_string(GLAD_VERSION_MAJOR(version)) + "." +
                             std::to_string(GLAD_VERSION_MINOR(version)));
  }
  return gl;
}

std::string driver_of(Context& context) {
  const GLubyte* const name = load_gl(context).GetString(GL_RENDERER);
  return name == nullptr ? "" : reinterpret_cast<const char*>(name);
}

GlObject make_buffer(const GladGLContext& gl) {
  GLuint name = 0;
  gl.GenBuffers(1, &name);
  return {gl, name, [](const GladGLContext& g, GLuint n) { g.DeleteBuffers(1, &n); }};
}

GlObject make_vertex_array(const GladGLContext& gl) {
  GLuint name = 0;
  gl.GenVertexArrays(1, &name);
  return {gl, name, [](const GladGLContext& g, GLuint n) { g.DeleteVertexArrays(1, &n); }};
}

GlObject make_framebuffer(const GladGLContext& gl) {
  GLuint name = 0;
  gl.GenFramebuffers(1, &name);
  return {gl, name, [](const GladGLContext& g, GLuint n) { g.DeleteFramebuffers(1, &n); }};
}

GlObject make_query(const GladGLContext& gl) {
  GLuint name = 0;
  gl.GenQueries(1, &name);
  return {gl, name, [](const GladGLContext& g, GLuint n) { g.DeleteQueries(1, &n); }};
}

GlObject make_texture(const GladGLContext& gl, const TextureShape& shape, const void* pixels) {
  GLuint name = 0;
  gl.GenTextures(1, &name);
  GlObject texture(gl, name, [](const GladGLContext& g, GLuint n) { g.DeleteTextures(1, &n); });
  gl.BindTexture(GL_TEXTURE_2D, name);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(shape.internal_format), shape.width, shape.height, 0, shape.format,
                shape.type, pixels);
  const auto filter = static_cast<GLint>(shape.filter);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

GlObject make_renderbuffer(const GladGLContext& gl, GLenum internal_format, int width, int height) {
  GLuint name = 0;
  gl.GenRenderbuffers(1, &name);
  GlObject buffer(gl, name, [](const GladGLContext& g, GLuint n) { g.DeleteRenderbuffers(1, &n); });
  gl.BindRenderbuffer(GL_RENDERBUFFER, name);
  gl.RenderbufferStorage(GL_RENDERBUFFER, internal_format, width, height);
  return buffer;
}

namespace {

GlObject compile(const GladGLContext& gl, GLenum stage, const Sources& pieces) {
  GlObject shader(gl, gl.CreateShader(stage), [](const GladGLContext& g, GLuint n) { g.DeleteShader(n); });
  std::vector<const char*> texts{"#version 330 core\n"};
  std::vector<GLint> lengths{-1};
  for (const std::string_view piece : pieces) {
    texts.push_back(piece.data());
    lengths.push_back(static_cast<GLint>(piece.size()));
  }
  gl.ShaderSource(shader.name(), static_cast<GLsizei>(texts.size()), texts.data(), lengths.data());
  gl.CompileShader(shader.name());
  GLint done = 0;
  gl.GetShaderiv(shader.name(), GL_COMPILE_STATUS, &done);
  if (done == 0) {
    std::string log(4096, '\0');
    GLsizei length = 0;
    gl.GetShaderInfoLog(shader.name(), static_cast<GLsizei>(log.size()), &length, log.data());
    throw std::runtime_error("shader: " + log.substr(0, static_cast<std::size_t>(length)));
  }
  return shader;
}

}  // namespace

GlObject make_program(const GladGLContext& gl, const Sources& vertex, const Sources& fragment) {
  const GlObject vertex_shader = compile(gl, GL_VERTEX_SHADER, vertex);
  const GlObject fragment_shader = compile(gl, GL_FRAGMENT_SHADER, fragment);
  GlObject program(gl, gl.CreateProgram(), [](const GladGLContext& g, GLuint n) { g.DeleteProgram(n); });
  gl.AttachShader(program.name(), vertex_shader.name());
  gl.AttachShader(program.name(), fragment_shader.name());
  gl.LinkProgram(program.name());
  GLint done = 0;
  gl.GetProgramiv(program.name(), GL_LINK_STATUS, &done);
  if (done == 0) {
    std::string log(4096, '\0');
    GLsizei length = 0;
    gl.GetProgramInfoLog(program.name(), static_cast<GLsizei>(log.size()), &length, log.data());
    throw std::runtime_error("shader program: " + log.substr(0, static_cast<std::size_t>(length)));
  }
  // All programs share the one uniform block of a frame (render/light.h), at binding 0.
  const GLuint block = gl.GetUniformBlockIndex(program.name(), "Frame");
  if (block != GL_INVALID_INDEX) gl.UniformBlockBinding(program.name(), block, 0);
  return program;
}

void use_texture(const GladGLContext& gl, const GlObject& program, const char* sampler, int unit,
                 const GlObject& texture) {
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl.BindTexture(GL_TEXTURE_2D, texture.name());
  gl.Uniform1i(gl.GetUniformLocation(program.name(), sampler), unit);
}

void begin_blending(const GladGLContext& gl) {
  gl.Enable(GL_BLEND);
  gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
}

void check_framebuffer(const GladGLContext& gl, const char* what) {
  const GLenum status = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error(std::string(what) + ": the context cannot draw into this framebuffer (status " +
                             std::to_string(status) + ")");
  }
}

void fill_buffer(const GladGLContext& gl, GLenum target, const GlObject& buffer, const void* data, std::size_t bytes) {
  gl.BindBuffer(target, buffer.name());
  gl.BufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_STREAM_DRAW);
}

Image read_pixels(const GladGLContext& gl, int width, int height) {
  const std::size_t row = 4 * static_cast<std::size_t>(width);
  Image image{width, height, std::vector<std::uint8_t>(row * static_cast<std::size_t>(height))};
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  // GL counts rows from below.
  auto top = image.rgba.begin(), bottom = image.rgba.end();
  for (int y = 0; y < height / 2; ++y, top += static_cast<std::ptrdiff_t>(row)) {
    bottom -= static_cast<std::ptrdiff_t>(row);
    std::swap_ranges(top, top + static_cast<std::ptrdiff_t>(row), bottom);
  }
  return image;
}

}  // namespace render
