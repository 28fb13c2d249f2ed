// Linear triangle. Reference corners (0,0) (1,0) (0,1).
#pragma once

#include <array>
#include <string_view>

#include "sim/element/edge2.h"
#include "sim/element/quadrature.h"

namespace sim {

struct Tri3 {
  static constexpr ElementKind kind = ElementKind::tri3;
  static constexpr std::string_view name = "tri3";
  static constexpr int dimension = 2, nodes = 3, corners = 3, order = 1;
  static constexpr bool membrane = true;
  static constexpr double nodes_per_element = 0.5;
  static constexpr int vtk = 5, gmsh = 2;
  static constexpr auto rule = triangle_1;
  static constexpr auto mass_rule = triangle_3;

  using Facet = Edge2;
  static constexpr std::array<int, 6> facets = {0, 1, 1, 2, 2, 0};
  static constexpr std::array<std::array<int, 3>, 3> edges = {{{0, 1, -1}, {1, 2, -1}, {2, 0, -1}}};
  static constexpr std::array<std::array<double, 2>, corners> corner_xi = {{{0, 0}, {1, 0}, {0, 1}}};
  // Node order that turns the element inside out.
  static constexpr std::array<int, nodes> mirrored = {0, 2, 1};

  // Barycentric coordinates: N_0 = 1 - xi - eta, N_1 = xi, N_2 = eta
  static constexpr std::array<double, nodes> N(const std::array<double, 2>& xi) {
    return {1 - xi[0] - xi[1], xi[0], xi[1]};
  }
  // dN_i/dxi_k
  static constexpr std::array<std::array<double, 2>, nodes> dN(const std::array<double, 2>&) {
    return {{{-1, -1}, {1, 0}, {0, 1}}};
  }
};

}  // namespace sim
