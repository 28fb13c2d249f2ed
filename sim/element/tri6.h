// Quadratic triangle: the corners of tri3, then the middles of edges 01 12 20.
#pragma once

#include <array>
#include <string_view>

#include "sim/element/edge3.h"
#include "sim/element/quadratic_simplex.h"
#include "sim/element/tri3.h"

namespace sim {

struct Tri6 : QuadraticSimplex<Tri6, Tri3> {
  static constexpr ElementKind kind = ElementKind::tri6;
  static constexpr std::string_view name = "tri6";
  static constexpr int dimension = 2, nodes = 6, corners = 3, order = 2;
  static constexpr bool membrane = true;
  static constexpr double nodes_per_element = 2;
  static constexpr int vtk = 22, gmsh = 9;
  static constexpr auto rule = triangle_3;
  static constexpr auto mass_rule = triangle_6;

  using Facet = Edge3;
  static constexpr std::array<int, 9> facets = {0, 1, 3, 1, 2, 4, 2, 0, 5};
  static constexpr std::array<std::array<int, 3>, 3> edges = {{{0, 1, 3}, {1, 2, 4}, {2, 0, 5}}};
  static constexpr auto corner_xi = Tri3::corner_xi;
  // Node order that turns the element inside out.
  static constexpr std::array<int, nodes> mirrored = {0, 2, 1, 5, 4, 3};
};

}  // namespace sim
