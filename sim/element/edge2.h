// Straight edge with two nodes: the facet of tri3 and quad4. Reference line [-1,1].
#pragma once

#include <array>

#include "sim/element/quadrature.h"

namespace sim {

struct Edge2 {
  static constexpr int dimension = 1, nodes = 2, corners = 2, order = 1;
  static constexpr std::array<std::array<int, 3>, 1> edges = {{{0, 1, -1}}};
  static constexpr std::array<std::array<double, 1>, corners> corner_xi = {{{-1}, {1}}};
  static constexpr auto rule = line_1;  // exact for N

  // N_0 = (1 - xi)/2, N_1 = (1 + xi)/2
  static constexpr std::array<double, nodes> N(const std::array<double, 1>& xi) {
    return {(1 - xi[0]) / 2, (1 + xi[0]) / 2};
  }
  // dN_i/dxi
  static constexpr std::array<std::array<double, 1>, nodes> dN(const std::array<double, 1>&) {
    return {{{-0.5}, {0.5}}};
  }
};

}  // namespace sim
