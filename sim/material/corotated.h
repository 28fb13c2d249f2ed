// Corotated linear elasticity: Psi = mu sum (s_i - 1)^2 + lambda/2 (sum (s_i - 1))^2. [Sifakis & Barbic 2012, 3.4]
#pragma once

#include <string_view>

#include "sim/material/stretches.h"

namespace sim {

struct Corotated : Isotropic<Corotated> {
  static constexpr std::string_view name = "corotated";
  double mu, lambda;  // Pa

  Corotated(const Lame& l, int /*d*/) : mu(l.mu), lambda(l.lambda) {}

  template <class T, int D, int M>
  T psi(const Mat<T, D, M>& F) const {
    const Svd<T, D, M> f = svd(F);
    T squares = T(0), sum = T(0);
    for (int i = 0; i < M; ++i) {
      squares += (f.s[i] - T(1)) * (f.s[i] - T(1));
      sum += f.s[i] - T(1);
    }
    return T(mu) * squares + T(0.5 * lambda) * sum * sum;
  }

  template <class T, int D, int M>
  Mat<T, D, M> P(const Mat<T, D, M>& F) const {
    const Svd<T, D, M> f = svd(F);
    Stretched<T, M> d;
    derivatives(f.s, d);
    return recompose(f, d.first);
  }

  // Psi_i = 2 mu (s_i - 1) + l, l = lambda sum (s_k - 1)
  template <class T, int M>
  void derivatives(const T (&s)[M], Stretched<T, M>& d) const {
    T l = T(0);
    for (int k = 0; k < M; ++k) l += T(lambda) * (s[k] - T(1));
    for (int i = 0; i < M; ++i) {
      d.first[i] = T(2 * mu) * (s[i] - T(1)) + l;
      d.over[i] = T(2 * mu) + (l - T(2 * mu)) * reciprocal(s[i]);
      d.second(i, i) = T(2 * mu + lambda);
      for (int j = i + 1; j < M; ++j) {
        const int k = pair_index<M>(i, j);
        d.second(i, j) = d.second(j, i) = T(lambda);
        d.minus[k] = T(2 * mu);
        d.plus[k] = T(2 * mu) + T(2) * (l - T(2 * mu)) * reciprocal(s[i] + s[j]);
      }
    }
  }
};

}  // namespace sim
