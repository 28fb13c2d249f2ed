#include "render/backdrop.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
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
constexpr std::string_view opacity_function = R"(
float fade(float r) {
  float s = max(1.0 - r / 0.997, 0.0);  // 0 before the fan's straight rim
  return s * s * (3.0 - 2.0 * s);
}
)";

// Background and ground in one pass. From a pixel to the ground's disc leads a projective map: with (u, v, w) linear on
// the screen, the point is (u, v) / w, in front of the eye where w > 0.
constexpr std::string_view background_vertex = R"(
uniform mat3 to_disc;
out vec3 on_disc;
out float height;
void main() {
  vec2 place = vec2(float(gl_VertexID & 1) * 4.0, float(gl_VertexID & 2) * 2.0) - 1.0;
  on_disc = to_disc * vec3(place, 1.0);
  height = 0.5 + 0.5 * place.y;
  gl_Position = vec4(place, 0.0, 1.0);
}
)";

constexpr std::string_view background_fragment = R"(
in vec3 on_disc;
in float height;
uniform vec3 above, below;
uniform vec4 tint;  // of the ground; sRGB, opacity at the centre
out vec4 colour;
void main() {
  vec3 sky = mix(below, above, height * height * (3.0 - 2.0 * height));
  float r = on_disc.z > 0.0 ? length(on_disc.xy) / on_disc.z : 1.0;
  colour = vec4(mix(sky, tint.rgb, tint.a * fade(r)), 1.0);
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

constexpr std::string_view disc_inputs = R"(
in vec2 disc;
uniform vec4 tint;
out vec4 colour;
)";

constexpr std::string_view plane_fragment = "void main() { colour = vec4(tint.rgb, tint.a * fade(length(disc))); }\n";

// Multiplies what is there by the square root of the light that is left, near to what linear light gives.
constexpr std::string_view shade_fragment = R"(
void main() {
  vec2 lit = visible(gl_FragCoord.xy, gl_FragCoord.z, vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z)));
  float light = 0.58 * lit.x * (0.75 + 0.25 * lit.y) + 0.42 * lit.y;
  colour = vec4(vec3(mix(1.0, sqrt(light), tint.a * fade(length(disc)))), 1.0);
}
)";

constexpr std::string_view plane_depth_fragment = "void main() {}\n";

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

// The ground fades where it is seen from so low that it would be a line across the picture.
float ground_opacity(const Ground& ground, const View& view) {
  if (!faces_eye(ground.point, ground.normal, view)) return 0;
  if (view.orthographic) return 1;
  const float height = to_vector(ground.normal).normalized().dot(view.eye - to_vector(ground.point));
  return std::clamp((height / (view.eye - view.target).norm() - 0.01F) / 0.07F, 0.0F, 1.0F);
}

bool shows_ground(const Frame& frame, const View& view) {
  return frame.ground && ground_opacity(*frame.ground, view) > 0;
}

Disc ground_disc(const Ground& ground, const View& view) {
  const float opacity = ground_opacity(ground, view);
  return disc_of(ground.point, ground.normal, view, 3.2F * view.extent, {0.965F, 0.965F, 0.96F, opacity});
}

Disc plane_disc(const PlaneObstacle& plane, const View& view) {
  return disc_of(plane.point, plane.normal, view, 1.1F * view.extent, {0.86F, 0.885F, 0.91F, 0.95F});
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

// From normalised screen coordinates to the disc, see background_vertex: the inverse of (x, y, w) of the clip space
// point of centre + a across + b along, a matrix on (a, b, 1).
Eigen::Matrix3f screen_to_disc(const Disc& disc, const View& view) {
  Eigen::Matrix<float, 4, 3> to_world = Eigen::Matrix<float, 4, 3>::Zero();
  to_world.block<3, 1>(0, 0) = disc.across;
  to_world.block<3, 1>(0, 1) = disc.along;
  to_world.col(2) << disc.centre, 1;
  const Eigen::Matrix<float, 4, 3> to_clip = view.world_to_clip * to_world;
  Eigen::Matrix3d to_screen;
  to_screen << to_clip.row(0).cast<double>(), to_clip.row(1).cast<double>(), to_clip.row(3).cast<double>();
  // A plane seen edge-on covers nothing: w = 0 everywhere.
  if (std::abs(to_screen.determinant()) < 1e-12) return Eigen::Matrix3f::Zero();
  return to_screen.inverse().cast<float>();
}

}  // namespace

