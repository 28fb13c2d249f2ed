// Trilinear hexahedron. Reference cube [-1,1]^3, counter-clockwise from below, bottom before top.
#pragma once

#include <array>
#include <string_view>

#include "sim/element/quad4.h"
#include "sim/element/quadrature.h"

namespace sim {

struct Hex8 {
  static constexpr ElementKind kind = ElementKind::hex8;
  static constexpr std::string_view name = "hex8";
  static constexpr int dimension = 3, nodes = 8, corners = 8, order = 1;
  static constexpr bool membrane = false;
  static constexpr double nodes_per_element = 1;
  static constexpr int vtk = 12, gmsh = 5;
  static constexpr auto rule = cube_8;
  static constexpr auto mass_rule = cube_8;  // N_i N_j has degree 2 in each variable

  using Facet = Quad4;
  static constexpr std::array<int, 24> facets = {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4,
                                                 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
  static constexpr std::array<std::array<int, 3>, 12> edges = {{{0, 1, -1},
                                                                {1, 2, -1},
                                                                {2, 3, -1},
                                                                {3, 0, -1},
                                                                {4, 5, -1},
                                                                {5, 6, -1},
                                                                {6, 7, -1},
                                                                {7, 4, -1},
                                                                {0, 4, -1},
                                                                {1, 5, -1},
                                                                {2, 6, -1},
                                                                {3, 7, -1}}};
  // Node order that turns the element inside out.
  static constexpr std::array<int, nodes> mirrored = {4, 5, 6, 7, 0, 1, 2, 3};
  static constexpr std::array<std::array<double, 3>, nodes> corner_xi = {
      {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};

  // N_i = (1 + xi_i xi)(1 + eta_i eta)(1 + zeta_i zeta)/8 with (xi_i, eta_i, zeta_i) the corner
  static constexpr std::array<double, nodes> N(const std::array<double, 3>& xi) {
    std::array<double, nodes> N{};
    for (int i = 0; i < nodes; ++i) {
      const auto& c = corner_xi[i];
      N[i] = (1 + c[0] * xi[0]) * (1 + c[1] * xi[1]) * (1 + c[2] * xi[2]) / 8;
    }
    return N;
  }
  // dN_i/dxi_k
  static constexpr std::array<std::array<double, 3>, nodes> dN(const std::array<double, 3>& xi) {
    std::array<std::array<double, 3>, nodes> dN{};
    for (int i = 0; i < nodes; ++i) {
      const auto& c = corner_xi[i];
      const double a = 1 + c[0] * xi[0], b = 1 + c[1] * xi[1], d = 1 + c[2] * xi[2];
      dN[i] = {c[0] * b * d / 8, c[1] * a * d / 8, c[2] * a * b / 8};
    }
    return dN;
  }
};

}  // namespace sim
