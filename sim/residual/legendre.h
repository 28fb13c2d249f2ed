// Legendre polynomials.
#pragma once

#include "sim/residual/real.h"

namespace sim::residual {

// P_n(t) with its derivative, and the polynomial before it.
struct Legendre {
  Real value = 1, slope = 0, before = 0;
};

// (m + 1) P_{m+1} = (2m + 1) t P_m - m P_{m-1},  P'_{m+1} = t P'_m + (m + 1) P_m [Abramowitz & Stegun
// 1964, 8.5.3, 8.5.4]. The second holds at the ends of [-1,1] too.
inline Legendre next(const Legendre& P, int m, Real t) {
  return {((2 * m + 1) * t * P.value - m * P.before) / (m + 1), t * P.slope + (m + 1) * P.value, P.value};
}

inline Legendre legendre(int n, Real t) {
  Legendre P;
  for (int m = 0; m < n; ++m) P = next(P, m, t);
  return P;
}

}  // namespace sim::residual
