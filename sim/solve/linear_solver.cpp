#include "sim/solve/linear_solver.h"

#include "sim/mesh/input_error.h"
#include "sim/solve/auto_solver.h"

namespace sim {

std::string settled_solver(const std::string& linear, Eigen::Index dofs, bool flat) {
  // Beyond this size the factor of a solid no longer pays: it grows like n^(4/3), an iteration like n.
  constexpr Eigen::Index largest_factor = 200000;
  // The factor of a surface grows hardly faster than the matrix.
  if (linear == "auto" && flat) return "cholmod";
  if (linear == "auto") return dofs <= largest_factor ? "auto" : "pcg";
  if (linear == "cholmod" || linear == "pcg" || linear == "pcg-assembled") return linear;
  throw InputError("solver.linear", "\"" + linear + "\" is not a solver: cholmod, pcg, pcg-assembled or auto");
}

bool forms_matrix(const std::string& settled) {
  return settled != "pcg";
}

std::unique_ptr<LinearSolver> make_linear_solver(const Model& model) {
  if (model.solver.linear == "auto") return std::make_unique<AutoSolver>(model);
  if (model.solver.linear == "cholmod") return std::make_unique<DirectSolver>(model);
  return std::make_unique<IterativeSolver>(model);
}

}  // namespace sim
