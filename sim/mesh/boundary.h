// The boundary of a mesh.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/mesh/mesh.h"

namespace sim {

struct Boundary {
  Eigen::MatrixXi facets;     // nodes per facet x facets, outward; those that belong to exactly one element
  std::vector<int> elements;  // the element of each
  int non_manifold = 0;       // facets that are shared by more than two elements (and are not in `facets`)
};

// Facets are faces of solids and edges of triangles and quads, in the order of the elements.
Boundary boundary(const Mesh& mesh);

// boundary(mesh).facets
Eigen::MatrixXi boundary_facets(const Mesh& mesh);

// What is drawn: the boundary facets of a solid; the elements themselves of a plane mesh or a membrane.
Eigen::MatrixXi surface_facets(const Mesh& mesh);

}  // namespace sim
