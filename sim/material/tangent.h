// The tangent dP/dF at one point, kept in the frame of the principal stretches: a handful of numbers that are all of
// its eigenvalues once the stretch block is diagonal. [Teran et al. 2005; Smith, de Goes, Kim 2019]
#pragma once

#include "sim/choices.h"
#include "sim/math/symmetric_eigen.h"

namespace sim {

template <class T>
T made_definite(const T& eigenvalue, Definiteness fix) {
  return maximum(eigenvalue, T(static_cast<double>(fix)) * eigenvalue);
}

// dF' = U^T dF V, dP' the same of dP; in these:
//   dP'_ii = sum_j stretch_ij dF'_jj
//   dP'_ij + dP'_ji = symmetric_ij (dF'_ij + dF'_ji),  dP'_ij - dP'_ji = antisymmetric_ij (dF'_ij - dF'_ji)   (i < j)
//   dP'_ni = normal_i dF'_ni   (membranes: row n is the unit normal)
// Units: Pa. Pairs are (0,1), (0,2), (1,2).
template <class T, int D, int M>
struct Tangent {
  static constexpr int pairs = M * (M - 1) / 2;
  Mat<T, D, D> U;
  Mat<T, M, M> V;
  Mat<T, M, M> stretch;
  T symmetric[pairs], antisymmetric[pairs];
  T normal[D > M ? M : 1];  // unused where M == D
};

template <int M>
constexpr int pair_index(int i, int j) {
  return M == 2 ? 0 : (i < j ? i + j : j + i) - 1;
}

// Cholesky pivots all positive: nothing to mend in the stretch block.
template <class T, int M>
bool all_positive_definite(const Mat<T, M, M>& A) {
  const T d0 = A(0, 0);
  const T d1 = A(1, 1) * d0 - A(0, 1) * A(0, 1);
  if (!all(d0 > T(0)) || !all(d1 > T(0))) return false;
  if constexpr (M == 3) {
    const T l12 = A(1, 2) * d0 - A(0, 1) * A(0, 2);
    const T d2 = (A(2, 2) * d0 - A(0, 2) * A(0, 2)) * d1 - l12 * l12;
    return all(d2 > T(0));
  }
  return true;
}

// Acts on the eigenvalues; the frame stays.
template <class T, int D, int M>
void make_definite(Tangent<T, D, M>& t, Definiteness fix) {
  if (fix == Definiteness::none) return;
  for (int k = 0; k < Tangent<T, D, M>::pairs; ++k) {
    t.symmetric[k] = made_definite(t.symmetric[k], fix);
    t.antisymmetric[k] = made_definite(t.antisymmetric[k], fix);
  }
  if constexpr (D > M)
    for (int i = 0; i < M; ++i) t.normal[i] = made_definite(t.normal[i], fix);
  if (all_positive_definite(t.stretch)) return;
  const SymmetricEigen<T, M> e = symmetric_eigen(t.stretch);
  for (int i = 0; i < M; ++i)
    for (int j = 0; j < M; ++j) {
      T sum = T(0);
      for (int k = 0; k < M; ++k) sum += made_definite(e.values[k], fix) * e.vectors(i, k) * e.vectors(j, k);
      t.stretch(i, j) = sum;
    }
}

// dP = (dP/dF) dF.
template <class T, int D, int M>
Mat<T, D, M> apply(const Tangent<T, D, M>& t, const Mat<T, D, M>& dF) {
  const Mat<T, D, M> a = transpose_times(t.U, dF) * t.V;
  Mat<T, D, M> b;
  for (int i = 0; i < M; ++i) {
    T sum = t.stretch(i, 0) * a(0, 0);
    for (int j = 1; j < M; ++j) sum += t.stretch(i, j) * a(j, j);
    b(i, i) = sum;
  }
  for (int i = 0; i < M - 1; ++i)
    for (int j = i + 1; j < M; ++j) {
      const int k = pair_index<M>(i, j);
      const T even = T(0.5) * t.symmetric[k] * (a(i, j) + a(j, i));
      const T odd = T(0.5) * t.antisymmetric[k] * (a(i, j) - a(j, i));
      b(i, j) = even + odd;
      b(j, i) = even - odd;
    }
  if constexpr (D > M)
    for (int i = 0; i < M; ++i) b(D - 1, i) = t.normal[i] * a(D - 1, i);
  return times_transpose(t.U * b, t.V);
}

// The block K_ij = g_i . (dP/dF) . g_j of two shape gradients [1/m], given in the frame: r_i = V^T g_i. D x D.
template <class T, int D, int M>
Mat<T, D, D> stiffness_block(const Tangent<T, D, M>& t, const T* ri, const T* rj) {
  Mat<T, D, D> k = Mat<T, D, D>::zero();
  for (int a = 0; a < M; ++a) k(a, a) = t.stretch(a, a) * ri[a] * rj[a];
  for (int a = 0; a < M - 1; ++a)
    for (int b = a + 1; b < M; ++b) {
      const int pair = pair_index<M>(a, b);
      const T half_sum = T(0.5) * (t.symmetric[pair] + t.antisymmetric[pair]);
      const T half_difference = T(0.5) * (t.symmetric[pair] - t.antisymmetric[pair]);
      k(a, a) += half_sum * ri[b] * rj[b];
      k(b, b) += half_sum * ri[a] * rj[a];
      k(a, b) = t.stretch(a, b) * ri[a] * rj[b] + half_difference * ri[b] * rj[a];
      k(b, a) = t.stretch(a, b) * ri[b] * rj[a] + half_difference * ri[a] * rj[b];
    }
  if constexpr (D > M) {
    k(D - 1, D - 1) = t.normal[0] * ri[0] * rj[0];
    for (int a = 1; a < M; ++a) k(D - 1, D - 1) += t.normal[a] * ri[a] * rj[a];
  }
  return times_transpose(t.U * k, t.U);
}

}  // namespace sim
