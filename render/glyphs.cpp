#include "render/glyphs.h"

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>

#include "render/light.h"

namespace render {
namespace {

constexpr float two_pi = 2 * std::numbers::pi_v<float>;

void add_vertex(Surface& surface, const Eigen::Vector3f& position, const Eigen::Vector3f& normal) {
  surface.positions.insert(surface.positions.end(), {position.x(), position.y(), position.z()});
  surface.normals.insert(surface.normals.end(), {normal.x(), normal.y(), normal.z()});
}

// Triangles between rows of `around` vertices each, the last of a row joined to its first; rows start at `first`.
void add_rows(Surface& surface, std::uint32_t first, std::uint32_t rows, std::uint32_t around) {
  for (std::uint32_t i = 0; i + 1 < rows; ++i) {
    for (std::uint32_t j = 0; j < around; ++j) {
      const std::uint32_t a = first + i * around + j, b = first + i * around + (j + 1) % around;
      surface.triangles.insert(surface.triangles.end(), {a, b, b + around, a, b + around, a + around});
    }
  }
}

void add_arrow(Surface& surface, const Eigen::Vector3f& from, const Eigen::Vector3f& to, float thickness) {
  const float length = (to - from).norm();
  const Eigen::Vector3f along = (to - from) / length, side = along.unitOrthogonal(), other = along.cross(side);
  const float head = std::min(5 * thickness, 0.5F * length), radius = std::min(thickness, 0.12F * length);
  // Profile along the axis: distance, radius, and the normal's parts outwards and along.
  struct Ring {
    float distance, radius, outwards, along;
  };
  const float slope = 2.4F * radius / head, steep = 1 / std::sqrt(1 + slope * slope);
  const Ring rings[] = {{0, 0, 0, -1},
                        {0, radius, 0, -1},
                        {0, radius, 1, 0},
                        {length - head, radius, 1, 0},
                        {length - head, radius, 0, -1},
                        {length - head, 2.4F * radius, 0, -1},
                        {length - head, 2.4F * radius, steep, slope * steep},
                        {length, 0, steep, slope * steep}};
  constexpr std::uint32_t around = 16;
  const auto first = static_cast<std::uint32_t>(surface.positions.size() / 3);
  for (const Ring& ring : rings) {
    for (std::uint32_t j = 0; j < around; ++j) {
      const float angle = two_pi * static_cast<float>(j) / around;
      const Eigen::Vector3f outwards = std::cos(angle) * side + std::sin(angle) * other;
      add_vertex(surface, from + ring.distance * along + ring.radius * outwards,
                 ring.outwards * outwards + ring.along * along);
    }
  }
  add_rows(surface, first, std::size(rings), around);
}

constexpr std::string_view marker_vertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 tint;
uniform float diameter;
out vec3 ink;
void main() {
  ink = tint;
  vec3 nearer = eye.w > 0.5 ? position - forward.xyz * (0.01 * forward.w) : mix(position, eye.xyz, 0.01);
  gl_Position = world_to_clip * vec4(nearer, 1.0);
  gl_PointSize = diameter;
}
)";

constexpr std::string_view marker_fragment = R"(
in vec3 ink;
uniform float diameter;
out vec4 colour;
void main() {
  float r = length(gl_PointCoord - 0.5) * diameter;  // pixels from the middle
  float cover = clamp(0.5 * diameter - r, 0.0, 1.0);
  if (cover <= 0.0) discard;
  float inside = clamp(0.5 * diameter - 0.16 * diameter - r, 0.0, 1.0);
  colour = vec4(mix(vec3(1.0), ink, inside), cover);
}
)";

}  // namespace

Surface sphere_surface(const SphereObstacle& sphere) {
  constexpr std::uint32_t rows = 33, around = 64;
  Surface surface;
  surface.name = "sphere obstacle";
  surface.colour = {0.62F, 0.67F, 0.72F};
  for (std::uint32_t i = 0; i < rows; ++i) {
    const float polar = two_pi / 2 * static_cast<float>(i) / (rows - 1);
    for (std::uint32_t j = 0; j < around; ++j) {
      const float angle = two_pi * static_cast<float>(j) / around;
      const Eigen::Vector3f normal(std::sin(polar) * std::sin(angle), -std::cos(polar),
                                   std::sin(polar) * std::cos(angle));
      add_vertex(surface, to_vector(sphere.centre) + sphere.radius * normal, normal);
    }
  }
  add_rows(surface, 0, rows, around);
  return surface;
}

std::vector<Surface> arrow_surfaces(const std::vector<Arrow>& arrows, float extent) {
  std::map<Colour, Surface> by_colour;
  for (const Arrow& arrow : arrows) {
    const Eigen::Vector3f from = to_vector(arrow.from), to = to_vector(arrow.to);
    if ((to - from).norm() <= 1e-6F * extent) continue;
    Surface& surface = by_colour[arrow.colour];
    surface.name = "arrows";
    surface.shadow = false;
    surface.colour = arrow.colour;
    add_arrow(surface, from, to, 0.0042F * extent);
  }
  std::vector<Surface> surfaces;
  for (auto& [colour, surface] : by_colour) surfaces.push_back(std::move(surface));
  return surfaces;
}

Markers::Markers(const GladGLContext& gl)
    : gl_(gl),
      program_(make_program(gl, {frame_block, marker_vertex}, {marker_fragment})),
      vertex_array_(make_vertex_array(gl)),
      vertices_(make_buffer(gl)) {
  gl.BindVertexArray(vertex_array_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  for (GLuint attribute = 0; attribute < 2; ++attribute) {
    gl.VertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, 6 * sizeof(float),
                           reinterpret_cast<const void*>(attribute * 3 * sizeof(float)));
    gl.EnableVertexAttribArray(attribute);
  }
  gl.BindVertexArray(0);
}

void Markers::draw(const std::vector<Marker>& markers, float diameter) {
  if (markers.empty()) return;
  packed_.clear();
  for (const Marker& marker : markers) {
    packed_.insert(packed_.end(), marker.at.begin(), marker.at.end());
    packed_.insert(packed_.end(), marker.colour.begin(), marker.colour.end());
  }
  fill_buffer(gl_, GL_ARRAY_BUFFER, vertices_, packed_.data(), packed_.size() * sizeof(float));
  gl_.UseProgram(program_.name());
  gl_.Uniform1f(gl_.GetUniformLocation(program_.name(), "diameter"), diameter);
  gl_.Enable(GL_PROGRAM_POINT_SIZE);
  begin_blending(gl_);
  gl_.BindVertexArray(vertex_array_.name());
  gl_.DrawArrays(GL_POINTS, 0, static_cast<GLsizei>(markers.size()));
  gl_.Disable(GL_BLEND);
  gl_.Disable(GL_PROGRAM_POINT_SIZE);
}

}  // namespace render
