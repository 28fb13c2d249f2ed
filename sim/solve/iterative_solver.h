// Solves by conjugate gradients with the diagonal as preconditioner: on the assembled matrix, or without any matrix
// through the terms' products (the lecture's dx -> df).
#pragma once

#include <optional>

#include "sim/solve/linear_solver.h"
#include "sim/solve/pcg.h"

namespace sim {

class IterativeSolver final : public LinearSolver {
 public:
  // with_matrix: assembled where the system has a pattern for it.
  explicit IterativeSolver(const Model& model, bool with_matrix = true);

  LinearResult solve(const TangentOperator& A, const Eigen::VectorXd& r, double tolerance,
                     Eigen::VectorXd& dx) override;
  // At most so many iterations.
  LinearResult solve_within(int most, const TangentOperator& A, const Eigen::VectorXd& r, double tolerance,
                            Eigen::VectorXd& dx);

 private:
  std::optional<BlockMatrix> matrix_;
  Eigen::VectorXd inverse_diagonal_;
  PcgScratch scratch_;
};

}  // namespace sim
