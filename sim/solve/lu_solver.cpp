#include "sim/solve/lu_solver.h"

namespace sim {

namespace {

// |A| |dx| / |r| of what still counts as a solution: a singular matrix may have a factor, of round-off.
constexpr double most_amplified = 1e12;

}  // namespace

LuSolver::LuSolver(const Model& model) : matrix_(*model.pattern, model.D) {}

LinearResult LuSolver::solve(const TangentOperator& A, const Eigen::VectorXd& r, double /*tolerance*/,
                             Eigen::VectorXd& dx) {
  LinearResult result;
  result.solved = false;
  dx.setZero();
  A.assemble(matrix_);
  const SparseMatrix free = free_part(matrix_, A.free());
  Eigen::VectorXd b(free.rows());
  Eigen::Index k = 0;
  for (Eigen::Index i = 0; i < r.size(); ++i)
    if (A.free()[i] != 0) b[k++] = r[i];
  lu_.compute(free);
  ++result.factorisations;
  if (lu_.info() != Eigen::Success) return result;
  const Eigen::VectorXd x = lu_.solve(b);
  if (!(free.norm() * x.norm() <= most_amplified * b.norm())) return result;
  k = 0;
  for (Eigen::Index i = 0; i < r.size(); ++i)
    if (A.free()[i] != 0) dx[i] = x[k++];
  ++result.iterations;
  result.solved = true;
  return result;
}

}  // namespace sim
