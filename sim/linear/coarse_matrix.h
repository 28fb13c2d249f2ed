// The matrix of the coarse level, C = Q' A Q, and its factor.
#pragma once

#include "sim/linear/cholesky.h"
#include "sim/linear/float_matrix.h"
#include "sim/linear/rigid_modes.h"

namespace sim {

template <int D>
class CoarseMatrix {
 public:
  CoarseMatrix(const FloatMatrix<D>& A, const Aggregates& aggregates);

  // From A and its coarse space as they are. False: C is not positive definite, and so A is not, but for round-off;
  // or there is no memory for its factor.
  bool make(const FloatMatrix<D>& A, const RigidModes<D>& modes, int threads);
  // y = C^{-1} r
  void solve(const Eigen::VectorXd& r, Eigen::VectorXd& y) { cholesky_.solve(r, y); }

  int size() const { return C_.pattern().rows() * RigidModes<D>::count; }
  // The blocks (a, b) with a <= b.
  const BlockMatrix& upper() const { return C_; }
  std::int64_t factor_nonzeros() const { return cholesky_.factor_nonzeros(); }
  double factor_operations() const { return cholesky_.factor_operations(); }

 private:
  bool analyse(const FloatMatrix<D>& A);
  void make_row(int a, const FloatMatrix<D>& A, const RigidModes<D>& modes);

  const Aggregates& aggregates_;
  std::vector<int> aggregate_;  // of each row of A
  BlockPattern pattern_;
  BlockMatrix C_;
  Cholesky cholesky_;
  std::vector<NodePair> met_;       // aggregates that blocks outside of A's pattern couple
  std::vector<NodePair> analysed_;  // those that the factor knows of
  bool is_analysed_ = false;
};

}  // namespace sim
