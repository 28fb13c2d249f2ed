// Where a body's nodes and elements lie in the system's numbering.
#pragma once

#include <string>

#include "sim/mesh/mesh.h"

namespace sim {

struct BodyRange {
  std::string name;
  int first_node = 0, node_count = 0;
  int first_element = 0, element_count = 0;
  double size = 0;             // longest side of the rest bounding box, m
  const Mesh* mesh = nullptr;  // rest mesh, owned by the system; node and element numbers are the body's own
};

}  // namespace sim
