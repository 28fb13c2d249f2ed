// Rows of a matrix that have blocks outside of its pattern, bodies in contact, as one diagonal block with a Cholesky
// factor of its own. Contact is stiff: nodes that it holds together move apart or together at very unequal cost, which
// blocks of single nodes know nothing of.
#pragma once

#include "sim/linear/cholesky.h"
#include "sim/linear/float_matrix.h"

namespace sim {

template <int D>
class CoupledRows {
 public:
  // From A as it is; free: 0 or 1 for each of its components. Where the block is not positive definite, or there is no
  // memory, there are no such rows.
  void make(const FloatMatrix<D>& A, const Eigen::VectorXd& free);
  bool empty() const { return rows_.empty(); }
  bool has(int row) const { return !rows_.empty() && number_[row] >= 0; }

  // z = A_CC^-1 r_C on these rows; returns r_C . z.
  double solve(const Eigen::Ref<const Eigen::VectorXd>& r);
  auto z(int row) const { return z_.template segment<D>(static_cast<Eigen::Index>(number_[row]) * D); }

 private:
  bool gather(const FloatMatrix<D>& A);
  void fill(const FloatMatrix<D>& A);

  std::vector<int> rows_, number_;  // which they are; the place of each row of A among them, -1: none
  BlockPattern pattern_, before_;   // blocks (i, j) with i <= j
  BlockMatrix matrix_{pattern_, D};
  Cholesky cholesky_;
  Eigen::VectorXd free_, analysed_free_, r_, z_;
  bool is_analysed_ = false;
};

}  // namespace sim
