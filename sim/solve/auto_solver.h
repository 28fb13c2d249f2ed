// Starts with conjugate gradients on two levels, goes over to CHOLMOD where they take too many iterations, and back
// where factors wear out so soon that they cost more: a choice by counts, so the same on every machine. State tells of
// what is held, and so of which of the two it is.
#pragma once

#include "sim/solve/assembled_solver.h"
#include "sim/solve/direct_solver.h"

namespace sim {

class AutoSolver final : public LinearSolver {
 public:
  explicit AutoSolver(const Model& model) : two_level_(model, /*two_levels=*/true), direct_(model) {}

  void begin_step(TangentOperator& A, const KeptFactor& kept) override;
  LinearResult solve(const TangentOperator& A, const Eigen::VectorXd& r, double tolerance,
                     Eigen::VectorXd& dx) override;
  const KeptFactor* kept() const override { return by_factor_ ? direct_.kept() : two_level_.kept(); }

 private:
  AssembledSolver two_level_;
  DirectSolver direct_;
  bool by_factor_ = false;
};

}  // namespace sim
