// How a load rises: s(t) = tau^2 (3 - 2 tau), tau = t/ramp, from 0 to 1, flat at both ends.
#pragma once

#include <algorithm>

namespace sim {

inline double risen(double t, double ramp) {
  if (t >= ramp) return 1;
  const double tau = std::max(t, 0.0) / ramp;
  return tau * tau * (3 - 2 * tau);
}

}  // namespace sim
