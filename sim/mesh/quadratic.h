// Quadratic elements from linear ones.
#pragma once

#include "sim/mesh/input_error.h"
#include "sim/mesh/mesh.h"

namespace sim {

// tri3 -> tri6, tet4 -> tet10 with straight edges; a quadratic mesh is returned unchanged. Nodes keep their numbers,
// elements too. A middle node joins the groups whose elements or facets it belongs to, or, in groups of nodes only,
// those which hold both ends of its edge. Throws InputError (mesh.element) for quad4 and hex8.
Mesh to_quadratic(const Mesh& mesh);

}  // namespace sim
