// Solves by CHOLMOD. A factor kept from an earlier iteration or step preconditions conjugate gradients on the matrix of
// now, until its age has cost as many solves as a new factor would. Where there is no memory for a factor, conjugate
// gradients without a matrix take over for good.
#pragma once

#include <optional>

#include "sim/solve/cholesky.h"
#include "sim/solve/iterative_solver.h"
#include "sim/solve/linear_solver.h"
#include "sim/solve/pcg.h"

namespace sim {

class DirectSolver final : public LinearSolver {
 public:
  explicit DirectSolver(const Model& model);

  void begin_step(TangentOperator& A, const KeptFactor& kept) override;
  LinearResult solve(const TangentOperator& A, const Eigen::VectorXd& r, double tolerance,
                     Eigen::VectorXd& dx) override;
  const KeptFactor* kept() const override { return &held_; }
  bool without_factor() const { return fallback_.has_value(); }

 private:
  Cholesky::Status factorise(const TangentOperator& A);
  void remember(const TangentOperator& A);
  void give_up_factor();

  const Model& model_;
  std::optional<BlockMatrix> matrix_;
  std::optional<Cholesky> cholesky_;
  KeptFactor held_;
  int epoch_ = -1;  // of the free components that were analysed
  PcgScratch scratch_;
  std::optional<IterativeSolver> fallback_;
  bool to_be_said_ = false;  // that there is no factor
};

}  // namespace sim
