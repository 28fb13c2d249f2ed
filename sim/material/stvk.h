// St. Venant-Kirchhoff: Psi = mu E:E + lambda/2 tr(E)^2, E = (C - I)/2. [Sifakis & Barbic 2012, part 1, 3.3]
// Softens and collapses in compression: below s = 0.58 a bar offers less the more it is squashed.
#pragma once

#include <string_view>

#include "sim/material/stretches.h"

namespace sim {

struct StVK : Isotropic<StVK> {
  static constexpr std::string_view name = "stvk";
  double mu, lambda;  // Pa

  StVK(const Lame& l, int /*d*/) : mu(l.mu), lambda(l.lambda) {}

  template <class T, int D, int M>
  static Mat<T, M, M> green(const Mat<T, D, M>& F) {
    return T(0.5) * (transpose_times(F, F) - Mat<T, M, M>::identity());
  }

  template <class T, int D, int M>
  T psi(const Mat<T, D, M>& F) const {
    const Mat<T, M, M> E = green(F);
    const T tr = trace(E);
    return T(mu) * contract(E, E) + T(0.5 * lambda) * tr * tr;
  }

  // P = F (2 mu E + lambda tr(E) I)
  template <class T, int D, int M>
  Mat<T, D, M> P(const Mat<T, D, M>& F) const {
    const Mat<T, M, M> E = green(F);
    Mat<T, M, M> S = T(2 * mu) * E;
    const T lambda_tr = T(lambda) * trace(E);
    for (int i = 0; i < M; ++i) S(i, i) += lambda_tr;
    return F * S;
  }

  // Psi_i = s_i (mu (s_i^2 - 1) + l), l = lambda sum (s_k^2 - 1)/2
  template <class T, int M>
  void derivatives(const T (&s)[M], Stretched<T, M>& d) const {
    T l = T(0);
    for (int k = 0; k < M; ++k) l += T(0.5 * lambda) * (s[k] * s[k] - T(1));
    for (int i = 0; i < M; ++i) {
      d.over[i] = T(mu) * (s[i] * s[i] - T(1)) + l;
      d.first[i] = s[i] * d.over[i];
      d.second(i, i) = T(mu) * (T(3) * s[i] * s[i] - T(1)) + l + T(lambda) * s[i] * s[i];
      for (int j = i + 1; j < M; ++j) {
        const int k = pair_index<M>(i, j);
        const T squares = s[i] * s[i] + s[j] * s[j];
        d.second(i, j) = d.second(j, i) = T(lambda) * s[i] * s[j];
        d.minus[k] = l - T(mu) + T(mu) * (squares + s[i] * s[j]);
        d.plus[k] = l - T(mu) + T(mu) * (squares - s[i] * s[j]);
      }
    }
  }
};

}  // namespace sim
