// Solves by CHOLMOD. A factor kept from an earlier iteration or step preconditions conjugate gradients on the matrix of
// now, until its age has cost as many solves as a new factor would.
#pragma once

#include <optional>

#include "sim/solve/cholesky.h"
#include "sim/solve/linear_solver.h"
#include "sim/solve/pcg.h"

namespace sim {

class DirectSolver final : public LinearSolver {
 public:
  explicit DirectSolver(const Model& model);

  LinearResult solve(const TangentOperator& A, const Linearisation& where, const Eigen::VectorXd& r, double tolerance,
                     KeptFactor& kept, Eigen::VectorXd& dx) override;
  bool lost(const KeptFactor& kept) const override;
  void restore(const TangentOperator& A, const KeptFactor& kept) override;

 private:
  bool factorise(const TangentOperator& A);

  BlockMatrix matrix_;
  Cholesky cholesky_;
  KeptFactor held_;
  int epoch_ = -1;  // of the free components that were analysed
  PcgScratch scratch_;
};

}  // namespace sim
