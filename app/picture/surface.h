// What is seen of a body: its surface as triangles and its element edges as lines. Quadratic facets are subdivided, so
// that curved edges look curved.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "app/scene/skin.h"
#include "sim/mesh/mesh.h"

namespace app {

// Vertices are mixed from the nodes of the mesh; the mixture never changes, so it is made once.
class Surface {
 public:
  // The boundary of a solid; all elements of a plane mesh or a membrane.
  explicit Surface(const sim::Mesh& mesh);
  // The skin that the body wears.
  Surface(const sim::Mesh& mesh, const Skin& skin);

  int vertex_count() const { return static_cast<int>(starts_.size()) - 1; }
  // 3 per triangle, counter-clockwise from outside.
  const std::vector<std::uint32_t>& triangles() const { return triangles_; }
  // Pairs of vertices along the element edges.
  const std::vector<std::uint32_t>& edges() const { return edges_; }
  // Pairs of vertices along the rim of a plane mesh; empty in 3D.
  const std::vector<std::uint32_t>& outline() const { return outline_; }

  // Whether its facets are flat by themselves, so that what is round has to be made so.
  bool is_linear() const { return linear_; }
  // The vertex at a node of the mesh, or of a skin the one that the node moves most; -1 where the node is inside.
  int vertex_of(int node) const;

  // x, y, z of each vertex, from an origin, by positions per node, dimension x nodes; z = 0 in 2D.
  std::vector<float> points(const Eigen::Ref<const Eigen::MatrixXd>& positions,
                            const Eigen::Vector3d& origin = Eigen::Vector3d::Zero()) const;
  // One number per vertex from one number per node.
  std::vector<float> values(const Eigen::Ref<const Eigen::VectorXd>& node_values) const;

 private:
  class Builder;

  // Vertex v = sum of weights_[k] times node nodes_[k], k from starts_[v] to starts_[v + 1].
  bool linear_ = true;
  std::vector<int> vertex_of_node_;  // -1: inside
  std::vector<int> starts_ = {0};
  std::vector<int> nodes_;
  std::vector<double> weights_;
  std::vector<std::uint32_t> triangles_, edges_, outline_;
};

}  // namespace app
