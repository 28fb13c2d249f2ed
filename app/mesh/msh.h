// Gmsh meshes: MSH 1, 2.0 to 2.2, 4.0 and 4.1, text and binary.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/mesh/msh_contents.h"
#include "sim/mesh/mesh.h"

namespace app {

// content: the whole file; name: the file's, for messages. What was left out or merged is told in remarks.
// The elements of the highest dimension are the body. Physical groups become groups: named ones by their name,
// others by their number. Triangles and squares whose nodes all have the same z make a mesh in the plane.
// Throws FileError.
sim::Mesh read_msh(std::string_view content, std::string_view name, std::vector<std::string>& remarks);

// What the file says, of which no mesh has been made. Throws FileError.
MshContents read_msh_contents(std::string_view content, std::string_view name);

}  // namespace app
