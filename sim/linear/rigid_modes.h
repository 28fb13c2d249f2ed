// The coarse space of a preconditioner: the rigid motions of each aggregate of nodes, about where the nodes are now.
//
//   u_i = t + w x d_i,   d_i = (x_i - centre)/radius      (2D: w is a number), zero on components that are not free
//
// Columns t, w of an aggregate are made orthonormal by a triangular T: B' B = L L', T = L^{-T}, Q = B T. A column that
// those before it make up, but for a thousandth of its length, is left out (the turn of two nodes about their line).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/linear/aggregates.h"

namespace sim {

template <int D>
class RigidModes {
 public:
  static constexpr int count = D == 3 ? 6 : 3;
  using Node = Eigen::Matrix<double, D, 1>;
  using Vector = Eigen::Matrix<double, count, 1>;
  using Square = Eigen::Matrix<double, count, count>;
  using Columns = Eigen::Matrix<double, D, count>;

  explicit RigidModes(const Aggregates& aggregates);

  // x: positions, node by node as the system numbers them. free: 0 or 1, in the order of the aggregates.
  void place(const Eigen::VectorXd& x, const Eigen::VectorXd& free, int threads);

  // B at row k (of the aggregates' order), before T and without regard to what is free.
  Columns motion(int k) const;
  const Square& T(int aggregate) const { return T_[aggregate]; }
  bool left_out(int aggregate, int column) const { return T_[aggregate](column, column) == 0; }

  // Q' r of an aggregate; r (in the aggregates' order) is zero where not free.
  Vector restricted(int aggregate, const double* r) const;
  // T y: what the rigid motion at(k, T y) of an aggregate's nodes is made of.
  Vector amplitudes(int aggregate, const double* y) const { return T_[aggregate] * Eigen::Map<const Vector>(y); }
  // B z at row k, without regard to what is free.
  Node at(int k, const Vector& z) const;

  static std::int64_t bytes(std::int64_t rows, std::int64_t aggregates) {
    return rows * D * 4 + aggregates * count * count * 8;
  }

 private:
  void place(int aggregate, const Eigen::VectorXd& x, const Eigen::VectorXd& free);
  Node arm(int k) const { return Eigen::Map<const Eigen::Matrix<float, D, 1>>(&arm_[k * D]).template cast<double>(); }

  const Aggregates& aggregates_;
  std::vector<float> arm_;  // d_i
  std::vector<Square> T_;
};

template <int D>
typename RigidModes<D>::Columns RigidModes<D>::motion(int k) const {
  const Node d = arm(k);
  if constexpr (D == 3)
    return Columns{{1, 0, 0, 0, d[2], -d[1]}, {0, 1, 0, -d[2], 0, d[0]}, {0, 0, 1, d[1], -d[0], 0}};
  else
    return Columns{{1, 0, -d[1]}, {0, 1, d[0]}};
}

template <int D>
typename RigidModes<D>::Node RigidModes<D>::at(int k, const Vector& z) const {
  const Node d = arm(k);
  if constexpr (D == 3)
    return {z[0] + z[4] * d[2] - z[5] * d[1], z[1] + z[5] * d[0] - z[3] * d[2], z[2] + z[3] * d[1] - z[4] * d[0]};
  else
    return {z[0] - z[2] * d[1], z[1] + z[2] * d[0]};
}

template <int D>
typename RigidModes<D>::Vector RigidModes<D>::restricted(int aggregate, const double* r) const {
  Vector sum = Vector::Zero();
  for (int k = aggregates_.start[aggregate]; k < aggregates_.start[aggregate + 1]; ++k) {
    const Node d = arm(k), f = Eigen::Map<const Node>(r + static_cast<std::size_t>(k) * D);
    sum.template head<D>() += f;
    if constexpr (D == 3) {
      sum[3] += d[1] * f[2] - d[2] * f[1];
      sum[4] += d[2] * f[0] - d[0] * f[2];
      sum[5] += d[0] * f[1] - d[1] * f[0];
    } else {
      sum[2] += d[0] * f[1] - d[1] * f[0];
    }
  }
  return T_[aggregate].transpose() * sum;
}

}  // namespace sim
