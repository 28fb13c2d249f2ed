#include "sim/residual/advection.h"

#include <algorithm>
#include <cmath>

namespace sim::residual {

// u = x - (e^(x/eps) - 1)/(e^(1/eps) - 1), with both exponentials over e^(1/eps): none overflows for a small eps, and
// expm1 keeps the digits for a large one.
Problem advection_diffusion(Real eps) {
  const auto constant = [](Real value) { return [value](Real) { return Jet{value, 0}; }; };
  const Real whole = -std::expm1(-1 / eps);
  const auto exact = [eps, whole](Real x) {
    const Real layer = std::exp((x - 1) / eps);
    return Jet{x + layer * std::expm1(-x / eps) / whole, 1 - layer / (eps * whole)};
  };
  return {constant(eps), constant(1), constant(0), constant(1), exact};
}

Real cell_peclet(Real eps, int n) {
  return 1 / (2 * eps * (n + 1));
}

Real overshoot(const Vector& nodes) {
  const Eigen::Index n = nodes.size();
  return std::max(Real(0), (nodes - Vector::LinSpaced(n, 1, n) / Real(n + 1)).maxCoeff());
}

}  // namespace sim::residual
