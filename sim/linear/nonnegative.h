// Least squares with weights that are not negative, and few of them: min |G w - b|, w >= 0 [Lawson & Hanson 1974],
// ended as soon as the residual is small enough, so that only some of the weights are not 0 [Farhat et al. 2015].
#pragma once

#include <Eigen/Core>
#include <vector>

namespace sim {

struct FewWeights {
  std::vector<int> columns;  // of G, rising
  std::vector<double> weights;
  double error = 0;  // |G w - b| / |b|
};

// Ends at |G w - b| <= tolerance |b|, or where no other column would bring it down.
FewWeights few_nonnegative(const Eigen::MatrixXd& G, const Eigen::VectorXd& b, double tolerance);

}  // namespace sim
