#include "sim/residual/chain.h"

#include <cmath>
#include <numbers>

namespace sim::residual {

Eigen::VectorXd Chain::places() const {
  return Eigen::VectorXd::LinSpaced(size(), 1, static_cast<double>(size())) * spacing();
}

Chain make_chain(int N, const std::function<double(double)>& stiffness, const std::function<double(double)>& load,
                 double wind) {
  Chain chain{Eigen::VectorXd(N + 1), wind, Eigen::VectorXd(N)};
  const double h = chain.spacing();
  for (int i = 0; i <= N; ++i) chain.springs[i] = stiffness((i + 0.5) * h) / (h * h);
  chain.b = chain.places().unaryExpr(load);
  return chain;
}

Eigen::MatrixXd matrix(const Chain& chain) {
  const Eigen::Index N = chain.size();
  const double drift = chain.wind / (2 * chain.spacing());
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(N, N);
  for (Eigen::Index i = 0; i < N; ++i) {
    A(i, i) = chain.springs[i] + chain.springs[i + 1];
    if (i > 0) A(i, i - 1) = -chain.springs[i] - drift;
    if (i + 1 < N) A(i, i + 1) = -chain.springs[i + 1] + drift;
  }
  return A;
}

Eigen::MatrixXd stretches(const Eigen::MatrixXd& x) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(x.rows() + 1, x.cols());
  result.topRows(x.rows()) = x;
  result.bottomRows(x.rows()) -= x;
  return result;
}

Eigen::MatrixXd power_vectors(const Chain& chain, int n) {
  const Eigen::ArrayXd s = chain.places();
  Eigen::MatrixXd U(chain.size(), n);
  for (int j = 0; j < n; ++j) U.col(j) = s.pow(j + 1) * (1 - s);
  return U;
}

Eigen::MatrixXd sine_vectors(const Chain& chain, int n) {
  const Eigen::ArrayXd s = chain.places();
  Eigen::MatrixXd U(chain.size(), n);
  for (int j = 0; j < n; ++j) U.col(j) = ((j + 1) * std::numbers::pi * s).sin();
  return U;
}

}  // namespace sim::residual
