#include "sim/residual/low_dimensional.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace sim::residual {

// The last s_i <= j/(n + 1)
std::vector<int> equal_rows(int N, int n) {
  std::vector<int> rows;
  for (int j = 1; j <= n; ++j) rows.push_back(j * (N + 1) / (n + 1) - 1);
  return rows;
}

std::vector<int> first_rows(int n) {
  std::vector<int> rows(n);
  std::iota(rows.begin(), rows.end(), 0);
  return rows;
}

std::vector<int> pivoted_rows(const Eigen::MatrixXd& AU) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(AU.transpose());
  const auto& order = qr.colsPermutation().indices();
  std::vector<int> rows(order.data(), order.data() + AU.cols());
  std::ranges::sort(rows);
  return rows;
}

Eigen::VectorXd solve_rows(const Chain& chain, const Eigen::MatrixXd& U, const std::vector<int>& rows) {
  const Eigen::MatrixXd AU = matrix(chain) * U;
  return AU(rows, Eigen::indexing::all).partialPivLu().solve(chain.b(rows));
}

Eigen::VectorXd solve_least_squares(const Chain& chain, const Eigen::MatrixXd& U) {
  return (matrix(chain) * U).colPivHouseholderQr().solve(chain.b);
}

Eigen::VectorXd solve_galerkin(const Chain& chain, const Eigen::MatrixXd& U) {
  return (U.transpose() * (matrix(chain) * U)).partialPivLu().solve(U.transpose() * chain.b);
}

// With K = sqrt(k) stretches(U) the energy is |K c|^2/2 - (U^T b).c, and K^T K c = U^T b by Cholesky.
Eigen::VectorXd solve_energy(const Chain& chain, const Eigen::MatrixXd& U) {
  const Eigen::MatrixXd K = chain.springs.cwiseSqrt().asDiagonal() * stretches(U);
  return (K.transpose() * K).llt().solve(U.transpose() * chain.b);
}

Eigen::VectorXd project(const Eigen::VectorXd& x, const Eigen::MatrixXd& U) {
  return U.colPivHouseholderQr().solve(x);
}

Eigen::VectorXd solve(const Chain& chain) {
  return matrix(chain).partialPivLu().solve(chain.b);
}

// e.A e is the energy of the springs: the part of the wind in A is antisymmetric.
ChainErrors measure(const Chain& chain, const Eigen::VectorXd& x, const Eigen::VectorXd& approximation) {
  const Eigen::VectorXd e = approximation - x;
  const double energy = chain.springs.dot(stretches(e).cwiseAbs2().col(0));
  return {(matrix(chain) * approximation - chain.b).norm(), std::sqrt(energy), e.norm(), e.cwiseAbs().maxCoeff()};
}

}  // namespace sim::residual
