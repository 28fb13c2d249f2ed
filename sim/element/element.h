// What is known of an element kind at run time: counts and the local nodes of its edges and facets.
// The shape functions themselves are compile-time structs, one file each: tri3.h ... hex8.h; list.h names them all.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <string_view>

#include "sim/element/kind.h"

namespace sim {

// One quadrature point: reference coordinates xi and weight; the weights of a rule sum to the reference measure
// (1/2 triangle, 1/6 tet, 4 square [-1,1]^2, 8 cube [-1,1]^3).
template <int Dim>
struct QuadraturePoint {
  std::array<double, Dim> xi;
  double weight;
};

struct ElementInfo {
  ElementKind kind;
  std::string_view name;
  int dimension;                // material dimension: 2 triangle or quad, 3 tet or hex
  int nodes;                    // per element
  int corners;                  // the first `corners` nodes are its corners
  int order;                    // 1 linear, 2 quadratic
  int facet_nodes;              // per boundary facet: 2 (edge2), 3 (edge3 or tri3), 6 (tri6), 4 (quad4)
  std::span<const int> facets;  // local nodes, facet by facet, outward (right-hand rule; 2D: inside on the left)
  std::span<const std::array<int, 3>> edges;  // corner, corner, middle node (-1 for linear elements)
};

const ElementInfo& info(ElementKind kind);
// nullptr when the name is not one of an element.
const ElementInfo* find_element(std::string_view name);

}  // namespace sim
