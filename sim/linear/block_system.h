// A linear system with a block matrix, solved by conjugate gradients that may have a coarse level.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>

#include "sim/linear/pcg.h"
#include "sim/math/block_matrix.h"

namespace sim {

class BlockSystem {
 public:
  virtual ~BlockSystem() = default;
  // Components where free is 0 are left out from now on; the coarse level is dropped.
  virtual void restrict_to(const Eigen::VectorXd& free) = 0;
  // The matrix, whose blocks (i, j) with i <= j are read; the coarse level stays what it was.
  virtual void take(const BlockMatrix& A, int threads) = 0;
  // Makes the coarse level of the matrix as it is, with nodes at x. False: the matrix is not positive definite on it,
  // or there is no memory; then there is no coarse level.
  virtual bool make_coarse(const Eigen::VectorXd& x, int threads) = 0;
  virtual void drop_coarse() = 0;
  // A x = b to |b - A x| <= tolerance |b| in at most so many iterations; b is zero where not free, and so is x.
  virtual PcgResult solve(const Eigen::VectorXd& b, double tolerance, int most, int threads, Eigen::VectorXd& x) = 0;
  // What a coarse level takes to make, in iterations: a count that follows from the mesh.
  virtual double iterations_per_coarse() const = 0;
};

// Positions X at rest, D = 2 or 3 numbers a node; body k has nodes first_node[k] ... first_node[k+1]-1.
std::unique_ptr<BlockSystem> make_block_system(const BlockPattern& pattern, const Eigen::VectorXd& X, int D,
                                               std::span<const int> first_node);

}  // namespace sim
