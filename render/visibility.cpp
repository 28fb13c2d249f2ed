#include "render/visibility.h"

#include <algorithm>

#include "render/light.h"

namespace render {
namespace {

constexpr std::string_view depth_vertex = R"(
void main() { gl_Position = world_to_clip * vec4(position, 1.0); }
)";

constexpr std::string_view depth_fragment = "void main() {}\n";

// One of 16 numbers per texel, repeated every 4 x 4, so that a mean over 4 x 4 texels has all of them: Bayer's order.
// It turns and spreads the samples around the texel.
constexpr std::string_view pattern = R"(
uniform sampler2D depth_map;
float turn(ivec2 p) {
  int x = p.x, y = p.y;
  int k = ((x ^ y) & 1) << 3 | (y & 1) << 2 | ((x ^ y) & 2) | (y & 2) >> 1;
  return float(k) / 16.0;
}
mat2 rotation(float angle) {
  float c = cos(angle), s = sin(angle);
  return mat2(c, s, -s, c);
}
)";

// Share of the key light: first the mean distance of what is in front of the point, from which the width of the
// penumbra follows (a lamp of finite size), then the share of lit points within that width. Points lie on a spiral of
// equal areas, each turned by the golden angle from the one before.
constexpr std::string_view shadow_part = R"(
uniform sampler2D shadow_map;
const float lamp = 0.30;    // tangent of the angle the lamp fills
const float widest = 0.06;  // penumbra, as a share of the map
const mat2 golden = mat2(-0.7373689, 0.6754903, -0.6754903, -0.7373689);

float key_light(vec3 world, vec3 normal, float phase) {
  float texel = 1.0 / float(textureSize(shadow_map, 0).x);
  // Lengths of the light's cube: its side is 1 / |first row|, its depth 1 / |third row|.
  float side = 1.0 / length(vec3(world_to_light[0][0], world_to_light[1][0], world_to_light[2][0]));
  float deep = 1.0 / length(vec3(world_to_light[0][2], world_to_light[1][2], world_to_light[2][2]));
  vec3 p = (world_to_light * vec4(world + normal * (2.0 * texel * side), 1.0)).xyz;
  bool inside = all(greaterThan(p.xy, vec2(0.0))) && all(lessThan(p.xy, vec2(1.0)));
  // Where nothing blocks, the map holds 1; what lies behind the cube is compared with what is in it.
  float receiver = min(p.z - 1.5 * texel * side / deep, 0.9999);
  mat2 spin = rotation(6.2831853 * phase);
  vec2 arm = spin[0];
  float found = 0.0, gap = 0.0;
  for (int i = 0; i < 5; ++i) {
    float d = textureLod(shadow_map, p.xy + arm * (sqrt((float(i) + phase) / 5.0) * widest), 0.0).r;
    float blocks = d < receiver ? 1.0 : 0.0;
    found += blocks;
    gap += blocks * (p.z - d);
    arm = golden * arm;
  }
  float width = clamp(gap / max(found, 1.0) * deep / side * lamp, 1.5 * texel, widest);
  float lit = 0.0;
  arm = spin[1];
  for (int i = 0; i < 6; ++i) {
    float d = textureLod(shadow_map, p.xy + arm * (sqrt((float(i) + phase) / 6.0) * width), 0.0).r;
    lit += d < receiver ? 0.0 : 1.0;
    arm = golden * arm;
  }
  return found > 0.0 && inside ? lit / 6.0 : 1.0;
}
)";

// Share of the sky: pairs of opposite neighbours. Window depth is linear on planes, so the mean of a pair lies in
// front of the point just where the surface is hollow.
constexpr std::string_view sky_part = R"(
const mat2 eighth = mat2(0.7071068, 0.7071068, -0.7071068, 0.7071068);  // of a turn

