// Surfaces in Wavefront OBJ files: a mesh in the plane, or a membrane in space.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/mesh/mesh.h"

namespace app {

// Reads vertices (v) and faces (f); the rest (normals, textures, materials, ...) is passed over. What becomes of faces:
// app/mesh/face_set.h. Throws FileError.
sim::Mesh read_obj(std::string_view content, std::string_view name, std::vector<std::string>& remarks);

}  // namespace app
