// Linear elasticity: Psi = mu eps:eps + lambda/2 tr(eps)^2, eps = sym(F) - I. Not rotation invariant: small motion
// only. On a membrane F is given in the rest frame (two tangents, then the normal); the normal row costs nothing.
#pragma once

#include <string_view>

#include "sim/material/lame.h"
#include "sim/material/tangent.h"

namespace sim {

struct Linear {
  static constexpr std::string_view name = "linear";
  static constexpr bool in_rest_frame = true;  // knows directions, so it needs the frame of the rest shape
  double mu, lambda;                           // Pa

  Linear(const Lame& l, int /*d*/) : mu(l.mu), lambda(l.lambda) {}

  template <class T, int D, int M>
  static Mat<T, M, M> strain(const Mat<T, D, M>& F) {
    Mat<T, M, M> eps;
    for (int i = 0; i < M; ++i)
      for (int j = 0; j < M; ++j) eps(i, j) = T(0.5) * (F(i, j) + F(j, i)) - T(i == j ? 1 : 0);
    return eps;
  }

  template <class T, int D, int M>
  T psi(const Mat<T, D, M>& F) const {
    const Mat<T, M, M> eps = strain(F);
    const T tr = trace(eps);
    return T(mu) * contract(eps, eps) + T(0.5 * lambda) * tr * tr;
  }

  // P = 2 mu eps + lambda tr(eps) I
  template <class T, int D, int M>
  Mat<T, D, M> P(const Mat<T, D, M>& F) const {
    const Mat<T, M, M> eps = strain(F);
    const T lambda_tr = T(lambda) * trace(eps);
    Mat<T, D, M> stress = Mat<T, D, M>::zero();
    for (int i = 0; i < M; ++i) {
      for (int j = 0; j < M; ++j) stress(i, j) = T(2 * mu) * eps(i, j);
      stress(i, i) += lambda_tr;
    }
    return stress;
  }

  // Constant: U = V = I, 2 mu on the symmetric pairs, nothing on the antisymmetric ones.
  template <class T, int D, int M>
  void linearise(const Mat<T, D, M>& F, Mat<T, D, M>& stress, Tangent<T, D, M>& t) const {
    stress = P(F);
    t.U = Mat<T, D, D>::identity();
    t.V = Mat<T, M, M>::identity();
    for (int i = 0; i < M; ++i) {
      for (int j = 0; j < M; ++j) t.stretch(i, j) = T(lambda + (i == j ? 2 * mu : 0));
      if constexpr (D > M) t.normal[i] = T(0);
    }
    for (int k = 0; k < Tangent<T, D, M>::pairs; ++k) {
      t.symmetric[k] = T(2 * mu);
      t.antisymmetric[k] = T(0);
    }
  }
};

}  // namespace sim
