// Input files of Abaqus and CalculiX (.inp): nodes, elements and sets of one part.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/mesh/mesh.h"

namespace app {

// NSET, ELSET and element-based SURFACE become groups of that name. All other keywords (materials, steps, loads, ...)
// are passed over. Throws FileError.
sim::Mesh read_abaqus(std::string_view content, std::string_view name, std::vector<std::string>& remarks);

}  // namespace app
