// The barrier of contacts and obstacles: nothing beyond dh, without end at the offset xi. [Li et al. 2020, 2023]
//   s = (d - xi)/dh,  b = -dh (s - 1)^2 ln s for 0 < s < 1, else 0 [m];  -kappa b' is a pressure
#pragma once

#include <cmath>

namespace sim {

struct Barrier {
  double b = 0, first = 0, second = 0;  // m, -, 1/m
  // gap = d - xi > 0
  Barrier(double gap, double dh) {
    const double s = gap / dh;
    if (s >= 1) return;
    const double log = std::log(s), left = s - 1;
    b = -dh * left * left * log;
    first = -(2 * left * log + left * left / s);
    second = (-2 * log - 4 * left / s + left * left / (s * s)) / dh;
  }
};

}  // namespace sim
