// Solves the linear system of a Newton step. One small interface; the ways are in the files beside it.
#pragma once

#include <memory>

#include "sim/solve/tangent_operator.h"
#include "sim/state.h"

namespace sim {

struct LinearResult {
  int iterations = 0;  // a direct solve counts 1
  int factorisations = 0;
  bool positive_definite = true;  // false: A is not, dx is not to be used
  bool solved = true;             // false: the tolerance was not reached
  bool no_factor = false;         // there was no memory for a factor, from here on there is none; said once
};

class LinearSolver {
 public:
  virtual ~LinearSolver() = default;
  // A step begins whose State tells of this factor. Another one that is held is dropped; one that is not (a state was
  // loaded) is made again, for which A is linearised where `kept` says.
  virtual void begin_step(TangentOperator& /*A*/, const KeptFactor& /*kept*/) {}
  // A dx = r to |r - A dx| <= tolerance |r|; A may be that of the solve before. dx and r are zero on
  // prescribed components.
  virtual LinearResult solve(const TangentOperator& A, const Eigen::VectorXd& r, double tolerance,
                             Eigen::VectorXd& dx) = 0;
  // The factor that is held, for State to tell of; nullptr: this solver holds none.
  virtual const KeptFactor* kept() const { return nullptr; }
};

std::unique_ptr<LinearSolver> make_linear_solver(const Model& model);

// The solver that a scene's choice stands for at this size, and whether what is settled forms a matrix.
LinearSolverKind settled_solver(LinearSolverKind chosen, Eigen::Index dofs);
bool forms_matrix(const Solver& settled);

}  // namespace sim
