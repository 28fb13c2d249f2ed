// What is known of an element kind at run time: counts and the local nodes of its edges and facets.
// The shape functions themselves are compile-time structs, one file each: tri3.h ... hex8.h; list.h names them all.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <string>
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
  ElementKind linear;                         // with the corners only; itself when it is linear
  std::optional<ElementKind> quadratic;       // with middle nodes as well; itself when it is quadratic
  bool membrane;                              // of dimension 2: can lie in space too
  double nodes_per_element;                   // of a large mesh, about
  int vtk;                                    // its number among VTK's cell types
  int gmsh;                                   // its number among Gmsh's element types
  std::span<const int> gmsh_order;            // local node i is Gmsh's node gmsh_order[i]; empty: i

  bool simplex() const { return corners == dimension + 1; }
};

// Of every element, in the order of list.h.
std::span<const ElementInfo> elements();
const ElementInfo& info(ElementKind kind);
// nullptr when the name is not one of an element.
const ElementInfo* find_element(std::string_view name);
// The names of the elements that are right, as a message lists them: "tri3, tri6 or quad4".
std::string element_list(bool (*right)(const ElementInfo&));

}  // namespace sim
