#include "sim/math/svd.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sim/math/symmetric_eigen.h"

namespace sim {
namespace {

template <int D, int M>
Mat<double, D, M> random_matrix(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Mat<double, D, M> A;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < M; ++j) A(i, j) = normal(random);
  return A;
}

template <int D, int M>
void expect_factors(const Mat<double, D, M>& F, double scale) {
  const Svd<double, D, M> r = svd(F);
  const Mat<double, D, D> UtU = transpose_times(r.U, r.U);
  const Mat<double, M, M> VtV = transpose_times(r.V, r.V);
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) EXPECT_NEAR(UtU(i, j), i == j, 1e-13);
  for (int i = 0; i < M; ++i)
    for (int j = 0; j < M; ++j) EXPECT_NEAR(VtV(i, j), i == j, 1e-13);
  EXPECT_NEAR(determinant(r.V), 1, 1e-13);
  EXPECT_NEAR(determinant(r.U), 1, 1e-13);
  for (int k = 0; k + 1 < M; ++k) EXPECT_GE(std::abs(r.s[k]), std::abs(r.s[k + 1]) - 1e-13 * scale);
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < M; ++j) {
      double sum = 0;
      for (int k = 0; k < M; ++k) sum += r.U(i, k) * r.s[k] * r.V(j, k);
      EXPECT_NEAR(sum, F(i, j), 1e-13 * scale);
    }
  if constexpr (D == M) {
    double J = 1;
    for (int k = 0; k < M; ++k) {
      J *= r.s[k];
      if (k + 1 < M) {
        EXPECT_GE(r.s[k], 0);
      }
    }
    EXPECT_NEAR(J, determinant(F), 1e-12 * std::pow(scale, D));
  }
}

TEST(Svd, ReproducesRandomMatrices) {
  std::mt19937 random(1);
  for (int k = 0; k < 300; ++k) {
    expect_factors(random_matrix<2, 2>(random), 3);
    expect_factors(random_matrix<3, 2>(random), 3);
    expect_factors(random_matrix<3, 3>(random), 3);
  }
}

TEST(Svd, TakesRankDeficientAndExtremeMatrices) {
  expect_factors(Mat<double, 3, 3>::zero(), 1);
  expect_factors(Mat<double, 2, 2>::zero(), 1);
  expect_factors(Mat<double, 3, 2>::zero(), 1);
  expect_factors(Mat<double, 3, 3>::identity(), 1);
  expect_factors(-1.0 * Mat<double, 3, 3>::identity(), 1);
  expect_factors(Mat<double, 3, 3>{{{1, 2, 3}, {2, 4, 6}, {3, 6, 9}}}, 14);  // a line
  expect_factors(Mat<double, 3, 3>{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}, 1);   // a plane
  expect_factors(Mat<double, 3, 3>{{{1e9, 0, 0}, {0, 1, 0}, {0, 0, 1e-9}}}, 1e9);
  expect_factors(Mat<double, 3, 2>{{{1, 1}, {1, 1}, {1, 1}}}, 2);
}

TEST(Svd, LanesGiveWhatDoubleGives) {
  std::mt19937 random(2);
  Mat<double, 3, 3> F[lane_count];
  Mat<Lanes, 3, 3> batch;
  for (int k = 0; k < lane_count; ++k) {
    F[k] = k == 1 ? Mat<double, 3, 3>::zero() : random_matrix<3, 3>(random);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) batch(i, j)[k] = F[k](i, j);
  }
  const Svd<Lanes, 3, 3> r = svd(batch);
  for (int k = 0; k < lane_count; ++k)
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(r.s[i][k], svd(F[k]).s[i], 1e-13);
}

TEST(SymmetricEigen, ReproducesTheMatrix) {
  std::mt19937 random(3);
  for (int n = 0; n < 100; ++n) {
    const Mat<double, 3, 3> B = random_matrix<3, 3>(random), A = B + transpose(B);
    const SymmetricEigen<double, 3> e = symmetric_eigen(A);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        double sum = 0;
        for (int k = 0; k < 3; ++k) sum += e.vectors(i, k) * e.values[k] * e.vectors(j, k);
        EXPECT_NEAR(sum, A(i, j), 1e-13);
      }
  }
}

}  // namespace
}  // namespace sim
