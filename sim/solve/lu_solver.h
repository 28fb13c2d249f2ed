// Solves by an LU factor with pivots, new for every matrix: slow, and right where A is not positive definite.
#pragma once

#include <Eigen/SparseLU>

#include "sim/linear/sparse.h"
#include "sim/solve/linear_solver.h"

namespace sim {

class LuSolver final : public LinearSolver {
 public:
  explicit LuSolver(const Model& model);

  // To round-off, whatever the tolerance. A result that is not solved: A is singular.
  LinearResult solve(const TangentOperator& A, const Eigen::VectorXd& r, double tolerance,
                     Eigen::VectorXd& dx) override;

 private:
  BlockMatrix matrix_;
  Eigen::SparseLU<SparseMatrix> lu_;
};

}  // namespace sim
