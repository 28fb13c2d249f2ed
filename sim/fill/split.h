// A tet of the lattice, cut by a surface, as tets that are inside. [Labelle & Shewchuk 2007, fig. 3]
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "sim/math/vec3.h"

namespace sim {

// What splitting needs to know of vertices and of what it makes of them.
struct Cutting {
  std::function<int(int)> sign;                // of a vertex: 1 inside, 0 on the surface, -1 outside
  std::function<int(int)> node;                // of a vertex
  std::function<int(int, int)> cut;            // the node where the surface cuts the edge between two vertices
  std::function<bool(int, int, int)> crosses;  // how the part of a face inside is cut in two: by the way from the first
                                               // vertex to the cut between second and third (true), or from the second
  std::function<Vec3(int)> place;              // of a node
};

// Appends the tets, none where all of the tet is outside. A tet whose four vertices are on the surface is kept.
void split_tet(const std::array<int, 4>& tet, const Cutting& cutting, std::vector<std::array<int, 4>>& tets);

}  // namespace sim
