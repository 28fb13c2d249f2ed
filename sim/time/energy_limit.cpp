#include "sim/time/energy_limit.h"

#include <algorithm>
#include <cmath>

namespace sim {

EnergyLimit::EnergyLimit(const Model& model, TangentOperator& tangent) : model_(model), tangent_(tangent) {
  x_.setZero(model.dofs());
  v_.setZero(model.dofs());
}

// T = 1/2 v.M v [J]
double EnergyLimit::kinetic(const Eigen::VectorXd& v) {
  x_.setZero();
  for (const Mass& mass : model_.masses) mass.add_product(1, v, x_, model_.D);
  return 0.5 * v.dot(x_);
}

// U(x) [J]
double EnergyLimit::potential_at(const State& state, double t) {
  return tangent_.energy({state.x, state.v, t, 0});
}

// J, that the step may end with; `had` is what there was at its beginning. Where someone gave the bodies another
// velocity, what was remembered is less than they have.
double EnergyLimit::most(const State& begin, double had) const {
  const bool remembers = begin.kinetic_most >= 0 && had <= begin.energy_most + 2 * noise * begin.kinetic_most;
  return remembers ? begin.energy_most : had;
}

void EnergyLimit::slow_down(double energy, State& next, double t_end) {
  const double left = energy - potential_at(next, t_end), T = kinetic(next.v);
  if (T <= left) return;
  next.v *= left > 0 ? std::sqrt(left / T) : 0;
  model_.pins.prescribe(t_end, next.x, next.v);
}

void EnergyLimit::calm(const State& begin, double t, State& next, double t_end) {
  next.force.setZero();
  slow_down(kinetic(begin.v) + potential_at(begin, t), next, t_end);
}

// Something that is prescribed moves, a term's own motion drags, or the potential changes while nothing does: it was
// `potential`.
bool EnergyLimit::driven(const State& begin, double t, double t_end, double potential) {
  for (const double end : {t, t_end}) {
    v_.setZero();
    model_.pins.prescribe(end, x_, v_);
    if (!v_.isZero(0)) return true;
    for (const auto& term : model_.terms)
      if (term->drives(end)) return true;
  }
  return potential_at(begin, t_end) != potential;
}

bool EnergyLimit::gains(const State& begin, double t, State& next, double t_end) {
  const double potential = potential_at(begin, t);
  const double T = kinetic(next.v), energy = T + potential_at(next, t_end);
  const double had = kinetic(begin.v) + potential;
  const double allowed = most(begin, had), fastest = std::max(begin.kinetic_most, T);
  const bool is_driven = driven(begin, t, t_end, potential);
  const double at_once = had + regained * fastest;
  if (!is_driven && !(energy <= std::min(allowed + noise * fastest, at_once))) return true;
  next.energy_most = is_driven ? energy : allowed;
  next.kinetic_most = is_driven ? T : fastest;
  return false;
}

void EnergyLimit::settle(State& next, double t_end) {
  next.energy_most = kinetic(next.v) + potential_at(next, t_end);
}

// With dv = v_{n+1} - v_n: T(v_n + s dv) = T(v_n) + b s + a s^2, a = T(dv), b = v_n.M dv = T(v_{n+1}) - T(v_n) - a.
void EnergyLimit::brake(const State& begin, double t, State& next, double t_end) {
  const double T_begin = kinetic(begin.v), T_end = kinetic(next.v);
  const double allowed = most(begin, T_begin + potential_at(begin, t)), left = allowed - potential_at(next, t_end);
  v_ = next.v - begin.v;
  const double a = kinetic(v_), b = T_end - T_begin - a;
  if (a > 0) {
    const double root = b * b - 4 * a * (T_begin - left);
    const double s = std::clamp((-b + std::sqrt(std::max(root, 0.0))) / (2 * a), 0.0, 1.0);
    next.v = begin.v + s * v_;
    model_.pins.prescribe(t_end, next.x, next.v);
  }
  slow_down(allowed, next, t_end);
  next.energy_most = allowed;
  next.kinetic_most = std::max(begin.kinetic_most, T_begin);
}

}  // namespace sim
