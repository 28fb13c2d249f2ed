// Isotropic materials as functions of the principal stretches: what each must give, and what follows for P and dP/dF.
#pragma once

#include "sim/material/lame.h"
#include "sim/material/tangent.h"

namespace sim {

// First and second derivatives of Psi at the principal stretches s; quotients in closed form, no vanishing divisor:
//   first_i = dPsi/ds_i,  second_ij = d2Psi/ds_i ds_j
//   minus_ij = (first_i - first_j)/(s_i - s_j),  plus_ij = (first_i + first_j)/(s_i + s_j),  over_i = first_i/s_i
template <class T, int M>
struct Stretched {
  T first[M];
  Mat<T, M, M> second;
  T minus[M * (M - 1) / 2], plus[M * (M - 1) / 2];
  T over[M];
};

// J, its derivatives dJ/ds_i = J/s_i (products of the others) and the rest of J after s_i and s_j.
template <class T>
T product(const T (&s)[2]) {
  return s[0] * s[1];
}
template <class T>
T product(const T (&s)[3]) {
  return s[0] * s[1] * s[2];
}
template <class T>
T product_without(const T (&s)[2], int i) {
  return s[1 - i];
}
template <class T>
T product_without(const T (&s)[3], int i) {
  return s[(i + 1) % 3] * s[(i + 2) % 3];
}
template <class T>
T product_without(const T (&)[2], int, int) {
  return T(1);
}
template <class T>
T product_without(const T (&s)[3], int i, int j) {
  return s[3 - i - j];
}

// 1/s where s is a divisor that no algebra removes (the energy itself has a kink at s = 0): kept away from zero.
template <class T>
T reciprocal(const T& s) {
  constexpr double least = 1e-8;  // of the rest length
  return T(1) / with_sign(maximum(absolute(s), T(least)), s);
}

// U diag(d) V^T
template <class T, int D, int M>
Mat<T, D, M> recompose(const Svd<T, D, M>& f, const T (&d)[M]) {
  Mat<T, D, M> A;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < M; ++j) {
      T sum = f.U(i, 0) * d[0] * f.V(j, 0);
      for (int k = 1; k < M; ++k) sum += f.U(i, k) * d[k] * f.V(j, k);
      A(i, j) = sum;
    }
  return A;
}

// What an isotropic material inherits: P = U diag(dPsi/ds) V^T and dP/dF in the frame of U and V (mathematics.md 4),
// from the material's `derivatives(s, Stretched&)`. The tangent is not yet made definite.
template <class Material>
struct Isotropic {
  template <class T, int D, int M>
  void linearise(const Mat<T, D, M>& F, Mat<T, D, M>& P, Tangent<T, D, M>& t) const {
    const Svd<T, D, M> f = svd(F);
    Stretched<T, M> d;
    static_cast<const Material&>(*this).derivatives(f.s, d);
    P = recompose(f, d.first);
    t.U = f.U;
    t.V = f.V;
    t.stretch = d.second;
    for (int k = 0; k < Tangent<T, D, M>::pairs; ++k) {
      t.symmetric[k] = d.minus[k];
      t.antisymmetric[k] = d.plus[k];
    }
    if constexpr (D > M)
      for (int i = 0; i < M; ++i) t.normal[i] = d.over[i];
  }
};

}  // namespace sim