float sky_light(vec2 place, float d, float z, float phase) {
  float radius = 0.085 * forward.w;  // world
  float pixels = radius / forward.w * size.w * (eye.w > 0.5 ? 1.0 : eye_distance / z);
  pixels = clamp(pixels, 3.0, 0.25 * size.w);
  float to_length = eye_depth_slope(z);
  vec2 arm = rotation(0.7853982 * phase)[0] * pixels / size.zw;
  float dark = 0.0;
  for (int i = 0; i < 4; ++i) {
    float share = (float((i * 3 + 1) % 4) + 0.4 + 0.6 * phase) / 4.0;
    float one = (d - textureLod(depth_map, place + arm * share, 0.0).r) * to_length;
    float two = (d - textureLod(depth_map, place - arm * share, 0.0).r) * to_length;
    float hollow = 0.5 * (one + two) / (radius * share);
    float near_by = 1.0 - smoothstep(1.0, 3.0, max(one, two) / radius);
    dark += clamp(hollow - 0.04, 0.0, 1.0) * near_by;
    arm = eighth * arm;
  }
  return 1.0 - min(1.7 * dark / 4.0, 0.85);
}
)";

constexpr std::string_view raw_inputs = R"(
in vec2 place;
uniform float eye_distance;
out vec4 result;
)";

constexpr std::string_view raw_main = R"(
void main() {
  float d = textureLod(depth_map, place, 0.0).r;
  float z = eye_depth(d);
  vec4 p = clip_to_world * vec4(vec3(place, d) * 2.0 - 1.0, 1.0);
  vec3 world = p.xyz / p.w;
  vec3 normal = normalize(cross(dFdx(world), dFdy(world)));
  float phase = turn(ivec2(gl_FragCoord.xy));
  result = vec4(1.0, 1.0, d, 1.0);
#ifdef SHADOW
  result.x = key_light(world, normal, phase);
#endif
#ifdef SKY
  result.y = sky_light(place, d, z, phase);
#endif
  if (d == 1.0) result.xy = vec2(1.0);
}
)";

// The mean over the 4 x 4 texels around that lie in the same plane.
constexpr std::string_view smooth_fragment = R"(
in vec2 place;
uniform sampler2D raw;
out vec4 result;
void main() {
  vec2 texel = 1.0 / size.zw;
  float own = textureLod(raw, place, 0.0).z;
  float tolerance = 0.01 * forward.w / eye_depth_slope(eye_depth(own));
  vec2 slope = vec2(dFdx(own), dFdy(own));
  slope *= step(abs(slope), vec2(5.0 * tolerance));  // an edge, not a slope
  vec3 sum = vec3(0.0);
  for (int k = 0; k < 16; ++k) {
    vec2 step = vec2(float(k & 3), float(k >> 2)) - 2.0;
    vec3 v = textureLod(raw, place + step * texel, 0.0).xyz;
    sum += vec3(v.xy, 1.0) / (abs(v.z - own - dot(slope, step)) + tolerance);
  }
  result = vec4(sum.xy / sum.z, own, 1.0);
}
)";

GlObject make_target(const GladGLContext& gl, GLenum attachment, const GlObject& texture, const char* what) {
  GlObject target = make_framebuffer(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, target.name());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture.name(), 0);
  if (attachment == GL_DEPTH_ATTACHMENT) {
    gl.DrawBuffer(GL_NONE);
    gl.ReadBuffer(GL_NONE);
  }
  check_framebuffer(gl, what);
  return target;
}

// Picture pixels per texel, so that the buffer has about 270 rows.
int scale_for(int height) {
  return std::max(1, (height + 135) / 270);
}

}  // namespace

std::string_view visibility_reach(int height) {
  return scale_for(height) == 1 ? "#define REACH 3\n" : "#define REACH 2\n";
}

