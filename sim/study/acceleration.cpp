#include "sim/study/acceleration.h"

#include "sim/build/parts.h"
#include "sim/solve/tangent_operator.h"
#include "sim/time/mass_solve.h"

namespace sim {

Eigen::VectorXd accelerations(const System& system, const State& state) {
  const Model& model = parts_of(system).model;
  TangentOperator tangent(model, 1);
  const double t = model.t(state.step);
  model.pins.mark(t, tangent.free());
  tangent.begin_step({state.x, state.v, t, 0});
  Eigen::VectorXd f(model.dofs()), a(model.dofs());
  tangent.forces({state.x, state.v, t, 0}, f);
  MassSolve(model).solve(f, tangent.free(), a);
  return a;
}

}  // namespace sim
