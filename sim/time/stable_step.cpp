#include "sim/time/stable_step.h"

#include <cmath>
#include <limits>

#include "sim/solve/tangent_operator.h"
#include "sim/time/mass_solve.h"

namespace sim {

double stable_step(double omega2, double d) {
  // The same without the difference of two large numbers.
  const double sum = std::sqrt(d * d + 4 * omega2) + d;
  return sum > 0 ? 4 / sum : std::numeric_limits<double>::infinity();
}

double stable_step(const Model& model) {
  constexpr int iterations = 60;
  TangentOperator K(model, model.threads);
  MassSolve M(model);
  model.pins.mark(0, K.free());
  Eigen::VectorXd f(model.dofs()), p(model.dofs()), Kp(model.dofs());
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(model.dofs());
  K.begin_step({model.X, still, 0, 0});  // what terms freeze for a step, they linearise with
  K.linearise({model.X, still, 0, 0}, 0, Definiteness::clamp, f);
  // A start with a share of every frequency, the same on every machine.
  for (Eigen::Index i = 0; i < p.size(); ++i) p[i] = std::sin(12.9898 * static_cast<double>(i + 1)) * K.free()[i];
  double omega2 = 0;
  for (int k = 0; k < iterations; ++k) {
    const double length = p.norm();
    if (!(length > 0)) return std::numeric_limits<double>::infinity();
    p /= length;
    K.multiply(p, Kp);
    M.solve(Kp, K.free(), p);
    omega2 = p.norm();
  }
  // Forces are linear in the velocity: f(X, 0) - f(X, p) = D p.
  const double length = p.norm();
  if (!(length > 0)) return std::numeric_limits<double>::infinity();
  p /= length;
  K.forces({model.X, p, 0, 0}, Kp);
  M.solve(f - Kp, K.free(), Kp);
  return stable_step(lacking * omega2, lacking * Kp.norm());
}

}  // namespace sim
