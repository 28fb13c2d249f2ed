// A mesh: nodes, elements of one kind, named groups. Plain data, as a reader or a generator makes it.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "sim/element/kind.h"

namespace sim {

// A named part of a mesh (Gmsh: physical group). Any of the lists may be empty.
struct Group {
  std::string name;
  std::vector<int> nodes;     // every node of the group, sorted, unique
  std::vector<int> elements;  // elements that belong to it, sorted (for a region with its own material)
  Eigen::MatrixXi facets;     // nodes per boundary facet x facets (for a traction); in the facet's own node order
  int dimension = 0;  // what it was made of: 0 nodes, 1 edges, 2 faces, 3 solids; a name may be there once in each
};

struct Mesh {
  ElementKind kind = ElementKind::tet4;
  Eigen::MatrixXd X;         // rest positions [m], dimension x nodes; dimension = 2 (plane) or 3
  Eigen::MatrixXi elements;  // nodes per element x elements
  std::vector<Group> groups;

  int dimension() const { return static_cast<int>(X.rows()); }
  int node_count() const { return static_cast<int>(X.cols()); }
  int element_count() const { return static_cast<int>(elements.cols()); }
};

}  // namespace sim
