#include "render/backdrop.h"

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "render/light.h"
#include "render/visibility.h"

namespace render {
namespace {

// Colours of the backdrop are made in sRGB: they are chosen, not computed from light.
constexpr std::string_view gradient_fragment = R"(
in vec2 place;
uniform vec3 above, below;
out vec4 colour;
void main() {
  float t = place.y * place.y * (3.0 - 2.0 * place.y);
  colour = vec4(mix(below, above, t), 1.0);
}
)";

// A disc in the plane: a fan around its centre.
constexpr std::string_view plane_vertex = R"(
uniform vec3 centre, across, along;
out vec2 disc;  // length 1 at the rim
void main() {
  float angle = 6.2831853 / 48.0 * float(gl_VertexID - 1);
  disc = gl_VertexID == 0 ? vec2(0.0) : vec2(cos(angle), sin(angle));
  gl_Position = world_to_clip * vec4(centre + disc.x * across + disc.y * along, 1.0);
}
)";

// Fades towards the rim.
constexpr std::string_view fading = R"(
in vec2 disc;
uniform vec4 tint;  // sRGB, opacity at the centre
out vec4 colour;
float opacity() {
  float fade = max(1.0 - length(disc) / 0.997, 0.0);  // 0 before the fan's straight rim
  return tint.a * fade * fade * (3.0 - 2.0 * fade);
}
)";

constexpr std::string_view plane_fragment = "void main() { colour = vec4(tint.rgb, opacity()); }\n";

// Multiplies what is there by the square root of the light that is left, near to what linear light gives.
constexpr std::string_view shade_fragment = R"(
void main() {
  if (fully_lit(ivec2(0))) discard;
  vec2 lit = visible(ivec2(0));
  float light = 0.58 * lit.x * (0.75 + 0.25 * lit.y) + 0.42 * lit.y;
  colour = vec4(vec3(mix(1.0, sqrt(light), opacity())), 1.0);
}
)";

constexpr std::string_view depth_fragment = "void main() {}\n";

// A plane as far as it is drawn.
struct Disc {
  Eigen::Vector3f centre, across, along;  // along, across: from the centre to the rim
  Eigen::Vector4f tint;                   // sRGB, opacity
};

// Ground and planes, the ground first. Each is a disc around the point nearest to what the camera looks at; seen from
// behind it is left out.
std::vector<Disc> discs_of(const Frame& frame, const View& view) {
  std::vector<Disc> discs;
  const auto add = [&](const Point& point, const Point& direction, float radius, const Eigen::Vector4f& tint) {
    const Eigen::Vector3f normal = to_vector(direction).normalized();
    if (normal.dot(view.orthographic ? Eigen::Vector3f(-view.forward) : view.eye - to_vector(point)) <= 0) return;
    const float height = normal.dot(view.target - to_vector(point));
    const Eigen::Vector3f across = (radius + 1.5F * std::abs(height)) * normal.unitOrthogonal();
    discs.push_back({view.target - height * normal, across, normal.cross(across), tint});
  };
  if (frame.ground) {
    add(frame.ground->point, frame.ground->normal, 3.2F * view.extent, {0.965F, 0.965F, 0.96F, 1});
  }
  for (const PlaneObstacle& plane : frame.planes) {
    add(plane.point, plane.normal, 1.1F * view.extent, {0.72F, 0.78F, 0.84F, 0.9F});
  }
  return discs;
}

void draw_disc(const GladGLContext& gl, const GlObject& program, const Disc& disc) {
  const auto set = [&](const char* name, const Eigen::Vector3f& v) {
    gl.Uniform3f(gl.GetUniformLocation(program.name(), name), v.x(), v.y(), v.z());
  };
  set("centre", disc.centre);
  set("across", disc.across);
  set("along", disc.along);
  gl.Uniform4fv(gl.GetUniformLocation(program.name(), "tint"), 1, disc.tint.data());
  gl.DrawArrays(GL_TRIANGLE_FAN, 0, 50);
}

}  // namespace

Backdrop::Backdrop(const GladGLContext& gl)
    : gl_(gl),
      gradient_(make_program(gl, {cover_vertex}, {gradient_fragment})),
      plane_(make_program(gl, {frame_block, plane_vertex}, {fading, plane_fragment})),
      shade_(make_program(gl, {frame_block, plane_vertex}, {frame_block, visibility_lookup, fading, shade_fragment})),
      depth_(make_program(gl, {frame_block, plane_vertex}, {depth_fragment})),
      empty_(make_vertex_array(gl)) {}

void Backdrop::draw(const Frame& frame, const View& view, const GlObject& visibility, const Rect& shaded) const {
  gl_.BindVertexArray(empty_.name());
  gl_.UseProgram(gradient_.name());
  const bool paper = frame.look.background == Background::paper;
  const auto set = [&](const char* name, float r, float g, float b) {
    gl_.Uniform3f(gl_.GetUniformLocation(gradient_.name(), name), r, g, b);
  };
  if (paper) {
    set("above", 1, 1, 1);
    set("below", 1, 1, 1);
  } else {
    set("above", 0.80F, 0.835F, 0.87F);
    set("below", 0.945F, 0.95F, 0.955F);
  }
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);

  // Each plane hides what lies behind it and is darkened where light is missing.
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthMask(GL_TRUE);
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  for (const Disc& disc : discs_of(frame, view)) {
    gl_.DepthFunc(GL_LESS);
    gl_.UseProgram(plane_.name());
    begin_blending(gl_);
    draw_disc(gl_, plane_, disc);
    if (shaded.empty()) continue;
    gl_.DepthFunc(GL_EQUAL);
    gl_.BlendFunc(GL_ZERO, GL_SRC_COLOR);
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.Scissor(shaded.x, shaded.y, shaded.width, shaded.height);
    gl_.UseProgram(shade_.name());
    use_texture(gl_, shade_, "visibility", 0, visibility);
    draw_disc(gl_, shade_, disc);
    gl_.Disable(GL_SCISSOR_TEST);
  }
  gl_.Disable(GL_BLEND);
  gl_.Disable(GL_DEPTH_TEST);
}

void Backdrop::draw_depth(const Frame& frame, const View& view) const {
  gl_.BindVertexArray(empty_.name());
  gl_.UseProgram(depth_.name());
  gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  for (const Disc& disc : discs_of(frame, view)) draw_disc(gl_, depth_, disc);
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace render
