// The physical groups of a Gmsh file as groups of the mesh that was made of it.
#pragma once

#include <string>
#include <vector>

#include "app/mesh/msh_contents.h"
#include "sim/mesh/mesh.h"

namespace app {

// Where the file's things are in the mesh.
struct MshIndex {
  const MshType* body;
  std::vector<int> nodes;     // by index in the file; -1: not in the mesh
  std::vector<int> elements;  // by position among the file's elements of the body's type
};

// Groups in the order of dimension and tag. Those of one dimension and name become one group. Elements of lower
// dimension that do not lie on the body and groups that remain empty are left out, with a remark. Throws FileError for
// facets that do not fit the body's elements.
std::vector<sim::Group> make_groups(const MshContents& contents, const MshIndex& index, const std::string& name,
                                    std::vector<std::string>& remarks);

}  // namespace app
