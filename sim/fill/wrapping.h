// Which part of a surface lies around which part of the solid that fills it.
#pragma once

#include <vector>

#include "sim/mesh/mesh.h"

namespace sim {

struct Wrapping {
  Eigen::MatrixXi facets;    // of the solid's boundary, nodes per facet x facets
  std::vector<int> nearest;  // for each the triangle of the surface that is nearest to its middle
};

Wrapping wrap(const Mesh& surface, const Mesh& solid);

// Each facet, and its nodes, belong to the groups of its triangle. A group that no facet comes to is empty.
std::vector<Group> inherit_groups(const Mesh& surface, const Wrapping& wrapping);

// Connected parts of the surface around which nothing has been filled: thinner than the tets.
int count_lost(const Mesh& surface, const Mesh& solid, const Wrapping& wrapping);

}  // namespace sim
