// Surfaces in OFF files: OFF, with normals, colours or textures behind the coordinates or not.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/mesh/mesh.h"

namespace app {

// What becomes of faces: app/mesh/face_set.h. Throws FileError.
sim::Mesh read_off(std::string_view content, std::string_view name, std::vector<std::string>& remarks);

}  // namespace app
