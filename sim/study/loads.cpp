#include "sim/study/loads.h"

#include "sim/build/parts.h"

namespace sim {

Loads loads(const System& system, const State& state) {
  const Model& model = parts_of(system).model;
  const Motion motion{state.x, state.v, system.time(state.step), 0};
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(model.dofs());
  Loads result{none, none, none};
  Eigen::VectorXd own = none;  // of the terms that no one applies
  for (const auto& term : model.terms) {
    const auto store = term->make_store(model.threads);
    term->begin_step(motion, *store);
    Eigen::VectorXd& applied = term->limits_moves() ? result.contact : result.applied;
    term->add_forces(motion, *store, term->role() == Role::applied ? applied : own);
  }
  Eigen::VectorXd free = Eigen::VectorXd::Ones(model.dofs());
  model.pins.mark(motion.t, free);
  result.held = -(1 - free.array()) * (own + result.applied + result.contact).array();
  return result;
}

}  // namespace sim
