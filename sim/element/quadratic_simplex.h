// Shape functions of a quadratic simplex from those of the linear one, L_i (its barycentric coordinates):
//   corners N_i = L_i (2 L_i - 1), middle of edge ab N = 4 L_a L_b   [Zienkiewicz & Taylor, The Finite Element Method]
#pragma once

#include <array>

namespace sim {

template <class Quadratic, class LinearSimplex>
struct QuadraticSimplex {
  using Linear = LinearSimplex;
  static constexpr int dim = Linear::dimension;
  static constexpr int node_count = Linear::nodes + static_cast<int>(Linear::edges.size());

  static constexpr std::array<double, node_count> N(const std::array<double, dim>& xi) {
    const auto L = Linear::N(xi);
    std::array<double, node_count> N{};
    for (int i = 0; i < Linear::nodes; ++i) N[i] = L[i] * (2 * L[i] - 1);
    for (const auto& [a, b, middle] : Quadratic::edges) N[middle] = 4 * L[a] * L[b];
    return N;
  }

  // dN_i/dxi_k
  static constexpr std::array<std::array<double, dim>, node_count> dN(const std::array<double, dim>& xi) {
    const auto L = Linear::N(xi);
    const auto dL = Linear::dN(xi);
    std::array<std::array<double, dim>, node_count> dN{};
    for (int k = 0; k < dim; ++k) {
      for (int i = 0; i < Linear::nodes; ++i) dN[i][k] = (4 * L[i] - 1) * dL[i][k];
      for (const auto& [a, b, middle] : Quadratic::edges) dN[middle][k] = 4 * (dL[a][k] * L[b] + L[a] * dL[b][k]);
    }
    return dN;
  }
};

}  // namespace sim
