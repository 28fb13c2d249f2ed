// Makes the batches of a region from its rest mesh: node numbers, shape gradients, weights.
#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <numeric>

#include "sim/mesh/geometry.h"
#include "sim/term/elastic.h"
#include "sim/term/element_batches.h"

namespace sim {

// Rest geometry at one quadrature point: G (nodes x M) [1/m], w [m^3 with the thickness], the frame [T n].
template <class Element, int D>
struct RestPoint {
  static constexpr int M = Element::dimension;
  Eigen::Matrix<double, Element::nodes, M> G;
  Eigen::Matrix<double, D, D> frame = Eigen::Matrix<double, D, D>::Identity();
  double w = 0;

  RestPoint(const Eigen::Matrix<double, D, Element::nodes>& X_e, const QuadraturePoint<M>& q, double thickness) {
    const auto dN_array = Element::dN(q.xi);
    Eigen::Matrix<double, Element::nodes, M> dN;
    for (int a = 0; a < Element::nodes; ++a)
      for (int m = 0; m < M; ++m) dN(a, m) = dN_array[a][m];
    const Eigen::Matrix<double, D, M> dX = X_e * dN;  // dX/dxi
    Eigen::Matrix<double, M, M> J;                    // the same in the frame
    if constexpr (D == M) {
      J = dX;
    } else {
      const Eigen::Vector3d t1 = dX.col(0).normalized();
      const Eigen::Vector3d n = dX.col(0).cross(dX.col(1)).normalized();
      frame << t1, n.cross(t1), n;
      J = (frame.transpose() * dX).template topRows<M>();
    }
    G = dN * J.inverse();
    w = q.weight * std::abs(J.determinant()) * (M == 3 ? 1.0 : thickness);
  }
};

// `framed`: the material knows directions, so the rest frames are kept too.
template <class Element, int D>
ElementBatches<Element, D> build_batches(const ElasticInput& input, bool framed) {
  using Batches = ElementBatches<Element, D>;
  constexpr int N = Batches::N, M = Batches::M, Q = Batches::Q;
  const Mesh& mesh = input.body.mesh;
  Batches b;
  b.count = static_cast<int>(input.elements.size());
  const int batches = (b.count + lane_count - 1) / lane_count;
  b.node.resize(static_cast<std::size_t>(batches) * N * lane_count);
  b.gradient.resize(static_cast<std::size_t>(batches) * Q * (N - 1) * M);
  b.weight.resize(static_cast<std::size_t>(batches) * Q);
  if (framed) b.frame.resize(static_cast<std::size_t>(batches) * Q);
  for (int e = 0; e < batches * lane_count; ++e) {
    const int batch = e / lane_count, lane = e % lane_count;
    const int number = input.elements[std::min(e, b.count - 1)];
    b.element.push_back(number);
    // F = x_e G and f_e = -w P G^T know no order of the nodes: rising numbers put every block in the upper half.
    std::array<int, N> order;
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](int i, int j) { return mesh.elements(i, number) < mesh.elements(j, number); });
    Eigen::Matrix<double, D, N> X_e = Eigen::Matrix<double, D, N>::Zero();
    for (int a = 0; a < N; ++a) {
      X_e.col(a).head(mesh.dimension()) = mesh.X.col(mesh.elements(a, number));
      b.node[(static_cast<std::size_t>(batch) * N + a) * lane_count + lane] =
          input.first_node + mesh.elements(order[a], number);
    }
    for (int q = 0; q < Q; ++q) {
      const RestPoint<Element, D> rest(X_e, Element::rule[q], input.body.thickness);
      const std::size_t point = static_cast<std::size_t>(batch) * Q + q;
      for (int a = 1; a < N; ++a)
        for (int m = 0; m < M; ++m) b.gradient[(point * (N - 1) + a - 1) * M + m][lane] = rest.G(order[a], m);
      const double counted = input.counts.empty() || e >= b.count ? 1 : input.counts[static_cast<std::size_t>(e)];
      b.weight[point][lane] = e < b.count ? counted * rest.w : 0.0;
      if (framed)
        for (int i = 0; i < D; ++i)
          for (int j = 0; j < D; ++j) b.frame[point](i, j)[lane] = rest.frame(i, j);
    }
  }
  b.chunks = std::make_unique<Chunks>(b.node, N * lane_count, input.node_count);
  return b;
}

}  // namespace sim
