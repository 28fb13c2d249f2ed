// Solves by CHOLMOD. A factor kept from an earlier iteration or step preconditions conjugate gradients on the matrix of
// now, until its age has cost as many solves as a new factor would. Where there is no memory for a factor, conjugate
// gradients without a matrix take over for good.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/linear/cholesky.h"
#include "sim/linear/pcg.h"
#include "sim/solve/iterative_solver.h"
#include "sim/solve/linear_solver.h"

namespace sim {

class DirectSolver final : public LinearSolver {
 public:
  explicit DirectSolver(const Model& model);

  void begin_step(TangentOperator& A, const KeptFactor& kept) override;
  LinearResult solve(const TangentOperator& A, const Eigen::VectorXd& r, double tolerance,
                     Eigen::VectorXd& dx) override;
  const KeptFactor* kept() const override { return &held_; }
  bool without_factor() const { return fallback_.has_value(); }
  // The next solve makes a factor.
  bool worn(const TangentOperator& A) const;
  // Memory that a solve has read on the average since the factor was made, its share of making it included.
  double bytes_per_solve() const;
  // Another solver took this many iterations where this one began; noted with the factor.
  void note_rival(std::int64_t iterations) { held_.fresh = iterations; }

 private:
  void assemble(const TangentOperator& A);
  Cholesky::Status factorise(const TangentOperator& A);
  void give_up_factor();

  const Model& model_;
  std::optional<BlockMatrix> matrix_;
  std::optional<Cholesky> cholesky_;
  KeptFactor held_;
  int epoch_ = -1;              // of the free components that were analysed
  std::int64_t revision_ = -1;  // of A, that was assembled
  PcgScratch scratch_;
  std::optional<IterativeSolver> fallback_;
  bool to_be_said_ = false;  // that there is no factor
};

}  // namespace sim
