#include "render/surface_buffer.h"

#include <algorithm>
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
  const bool same_outline = made_outline_ == surface.outline;
  const bool same = same_shape && made_triangles_ == surface.triangles && made_edges_ == surface.edges &&
                    made_round_ == surface.round;
  if (!same) make_topology(surface);
  if (same && same_outline) return;
  made_outline_ = surface.outline;
  outline_indices_ = made_outline_.size();
  gl_.BindVertexArray(0);  // so that no array remembers this binding
  fill_buffer(gl_, GL_ELEMENT_ARRAY_BUFFER, outline_, made_outline_.data(), outline_indices_ * sizeof(std::uint32_t));
}

void SurfaceBuffer::make_topology(const Surface& surface) {
  const bool given = !surface.normals.empty();
  const std::vector<float>& rest = surface.rest.empty() ? surface.positions : surface.rest;
  made_triangles_ = surface.triangles;
  made_edges_ = surface.edges;
  made_round_ = surface.round;
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
  std::vector<std::uint32_t> edges = surface.edges;
  rounding_ = surface.round && !given ? rounding_of(smoothing_, edges) : std::vector<Rounding>{};
  const std::vector<std::uint32_t>& triangles = rounding_.empty() ? smoothing_.triangles : rounding_.back().triangles;
  gl_.BindVertexArray(0);
  const auto upload = [&](const GlObject& buffer, const std::vector<std::uint32_t>& indices) {
    fill_buffer(gl_, GL_ELEMENT_ARRAY_BUFFER, buffer, indices.data(), indices.size() * sizeof(std::uint32_t));
    return indices.size();
  };
  triangle_indices_ = upload(triangles_, triangles);
  edge_indices_ = upload(edges_, edges);
}

void SurfaceBuffer::update(const Surface& surface, const ColourScale* scale) {
  update_topology(surface);
  const bool given = !surface.normals.empty();
  if (!given) vertex_normals(smoothing_, surface.positions, normals_);
  positions_.clear();
  values_.clear();
  if (given) normals_.clear();
  const auto vector = [](const std::vector<float>& list, std::size_t v) {
    return Eigen::Map<const Eigen::Vector3f>(list.data() + 3 * v);
  };
  for (const std::uint32_t v : smoothing_.source) {
    positions_.push_back(vector(surface.positions, v));
    if (given) normals_.push_back(vector(surface.normals, v));
    values_.push_back(surface.values.empty() ? 0 : place_on(*scale, surface.values[v]));
  }
  for (const Rounding& level : rounding_) add_middles(level, positions_, normals_, values_);
  packed_.resize(positions_.size() * floats_per_vertex);
  float* out = packed_.data();
  for (std::size_t i = 0; i < positions_.size(); ++i, out += floats_per_vertex) {
    std::copy_n(positions_[i].data(), 3, out);
    std::copy_n(normals_[i].data(), 3, out + 3);
    out[6] = values_[i];
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
  draw(GL_TRIANGLES, triangles_, triangle_indices_);
}
void SurfaceBuffer::draw_edges() const {
  draw(GL_LINES, edges_, edge_indices_);
}
void SurfaceBuffer::draw_outline() const {
  draw(GL_LINES, outline_, outline_indices_);
}

}  // namespace render
