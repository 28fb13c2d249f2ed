#include "sim/study/flight_drift.h"

#include "sim/build/parts.h"
#include "sim/stepper.h"

namespace sim {

namespace {

double relative(double change, double before) {
  return before > 0 ? change / before : change;
}

}  // namespace

FlightDrift flight_drift(const System& system, std::int64_t steps, const std::function<bool()>& interrupted) {
  const auto stepper = make_stepper(system, 1);
  State state = system.initial_state();
  const Eigen::VectorXd x = state.x;
  const Measures before = system.measure(state);
  FlightDrift d;
  while (d.steps < steps && !interrupted()) {
    d.failure = stepper->step(state).failure;
    if (!d.failure.empty()) break;
    ++d.steps;
  }
  const Measures after = system.measure(state);
  const double E = before.kinetic + before.elastic;
  d.p = relative((after.p - before.p).norm(), before.p.norm());
  d.L = relative((after.L - before.L).norm(), before.L.norm());
  d.energy = relative(after.kinetic + after.elastic - E, E);
  d.away = (state.x - x).cwiseAbs().maxCoeff() / parts_of(system).model.node_size[0];
  return d;
}

}  // namespace sim
