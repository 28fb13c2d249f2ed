// Makes a mesh fit for computing, or refuses it.
#pragma once

#include "sim/mesh/input_error.h"
#include "sim/mesh/mesh.h"

namespace sim {

// What was mended.
struct MeshCheck {
  int reoriented = 0;      // elements that were inside out
  int dropped_nodes = 0;   // nodes of no element
  int dropped_facets = 0;  // group facets on such nodes
};

// Re-orients elements with negative measure (their node order is mirrored) and drops nodes that no element uses.
// Throws InputError (key "mesh") on an empty mesh, lists of the wrong shape, node numbers out of range, coordinates
// that are not finite, elements whose measure is zero (below 1e-14 of their longest edge to the power of the
// dimension), and elements that are folded: det dX/dxi <= 0 at a quadrature point or corner.
MeshCheck check_and_orient(Mesh& mesh);

}  // namespace sim
