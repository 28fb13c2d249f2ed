// Quadrature rules on [-1,1] of any number of points. None has its points at the ends, where hats have no slope.
#pragma once

#include "sim/residual/real.h"

namespace sim::residual {

struct Rule {
  Vector t, weight;  // points ascending; weights sum to 2
};

// n points, degree 2n - 1. n >= 1.
Rule gauss_legendre(int n);

// n points, degree n - 1. n >= 1.
Rule fejer(int n);

}  // namespace sim::residual
