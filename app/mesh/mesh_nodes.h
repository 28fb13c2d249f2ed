// The nodes of a mesh that was read: only those that its elements use, in the dimension that they need.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/mesh/mesh.h"

namespace app {

// Keeps the nodes that some element refers to, in their order, and renumbers the elements (not the groups).
// Returns the new index of each old node, -1 for those that are gone; a remark counts these.
std::vector<int> keep_used_nodes(sim::Mesh& mesh, std::string_view name, std::vector<std::string>& remarks);

// Elements of material dimension 2 (triangles, squares) whose nodes all have the same z, but for rounding, become
// a mesh in the plane: X has two rows. Throws FileError for squares that are not in such a plane.
void flatten(sim::Mesh& mesh, std::string_view name);

// For each column the first column with the same set of entries: itself, unless it repeats an earlier one.
std::vector<int> first_equal_column(const Eigen::MatrixXi& columns);

}  // namespace app
