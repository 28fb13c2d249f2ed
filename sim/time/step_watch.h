// What an explicit step needs as the body deforms: a body that is compressed vibrates faster than at rest, so the step
// that was stable there may not be here.
#pragma once

#include "sim/solve/tangent_operator.h"
#include "sim/state.h"
#include "sim/time/mass_solve.h"

namespace sim {

// Every so many steps the fastest vibration about the present positions is looked for, by power iterations of M^{-1} K
// whose products are differences of forces,
//   K p = (f(x) - f(x + e p)) / e,    D p = f(x, 0) - f(x, p),
// and steps are taken in as many parts as it needs from then on. Both are part of the state, so that a resumed run goes
// on with the same bits.
class StepWatch {
 public:
  StepWatch(const Model& model, TangentOperator& tangent, MassSolve& mass);

  bool is_due(const State& state) const;
  // Sets parts and fastest of the state at time t; the terms' step must have begun there.
  void look(double t, State& state, StepReport& report);

 private:
  double iterate(double t, const State& state, Eigen::VectorXd& p);
  double damping_rate(double t, const State& state, const Eigen::VectorXd& p);

  const Model& model_;
  TangentOperator& tangent_;
  MassSolve& mass_;
  Eigen::VectorXd still_, f_, moved_, difference_, product_;
};

}  // namespace sim
