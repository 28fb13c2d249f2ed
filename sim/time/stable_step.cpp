#include "sim/time/stable_step.h"

#include <cmath>
#include <limits>

#include "sim/solve/tangent_operator.h"
#include "sim/time/mass_solve.h"

namespace sim {

double stable_step(const Model& model) {
  constexpr int iterations = 60;
  constexpr double lacking = 1.05;  // of omega^2, after that many iterations
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
  return omega2 > 0 ? 2 / std::sqrt(lacking * omega2) : std::numeric_limits<double>::infinity();
}

}  // namespace sim
