// Quadratic tetrahedron: the corners of tet4, then the middles of edges 01 12 20 03 13 23.
#pragma once

#include <array>
#include <string_view>

#include "sim/element/quadratic_simplex.h"
#include "sim/element/tet4.h"
#include "sim/element/tri6.h"

namespace sim {

struct Tet10 : QuadraticSimplex<Tet10, Tet4> {
  static constexpr ElementKind kind = ElementKind::tet10;
  static constexpr std::string_view name = "tet10";
  static constexpr int dimension = 3, nodes = 10, corners = 4, order = 2;
  static constexpr bool membrane = false;
  static constexpr double nodes_per_element = 1.37;
  static constexpr int vtk = 24, gmsh = 11;
  static constexpr std::array<int, 10> gmsh_order = {0, 1, 2, 3, 4,
                                                     5, 6, 7, 9, 8};  // the middle of 23 before that of 13
  static constexpr auto rule = tet_4;
  static constexpr auto mass_rule = tet_14;

  using Facet = Tri6;
  static constexpr std::array<int, 24> facets = {0, 2, 1, 6, 5, 4, 0, 1, 3, 4, 8, 7,
                                                 1, 2, 3, 5, 9, 8, 0, 3, 2, 7, 9, 6};
  static constexpr std::array<std::array<int, 3>, 6> edges = {
      {{0, 1, 4}, {1, 2, 5}, {2, 0, 6}, {0, 3, 7}, {1, 3, 8}, {2, 3, 9}}};
  static constexpr auto corner_xi = Tet4::corner_xi;
  // Node order that turns the element inside out.
  static constexpr std::array<int, nodes> mirrored = {0, 2, 1, 3, 6, 5, 4, 7, 9, 8};
};

}  // namespace sim
