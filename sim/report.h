// What a system and its steps have to say about themselves.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "sim/math/vec3.h"

namespace sim {

// What a step has to say about itself.
struct StepReport {
  std::int64_t step = 0;     // the step that was taken: 1 is the first
  bool interrupted = false;  // the caller wanted no more of it: the failure says so
  int newton = 0;            // Newton iterations, all stages
  int linear = 0;            // iterations of the linear solver (a direct solve counts 1)
  int factorisations = 0;
  int force_evaluations = 0;
  int backtracks = 0;       // halvings in the line search
  int splits = 0;           // times that the step, or a part of it, was repeated in halves
  bool converged = true;    // false: the equations are not solved to the tolerance; a fact, not an error
  double increment = 0;     // of the last Newton iteration: max |dx|/(g h) [body sizes per second]
  double min_J = 1;         // smallest det F over the quadrature points after the step
  int min_J_element = -1;   // where, counted over all bodies
  int inverted = 0;         // elements with J <= 0 at a quadrature point after the step
  bool braked = false;      // it would have made energy of nothing: by backward Euler, or with less speed
  bool no_factor = false;   // there was no memory for the factor: solved without a matrix
  std::string_view reason;  // why it did not converge
  std::string failure;      // empty, or why the step could not be taken (the state is then unchanged)
  // Seconds by phase; for the eye only, nothing is decided by them.
  double seconds = 0, seconds_assemble = 0, seconds_solve = 0;
};

// One line of `ritz explain`: a term of the energy that this scene has.
struct TermInfo {
  std::string name;  // "elastic beam stable-neo-hookean tet4"
  std::string what;  // "1536 elements, 1536 points", "81 nodes"
};

// Energies [J], momenta [kg m/s, kg m^2/s about the origin].
struct Measures {
  double kinetic = 0, elastic = 0, potential = 0;  // potential: gravity, tractions, springs, obstacles
  Vec3 p = {0, 0, 0}, L = {0, 0, 0};
};

// von Mises Cauchy stress [Pa], largest principal stretch, Psi [J/m^3], det F; of contact: pressure on the surface [Pa]
enum class Quantity { stress, stretch, energy, J, pressure };

struct Counts {
  int nodes = 0, elements = 0, dofs = 0, free_dofs = 0;
  std::int64_t nonzeros = 0;  // of the matrix; 0 when the scene forms none
  std::int64_t bytes = 0;     // estimate of what a run needs, the program included, without pictures
};

}  // namespace sim
