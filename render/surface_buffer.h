// A surface on the graphics side. Index lists and creases are kept as long as the topology stays.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "render/frame.h"
#include "render/gl.h"
#include "render/normals.h"
#include "render/rounding.h"

namespace render {

// Where each attribute of a vertex is bound in the shaders.
inline constexpr std::string_view vertex_attributes = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float value;
)";

class SurfaceBuffer {
 public:
  explicit SurfaceBuffer(const GladGLContext& gl);

  // Takes the surface's present shape; values are placed on the scale, 0 at low, 1 at high (scale may be null without
  // values). The surface must have been checked (render/check.h).
  void update(const Surface& surface, const ColourScale* scale);

  // Whether the inside of the surface is hidden as long as nothing is inverted.
  bool closed() const { return closed_; }

  std::size_t triangle_count() const { return triangle_indices_ / 3; }

  void draw_triangles() const;
  void draw_edges() const;
  void draw_outline() const;

 private:
  void update_topology(const Surface& surface);
  void make_topology(const Surface& surface);
  void draw(GLenum mode, const GlObject& indices, std::size_t count) const;

  const GladGLContext& gl_;
  GlObject vertex_array_, vertices_, triangles_, edges_, outline_;
  // What the index lists were made from, to see when they must be made anew.
  std::vector<std::uint32_t> made_triangles_, made_edges_, made_outline_;
  std::vector<float> made_rest_;
  float made_crease_ = -1;
  bool made_round_ = false;
  bool closed_ = false;
  std::size_t triangle_indices_ = 0, edge_indices_ = 0, outline_indices_ = 0;  // uploaded
  Smoothing smoothing_;
  std::vector<Rounding> rounding_;                    // coarse to fine; empty: not made round
  std::vector<Eigen::Vector3f> positions_, normals_;  // scratch
  std::vector<float> values_;                         // scratch
  std::vector<float> packed_;                         // scratch: position, normal, value of each vertex
};

}  // namespace render
