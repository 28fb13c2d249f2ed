// What a step has to say about itself.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace sim {

struct StepReport {
  std::int64_t step = 0;  // the step that was taken: 1 is the first
  int newton = 0;         // Newton iterations, all stages
  int linear = 0;         // iterations of the linear solver (a direct solve counts 1)
  int factorisations = 0;
  int force_evaluations = 0;
  int backtracks = 0;       // halvings in the line search
  int splits = 0;           // times that the step, or a part of it, was repeated in halves
  bool converged = true;    // false: the equations are not solved to the tolerance; a fact, not an error
  double residual = 0;      // last max |dx|/(g h) [body sizes per second]
  double min_J = 1;         // smallest det F over the quadrature points after the step
  int min_J_element = -1;   // where, counted over all bodies
  int inverted = 0;         // elements with J <= 0 at a quadrature point after the step
  int untangled = 0;        // nodes that were moved to undo inversions
  bool no_factor = false;   // there was no memory for the factor: solved without a matrix
  std::string_view reason;  // why it did not converge
  std::string failure;      // empty, or why the step could not be taken (the state is then unchanged)
  // Seconds by phase; for the eye only, nothing is decided by them.
  double seconds = 0, seconds_assemble = 0, seconds_solve = 0;
};

}  // namespace sim
