// Singular values with the signed convention of mathematics.md 3: F = U diag(s) V^T, det V = +1, det U = +1, and where
// F is square the last s carries the sign of det F. One-sided Jacobi [Hestenes 1958]: columns of B = F V are rotated
// until they are orthogonal; small singular values keep their relative accuracy. Branch-free in the lanes.
#pragma once

#include "sim/math/lanes.h"
#include "sim/math/mat.h"

namespace sim {

template <class T, int D, int M>
struct Svd {
  Mat<T, D, D> U;  // the last column is the unit normal where M < D
  T s[M];          // |s_0| >= |s_1| >= ...
  Mat<T, M, M> V;
};

// (columns p, q) <- (columns p, q) rotated by cosine c and sine s.
template <class T, int R, int C>
void rotate_columns(Mat<T, R, C>& A, int p, int q, const T& c, const T& s) {
  for (int i = 0; i < R; ++i) {
    const T ap = A(i, p), aq = A(i, q);
    A(i, p) = c * ap - s * aq;
    A(i, q) = s * ap + c * aq;
  }
}

template <class T, int R, int C>
T dot_columns(const Mat<T, R, C>& A, int p, int q) {
  T sum = A(0, p) * A(0, q);
  for (int i = 1; i < R; ++i) sum += A(i, p) * A(i, q);
  return sum;
}

// The rotation by theta, |theta| <= pi/4, that makes a symmetric 2 x 2 matrix [app apq; apq aqq] nearly diagonal:
//   tan 2 theta = y/x,  x = |aqq - app|,  y = 2 apq with the sign of aqq - app
//   tan theta/2 ~ n/m,  n = y (x + b |y|),  m = 4 x^2 + 4 b x |y| + 5/4 y^2,  b = 5/4 tan pi/8
// The quotient has the exact limits at y = 0 (to third order) and x = 0, and is at most 5 per cent off between; cosine
// and sine of the half-angle formulas are those of a rotation whatever it is, and cost one division and no root. What
// is left off the diagonal is for the next sweep. Below 1e-25 or so nothing is rotated.
template <class T>
void jacobi_rotation(const T& app, const T& aqq, const T& apq, T& c, T& s) {
  constexpr double b = 1.25 * 0.41421356237309503;
  const T d = aqq - app, x = absolute(d), y = with_sign(T(2), d) * apq, size_y = absolute(y);
  const T n = y * (x + T(b) * size_y), m = T(4) * x * (x + T(b) * size_y) + T(1.25) * y * y;
  const T nn = n * n, mm = m * m, sum = mm + nn;
  const auto rotated = sum > T(1e-200);
  const T over = T(1) / select(rotated, sum, T(1));
  c = select(rotated, (mm - nn) * over, T(1));
  s = select(rotated, (m + m) * n * over, T(0));
}

// Columns of B are orthogonal to 1e-14 of their lengths.
template <class T, int D, int M>
bool columns_orthogonal(const Mat<T, D, M>& B) {
  for (int p = 0; p < M - 1; ++p)
    for (int q = p + 1; q < M; ++q) {
      const T apq = dot_columns(B, p, q);
      if (!all(apq * apq <= T(1e-28) * dot_columns(B, p, p) * dot_columns(B, q, q))) return false;
    }
  return true;
}

// Makes the columns of B orthogonal, V collects the rotations. Three or four sweeps as a rule, at most 8.
template <class T, int D, int M>
void orthogonalise_columns(Mat<T, D, M>& B, Mat<T, M, M>& V) {
  for (int sweep = 0; sweep < 8 && !columns_orthogonal(B); ++sweep)
    for (int p = 0; p < M - 1; ++p)
      for (int q = p + 1; q < M; ++q) {
        T c, s;
        jacobi_rotation(dot_columns(B, p, p), dot_columns(B, q, q), dot_columns(B, p, q), c, s);
        rotate_columns(B, p, q, c, s);
        rotate_columns(V, p, q, c, s);
      }
}

// Sorts the columns of B by falling length; a swap negates one column so that det V stays +1.
template <class T, int D, int M>
void sort_columns(Mat<T, D, M>& B, Mat<T, M, M>& V) {
  const auto order = [&](int p, int q) {
    const auto swap = dot_columns(B, p, p) < dot_columns(B, q, q);
    const T c = select(swap, T(0), T(1)), s = select(swap, T(1), T(0));
    rotate_columns(B, p, q, c, s);
    rotate_columns(V, p, q, c, s);
  };
  order(0, 1);
  if constexpr (M == 3) {
    order(0, 2);
    order(1, 2);
  }
}

// Column k of U: column k of B made orthogonal to the columns before it and normalised. Where nothing is left of it,
// it is the axis least along the columns before, made orthogonal to them.
template <class T, int D, int M>
void complete_column(Mat<T, D, D>& U, const Mat<T, D, M>& B, int k, const T& scale) {
  T u[D];
  for (int i = 0; i < D; ++i) u[i] = B(i, k);
  const auto project = [&] {
    for (int j = 0; j < k; ++j) {
      T along = u[0] * U(0, j);
      for (int i = 1; i < D; ++i) along += u[i] * U(i, j);
      for (int i = 0; i < D; ++i) u[i] -= along * U(i, j);
    }
    T length2 = u[0] * u[0];
    for (int i = 1; i < D; ++i) length2 += u[i] * u[i];
    return square_root(length2);
  };
  T length = project();
  const auto lost = length <= T(1e-200) + T(1e-14) * scale;
  if (!all(!lost)) {
    T used[D], least = T(2);
    for (int i = 0; i < D; ++i) {
      used[i] = T(0);
      for (int j = 0; j < k; ++j) used[i] += U(i, j) * U(i, j);
      least = select(used[i] < least, used[i], least);
    }
    auto free = lost;
    for (int i = 0; i < D; ++i) {
      const auto take = free && used[i] <= least;
      u[i] = select(lost, select(take, T(1), T(0)), u[i]);
      free = free && !take;
    }
    length = project();
  }
  const T inverse = T(1) / length;
  for (int i = 0; i < D; ++i) U(i, k) = u[i] * inverse;
}

template <class T, int D, int M>
Svd<T, D, M> svd(const Mat<T, D, M>& F) {
  Svd<T, D, M> r;
  Mat<T, D, M> B = F;
  r.V = Mat<T, M, M>::identity();
  orthogonalise_columns(B, r.V);
  sort_columns(B, r.V);
  const T scale = square_root(dot_columns(B, 0, 0));
  complete_column(r.U, B, 0, scale);
  if constexpr (D == 2) {
    r.U(0, 1) = -r.U(1, 0);
    r.U(1, 1) = r.U(0, 0);
  } else {
    complete_column(r.U, B, 1, scale);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      r.U(i, 2) = r.U(j, 0) * r.U(k, 1) - r.U(k, 0) * r.U(j, 1);
    }
  }
  for (int k = 0; k < M; ++k) {
    r.s[k] = r.U(0, k) * B(0, k);
    for (int i = 1; i < D; ++i) r.s[k] += r.U(i, k) * B(i, k);
  }
  return r;
}

}  // namespace sim
