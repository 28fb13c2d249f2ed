#include "sim/study/loads.h"

#include "sim/build/parts.h"

namespace sim {

Loads loads(const System& system, const State& state) {
  const Model& model = parts_of(system).model;
  const Motion motion{state.x, state.v, system.time(state.step), 0};
  Loads result{Eigen::VectorXd::Zero(model.dofs()), Eigen::VectorXd::Zero(model.dofs())};
  Eigen::VectorXd own = Eigen::VectorXd::Zero(model.dofs());  // of the terms that no one applies
  for (const auto& term : model.terms) {
    const auto store = term->make_store(model.threads);
    term->begin_step(motion, *store);
    term->add_forces(motion, *store, term->role() == Role::applied ? result.applied : own);
  }
  Eigen::VectorXd free = Eigen::VectorXd::Ones(model.dofs());
  model.pins.mark(motion.t, free);
  result.held = -(1 - free.array()) * (own + result.applied).array();
  return result;
}

}  // namespace sim
