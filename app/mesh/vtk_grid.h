// What a VTK file of either syntax says of an unstructured grid, before a mesh is made of it.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "app/mesh/cursor.h"
#include "sim/mesh/mesh.h"

namespace app {

struct VtkGrid {
  std::vector<double> points;             // x, y, z of each
  std::vector<std::int64_t> nodes, ends;  // nodes of all cells in a row; where each cell ends in it
  std::vector<std::int64_t> types;        // of the cells, VTK's numbers
  std::vector<std::pair<std::string, std::vector<std::int64_t>>> integers;  // arrays of the cells, one number each
};

// A cell whose number in gmsh:physical, medit:ref, cell_tags or CellEntityIds is N is in group "N"; one whose number in
// another array is, in group "ARRAY=N". 0 of the former means none; an array of more than 100 different numbers counts
// cells and makes no groups. Throws FileError at whatever is not right in the grid.
sim::Mesh make_mesh(const Cursor& in, const VtkGrid& grid, std::vector<std::string>& remarks);

}  // namespace app
