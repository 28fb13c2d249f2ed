// Stable neo-Hookean: Psi = m/2 (I_C - d) + l/2 (J - a)^2 - m/2 ln(I_C + 1). [Smith, de Goes, Kim 2018]
// Finite for every F, inverted ones too; m, l, a make it agree with linear elasticity at rest in d = 2 and 3.
#pragma once

#include <string_view>

#include "sim/material/stretches.h"
#include "sim/math/volume.h"

namespace sim {

struct StableNeoHookean : Isotropic<StableNeoHookean> {
  static constexpr std::string_view name = "stable-neo-hookean";
  double d;     // material dimension
  double m, l;  // Pa
  double a;     // rest: a = 1 + m/l - m/(l (d+1))
  double psi_rest;

  StableNeoHookean(const Lame& lame, int d_)
      : d(d_),
        m(lame.mu * (d + 1) / d),
        l(lame.lambda + lame.mu * (d + 2) * (d - 1) / (d * (d + 1))),
        a(1 + m / l - m / (l * (d + 1))),
        psi_rest(0.5 * l * (1 - a) * (1 - a) - 0.5 * m * std::log(d + 1)) {}

  // Less its value at rest, so that a body at rest has no energy.
  template <class T, int D, int M>
  T psi(const Mat<T, D, M>& F) const {
    const T I = contract(F, F), excess = volume_ratio(F) - T(a);
    return T(0.5 * m) * (I - T(d)) + T(0.5 * l) * excess * excess - T(0.5 * m) * natural_log(I + T(1)) - T(psi_rest);
  }

  // P = m I_C/(I_C + 1) F + l (J - a) dJ/dF
  template <class T, int D, int M>
  Mat<T, D, M> P(const Mat<T, D, M>& F) const {
    const T I = contract(F, F);
    T J;
    Mat<T, D, M> dJ;
    volume_ratio(F, J, dJ);
    return (T(m) * I / (I + T(1))) * F + (T(l) * (J - T(a))) * dJ;
  }

  // Psi_i = c s_i + l (J - a) J_i, c = m I_C/(I_C + 1), J_i = dJ/ds_i
  template <class T, int M>
  void derivatives(const T (&s)[M], Stretched<T, M>& out) const {
    T I = s[0] * s[0];
    for (int k = 1; k < M; ++k) I += s[k] * s[k];
    const T inverse = T(1) / (I + T(1));
    const T c = T(m) * I * inverse, dc = T(2 * m) * inverse * inverse;
    const T pressure = T(l) * (product(s) - T(a));
    for (int i = 0; i < M; ++i) {
      const T Ji = product_without(s, i);
      out.first[i] = c * s[i] + pressure * Ji;
      out.over[i] = c + pressure * Ji * reciprocal(s[i]);
      out.second(i, i) = c + dc * s[i] * s[i] + T(l) * Ji * Ji;
      for (int j = i + 1; j < M; ++j) {
        const int k = pair_index<M>(i, j);
        const T Jij = product_without(s, i, j);
        out.second(i, j) = out.second(j, i) = dc * s[i] * s[j] + T(l) * Ji * product_without(s, j) + pressure * Jij;
        out.minus[k] = c - pressure * Jij;
        out.plus[k] = c + pressure * Jij;
      }
    }
  }
};

}  // namespace sim
