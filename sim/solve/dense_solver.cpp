#include "sim/solve/dense_solver.h"

namespace sim {

DenseSolver::DenseSolver(const Model& model)
    : matrix_(*model.pattern, 1), dense_(model.dofs(), model.dofs()), factor_(model.dofs()) {}

LinearResult DenseSolver::solve(const TangentOperator& A, const Eigen::VectorXd& r, double /*tolerance*/,
                                Eigen::VectorXd& dx) {
  LinearResult result;
  A.assemble_upper(matrix_);
  // Row by row, of which the part right of the diagonal is filled; the factor reads what lies below it.
  dense_ = Eigen::Map<const Eigen::MatrixXd>(matrix_.values().data(), dense_.rows(), dense_.cols());
  factor_.compute(dense_);
  ++result.factorisations;
  result.positive_definite = factor_.info() == Eigen::Success;
  if (!result.positive_definite) return result;
  dx = r;
  factor_.solveInPlace(dx);
  ++result.iterations;
  return result;
}

}  // namespace sim
