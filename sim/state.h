// All that changes from step to step. Copy it to reset, to step back, to save and go on.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace sim {

// What a linear solver may hold from one solve to the next: the factor of the matrix, or the coarse level of two.
enum class Kept { nothing, factor, coarse };

// At which state it was made; a resumed run makes the same from it again.
struct KeptFactor {
  std::int64_t what = 0;             // a value of sim::Kept
  std::int64_t excess = 0;           // iterations that a new one would have saved so far
  std::int64_t solves = 0;           // that it has served
  std::int64_t fresh = 0;            // iterations that a solve takes with a coarse level as young as the matrix
  std::int64_t definiteness = 0;     // a value of sim::Definiteness
  double t_begin = 0, t = 0;         // s: start of that step, and of its stage
  double dv_dx = 0, c = 0;           // 1/(g h), 1/(g h)^2
  double barriers = 1;               // how often they count there
  Eigen::VectorXd x_begin, v_begin;  // at the start of that step
  Eigen::VectorXd x, v;              // where it was linearised
};

// Where a system that moves in a basis is in it: x = X + U c. Empty without one.
struct Coordinates {
  Eigen::VectorXd c, rate;                // m sqrt(kg), and per second
  Eigen::VectorXd c_before, rate_before;  // of the step before; empty until there is one
  Eigen::VectorXd force;                  // U^T f that the last stage balanced; empty: to be evaluated
};

struct State {
  std::int64_t step = 0;               // completed steps; the time is System::time(step)
  Eigen::VectorXd x, v;                // positions [m] and velocities [m/s], D numbers per node, node by node
  Eigen::VectorXd x_before, v_before;  // of the step before; empty until there is one
  Eigen::VectorXd force;               // N, that the last stage balanced, without barriers; empty: to be evaluated
  // J, where bodies may hit something: the most that they had, kinetic and potential, since something last drove them
  // or backward Euler took a step in another scheme's place, and their largest kinetic energy since they were driven.
  // The latter negative: neither is known.
  double energy_most = 0, kinetic_most = -1;
  std::int64_t parts = 1;   // explicit schemes: how many a step is taken in (sim/time/step_watch.h)
  Eigen::VectorXd fastest;  // ... and the shape of the vibration that asks for them; empty: not watched yet
  KeptFactor kept;
  Coordinates coordinates;
};

// Calls f(field) for every number and vector, in a fixed order: what is saved, compared and hashed. Of a state without
// its coordinates, of coordinates, and of both.
template <class S, class F>
void for_each_nodal_field(S& state, const F& f) {
  f(state.step);
  f(state.x);
  f(state.v);
  f(state.x_before);
  f(state.v_before);
  f(state.force);
  f(state.energy_most);
  f(state.kinetic_most);
  f(state.parts);
  f(state.fastest);
  auto& k = state.kept;
  f(k.what);
  f(k.excess);
  f(k.solves);
  f(k.fresh);
  f(k.definiteness);
  f(k.t_begin);
  f(k.t);
  f(k.dv_dx);
  f(k.c);
  f(k.barriers);
  f(k.x_begin);
  f(k.v_begin);
  f(k.x);
  f(k.v);
}
template <class Q, class F>
void for_each_coordinate_field(Q& q, const F& f) {
  f(q.c);
  f(q.rate);
  f(q.c_before);
  f(q.rate_before);
  f(q.force);
}
template <class S, class F>
void for_each_field(S& state, const F& f) {
  for_each_nodal_field(state, f);
  for_each_coordinate_field(state.coordinates, f);
}

// FNV-1a over every bit of the state: equal states, equal hash.
std::uint64_t hash(const State& state);

}  // namespace sim
