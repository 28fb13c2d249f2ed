// Meshes of the Vega library (.veg).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/mesh/mesh.h"

namespace app {

// Sets of elements become groups of that name; materials and regions are passed over. Throws FileError.
sim::Mesh read_vega(std::string_view content, std::string_view name, std::vector<std::string>& remarks);

}  // namespace app
