// Advances a State by one step of the scene's integrator. Owns the scratch memory; allocates in the first step only.
#pragma once

#include "sim/report.h"
#include "sim/state.h"

namespace sim {

class Stepper {
 public:
  virtual ~Stepper() = default;
  // Takes one step. On failure (report.failure not empty) the state is left as it was.
  virtual StepReport step(State& state) = 0;
};

}  // namespace sim
