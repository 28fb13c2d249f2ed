// Groups of near nodes, for the coarse level of a preconditioner: each body's rest positions, halved across their
// longest side again and again.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace sim {

struct Aggregates {
  std::vector<int> order;  // all nodes, aggregate by aggregate
  std::vector<int> start;  // aggregate a has nodes order[start[a]] ... order[start[a+1]-1]

  int count() const { return static_cast<int>(start.size()) - 1; }
};

// About `size` nodes in each. X: D numbers per node; body k has nodes first_node[k] ... first_node[k+1]-1, and no
// aggregate has nodes of two bodies. The same for the same positions on any machine: ties go by node number.
Aggregates bisect(const Eigen::VectorXd& X, int D, std::span<const int> first_node, int size);

}  // namespace sim
