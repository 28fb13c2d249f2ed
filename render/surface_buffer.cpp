#include "render/surface_buffer.h"

#include <numeric>

namespace render {
namespace {

constexpr int floats_per_vertex = 7;

// The value's place on the scale; a scale without extent shows its middle.
float place_on(const ColourScale& scale, float value) {
  const float width = scale.high - scale.low;
  return width != 0 ? (value - scale.low) / width : 0.5F;
}

}  // namespace

SurfaceBuffer::SurfaceBuffer(const GladGLContext& gl)
    : gl_(gl),
      vertex_array_(make_vertex_array(gl)),
      vertices_(make_buffer(gl)),
      triangles_(make_buffer(gl)),
      edges_(make_buffer(gl)),
      outline_(make_buffer(gl)) {
  gl.BindVertexArray(vertex_array_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  constexpr GLsizei stride = floats_per_vertex * sizeof(float);
  const auto offset = [](std::size_t floats) { return reinterpret_cast<const void*>(floats * sizeof(float)); };
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, offset(0));
  gl.VertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride, offset(3));
  gl.VertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, stride, offset(6));
  for (GLuint attribute = 0; attribute < 3; ++attribute) gl.EnableVertexAttribArray(attribute);
  gl.BindVertexArray(0);
}

void SurfaceBuffer::update_topology(const Surface& surface) {
  const bool given = !surface.normals.empty();
  const std::vector<float>& rest = surface.rest.empty() ? surface.positions : surface.rest;
  // Without computed normals the shape does not matter, only the number of vertices.
  const bool same_shape = given ? smoothing_.source.size() == rest.size() / 3 && made_crease_ < 0
                                : made_crease_ == surface.crease && made_rest_ == rest;
  const auto upload = [&](const GlObject& buffer, const std::vector<std::uint32_t>& indices) {
    fill_buffer(gl_, GL_ELEMENT_ARRAY_BUFFER, buffer, indices.data(), indices.size() * sizeof(std::uint32_t));
  };
  gl_.BindVertexArray(0);  // so that no array remembers these bindings
  if (!same_shape || made_triangles_ != surface.triangles) {
    made_triangles_ = surface.triangles;
    made_crease_ = given ? -1 : surface.crease;
    if (given) {
      made_rest_.clear();
      smoothing_.triangles = surface.triangles;
      smoothing_.source.resize(rest.size() / 3);
      std::iota(smoothing_.source.begin(), smoothing_.source.end(), 0U);
    } else {
      made_rest_ = rest;
      smoothing_ = smooth_groups(rest, surface.triangles, surface.crease);
    }
    closed_ = is_closed(surface.triangles);
    upload(triangles_, smoothing_.triangles);
  }
  if (made_edges_ != surface.edges) upload(edges_, made_edges_ = surface.edges);
  if (made_outline_ != surface.outline) upload(outline_, made_outline_ = surface.outline);
}

void SurfaceBuffer::update(const Surface& surface, const ColourScale* scale) {
  update_topology(surface);
  const bool given = !surface.normals.empty();
  if (!given) vertex_normals(smoothing_, surface.positions, normals_);
  packed_.resize(smoothing_.source.size() * floats_per_vertex);
  float* out = packed_.data();
  for (std::size_t copy = 0; copy < smoothing_.source.size(); ++copy, out += floats_per_vertex) {
    const std::size_t v = smoothing_.source[copy];
    const float* position = surface.positions.data() + 3 * v;
    const float* normal = given ? surface.normals.data() + 3 * v : normals_[copy].data();
    std::copy(position, position + 3, out);
    std::copy(normal, normal + 3, out + 3);
    out[6] = surface.values.empty() ? 0 : place_on(*scale, surface.values[v]);
  }
  fill_buffer(gl_, GL_ARRAY_BUFFER, vertices_, packed_.data(), packed_.size() * sizeof(float));
}

void SurfaceBuffer::draw(GLenum mode, const GlObject& indices, std::size_t count) const {
  if (count == 0) return;
  gl_.BindVertexArray(vertex_array_.name());
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.name());
  gl_.DrawElements(mode, static_cast<GLsizei>(count), GL_UNSIGNED_INT, nullptr);
}

void SurfaceBuffer::draw_triangles() const {
  draw(GL_TRIANGLES, triangles_, made_triangles_.size());
}
void SurfaceBuffer::draw_edges() const {
  draw(GL_LINES, edges_, made_edges_.size());
}
void SurfaceBuffer::draw_outline() const {
  draw(GL_LINES, outline_, made_outline_.size());
}

}  // namespace render
