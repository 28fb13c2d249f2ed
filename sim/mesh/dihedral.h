// The angles between the faces of tets.
#pragma once

#include <array>

#include "sim/math/vec3.h"
#include "sim/mesh/mesh.h"

namespace sim {

// The smallest of the six [degrees].
double smallest_dihedral(const std::array<Vec3, 4>& corners);
// Of all elements of a mesh of tets, by their corners.
double smallest_dihedral(const Mesh& mesh);

}  // namespace sim
