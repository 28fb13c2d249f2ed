#include "sim/loads.h"

#include "sim/parts.h"
#include "sim/term/damping.h"
#include "sim/term/gravity.h"

namespace sim {

Loads loads(const System& system, const State& state) {
  const System::Parts& parts = system.parts();
  const Motion motion{state.x, state.v, system.time(state.step), 0};
  Loads result{Eigen::VectorXd::Zero(parts.dofs()), Eigen::VectorXd::Zero(parts.dofs())};
  Eigen::VectorXd own = Eigen::VectorXd::Zero(parts.dofs());  // elastic, damping, weight
  for (const auto& term : parts.terms) {
    const bool inside = dynamic_cast<const ElasticTerm*>(term.get()) != nullptr ||
                        dynamic_cast<const RayleighDamping*>(term.get()) != nullptr ||
                        dynamic_cast<const Gravity*>(term.get()) != nullptr;
    const auto store = term->make_store(parts.threads);
    term->begin_step(motion, *store);
    term->add_forces(motion, *store, inside ? own : result.applied);
  }
  Eigen::VectorXd free = Eigen::VectorXd::Ones(parts.dofs());
  parts.pins.mark(motion.t, free);
  result.held = -(1 - free.array()) * (own + result.applied).array();
  return result;
}

}  // namespace sim
