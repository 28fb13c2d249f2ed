#include "sim/residual/rule.h"

#include <cmath>
#include <numbers>

#include "sim/residual/legendre.h"

namespace sim::residual {
namespace {

constexpr Real pi_real = std::numbers::pi_v<Real>;

}  // namespace

// The roots t_j of P_n by Newton's method from cos(pi (j - 1/4)/(n + 1/2)), weights 2/((1 - t^2) P_n'(t)^2)
// [Abramowitz & Stegun 1964, 25.4.29 and 22.16.6].
Rule gauss_legendre(int n) {
  constexpr int steps = 8;  // quadratic convergence from two digits: five are enough
  Rule rule{Vector(n), Vector(n)};
  for (int j = 0; j < n; ++j) {
    Real t = -std::cos(pi_real * (j + Real(0.75)) / (n + Real(0.5)));
    Legendre P = legendre(n, t);
    for (int k = 0; k < steps; ++k) {
      t -= P.value / P.slope;
      P = legendre(n, t);
    }
    rule.t[j] = t;
    rule.weight[j] = 2 / ((1 - t * t) * P.slope * P.slope);
  }
  return rule;
}

// t_j = cos(theta_j), theta_j = pi (2j - 1)/(2n), weights 2/n (1 - 2 sum_m cos(2 m theta_j)/(4 m^2 - 1)), m <= n/2:
// Fejér's first rule [Davis & Rabinowitz 1984, 2.5.5].
Rule fejer(int n) {
  Rule rule{Vector(n), Vector(n)};
  for (int j = 0; j < n; ++j) {
    const Real theta = pi_real * (2 * (n - j) - 1) / (2 * n);
    Real sum = 0;
    for (int m = 1; m <= n / 2; ++m) sum += std::cos(2 * m * theta) / (4 * m * m - 1);
    rule.t[j] = std::cos(theta);
    rule.weight[j] = (1 - 2 * sum) * 2 / n;
  }
  return rule;
}

}  // namespace sim::residual
