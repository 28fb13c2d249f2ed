#include "render/canvas.h"

#include <algorithm>
#include <string>

#include "render/light.h"
#include "render/visibility.h"

namespace render {
namespace {

constexpr std::string_view copy_fragment = R"(
uniform sampler2D picture;
uniform ivec2 origin;
out vec4 colour;
void main() { colour = texelFetch(picture, ivec2(gl_FragCoord.xy) + origin, 0); }
)";

// Samples are sRGB; their squares are close to linear light, and equal samples keep their value exactly. The share of
// the light that is seen is raised to 1/1.1, because sRGB is nearer to a power of 2.2.
constexpr std::string_view resolve_fragment = R"(
uniform SURFACE region;
uniform SURFACE depth_map;
uniform ivec2 origin;
out vec4 colour;
void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) - origin;
#ifdef SHADED
  float depth = texelFetch(depth_map, pixel, 0).r;
  vec2 lit = visible(gl_FragCoord.xy, depth, vec2(dFdx(depth), dFdy(depth)));
#endif
  vec3 sum = vec3(0.0);
  for (int i = 0; i < SAMPLES; ++i) {
    vec4 s = texelFetch(region, pixel, i);
    vec3 light = s.rgb * s.rgb;
#ifdef SHADED
    float seen = mix(lit.x, lit.y, min(s.a / most_rest, 1.0));
    light *= s.a > 0.5 + 0.5 * most_rest ? 1.0 : seen * (1.1 - 0.1 * seen);
#endif
    sum += light;
  }
  colour = vec4(sqrt(sum / float(SAMPLES)), 1.0);
}
)";

// What the context can do of the samples that were asked for.
int possible_samples(const GladGLContext& gl, int wanted) {
  GLint colour = 1, depth = 1;
  gl.GetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &colour);
  gl.GetIntegerv(GL_MAX_DEPTH_TEXTURE_SAMPLES, &depth);
  return std::max(1, std::min({wanted, static_cast<int>(colour), static_cast<int>(depth)}));
}

// A texture to draw into, multisampled when samples > 1.
GlObject make_surface(const GladGLContext& gl, GLenum format, GLenum pixels, int width, int height, int samples) {
  if (samples == 1) return make_texture(gl, {format, width, height, pixels, GL_UNSIGNED_BYTE, GL_NEAREST});
  GLuint name = 0;
  gl.GenTextures(1, &name);
  GlObject texture(gl, name, [](const GladGLContext& g, GLuint n) { g.DeleteTextures(1, &n); });
  gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, name);
  gl.TexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, format, width, height, GL_TRUE);
  return texture;
}

void set_origin(const GladGLContext& gl, const GlObject& program, const Rect& rect) {
  gl.UseProgram(program.name());
  gl.Uniform2i(gl.GetUniformLocation(program.name(), "origin"), rect.x, rect.y);
}

}  // namespace

Canvas::Canvas(const GladGLContext& gl, int width, int height, int samples)
    : gl_(gl), width_(width), height_(height), samples_(possible_samples(gl, samples)) {
  picture_texture_ = make_texture(gl, {GL_RGBA8, width, height, GL_RGBA, GL_UNSIGNED_BYTE, GL_NEAREST});
  picture_ = make_framebuffer(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, picture_.name());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture_texture_.name(), 0);
  picture_depth_ = make_renderbuffer(gl, GL_DEPTH_COMPONENT24, width, height);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, picture_depth_.name());
  check_framebuffer(gl, "picture");
  // The region's first allocation tells how many samples a pixel really has.
  make_region(64, 64);
  if (samples_ > 1) {
    gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, region_colour_.name());
    GLint given = 1;
    gl.GetTexLevelParameteriv(GL_TEXTURE_2D_MULTISAMPLE, 0, GL_TEXTURE_SAMPLES, &given);
    samples_ = static_cast<int>(given);
  }
  const std::string switches = "#define SAMPLES " + std::to_string(samples_) + "\n#define SURFACE " +
                               (samples_ > 1 ? "sampler2DMS" : "sampler2D") + "\n";
  copy_ = make_program(gl, {cover_vertex}, {copy_fragment});
  resolve_ = make_program(gl, {cover_vertex}, {switches, resolve_fragment});
  resolve_shaded_ = make_program(gl, {cover_vertex},
                                 {switches, "#define SHADED\n", visibility_reach(height), opacity_code, frame_block,
                                  visibility_lookup, resolve_fragment});
  empty_ = make_vertex_array(gl);
}

void Canvas::make_region(int width, int height) {
  region_width_ = width;
  region_height_ = height;
  region_colour_ = make_surface(gl_, GL_RGBA8, GL_RGBA, width, height, samples_);
  region_depth_ = make_surface(gl_, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, width, height, samples_);
  region_target_ = make_framebuffer(gl_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, region_target_.name());
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, surface_kind(), region_colour_.name(), 0);
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, surface_kind(), region_depth_.name(), 0);
  check_framebuffer(gl_, "multisampled region");
}

void Canvas::copy_into_picture(const GlObject& framebuffer) const {
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer.name());
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, picture_.name());
  gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void Canvas::draw_into_picture() const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, picture_.name());
  gl_.Viewport(0, 0, width_, height_);
  gl_.Disable(GL_DEPTH_TEST);
}

void Canvas::draw_into_region(const Rect& region) {
  region_ = region;
  if (region.width > region_width_ || region.height > region_height_) {
    // Grown in steps, so that a body that moves does not mean a new buffer every frame.
    constexpr int step = 128;
    const auto grown = [](int wanted, int had, int most) {
      return std::min(std::max((wanted + step - 1) / step * step, had), std::max(most, 64));
    };
    make_region(grown(region.width, region_width_, width_), grown(region.height, region_height_, height_));
  }
  gl_.BindFramebuffer(GL_FRAMEBUFFER, region_target_.name());
  gl_.Viewport(0, 0, region.width, region.height);
  // Colour from the picture, depth far away: no clear needed.
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_ALWAYS);
  gl_.DepthMask(GL_TRUE);
  set_origin(gl_, copy_, region);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, picture_texture_.name());
  gl_.BindVertexArray(empty_.name());
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  gl_.DepthFunc(GL_LESS);
  // From here on the viewport is the whole picture's, shifted: the region shows its part.
  gl_.Viewport(-region.x, -region.y, width_, height_);
}

void Canvas::resolve(const GlObject* visibility) {
  const GlObject& program = visibility != nullptr ? resolve_shaded_ : resolve_;
  draw_into_picture();
  gl_.Viewport(region_.x, region_.y, region_.width, region_.height);
  set_origin(gl_, program, region_);
  if (visibility != nullptr) use_texture(gl_, program, "visibility", 2, *visibility);
  const auto use_surface = [&](const char* sampler, int unit, const GlObject& surface) {
    gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl_.BindTexture(surface_kind(), surface.name());
    gl_.Uniform1i(gl_.GetUniformLocation(program.name(), sampler), unit);
  };
  use_surface("region", 0, region_colour_);
  use_surface("depth_map", 1, region_depth_);
  gl_.BindVertexArray(empty_.name());
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  gl_.Viewport(0, 0, width_, height_);
}

Image Canvas::read() const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, picture_.name());
  return read_pixels(gl_, width_, height_);
}

void Canvas::copy_to_default(int x) const {
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, picture_.name());
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  gl_.ClearColor(0, 0, 0, 1);  // what stands beside the picture is blended, and opaque
  gl_.Clear(GL_COLOR_BUFFER_BIT);
  gl_.BlitFramebuffer(0, 0, width_, height_, x, 0, x + width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace render
