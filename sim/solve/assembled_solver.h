// Solves by conjugate gradients on the assembled matrix in single precision, preconditioned by its diagonal blocks and,
// where asked for, by a coarse level of rigid motions (sim/linear/two_level.h). The coarse level is kept for later
// solves, until its age has cost as many iterations as a new one would.
#pragma once

#include "sim/linear/block_system.h"
#include "sim/solve/linear_solver.h"

namespace sim {

class AssembledSolver final : public LinearSolver {
 public:
  AssembledSolver(const Model& model, bool two_levels);

  void begin_step(TangentOperator& A, const KeptFactor& kept) override;
  LinearResult solve(const TangentOperator& A, const Eigen::VectorXd& r, double tolerance,
                     Eigen::VectorXd& dx) override;
  // At most so many iterations.
  LinearResult solve_within(int most, const TangentOperator& A, const Eigen::VectorXd& r, double tolerance,
                            Eigen::VectorXd& dx);
  const KeptFactor* kept() const override { return two_levels_ ? &held_ : nullptr; }
  // Memory that an iteration reads and writes.
  double bytes_per_iteration() const;

 private:
  void take(const TangentOperator& A);
  void renew(const TangentOperator& A);
  PcgResult conjugate_gradients(int most, const TangentOperator& A, const Eigen::VectorXd& r, double tolerance,
                                Eigen::VectorXd& dx);
  void refine(int most, const TangentOperator& A, const Eigen::VectorXd& r, double tolerance, Eigen::VectorXd& dx,
              LinearResult& result);

  bool two_levels_;
  BlockMatrix matrix_;
  std::unique_ptr<BlockSystem> system_;
  KeptFactor held_;
  int epoch_ = -1;              // of the free components that the system has
  std::int64_t revision_ = -1;  // of A, that the system has
  Eigen::VectorXd rest_, correction_;
};

}  // namespace sim
