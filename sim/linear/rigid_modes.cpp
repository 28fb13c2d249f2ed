#include "sim/linear/rigid_modes.h"

#include <cmath>

namespace sim {

namespace {

// T with T' G T = 1 on the columns that are kept, 0 on the others; upper triangular.
template <class Square>
Square orthonormalise(const Square& G) {
  constexpr double least = 1e-3;  // of its length that a column must keep
  const Eigen::Index n = G.rows();
  Square L = Square::Zero(), T = Square::Zero();
  for (Eigen::Index j = 0; j < n; ++j) {
    const double rest = G(j, j) - L.row(j).head(j).squaredNorm();
    if (!(rest > least * least * G(j, j))) {
      L.row(j).setZero();
      continue;
    }
    L(j, j) = std::sqrt(rest);
    for (Eigen::Index i = j + 1; i < n; ++i) L(i, j) = (G(i, j) - L.row(i).head(j).dot(L.row(j).head(j))) / L(j, j);
  }
  // L' T = 1, row by row from below, on the columns that are kept.
  for (Eigen::Index j = 0; j < n; ++j) {
    if (L(j, j) == 0) continue;
    T(j, j) = 1 / L(j, j);
    for (Eigen::Index i = j - 1; i >= 0; --i) {
      if (L(i, i) == 0) continue;
      double sum = 0;
      for (Eigen::Index k = i + 1; k <= j; ++k) sum += L(k, i) * T(k, j);
      T(i, j) = -sum / L(i, i);
    }
  }
  return T;
}

}  // namespace

template <int D>
RigidModes<D>::RigidModes(const Aggregates& aggregates)
    : aggregates_(aggregates), arm_(aggregates.order.size() * D), T_(aggregates.count()) {}

template <int D>
void RigidModes<D>::place(const Eigen::VectorXd& x, const Eigen::VectorXd& free, int threads) {
#pragma omp parallel for schedule(static) num_threads(threads)
  for (int a = 0; a < aggregates_.count(); ++a) place(a, x, free);
}

template <int D>
void RigidModes<D>::place(int aggregate, const Eigen::VectorXd& x, const Eigen::VectorXd& free) {
  const int first = aggregates_.start[aggregate], last = aggregates_.start[aggregate + 1];
  const auto position = [&](int k) { return x.segment<D>(static_cast<Eigen::Index>(aggregates_.order[k]) * D); };
  Node centre = Node::Zero();
  for (int k = first; k < last; ++k) centre += position(k);
  centre /= last - first;
  double radius = 0;
  for (int k = first; k < last; ++k) radius = std::max(radius, (position(k) - centre).norm());
  Square G = Square::Zero();
  for (int k = first; k < last; ++k) {
    Node d = Node::Zero();
    if (radius > 0) d = (position(k) - centre) / radius;
    for (int c = 0; c < D; ++c) arm_[k * D + c] = static_cast<float>(d[c]);
    const Columns B = free.segment<D>(static_cast<Eigen::Index>(k) * D).asDiagonal() * motion(k);
    G.noalias() += B.transpose() * B;
  }
  T_[aggregate] = orthonormalise(G);
}

template class RigidModes<2>;
template class RigidModes<3>;

}  // namespace sim
