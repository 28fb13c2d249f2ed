// Solves by conjugate gradients with the diagonal as preconditioner, without any matrix: through the terms' products
// (the lecture's dx -> df).
#pragma once

#include "sim/linear/pcg.h"
#include "sim/solve/linear_solver.h"

namespace sim {

class IterativeSolver final : public LinearSolver {
 public:
  explicit IterativeSolver(const Model& model);

  LinearResult solve(const TangentOperator& A, const Eigen::VectorXd& r, double tolerance,
                     Eigen::VectorXd& dx) override;

 private:
  Eigen::VectorXd inverse_diagonal_;
  PcgScratch scratch_;
};

}  // namespace sim
