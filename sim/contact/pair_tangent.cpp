#include "sim/contact/pair_tangent.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace sim {

namespace {

template <int N>
Eigen::Matrix<double, N, N> clamp(const Eigen::Matrix<double, N, N>& A) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> eigen(A);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() * eigen.eigenvectors().transpose();
}

// The columns c (x) n, c_k (x) n, c (x) t.
using Range = Eigen::Matrix<double, 12, 5>;
using Small = Eigen::Matrix<double, 5, 5>;

Range range_of(const Distance& at, const Vec3* t) {
  Range V = Range::Zero();
  for (int i = 0; i < at.nodes; ++i) {
    V.block<3, 1>(3 * i, 0) = at.c[i] * at.n;
    for (int k = 0; k < at.parameters; ++k) V.block<3, 1>(3 * i, 1 + k) = at.c_k[k][i] * at.n;
    for (int k = 0; k < 2; ++k) V.block<3, 1>(3 * i, 3 + k) = at.c[i] * t[k];
  }
  return V;
}

// H = V S V^T, with B_k = d (c_k (x) n) + sum_t (w_k . t) (c (x) t)
Small in_range(const Distance& at, const Vec3* t, double first, double second) {
  Small S = Small::Zero();
  Eigen::Matrix<double, 5, 2> B = Eigen::Matrix<double, 5, 2>::Zero();
  for (int k = 0; k < at.parameters; ++k) {
    B(1 + k, k) = at.d;
    for (int j = 0; j < 2; ++j) B(3 + j, k) = at.w_k[k].dot(t[j]);
  }
  S = -first / at.d * B * at.inverse_G * B.transpose();
  S(0, 0) += second;
  for (int j = 0; j < 2; ++j) S(3 + j, 3 + j) += first / at.d;
  return S;
}

}  // namespace

PairMatrix without_negative_part(const PairMatrix& A) {
  return clamp<12>(A);
}

PairMatrix pair_tangent(const Distance& at, double first, double second, Definiteness fix) {
  const PairVector g = at.gradient();
  if (fix == Definiteness::none) return second * g * g.transpose() + first * at.hessian();
  const Vec3 t0 = at.n.unitOrthogonal(), t[2] = {t0, at.n.cross(t0)};
  const Range V = range_of(at, t);
  const Small S = in_range(at, t, first, second);
  // Orthonormal coordinates of the range, from its Gram matrix; a parameter that there is not has a column of zeros.
  Small gram = V.transpose() * V;
  for (int k = at.parameters; k < 2; ++k) gram(1 + k, 1 + k) = 1;
  const Eigen::LLT<Small> llt(gram);
  const Small L = llt.matrixL();
  const Small inner = clamp<5>(L.transpose() * S * L);
  const Eigen::Matrix<double, 5, 12> Q = L.triangularView<Eigen::Lower>().solve(V.transpose());
  return Q.transpose() * inner * Q;
}

}  // namespace sim
