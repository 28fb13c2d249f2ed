// Solves by a dense Cholesky factor, new for every matrix: for few unknowns that all act on each other.
#pragma once

#include <Eigen/Cholesky>

#include "sim/solve/linear_solver.h"

namespace sim {

class DenseSolver final : public LinearSolver {
 public:
  // The pattern of the model has every block, and one number in each.
  explicit DenseSolver(const Model& model);

  // To round-off, whatever the tolerance.
  LinearResult solve(const TangentOperator& A, const Eigen::VectorXd& r, double tolerance,
                     Eigen::VectorXd& dx) override;

 private:
  BlockMatrix matrix_;
  Eigen::MatrixXd dense_;
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

}  // namespace sim