Backdrop::Backdrop(const GladGLContext& gl, int width, int height)
    : gl_(gl),
      background_(make_program(gl, {background_vertex}, {opacity_function, background_fragment})),
      plane_(make_program(gl, {frame_block, plane_vertex}, {disc_inputs, opacity_function, plane_fragment})),
      shade_(make_program(
          gl, {frame_block, plane_vertex},
          {visibility_reach(height), frame_block, visibility_lookup, disc_inputs, opacity_function, shade_fragment})),
      depth_(make_program(gl, {frame_block, plane_vertex}, {plane_depth_fragment})),
      made_texture_(make_texture(gl, {GL_RGBA8, width, height, GL_RGBA, GL_UNSIGNED_BYTE, GL_NEAREST})),
      made_target_(make_framebuffer(gl)),
      empty_(make_vertex_array(gl)) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, made_target_.name());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, made_texture_.name(), 0);
  check_framebuffer(gl, "background");
}

void Backdrop::draw_background(const Frame& frame, const View& view, const Disc* ground, const Canvas& canvas) {
  const bool paper = frame.look.background == Background::paper;
  const Eigen::Vector3f white = Eigen::Vector3f::Ones();
  Sky sky;
  sky.above = paper ? white : Eigen::Vector3f(0.80F, 0.835F, 0.87F);
  sky.below = paper ? white : Eigen::Vector3f(0.945F, 0.95F, 0.955F);
  sky.to_disc = ground != nullptr ? screen_to_disc(*ground, view) : Eigen::Matrix3f::Zero();
  sky.tint = ground != nullptr ? ground->tint : Eigen::Vector4f::Zero();
  if (!made_ || !(*made_ == sky)) {
    made_ = sky;
    gl_.BindFramebuffer(GL_FRAMEBUFFER, made_target_.name());
    gl_.UseProgram(background_.name());
    const auto place = [&](const char* name) { return gl_.GetUniformLocation(background_.name(), name); };
    gl_.Uniform3fv(place("above"), 1, sky.above.data());
    gl_.Uniform3fv(place("below"), 1, sky.below.data());
    gl_.UniformMatrix3fv(place("to_disc"), 1, GL_FALSE, sky.to_disc.data());
    gl_.Uniform4fv(place("tint"), 1, sky.tint.data());
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  }
  canvas.copy_into_picture(made_target_);
  canvas.draw_into_picture();
}

void Backdrop::draw(const Frame& frame, const View& view, const GlObject& visibility, const Shades& shades,
                    const Canvas& canvas) {
  canvas.draw_into_picture();
  gl_.BindVertexArray(empty_.name());
  const bool on_ground = shows_ground(frame, view);
  const Disc ground = on_ground ? ground_disc(*frame.ground, view) : Disc{};
  draw_background(frame, view, on_ground ? &ground : nullptr, canvas);
  if (on_ground) draw_shade(ground, visibility, shades.ground);
  if (frame.planes.empty()) return;
  // Planes hide each other and the ground, and are hidden by it.
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthMask(GL_TRUE);
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  gl_.DepthFunc(GL_LEQUAL);
  gl_.UseProgram(depth_.name());
  gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  if (on_ground) draw_disc(gl_, depth_, ground);
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
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
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_ZERO, GL_SRC_COLOR);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.Scissor(rect.x, rect.y, rect.width, rect.height);
  gl_.UseProgram(shade_.name());
  use_texture(gl_, shade_, "visibility", 0, visibility);
  draw_disc(gl_, shade_, disc);
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.Disable(GL_BLEND);
}

void Backdrop::draw_depth(const Frame& frame, const View& view) const {
  gl_.BindVertexArray(empty_.name());
  gl_.UseProgram(depth_.name());
  gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  if (shows_ground(frame, view)) {
    draw_disc(gl_, depth_, ground_disc(*frame.ground, view));
  }
  for (const PlaneObstacle& plane : frame.planes) {
    if (faces_eye(plane.point, plane.normal, view)) draw_disc(gl_, depth_, plane_disc(plane, view));
  }
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace render
