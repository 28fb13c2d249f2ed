// Surfaces in PLY files, text and binary.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/mesh/mesh.h"

namespace app {

// Reads x, y, z of the element vertex and vertex_indices of the element face; other properties and elements are passed
// over. What becomes of faces: app/mesh/face_set.h. Throws FileError.
sim::Mesh read_ply(std::string_view content, std::string_view name, std::vector<std::string>& remarks);

}  // namespace app
