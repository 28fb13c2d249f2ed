// Bilinear quadrilateral. Reference square [-1,1]^2, counter-clockwise from (-1,-1).
#pragma once

#include <array>
#include <string_view>

#include "sim/element/edge2.h"
#include "sim/element/quadrature.h"

namespace sim {

struct Quad4 {
  static constexpr ElementKind kind = ElementKind::quad4;
  static constexpr std::string_view name = "quad4";
  static constexpr int dimension = 2, nodes = 4, corners = 4, order = 1;
  static constexpr bool membrane = false;
  static constexpr double nodes_per_element = 1;
  static constexpr int vtk = 9, gmsh = 3;
  static constexpr auto rule = square_4;
  static constexpr auto mass_rule = square_4;  // N_i N_j has degree 2 in each variable

  using Facet = Edge2;
  static constexpr std::array<int, 8> facets = {0, 1, 1, 2, 2, 3, 3, 0};
  static constexpr std::array<std::array<int, 3>, 4> edges = {{{0, 1, -1}, {1, 2, -1}, {2, 3, -1}, {3, 0, -1}}};
  // Node order that turns the element inside out.
  static constexpr std::array<int, nodes> mirrored = {0, 3, 2, 1};
  static constexpr std::array<std::array<double, 2>, nodes> corner_xi = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

  // N_i = (1 + xi_i xi)(1 + eta_i eta)/4 with (xi_i, eta_i) the corner
  static constexpr std::array<double, nodes> N(const std::array<double, 2>& xi) {
    std::array<double, nodes> N{};
    for (int i = 0; i < nodes; ++i) N[i] = (1 + corner_xi[i][0] * xi[0]) * (1 + corner_xi[i][1] * xi[1]) / 4;
    return N;
  }
  // dN_i/dxi_k
  static constexpr std::array<std::array<double, 2>, nodes> dN(const std::array<double, 2>& xi) {
    std::array<std::array<double, 2>, nodes> dN{};
    for (int i = 0; i < nodes; ++i) {
      const auto& c = corner_xi[i];
      dN[i] = {c[0] * (1 + c[1] * xi[1]) / 4, c[1] * (1 + c[0] * xi[0]) / 4};
    }
    return dN;
  }
};

}  // namespace sim
