// Advances a State by one step of the scene's integrator. Owns the scratch memory; allocates in the first step only.
#pragma once

#include <memory>

#include "sim/report.h"
#include "sim/system.h"

namespace sim {

class Stepper {
 public:
  virtual ~Stepper() = default;
  // Takes one step. On failure (report.failure not empty) the state is left as it was.
  virtual StepReport step(State& state) = 0;
};

// The stepper that the scene's integrator and solver name. `system` must outlive it.
// threads >= 1: the bits of the result do not depend on it.
std::unique_ptr<Stepper> make_stepper(const System& system, int threads);

}  // namespace sim
