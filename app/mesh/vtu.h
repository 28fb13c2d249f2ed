// VTK XML files with an unstructured grid (.vtu): text, base64 or raw, with zlib or without.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/mesh/mesh.h"

namespace app {

// Integer arrays of the cells become groups: app/mesh/vtk_grid.h. Throws FileError.
sim::Mesh read_vtu(std::string_view content, std::string_view name, std::vector<std::string>& remarks);

// The points alone, three numbers each. Throws FileError.
std::vector<double> read_vtu_points(std::string_view content, std::string_view name);

}  // namespace app
