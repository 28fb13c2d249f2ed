#include "sim/linear/aggregates.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sim {

namespace {

// The axis along which these nodes reach furthest.
int longest_side(const Eigen::VectorXd& X, int D, std::span<const int> nodes) {
  Eigen::VectorXd low = X.segment(static_cast<Eigen::Index>(nodes[0]) * D, D), high = low;
  for (const int node : nodes) {
    const auto x = X.segment(static_cast<Eigen::Index>(node) * D, D);
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  return axis;
}

// Divides the nodes into `parts` of nearly equal count, one after the other; their ends go to `start`.
void divide(const Eigen::VectorXd& X, int D, std::span<int> nodes, int parts, std::vector<int>& start) {
  if (parts <= 1) {
    start.push_back(start.back() + static_cast<int>(nodes.size()));
    return;
  }
  const int left = parts / 2, axis = longest_side(X, D, nodes);
  const std::size_t half = nodes.size() * left / parts;
  const auto before = [&](int a, int b) {
    const double xa = X[static_cast<Eigen::Index>(a) * D + axis], xb = X[static_cast<Eigen::Index>(b) * D + axis];
    return xa < xb || (xa == xb && a < b);
  };
  std::nth_element(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(half), nodes.end(), before);
  divide(X, D, nodes.first(half), left, start);
  divide(X, D, nodes.subspan(half), parts - left, start);
}

}  // namespace

Aggregates bisect(const Eigen::VectorXd& X, int D, std::span<const int> first_node, int size) {
  Aggregates result;
  result.order.resize(first_node.back());
  std::iota(result.order.begin(), result.order.end(), 0);
  result.start.push_back(0);
  for (std::size_t body = 0; body + 1 < first_node.size(); ++body) {
    const int count = first_node[body + 1] - first_node[body];
    if (count == 0) continue;
    const auto nodes = std::span<int>(result.order).subspan(first_node[body], count);
    divide(X, D, nodes, std::max(1, static_cast<int>(std::lround(static_cast<double>(count) / size))), result.start);
  }
  // Which of equal halves nth_element leaves where depends on the library: by number within an aggregate.
  for (int a = 0; a < result.count(); ++a)
    std::sort(result.order.begin() + result.start[a], result.order.begin() + result.start[a + 1]);
  return result;
}

}  // namespace sim
