#include "sim/stepper.h"

#include "sim/time/explicit.h"
#include "sim/time/implicit.h"

namespace sim {

std::unique_ptr<Stepper> make_stepper(const System& system, int threads) {
  if (system.parts().scheme->stages.empty()) return std::make_unique<ExplicitStepper>(system.parts(), threads);
  return std::make_unique<ImplicitStepper>(system.parts(), threads);
}

}  // namespace sim
