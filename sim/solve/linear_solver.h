// Solves the linear system of a Newton step. One small interface; the ways are in the files beside it.
#pragma once

#include <memory>
#include <string>

#include "sim/mesh/input_error.h"
#include "sim/solve/tangent_operator.h"
#include "sim/state.h"

namespace sim {

struct LinearResult {
  int iterations = 0;  // a direct solve counts 1
  int factorisations = 0;
  bool positive_definite = true;  // false: A is not, dx is not to be used
  bool solved = true;             // false: the tolerance was not reached
};

// Where a matrix was linearised: all that is needed to make it again.
struct Linearisation {
  const Motion& at;
  const Motion& begin;  // of the step
  double mass = 0;      // 1/(g h)^2
  Definiteness fix = Definiteness::clamp;
};

class LinearSolver {
 public:
  virtual ~LinearSolver() = default;
  // A dx = r to |r - A dx| <= tolerance |r|; A was linearised anew, `where`. dx and r are zero on prescribed
  // components. `kept` tells of the factor that is held from before, and is told of a new one.
  virtual LinearResult solve(const TangentOperator& A, const Linearisation& where, const Eigen::VectorXd& r,
                             double tolerance, KeptFactor& kept, Eigen::VectorXd& dx) = 0;
  // True when the factor that `kept` tells of is not the one held (a state was loaded): the caller linearises A where
  // `kept` says and calls restore.
  virtual bool lost(const KeptFactor& /*kept*/) const { return false; }
  virtual void restore(const TangentOperator& /*A*/, const KeptFactor& /*kept*/) {}
};

// "cholmod", "pcg" (forms no matrix), "pcg-assembled", or "auto": by size and by counts of iterations.
// Throws InputError (key "solver.linear") for another name.
std::unique_ptr<LinearSolver> make_linear_solver(const Model& model);

// The solver that a name stands for at this size, and whether it forms a matrix.
// flat: all elements are triangles or quads.
std::string settled_solver(const std::string& linear, Eigen::Index dofs, bool flat);
bool forms_matrix(const std::string& settled);

}  // namespace sim
