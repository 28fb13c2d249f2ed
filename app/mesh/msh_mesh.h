// A mesh made of what a Gmsh file says.
#pragma once

#include <string>
#include <vector>

#include "app/mesh/msh_contents.h"
#include "sim/mesh/mesh.h"

namespace app {

// Throws FileError when there is no body in it: no elements of dimension 2 or 3, or not of one kind.
sim::Mesh make_mesh(const MshContents& contents, const std::string& name, std::vector<std::string>& remarks);

}  // namespace app
