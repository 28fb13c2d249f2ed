// Starts with conjugate gradients on the assembled matrix and changes to CHOLMOD for the rest of the run once they need
// too many iterations. Iterations are counted and no time is measured, so that every machine changes at the same step.
// The solver has changed when the state holds a factor, and a resumed run reads from that how it has to go on.
#pragma once

#include "sim/solve/direct_solver.h"
#include "sim/solve/iterative_solver.h"

namespace sim {

class AutoSolver final : public LinearSolver {
 public:
  explicit AutoSolver(const Model& model) : iterative_(model), direct_(model) {}

  void begin_step(TangentOperator& A, const KeptFactor& kept) override { direct_.begin_step(A, kept); }
  LinearResult solve(const TangentOperator& A, const Eigen::VectorXd& r, double tolerance,
                     Eigen::VectorXd& dx) override {
    // About as long as a factor, shared by the steps that it serves, and its solves take (beam of 8,000 to 24,000
    // dofs).
    constexpr int too_many = 200;
    if (direct_.kept()->valid || direct_.without_factor()) return direct_.solve(A, r, tolerance, dx);
    const LinearResult tried = iterative_.solve_within(too_many, A, r, tolerance, dx);
    if (tried.solved && tried.positive_definite) return tried;
    LinearResult result = direct_.solve(A, r, tolerance, dx);
    result.iterations += tried.iterations;
    return result;
  }
  const KeptFactor* kept() const override { return direct_.kept(); }

 private:
  IterativeSolver iterative_;
  DirectSolver direct_;
};

}  // namespace sim
