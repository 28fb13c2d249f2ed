// The connected parts of a mesh.
#pragma once

#include <vector>

#include "sim/mesh/mesh.h"

namespace sim {

struct Component {
  std::vector<int> nodes, elements;  // ascending
};

// In the order of their lowest nodes.
std::vector<Component> components(const Mesh& mesh);

}  // namespace sim
