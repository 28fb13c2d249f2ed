// Meshes of TetGen: NAME.node has the points, NAME.ele the tets (or, by Triangle, the triangles in the plane).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/mesh/mesh.h"

namespace app {

// The two whole files, with their names for messages. Points are numbered from 0 or from 1: the first one tells.
// Attributes and markers are passed over. Throws FileError.
sim::Mesh read_tetgen(std::string_view node_content, std::string_view node_name, std::string_view ele_content,
                      std::string_view ele_name, std::vector<std::string>& remarks);

}  // namespace app
