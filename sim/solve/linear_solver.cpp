#include "sim/solve/linear_solver.h"

#include "sim/solve/auto_solver.h"

namespace sim {

LinearSolverKind settled_solver(LinearSolverKind chosen, Eigen::Index dofs, bool flat) {
  // Beyond this size the factor of a solid no longer pays: it grows like n^(4/3), an iteration like n.
  constexpr Eigen::Index largest_factor = 200000;
  if (chosen != LinearSolverKind::automatic) return chosen;
  // The factor of a surface grows hardly faster than the matrix.
  if (flat) return LinearSolverKind::cholmod;
  return dofs <= largest_factor ? LinearSolverKind::automatic : LinearSolverKind::pcg;
}

bool forms_matrix(LinearSolverKind settled) {
  return settled != LinearSolverKind::pcg;
}

std::unique_ptr<LinearSolver> make_linear_solver(const Model& model) {
  if (model.solver.linear == LinearSolverKind::automatic) return std::make_unique<AutoSolver>(model);
  if (model.solver.linear == LinearSolverKind::cholmod) return std::make_unique<DirectSolver>(model);
  return std::make_unique<IterativeSolver>(model);
}

}  // namespace sim
