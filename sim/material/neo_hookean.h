// Neo-Hookean: Psi = mu/2 (I_C - d) - mu ln J + lambda/2 (ln J)^2. [Bonet & Wood 2008, 6.4.3]
// Infinite at J -> 0: the energy of an inverted element is +infinity, so a line search never enters there.
#pragma once

#include <limits>
#include <string_view>

#include "sim/material/stretches.h"
#include "sim/math/volume.h"

namespace sim {

struct NeoHookean : Isotropic<NeoHookean> {
  static constexpr std::string_view name = "neo-hookean";
  double mu, lambda;  // Pa
  double d;           // material dimension

  NeoHookean(const Lame& l, int d_) : mu(l.mu), lambda(l.lambda), d(d_) {}

  template <class T, int D, int M>
  T psi(const Mat<T, D, M>& F) const {
    const T J = volume_ratio(F);
    const T ln_J = natural_log(maximum(J, T(std::numeric_limits<double>::min())));
    const T psi = T(0.5 * mu) * (contract(F, F) - T(d)) - T(mu) * ln_J + T(0.5 * lambda) * ln_J * ln_J;
    return select(J > T(0), psi, T(std::numeric_limits<double>::infinity()));
  }

  // P = mu F + (lambda ln J - mu) F^{-T}, F^{-T} = (dJ/dF)/J
  template <class T, int D, int M>
  Mat<T, D, M> P(const Mat<T, D, M>& F) const {
    T J;
    Mat<T, D, M> dJ;
    volume_ratio(F, J, dJ);
    return T(mu) * F + ((T(lambda) * natural_log(J) - T(mu)) / J) * dJ;
  }

  // Psi_i = mu s_i + c/s_i, c = lambda ln J - mu
  template <class T, int M>
  void derivatives(const T (&s)[M], Stretched<T, M>& d) const {
    const T c = T(lambda) * natural_log(product(s)) - T(mu);
    T r[M];
    for (int i = 0; i < M; ++i) r[i] = T(1) / s[i];
    for (int i = 0; i < M; ++i) {
      d.first[i] = T(mu) * s[i] + c * r[i];
      d.over[i] = T(mu) + c * r[i] * r[i];
      d.second(i, i) = T(mu) + (T(lambda) - c) * r[i] * r[i];
      for (int j = i + 1; j < M; ++j) {
        const int k = pair_index<M>(i, j);
        const T rr = r[i] * r[j];
        d.second(i, j) = d.second(j, i) = T(lambda) * rr;
        d.minus[k] = T(mu) - c * rr;
        d.plus[k] = T(mu) + c * rr;
      }
    }
  }
};

}  // namespace sim
