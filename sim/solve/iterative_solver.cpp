#include "sim/solve/iterative_solver.h"

namespace sim {

IterativeSolver::IterativeSolver(const Model& model, bool with_matrix) : inverse_diagonal_(model.dofs()) {
  if (with_matrix && model.pattern) matrix_.emplace(*model.pattern, model.D);
}

LinearResult IterativeSolver::solve(const TangentOperator& A, const Eigen::VectorXd& r, double tolerance,
                                    Eigen::VectorXd& dx) {
  return solve_within(100 + static_cast<int>(std::min<Eigen::Index>(r.size(), 20000)), A, r, tolerance, dx);
}

LinearResult IterativeSolver::solve_within(int most, const TangentOperator& A, const Eigen::VectorXd& r,
                                           double tolerance, Eigen::VectorXd& dx) {
  if (matrix_) {
    A.assemble(*matrix_);
    matrix_->diagonal(inverse_diagonal_);
    inverse_diagonal_.array() = inverse_diagonal_.array() * A.free().array() + (1 - A.free().array());
  } else {
    A.diagonal(inverse_diagonal_);
  }
  inverse_diagonal_ = inverse_diagonal_.array().abs().inverse();
  const auto multiply = [&](const Eigen::VectorXd& p, Eigen::VectorXd& Ap) {
    if (!matrix_) return A.multiply(p, Ap);
    matrix_->multiply(p, Ap, A.threads());
    Ap.array() *= A.free().array();
  };
  const auto precondition = [&](const Eigen::VectorXd& residual, Eigen::VectorXd& z) {
    z = inverse_diagonal_.cwiseProduct(residual);
  };
  const PcgResult cg = pcg(multiply, precondition, r, tolerance, most, scratch_, dx);
  // Negative curvature at once: there is no direction to use. Later: what was reached is one.
  return {cg.iterations, 0, cg.positive_definite || cg.iterations > 1, cg.converged};
}

}  // namespace sim
