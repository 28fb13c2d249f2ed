// Uniform refinement.
#pragma once

#include "sim/mesh/mesh.h"

namespace sim {

// Splits every triangle or quad into 4 and every tet or hex into 8 of the same kind. New nodes lie on the element's
// own map, so quadratic elements keep their curved shape. Nodes keep their numbers; the children of element e are
// numbered from e * 4 (or 8). Groups are carried: their elements and facets are split, and new nodes join as in
// to_quadratic.
Mesh refine(const Mesh& mesh);

}  // namespace sim
