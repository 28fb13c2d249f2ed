// Element types of Abaqus and CalculiX.
#pragma once

#include <string_view>
#include <vector>

#include "app/mesh/msh_type.h"

namespace app {

// By its name ("C3D10M"), in capitals; nullptr for what no body is made of (springs, masses, axisymmetric, ...).
const MshType* find_abaqus_type(std::string_view name);

// The local nodes of a face "S1", "S2", ... as a surface names it; with as many nodes as a facet has. Empty when the
// element has no such face.
std::vector<int> abaqus_face(const MshType& type, int face);

}  // namespace app
