// Quadratic edge, ends then middle: the facet of tri6. Reference line [-1,1].
#pragma once

#include <array>

#include "sim/element/edge2.h"
#include "sim/element/quadrature.h"

namespace sim {

struct Edge3 {
  using Linear = Edge2;
  static constexpr int dimension = 1, nodes = 3, corners = 2, order = 2;
  static constexpr std::array<std::array<int, 3>, 1> edges = {{{0, 1, 2}}};
  static constexpr auto corner_xi = Edge2::corner_xi;
  static constexpr auto rule = line_3;  // exact for N on straight edges, with one point to spare for curved ones

  // Lagrange polynomials at -1, 1, 0: N_0 = xi (xi - 1)/2, N_1 = xi (xi + 1)/2, N_2 = 1 - xi^2
  static constexpr std::array<double, nodes> N(const std::array<double, 1>& xi) {
    const double x = xi[0];
    return {x * (x - 1) / 2, x * (x + 1) / 2, 1 - x * x};
  }
  // dN_i/dxi
  static constexpr std::array<std::array<double, 1>, nodes> dN(const std::array<double, 1>& xi) {
    return {{{xi[0] - 0.5}, {xi[0] + 0.5}, {-2 * xi[0]}}};
  }
};

}  // namespace sim
