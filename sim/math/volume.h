// J and dJ/dF: the ratio of volumes, or of areas where F is 3 x 2 (a membrane).
#pragma once

#include "sim/math/lanes.h"
#include "sim/math/mat.h"

namespace sim {

// J = det F, dJ/dF = cof F
template <class T, int D>
void volume_ratio(const Mat<T, D, D>& F, T& J, Mat<T, D, D>& dJ) {
  dJ = cofactor(F);
  J = F(0, 0) * dJ(0, 0);
  for (int j = 1; j < D; ++j) J += F(0, j) * dJ(0, j);
}

// J = sqrt(det C), C = F^T F; dJ/dF = F adj(C) / J. At J = 0 there is a kink; dJ is bounded there.
template <class T>
void volume_ratio(const Mat<T, 3, 2>& F, T& J, Mat<T, 3, 2>& dJ) {
  const Mat<T, 2, 2> C = transpose_times(F, F);
  const Mat<T, 2, 2> adjugate = {{{C(1, 1), -C(0, 1)}, {-C(1, 0), C(0, 0)}}};
  J = square_root(maximum(determinant(C), T(0)));
  dJ = (T(1) / maximum(J, T(1e-12))) * (F * adjugate);
}

template <class T, int D>
T volume_ratio(const Mat<T, D, D>& F) {
  return determinant(F);
}
template <class T>
T volume_ratio(const Mat<T, 3, 2>& F) {
  return square_root(maximum(determinant(transpose_times(F, F)), T(0)));
}

}  // namespace sim
