#include "sim/study/unit_costs.h"

#include <Eigen/QR>
#include <algorithm>
#include <limits>
#include <vector>

namespace sim {
namespace {

constexpr int kinds = 4;
using Row = Eigen::Matrix<double, 1, kinds>;

Row row_of(const TimedStep& step) {
  const StepCounts& c = step.counts;
  return Row(c.steps, c.force_evaluations, c.factorisations, c.linear) / step.seconds;
}

// Least squares with no negative cost: the best of all sets of kinds that may cost something, each solved by itself.
UnitCosts fitted(const std::vector<TimedStep>& steps) {
  Eigen::MatrixXd A(steps.size(), kinds);
  for (std::size_t k = 0; k < steps.size(); ++k) A.row(static_cast<Eigen::Index>(k)) = row_of(steps[k]);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(A.rows());
  Eigen::Vector4d best = Eigen::Vector4d::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (int set = 1; set < 1 << kinds; ++set) {
    // Columns outside the set are zero, and so is what the solution of least norm says of them.
    Eigen::MatrixXd of_set = A;
    for (int c = 0; c < kinds; ++c)
      if ((set >> c & 1) == 0) of_set.col(c).setZero();
    const Eigen::Vector4d u = of_set.completeOrthogonalDecomposition().solve(ones);
    const double residual = (of_set * u - ones).squaredNorm(), round_off = 1e-12 * u.cwiseAbs().maxCoeff();
    if (!(u.minCoeff() >= -round_off) || !(residual < least)) continue;
    least = residual;
    best = u.cwiseMax(0);
  }
  return {best[0], best[1], best[2], best[3]};
}

}  // namespace

double pace(std::span<const TimedStep> steps, const UnitCosts& costs) {
  std::vector<double> ratios;
  for (const TimedStep& step : steps)
    if (step.seconds > 0 && costs.of(step.counts) > 0) ratios.push_back(step.seconds / costs.of(step.counts));
  if (ratios.empty()) return 1;
  const auto quarter = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 4);
  std::nth_element(ratios.begin(), quarter, ratios.end());
  return *quarter;
}

UnitCosts unit_costs(std::span<const TimedStep> steps) {
  constexpr double held_up = 1.25;
  std::vector<TimedStep> used;
  for (const TimedStep& step : steps)
    if (step.seconds > 0) used.push_back(step);
  if (used.empty()) return {};
  UnitCosts costs = fitted(used);
  const double limit = held_up * pace(used, costs);
  std::erase_if(used, [&](const TimedStep& step) { return step.seconds > limit * costs.of(step.counts); });
  costs = fitted(used);
  return costs * pace(used, costs);
}

}  // namespace sim
