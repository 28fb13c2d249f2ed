#include "sim/solve/linear_solver.h"

#include "sim/solve/auto_solver.h"
#include "sim/solve/dense_solver.h"
#include "sim/solve/lu_solver.h"

namespace sim {

LinearSolverKind settled_solver(LinearSolverKind chosen, Eigen::Index dofs) {
  // Beyond this size a factor of a solid no longer pays: it grows like n^(4/3), the two levels' work hardly faster
  // than n.
  constexpr Eigen::Index largest_factor = 30000;
  if (chosen != LinearSolverKind::automatic) return chosen;
  return dofs <= largest_factor ? LinearSolverKind::automatic : LinearSolverKind::two_level;
}

bool forms_matrix(const Solver& settled) {
  return settled.linear != LinearSolverKind::pcg || settled.newton == NewtonKind::pure;
}

std::unique_ptr<LinearSolver> make_linear_solver(const Model& model) {
  if (model.solver.newton == NewtonKind::pure) return std::make_unique<LuSolver>(model);
  if (model.dense) return std::make_unique<DenseSolver>(model);
  const LinearSolverKind linear = model.solver.linear;
  if (linear == LinearSolverKind::automatic) return std::make_unique<AutoSolver>(model);
  if (linear == LinearSolverKind::cholmod) return std::make_unique<DirectSolver>(model);
  if (linear == LinearSolverKind::pcg) return std::make_unique<IterativeSolver>(model);
  return std::make_unique<AssembledSolver>(model, linear == LinearSolverKind::two_level);
}

}  // namespace sim
