// An order of the elements in which neighbours in space are neighbours in memory.
#pragma once

#include <vector>

#include "sim/mesh/mesh.h"

namespace sim {

// order[k] is the k-th element along the Morton curve (Z curve) through the centroids; a permutation.
std::vector<int> spatial_order(const Mesh& mesh);

}  // namespace sim