Visibility::Visibility(const GladGLContext& gl, int width, int height)
    : gl_(gl),
      scale_(scale_for(height)),
      width_((width + scale_ - 1) / scale_),
      height_((height + scale_ - 1) / scale_) {
  depth_ = make_texture(gl, {GL_DEPTH_COMPONENT32F, width_, height_, GL_DEPTH_COMPONENT, GL_FLOAT, GL_NEAREST});
  depth_target_ = make_target(gl, GL_DEPTH_ATTACHMENT, depth_, "visibility depth");
  raw_ = make_texture(gl, {GL_RGBA32F, width_, height_, GL_RGBA, GL_FLOAT, GL_NEAREST});
  raw_target_ = make_target(gl, GL_COLOR_ATTACHMENT0, raw_, "visibility");
  smooth_ = make_texture(gl, {GL_RGBA32F, width_, height_, GL_RGBA, GL_FLOAT, GL_NEAREST});
  smooth_target_ = make_target(gl, GL_COLOR_ATTACHMENT0, smooth_, "smooth visibility");
  depth_program_ = make_program(gl, {frame_block, vertex_attributes, depth_vertex}, {depth_fragment});
  const auto make_raw = [&](const char* parts) {
    return make_program(gl, {cover_vertex}, {parts, frame_block, raw_inputs, pattern, shadow_part, sky_part, raw_main});
  };
  shadow_program_ = make_raw("#define SHADOW\n");
  sky_program_ = make_raw("#define SKY\n");
  both_program_ = make_raw("#define SHADOW\n#define SKY\n");
  smooth_program_ = make_program(gl, {cover_vertex}, {frame_block, smooth_fragment});
  empty_ = make_vertex_array(gl);
  inside_query_ = make_query(gl);
}

bool Visibility::draw(const Frame& frame, const View& view, const SurfaceList& solids, const Backdrop& backdrop,
                      const ShadowMap& shadow, const Rect& rect) const {
  gl_.Viewport(0, 0, width_, height_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, depth_target_.name());
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_LESS);
  gl_.DepthMask(GL_TRUE);
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  backdrop.draw_depth(frame, view);
  draw_solids(solids);

  // Each stage has the texels around it that the next one reads.
  const auto scissor = [&](int border) {
    gl_.Scissor(rect.x / scale_ - border, rect.y / scale_ - border, rect.width / scale_ + 2 * border,
                rect.height / scale_ + 2 * border);
  };
  gl_.Enable(GL_SCISSOR_TEST);
  scissor(6);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.BindVertexArray(empty_.name());
  gl_.BindFramebuffer(GL_FRAMEBUFFER, raw_target_.name());
  const GlObject& program = !frame.look.shadow ? sky_program_ : !frame.look.occlusion ? shadow_program_ : both_program_;
  gl_.UseProgram(program.name());
  use_texture(gl_, program, "depth_map", 0, depth_);
  use_texture(gl_, program, "shadow_map", 1, shadow.depth());
  gl_.Uniform1f(gl_.GetUniformLocation(program.name(), "eye_distance"), (view.target - view.eye).norm());
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);

  scissor(3);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, smooth_target_.name());
  gl_.UseProgram(smooth_program_.name());
  use_texture(gl_, smooth_program_, "raw", 0, raw_);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  gl_.Disable(GL_SCISSOR_TEST);
  GLuint shows = 0;
  gl_.GetQueryObjectuiv(inside_query_.name(), GL_QUERY_RESULT, &shows);
  return shows != 0;
}

// Outsides first; then the insides of closed surfaces, a little farther away, tell whether they are seen.
void Visibility::draw_solids(const SurfaceList& solids) const {
  gl_.UseProgram(depth_program_.name());
  gl_.CullFace(GL_BACK);
  for (const SurfaceBuffer* solid : solids) {
    if (solid->closed()) gl_.Enable(GL_CULL_FACE);
    solid->draw_triangles();
    gl_.Disable(GL_CULL_FACE);
  }
  gl_.Enable(GL_CULL_FACE);
  gl_.CullFace(GL_FRONT);
  gl_.Enable(GL_POLYGON_OFFSET_FILL);
  gl_.PolygonOffset(1, 4);
  gl_.BeginQuery(GL_ANY_SAMPLES_PASSED, inside_query_.name());
  for (const SurfaceBuffer* solid : solids) {
    if (solid->closed()) solid->draw_triangles();
  }
  gl_.EndQuery(GL_ANY_SAMPLES_PASSED);
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
  gl_.Disable(GL_CULL_FACE);
}

}  // namespace render
