// Eigenvalues and vectors of a symmetric 2 x 2 or 3 x 3 matrix by cyclic Jacobi rotations, in lanes.
#pragma once

#include "sim/math/svd.h"

namespace sim {

template <class T, int M>
struct SymmetricEigen {
  T values[M];
  Mat<T, M, M> vectors;  // in columns
};

// A <- R^T A R for the rotation of columns p, q.
template <class T, int M>
void rotate_rows(Mat<T, M, M>& A, int p, int q, const T& c, const T& s) {
  for (int j = 0; j < M; ++j) {
    const T ap = A(p, j), aq = A(q, j);
    A(p, j) = c * ap - s * aq;
    A(q, j) = s * ap + c * aq;
  }
}

// Off-diagonal entries are below 1e-14 of the largest entry of the diagonal.
template <class T, int M>
bool is_diagonal(const Mat<T, M, M>& A) {
  T largest = absolute(A(0, 0)), off = T(0);
  for (int i = 0; i < M; ++i) {
    largest = maximum(largest, absolute(A(i, i)));
    for (int j = i + 1; j < M; ++j) off = maximum(off, absolute(A(i, j)));
  }
  return all(off <= T(1e-14) * largest);
}

template <class T, int M>
SymmetricEigen<T, M> symmetric_eigen(Mat<T, M, M> A) {
  SymmetricEigen<T, M> r;
  r.vectors = Mat<T, M, M>::identity();
  for (int sweep = 0; sweep < 6 && !is_diagonal(A); ++sweep)
    for (int p = 0; p < M - 1; ++p)
      for (int q = p + 1; q < M; ++q) {
        T c, s;
        jacobi_rotation(A(p, p), A(q, q), A(p, q), c, s);
        rotate_columns(A, p, q, c, s);
        rotate_rows(A, p, q, c, s);
        rotate_columns(r.vectors, p, q, c, s);
      }
  for (int i = 0; i < M; ++i) r.values[i] = A(i, i);
  return r;
}

}  // namespace sim
