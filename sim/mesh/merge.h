// Nodes that stand at one place: counted, and joined.
#pragma once

#include "sim/mesh/mesh.h"

namespace sim {

// Nodes closer than this are taken to stand at one place [m]: what a file in single precision cannot tell apart.
double coincidence(const Mesh& mesh);

// How many nodes stand within the distance of another that comes before them.
int count_coincident(const Mesh& mesh, double distance);

struct Joined {
  int nodes = 0;     // that went
  int elements = 0;  // that went, as two of their nodes became one
};

// Each node that stands within the distance of one before it becomes that one, in elements and groups.
Joined join_coincident(Mesh& mesh, double distance);

}  // namespace sim
