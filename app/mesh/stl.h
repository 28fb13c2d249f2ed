// Surfaces in STL files, text and binary: triangles without numbers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/mesh/mesh.h"

namespace app {

// Corners that stand at one place, to the bit, are one vertex. Normals and attributes are passed over. What becomes of
// faces: app/mesh/face_set.h. Throws FileError.
sim::Mesh read_stl(std::string_view content, std::string_view name, std::vector<std::string>& remarks);

}  // namespace app
