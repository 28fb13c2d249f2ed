// Legacy VTK files (.vtk) with an unstructured grid, text and binary, versions 1 to 5.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/mesh/mesh.h"

namespace app {

// Integer arrays of the cells become groups: app/mesh/vtk_grid.h. Throws FileError.
sim::Mesh read_vtk(std::string_view content, std::string_view name, std::vector<std::string>& remarks);

}  // namespace app
