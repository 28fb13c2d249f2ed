// Linear tetrahedron. Reference corners (0,0,0) (1,0,0) (0,1,0) (0,0,1).
#pragma once

#include <array>
#include <string_view>

#include "sim/element/quadrature.h"
#include "sim/element/tri3.h"

namespace sim {

struct Tet4 {
  static constexpr ElementKind kind = ElementKind::tet4;
  static constexpr std::string_view name = "tet4";
  static constexpr int dimension = 3, nodes = 4, corners = 4, order = 1;
  static constexpr bool membrane = false;
  static constexpr double nodes_per_element = 0.18;
  static constexpr int vtk = 10, gmsh = 4;
  static constexpr auto rule = tet_1;
  static constexpr auto mass_rule = tet_4;

  using Facet = Tri3;
  static constexpr std::array<int, 12> facets = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
  static constexpr std::array<std::array<int, 3>, 6> edges = {
      {{0, 1, -1}, {1, 2, -1}, {2, 0, -1}, {0, 3, -1}, {1, 3, -1}, {2, 3, -1}}};
  static constexpr std::array<std::array<double, 3>, corners> corner_xi = {
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  // Node order that turns the element inside out.
  static constexpr std::array<int, nodes> mirrored = {0, 2, 1, 3};

  // Barycentric coordinates: N_0 = 1 - xi - eta - zeta, N_1 = xi, N_2 = eta, N_3 = zeta
  static constexpr std::array<double, nodes> N(const std::array<double, 3>& xi) {
    return {1 - xi[0] - xi[1] - xi[2], xi[0], xi[1], xi[2]};
  }
  // dN_i/dxi_k
  static constexpr std::array<std::array<double, 3>, nodes> dN(const std::array<double, 3>&) {
    return {{{-1, -1, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  }
};

}  // namespace sim
