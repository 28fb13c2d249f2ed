#include "sim/solve/auto_solver.h"

namespace sim {

void AutoSolver::begin_step(TangentOperator& A, const KeptFactor& kept) {
  by_factor_ = direct_.without_factor() || static_cast<Kept>(kept.what) == Kept::factor;
  direct_.begin_step(A, kept);
  two_level_.begin_step(A, kept);
}

LinearResult AutoSolver::solve(const TangentOperator& A, const Eigen::VectorXd& r, double tolerance,
                               Eigen::VectorXd& dx) {
  // About as long as a factor, shared by the steps that it serves, and its solves take (beam of 8,000 dofs of stiffness
  // ratio 1e6: half the time at 88 iterations; bear of 5,000 elements: nearly twice the time at 41).
  constexpr int too_many = 80;
  if (by_factor_ && !direct_.without_factor() && direct_.kept()->what != 0 && direct_.worn(A)) {
    const double rival = static_cast<double>(direct_.kept()->fresh) * two_level_.bytes_per_iteration();
    by_factor_ = direct_.bytes_per_solve() <= rival;
  }
  if (by_factor_) {
    const std::int64_t rival = direct_.kept()->fresh;
    const LinearResult result = direct_.solve(A, r, tolerance, dx);
    direct_.note_rival(rival);
    return result;
  }
  const LinearResult tried = two_level_.solve_within(too_many, A, r, tolerance, dx);
  if (tried.solved || !tried.positive_definite) return tried;
  LinearResult result = direct_.solve(A, r, tolerance, dx);
  direct_.note_rival(tried.iterations);
  by_factor_ = direct_.kept()->what != 0 || direct_.without_factor();
  result.iterations += tried.iterations;
  return result;
}

}  // namespace sim
