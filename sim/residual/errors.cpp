#include "sim/residual/errors.h"

#include <algorithm>
#include <cmath>

#include "sim/residual/grid.h"

namespace sim::residual {
namespace {

Real largest(const Problem& problem, const Trial& trial) {
  constexpr int cells = 1000;
  Real most = 0;
  for (int i = 0; i <= cells; ++i) {
    const Real x = Real(i) / cells;
    most = std::max(most, std::abs(trial.at(x).value - problem.exact(x).value));
  }
  return most;
}

}  // namespace

Errors measure(const Problem& problem, const Trial& trial, bool self_adjoint) {
  const Grid grid = gauss_grid(problem, static_cast<int>(trial.coefficients().size()));
  Real e2 = 0, slope2 = 0, energy = 0, residual2 = 0, F = 0;
  for (Eigen::Index p = 0; p < grid.x.size(); ++p) {
    const Real x = grid.x[p], w = grid.weight[p];
    const Sample u = trial.at(x);
    const Jet exact = problem.exact(x);
    const Real k = problem.k(x).value, q = problem.q(x).value, f = problem.f(x).value;
    const Real e = u.value - exact.value, slope = u.slope - exact.slope, r = apply(problem, x, u) - f;
    e2 += w * e * e;
    slope2 += w * slope * slope;
    energy += w * (k * slope * slope + q * e * e);
    residual2 += w * r * r;
    F += w * (k * u.slope * u.slope / 2 + q * u.value * u.value / 2 - f * u.value);
  }
  Errors errors{std::sqrt(e2), std::sqrt(slope2), {}, {}, largest(problem, trial), {}};
  if (self_adjoint && energy >= 0) errors.energy_norm = std::sqrt(energy);
  if (trial.basis().smooth) errors.residual_L2 = std::sqrt(residual2);
  if (self_adjoint) errors.F = F;
  return errors;
}

Vector weighted_residuals(const Problem& problem, const Trial& trial) {
  const Eigen::Index n = trial.coefficients().size();
  const Grid grid = gauss_grid(problem, static_cast<int>(n));
  Vector sums = Vector::Zero(n);
  std::vector<Sample> u(n);
  for (Eigen::Index p = 0; p < grid.x.size(); ++p) {
    const Real x = grid.x[p], r = apply(problem, x, trial.at(x)) - problem.f(x).value;
    trial.basis().sample(x, u);
    for (Eigen::Index i = 0; i < n; ++i) sums[i] += grid.weight[p] * u[i].value * r;
  }
  return sums;
}

Real order(const Basis& basis, int n, Real error_n, int m, Real error_m) {
  const int ends = basis.smooth ? 0 : 1;
  return std::log(error_n / error_m) / std::log(Real(m + ends) / Real(n + ends));
}

}  // namespace sim::residual
