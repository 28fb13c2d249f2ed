// The mass of a body: m_ij = int rho N_i N_j, whole (consistent) or gathered on the diagonal (lumped).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "sim/math/block_matrix.h"
#include "sim/scene.h"

namespace sim {

// Consistent element masses are added by rows into a node-by-node matrix (the same number for each of the D
// components).
class Mass {
 public:
  // density[e]: of each element of the mesh [kg/m^3]. Node numbers are shifted by first_node.
  Mass(const Body& body, const std::vector<double>& density, int first_node);

  // A mass of 1 for each of some numbers that are no nodes.
  static Mass unit(int first, int count);

  bool lumped() const { return !consistent_; }
  int first_node() const { return first_node_; }
  // Mass at each node [kg]: the diagonal when lumped, else the row sums (for weighting, not for solving).
  const Eigen::VectorXd& nodal() const { return nodal_; }
  double total() const { return total_; }

  // y += s M p for the body's part of vectors with D numbers per node
  void add_product(double s, const Eigen::VectorXd& p, Eigen::VectorXd& y, int D) const;
  // d += s diag(M)
  void add_diagonal(double s, Eigen::VectorXd& d, int D) const;
  // A += s M
  void add_matrix(double s, BlockMatrix& A) const;

  void couple(Coupling& coupling) const;
  void bind(const BlockPattern& pattern);

 private:
  struct Consistent {
    BlockPattern pattern;        // of the body's own nodes
    std::vector<double> values;  // kg
    std::vector<int> slot;       // of each entry in the matrix of the system
  };
  Mass(int first_node, Eigen::VectorXd nodal)
      : first_node_(first_node), nodal_(std::move(nodal)), total_(nodal_.sum()) {}

  int first_node_;
  Eigen::VectorXd nodal_;
  double total_ = 0;  // kg
  std::optional<Consistent> consistent_;
  std::vector<int> diagonal_slot_;
};

}  // namespace sim
