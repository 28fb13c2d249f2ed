// Makes good meshes bad, for tests of what a solver bears.
#pragma once

#include "sim/mesh/mesh.h"

namespace sim {

// The longest axis becomes `ratio` times as long: elements of that aspect ratio.
void lengthen(Mesh& mesh, double ratio);
// Moves one corner along an edge until `left` of the edge's length is left: the elements around it become slivers.
// Without an edge along which no element turns over, the mesh stays.
void make_slivers(Mesh& mesh, double left);
// The first `count` elements, each with nodes of its own; groups are dropped.
void disconnect(Mesh& mesh, int count);

}  // namespace sim
