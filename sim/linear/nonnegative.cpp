#include "sim/linear/nonnegative.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>
#include <numeric>

namespace sim {

namespace {

// The columns that have a weight, their products with each other and with b, and their weights.
class Support {
 public:
  Support(const Eigen::MatrixXd& G, const Eigen::VectorXd& b) : G_(G), b_(b) {}

  const std::vector<int>& columns() const { return columns_; }
  const Eigen::VectorXd& weights() const { return w_; }

  void add(int column) {
    const Eigen::Index k = w_.size();
    gram_.conservativeResize(k + 1, k + 1);
    Gb_.conservativeResize(k + 1);
    w_.conservativeResize(k + 1);
    columns_.push_back(column);
    for (Eigen::Index i = 0; i <= k; ++i)
      gram_(i, k) = gram_(k, i) = G_.col(columns_[static_cast<std::size_t>(i)]).dot(G_.col(column));
    Gb_[k] = G_.col(column).dot(b_);
    w_[k] = 0;
  }

  // The best weights; columns that would want a negative one leave, at the place on the way there where theirs is 0.
  void solve() {
    while (w_.size() > 0) {
      const Eigen::VectorXd best = gram_.ldlt().solve(Gb_);
      double a = 1;
      for (Eigen::Index i = 0; i < w_.size(); ++i)
        if (best[i] <= 0) a = std::min(a, w_[i] / (w_[i] - best[i]));
      w_ += a * (best - w_);
      if (a == 1 && best.minCoeff() > 0) return;
      for (Eigen::Index i = w_.size() - 1; i >= 0; --i)
        if (best[i] <= 0 && w_[i] <= 1e-12 * w_.maxCoeff()) remove(i);
    }
  }

  void residual(Eigen::VectorXd& r) const {
    r = b_;
    for (Eigen::Index i = 0; i < w_.size(); ++i) r -= w_[i] * G_.col(columns_[static_cast<std::size_t>(i)]);
  }

 private:
  void remove(Eigen::Index i) {
    std::vector<Eigen::Index> kept;
    for (Eigen::Index k = 0; k < w_.size(); ++k)
      if (k != i) kept.push_back(k);
    gram_ = Eigen::MatrixXd(gram_(kept, kept));
    Gb_ = Eigen::VectorXd(Gb_(kept));
    w_ = Eigen::VectorXd(w_(kept));
    columns_.erase(columns_.begin() + i);
  }

  const Eigen::MatrixXd& G_;
  const Eigen::VectorXd& b_;
  std::vector<int> columns_;
  Eigen::MatrixXd gram_;
  Eigen::VectorXd Gb_, w_;
};

FewWeights sorted(const Support& support, double error) {
  std::vector<std::size_t> order(support.columns().size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return support.columns()[i] < support.columns()[j]; });
  FewWeights few;
  few.error = error;
  for (const std::size_t i : order) {
    few.columns.push_back(support.columns()[i]);
    few.weights.push_back(support.weights()[static_cast<Eigen::Index>(i)]);
  }
  return few;
}

}  // namespace

FewWeights few_nonnegative(const Eigen::MatrixXd& G, const Eigen::VectorXd& b, double tolerance) {
  constexpr double flat = 1e-10;  // of a slope beside the largest that there could be
  Support support(G, b);
  Eigen::VectorXd r = b, slope;
  const double whole = b.norm(), steepest = G.colwise().norm().maxCoeff() * whole;
  double least = std::numeric_limits<double>::infinity();
  const Eigen::Index most = 3 * G.cols();
  for (Eigen::Index k = 0; k < most && r.norm() > tolerance * whole && r.norm() < least; ++k) {
    least = r.norm();
    slope.noalias() = G.transpose() * r;
    for (const int column : support.columns()) slope[column] = 0;
    Eigen::Index next = 0;
    if (!(slope.maxCoeff(&next) > flat * steepest)) break;
    support.add(static_cast<int>(next));
    support.solve();
    support.residual(r);
  }
  return sorted(support, whole > 0 ? r.norm() / whole : 0);
}

}  // namespace sim
