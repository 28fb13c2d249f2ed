// Fixed corotated: Psi = mu sum (s_i - 1)^2 + lambda/2 (J - 1)^2. [Stomakhin et al. 2012]
#pragma once

#include <string_view>

#include "sim/material/stretches.h"
#include "sim/math/volume.h"

namespace sim {

struct FixedCorotated : Isotropic<FixedCorotated> {
  static constexpr std::string_view name = "fixed-corotated";
  double mu, lambda;  // Pa

  FixedCorotated(const Lame& l, int /*d*/) : mu(l.mu), lambda(l.lambda) {}

  template <class T, int D, int M>
  T psi(const Mat<T, D, M>& F) const {
    const Svd<T, D, M> f = svd(F);
    T squares = T(0);
    for (int i = 0; i < M; ++i) squares += (f.s[i] - T(1)) * (f.s[i] - T(1));
    const T growth = product(f.s) - T(1);
    return T(mu) * squares + T(0.5 * lambda) * growth * growth;
  }

  template <class T, int D, int M>
  Mat<T, D, M> P(const Mat<T, D, M>& F) const {
    const Svd<T, D, M> f = svd(F);
    Stretched<T, M> d;
    derivatives(f.s, d);
    return recompose(f, d.first);
  }

  // Psi_i = 2 mu (s_i - 1) + p J_i, p = lambda (J - 1), J_i = dJ/ds_i
  template <class T, int M>
  void derivatives(const T (&s)[M], Stretched<T, M>& d) const {
    const T p = T(lambda) * (product(s) - T(1));
    for (int i = 0; i < M; ++i) {
      const T Ji = product_without(s, i);
      d.first[i] = T(2 * mu) * (s[i] - T(1)) + p * Ji;
      d.over[i] = T(2 * mu) + (p * Ji - T(2 * mu)) * reciprocal(s[i]);
      d.second(i, i) = T(2 * mu) + T(lambda) * Ji * Ji;
      for (int j = i + 1; j < M; ++j) {
        const int k = pair_index<M>(i, j);
        const T Jij = product_without(s, i, j);
        d.second(i, j) = d.second(j, i) = T(lambda) * Ji * product_without(s, j) + p * Jij;
        d.minus[k] = T(2 * mu) - p * Jij;
        d.plus[k] = T(2 * mu) - T(4 * mu) * reciprocal(s[i] + s[j]) + p * Jij;
      }
    }
  }
};

}  // namespace sim
