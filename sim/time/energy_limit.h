// What a step may not do to the energy of bodies that nothing drives: make more of it.
#pragma once

#include "sim/solve/tangent_operator.h"
#include "sim/state.h"

namespace sim {

class EnergyLimit {
 public:
  EnergyLimit(const Model& model, TangentOperator& tangent);

  // A step that is accepted unsolved has the velocity of an iteration on its way, which no force justifies. `next`, the
  // end of the step from `begin` at t to t_end, is slowed down until kinetic and potential energy together are at most
  // what they were:
  //   s^2 = (T_n + U(x_n) - U(x_{n+1})) / T_{n+1}, at most 1, 0 where that is negative; v <- s v
  // Neither does it hand on the force of its last stage, which would give that velocity once more.
  void calm(const State& begin, double t, State& next, double t_end);

  // Bodies that hit something hard leave it in a motion that no step resolves: trapezoidal makes more of it without
  // end, and every scheme a little where a corner slips off another. True: nothing drives the bodies, and at the end of
  // this step they have more energy than they ever had since it last did, by more than `noise` of the largest kinetic
  // energy, or more than at its beginning by more than `regained` of that. Otherwise `next` remembers that most. [after
  // Dinev et al. 2018]
  bool gains(const State& begin, double t, State& next, double t_end);
  // Backward Euler took the step: what it lost is lost, and the energy at its end is the most from then on.
  void settle(State& next, double t_end);
  // Where backward Euler gains as well: what the step did to the velocity counts as far as there is energy for it,
  // which keeps the momentum. The largest s in [0, 1] with
  //   T(v_n + s (v_{n+1} - v_n)) + U(x_{n+1}) <= that most
  void brake(const State& begin, double t, State& next, double t_end);

 private:
  double kinetic(const Eigen::VectorXd& v);
  double potential_at(const State& state, double t);
  double most(const State& begin, double had) const;
  void slow_down(double energy, State& next, double t_end);
  bool driven(const State& begin, double t, double t_end, double potential);

  static constexpr double noise = 1e-3, regained = 0.1;
  const Model& model_;
  TangentOperator& tangent_;
  Eigen::VectorXd x_, v_;  // scratch
};

}  // namespace sim
