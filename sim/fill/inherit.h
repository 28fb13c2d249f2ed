// The groups of a surface, on the solid that fills it.
#pragma once

#include <vector>

#include "sim/mesh/mesh.h"

namespace sim {

// Each boundary facet of the solid, and its nodes, belong to the groups of the triangle of the surface that is nearest
// to the facet's middle. A group that no facet comes to is empty.
std::vector<Group> inherit_groups(const Mesh& surface, const Mesh& solid);

}  // namespace sim
