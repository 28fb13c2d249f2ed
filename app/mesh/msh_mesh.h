// A mesh made of what a Gmsh file says.
#pragma once

#include <string>
#include <vector>

#include "app/mesh/msh_contents.h"
#include "sim/mesh/mesh.h"

namespace app {

// Throws FileError when there is no body in it: no elements of dimension 2 or 3, or not of one kind, but for triangles
// and squares, which all become triangles.
sim::Mesh make_mesh(MshContents contents, const std::string& name, std::vector<std::string>& remarks);

}  // namespace app
