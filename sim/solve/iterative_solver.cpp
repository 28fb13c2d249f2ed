#include "sim/solve/iterative_solver.h"

namespace sim {

IterativeSolver::IterativeSolver(const Model& model) : inverse_diagonal_(model.dofs()) {}

LinearResult IterativeSolver::solve(const TangentOperator& A, const Eigen::VectorXd& r, double tolerance,
                                    Eigen::VectorXd& dx) {
  A.diagonal(inverse_diagonal_);
  inverse_diagonal_ = inverse_diagonal_.array().abs().inverse();
  const auto multiply = [&](const Eigen::VectorXd& p, Eigen::VectorXd& Ap) { A.multiply(p, Ap); };
  const auto precondition = [&](const Eigen::VectorXd& residual, Eigen::VectorXd& z) {
    z = inverse_diagonal_.cwiseProduct(residual);
  };
  const PcgResult cg = pcg(multiply, precondition, r, tolerance, iteration_limit(r.size()), scratch_, dx);
  LinearResult result;
  result.iterations = cg.iterations;
  result.positive_definite = usable(cg);
  result.solved = cg.converged;
  return result;
}

}  // namespace sim
