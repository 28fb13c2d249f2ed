// Nodes whose displacements are few numbers: x = X + U c.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/math/block_matrix.h"

namespace sim {

class Lift {
 public:
  // A row for each component of each node, so that what belongs to a node lies together.
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  Lift(Rows U, Eigen::VectorXd X) : U_(std::move(U)), X_(std::move(X)) {}

  Eigen::Index coordinates() const { return U_.cols(); }
  Eigen::Index dofs() const { return U_.rows(); }
  const Rows& U() const { return U_; }
  const Eigen::VectorXd& X() const { return X_; }

  // x = X + U c
  void place(const Eigen::VectorXd& c, Eigen::VectorXd& x) const;
  // v = U dc
  void move(const Eigen::VectorXd& dc, Eigen::VectorXd& v) const;
  // g += U^T f
  void gather(const Eigen::VectorXd& f, Eigen::VectorXd& g) const;

  // What U^T K U takes, to be kept from one to the next.
  struct Scratch {
    std::vector<Rows> product;          // of each chunk of nodes: rows of K U
    std::vector<Eigen::MatrixXd> part;  // of each chunk: what it adds
  };
  // R = U^T K U, its upper half, with K whole. The same bits for any number of threads.
  void reduce(const BlockMatrix& K, int threads, Scratch& scratch, Eigen::MatrixXd& R) const;

 private:
  void reduce_rows(const BlockMatrix& K, int first, int last, Rows& KU, Eigen::MatrixXd& R) const;
  void add_outside(const BlockMatrix& K, Rows& KU, Eigen::MatrixXd& R) const;

  Rows U_;
  Eigen::VectorXd X_;
};

}  // namespace sim
