// Medit meshes (.mesh), text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/mesh/mesh.h"

namespace app {

// References become groups by their number, 0 means none. Sections that are not known are passed over. Throws
// FileError.
sim::Mesh read_medit(std::string_view content, std::string_view name, std::vector<std::string>& remarks);

}  // namespace app
