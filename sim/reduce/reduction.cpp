#include "sim/reduce/reduction.h"

namespace sim {

Eigen::VectorXd Reduction::rate_of(const Eigen::VectorXd& v) const {
  return gram.solve(mass.transpose() * v);
}

Eigen::VectorXd Reduction::coordinates_of(const Eigen::VectorXd& x) const {
  return rate_of(x - lift->X());
}

void Reduction::enter(State& state) const {
  Coordinates& q = state.coordinates;
  q = {};
  q.c = coordinates_of(state.x);
  q.rate = rate_of(state.v);
  if (state.x_before.size() > 0) {
    q.c_before = coordinates_of(state.x_before);
    q.rate_before = rate_of(state.v_before);
  }
  lift->place(q.c, state.x);
  lift->move(q.rate, state.v);
  state.force.resize(0);
  state.fastest.resize(0);
  state.kept = {};
}

}  // namespace sim
