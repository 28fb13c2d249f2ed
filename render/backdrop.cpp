#include "render/backdrop.h"

#include <Eigen/Geometry>
#include <cmath>

#include "render/light.h"
#include "render/visibility.h"

namespace render {

// A plane as far as it is drawn: a disc around the point nearest to what the camera looks at.
struct Disc {
  Eigen::Vector3f centre, across, along;  // along, across: from the centre to the rim
  Eigen::Vector4f tint;                   // sRGB, opacity
};

namespace {

// Colours of the backdrop are made in sRGB: they are chosen, not computed from light.
constexpr std::string_view gradient = R"(
uniform vec3 above, below;
vec3 background() {
  float t = gl_FragCoord.y / size.y;
  return mix(below, above, t * t * (3.0 - 2.0 * t));
}
)";

constexpr std::string_view background_fragment = R"(
out vec4 colour;
void main() { colour = vec4(background(), 1.0); }
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

constexpr std::string_view ground_fragment =
    "void main() { colour = vec4(mix(background(), tint.rgb, opacity()), 1.0); }\n";

constexpr std::string_view plane_fragment = "void main() { colour = vec4(tint.rgb, opacity()); }\n";

// Multiplies what is there by the square root of the light that is left, near to what linear light gives.
constexpr std::string_view shade_fragment = R"(
void main() {
  vec2 lit = visible(ivec2(0));
  float light = 0.58 * lit.x * (0.75 + 0.25 * lit.y) + 0.42 * lit.y;
  colour = vec4(vec3(mix(1.0, sqrt(light), opacity())), 1.0);
}
)";

constexpr std::string_view depth_fragment = "void main() {}\n";

bool faces_eye(const Point& point, const Point& normal, const View& view) {
  const Eigen::Vector3f towards_eye =
      view.orthographic ? Eigen::Vector3f(-view.forward) : Eigen::Vector3f(view.eye - to_vector(point));
  return to_vector(normal).dot(towards_eye) > 0;
}

Disc disc_of(const Point& point, const Point& direction, const View& view, float radius, const Eigen::Vector4f& tint) {
  const Eigen::Vector3f normal = to_vector(direction).normalized();
  const float height = normal.dot(view.target - to_vector(point));
  const Eigen::Vector3f across = (radius + 1.5F * std::abs(height)) * normal.unitOrthogonal();
  return {view.target - height * normal, across, normal.cross(across), tint};
}

Disc ground_disc(const Ground& ground, const View& view) {
  return disc_of(ground.point, ground.normal, view, 3.2F * view.extent, {0.965F, 0.965F, 0.96F, 1});
}

Disc plane_disc(const PlaneObstacle& plane, const View& view) {
  return disc_of(plane.point, plane.normal, view, 1.1F * view.extent, {0.72F, 0.78F, 0.84F, 0.9F});
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
      background_(make_program(gl, {cover_vertex}, {frame_block, gradient, background_fragment})),
      ground_(make_program(gl, {frame_block, plane_vertex}, {frame_block, gradient, fading, ground_fragment})),
      plane_(make_program(gl, {frame_block, plane_vertex}, {fading, plane_fragment})),
      shade_(make_program(gl, {frame_block, plane_vertex}, {frame_block, visibility_lookup, fading, shade_fragment})),
      depth_(make_program(gl, {frame_block, plane_vertex}, {depth_fragment})),
      empty_(make_vertex_array(gl)) {}

void Backdrop::use_background(const GlObject& program, Background background) const {
  gl_.UseProgram(program.name());
  const bool paper = background == Background::paper;
  const auto set = [&](const char* name, float r, float g, float b) {
    gl_.Uniform3f(gl_.GetUniformLocation(program.name(), name), paper ? 1 : r, paper ? 1 : g, paper ? 1 : b);
  };
  set("above", 0.80F, 0.835F, 0.87F);
  set("below", 0.945F, 0.95F, 0.955F);
}

// From front to back as far as that saves time: the background is drawn where no ground is.
void Backdrop::draw(const Frame& frame, const View& view, const GlObject& visibility, const Shades& shades) const {
  gl_.BindVertexArray(empty_.name());
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthMask(GL_TRUE);
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  gl_.DepthFunc(GL_LEQUAL);
  const bool ground = frame.ground && faces_eye(frame.ground->point, frame.ground->normal, view);
  if (ground) {
    use_background(ground_, frame.look.background);
    draw_disc(gl_, ground_, ground_disc(*frame.ground, view));
  }
  use_background(background_, frame.look.background);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  if (ground) draw_shade(ground_disc(*frame.ground, view), visibility, shades.ground);
  for (std::size_t i = 0; i < frame.planes.size(); ++i) {
    if (!faces_eye(frame.planes[i].point, frame.planes[i].normal, view)) continue;
    const Disc disc = plane_disc(frame.planes[i], view);
    gl_.UseProgram(plane_.name());
    begin_blending(gl_);
    draw_disc(gl_, plane_, disc);
    gl_.Disable(GL_BLEND);
    draw_shade(disc, visibility, shades.planes[i]);
  }
  gl_.Disable(GL_DEPTH_TEST);
}

void Backdrop::draw_shade(const Disc& disc, const GlObject& visibility, const Rect& rect) const {
  if (rect.empty()) return;
  gl_.DepthFunc(GL_EQUAL);
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_ZERO, GL_SRC_COLOR);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.Scissor(rect.x, rect.y, rect.width, rect.height);
  gl_.UseProgram(shade_.name());
  use_texture(gl_, shade_, "visibility", 0, visibility);
  draw_disc(gl_, shade_, disc);
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.Disable(GL_BLEND);
  gl_.DepthFunc(GL_LEQUAL);
}

void Backdrop::draw_depth(const Frame& frame, const View& view) const {
  gl_.BindVertexArray(empty_.name());
  gl_.UseProgram(depth_.name());
  gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  if (frame.ground && faces_eye(frame.ground->point, frame.ground->normal, view)) {
    draw_disc(gl_, depth_, ground_disc(*frame.ground, view));
  }
  for (const PlaneObstacle& plane : frame.planes) {
    if (faces_eye(plane.point, plane.normal, view)) draw_disc(gl_, depth_, plane_disc(plane, view));
  }
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace render
